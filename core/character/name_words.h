// core/character/name_words.h: words in the names that files give to joints and clips.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// Small letters alone, without what stands between words: "Upper_Arm.L" -> "upperarml".
[[nodiscard]] std::string lettersOf(std::string_view name);

/// Words in small letters: parted by anything but letters, and where a capital follows a small letter:
/// "Armature|WalkCycle_01" -> "armature", "walk", "cycle".
[[nodiscard]] std::vector<std::string> wordsOf(std::string_view name);

}  // namespace sinew
