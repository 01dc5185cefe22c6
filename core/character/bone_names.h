// core/character/bone_names.h: what the names of bones say of the parts of a body.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/character/body_slot.h"
#include "core/character/side_names.h"
#include "sinew/character/skeleton.h"

namespace sinew {

/// A name taken apart.
struct BoneName {
  std::string key;  ///< Small letters without what all names share, side and number: "mixamorig:LeftUpLeg" -> "upleg".
  std::optional<Side> side;
  bool helper = false;  ///< Twists, corrects or controls another bone: no part of a body by itself.
  bool digit = false;   ///< Finger or single toe.
};

/// [bones]. Names in English, and the usual Japanese ones in kanji, kana and Latin letters.
[[nodiscard]] std::vector<BoneName> boneNames(const Skeleton& skeleton);

/// The usual Japanese words for parts and sides in English: "左腕" -> "left  upperarm ". Other names stay.
[[nodiscard]] std::string inEnglish(std::string name);

/// How well a name fits a part: 3 the usual word for it, 2 a word for it in some conventions, 1 may mean it, 0 says
/// nothing, -3 is the word for something else.
[[nodiscard]] int nameFits(const BoneName& name, Slot slot);

/// What kind of limb a name speaks of.
enum class LimbWord { kNone, kArm, kLeg, kFrontLeg, kHindLeg };
[[nodiscard]] LimbWord limbWord(const BoneName& name);

}  // namespace sinew
