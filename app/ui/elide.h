// app/ui/elide.h: long names in little room, so that names that differ stay different.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace sinew::app {

/// Width of a text, in any unit; grows with the text.
using MeasureText = std::function<float(std::string_view)>;

/// What most names of a list begin and end with, and which therefore says nothing: "mixamorig:", "_Twist_01".
struct SharedEnds {
  std::string_view prefix;
  std::string_view suffix;
};

/// The longest ends that more than half of the names share, up to and with a separator (one of "_:.-| /"). Empty where
/// there is none, and for fewer than two names. Views into the names.
[[nodiscard]] SharedEnds sharedEnds(std::span<const std::string_view> names);

/// The text if it fits; else an ellipsis for the shared prefix, then one for the shared suffix too; else the beginning
/// and the end of what is between them, an ellipsis in the middle. Whole characters of UTF-8; no wider than `width`,
/// unless the ellipsis alone is.
[[nodiscard]] std::string elided(const std::string& text, float width, const MeasureText& measure,
                                 const SharedEnds& shared = {});

}  // namespace sinew::app
