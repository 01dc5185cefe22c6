// core/geometry/nearest_name.h: the name that a misspelled word was probably meant as.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// The name nearest to the word: capitals and signs do not count, up to a third of the letters may be wrong, missing or
/// swapped; else one that has the word as a part. "" where none is near.
[[nodiscard]] std::string nearestName(std::string_view word, const std::vector<std::string>& names);

/// `; did you mean "Walk"?`, or "" where no name is near.
[[nodiscard]] std::string didYouMean(std::string_view word, const std::vector<std::string>& names);

}  // namespace sinew
