// app/ui/reading_order.h: text as it is drawn: long names elided, right-to-left text in visual order.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace sinew::app {

// Elides long names so that different names stay different.

using MeasureText = std::function<float(std::string_view)>;  ///< Width of a text in any unit; grows with the text.

/// Common beginnings and ends of a list's names: "mixamorig:", "_Twist_01".
struct SharedEnds {
  std::string_view prefix;
  std::string_view suffix;
};

/// The longest ends with a separator (one of "_:.-| /") that more than half of at least two names share. Views into the
/// names; empty: none.
[[nodiscard]] SharedEnds sharedEnds(std::span<const std::string_view> names);

/// The text if it fits; else with an ellipsis for the shared prefix, then for the suffix too, else in the middle of the
/// rest. Whole UTF-8 characters; no wider than `width` unless the ellipsis alone is.
[[nodiscard]] std::string elided(const std::string& text, float width, const MeasureText& measure,
                                 const SharedEnds& shared = {});

/// Text with Hebrew or Arabic letters in visual order, Arabic letters joined, each line left to right as a whole; other
/// text unchanged. Marked with U+202D, so that a second call changes nothing. For labels, not for text fields, which
/// keep what is typed. Calls noteShown().
[[nodiscard]] std::string inReadingOrder(const std::string& text);

void noteShown(std::u32string_view letters);  ///< Notes letters that are shown otherwise: typed or pasted.
[[nodiscard]] std::u32string takeShown();     ///< Letters beyond ASCII that were noted since the last call.

}  // namespace sinew::app
