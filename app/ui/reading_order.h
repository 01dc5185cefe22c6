// app/ui/reading_order.h: text that is read from the right, as it has to be drawn from the left.
#pragma once

#include <string>
#include <string_view>

namespace sinew::app {

/// Where a text has Hebrew or Arabic letters: in the order of the screen, Arabic letters joined, in a line that as a
/// whole goes from left to right, as the interface does. Line by line. Marked (U+202D), so that a second call
/// leaves it as it is. Any other text: itself. For labels: a text field has to keep what is typed. Notes it as shown.
[[nodiscard]] std::string inReadingOrder(const std::string& text);

/// What is shown otherwise: typed or pasted.
void noteShown(std::u32string_view letters);
/// Letters beyond ASCII that have been shown since the last call.
[[nodiscard]] std::u32string takeShown();

}  // namespace sinew::app
