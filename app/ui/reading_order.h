// app/ui/reading_order.h: text that is read from the right, as it has to be drawn from the left.
#pragma once

#include <string>

namespace sinew::app {

/// Where a text has Hebrew or Arabic letters: in the order of the screen, Arabic letters joined, in a line that as a
/// whole goes from left to right, as the interface does. Line by line. Marked (U+202D), so that a second call
/// leaves it as it is. Any other text: itself. For labels: a text field has to keep what is typed.
[[nodiscard]] std::string inReadingOrder(const std::string& text);

}  // namespace sinew::app
