// core/character/bone_names.h: what the names of bones say of the parts of a body.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/character/skeleton.h"

namespace sinew {

// Which side a name means, and the name of its counterpart.
//
// A side marker is left or right, l or r, lf or rt, fl or fr, bl or br, in any case, standing apart: "arm_L", "L.arm",
// "Bip01 R Hand", "thigh L 2", "LeftArm", "handR", "hand.l.001". left and right also count inside a word ("armleft").

enum class Side { kLeft, kRight };

/// A marker in a name.
struct SideMarker {
  std::size_t begin = 0;   ///< Byte.
  std::size_t length = 0;  ///< Bytes.
  Side side = Side::kLeft;
};

/// All markers, in order. Where a whole word (left, right) is among them, only the words.
[[nodiscard]] std::vector<SideMarker> sideMarkers(std::string_view name);

/// The side that a name says; nothing where it has no marker, or as many of both.
[[nodiscard]] std::optional<Side> sideNamed(std::string_view name);

/// The name with its side changed, case kept: "thigh L" -> "thigh R", "LEFT_arm" -> "RIGHT_arm". Nothing where the name
/// has no marker or several: then the pattern is not clear. Its own inverse.
[[nodiscard]] std::optional<std::string> mirroredName(std::string_view name);

/// The name without its one marker and what parts it from the rest: "biceps L" -> "biceps", "L_biceps" -> "biceps". The
/// name itself where it has none or several, or nothing would be left.
[[nodiscard]] std::string withoutSide(const std::string& name);

// Words in the names that files give to joints and clips.

/// Small letters alone, without what stands between words: "Upper_Arm.L" -> "upperarml".
[[nodiscard]] std::string lettersOf(std::string_view name);

/// Words in small letters: parted by anything but letters, and where a capital follows a small letter:
/// "Armature|WalkCycle_01" -> "armature", "walk", "cycle".
[[nodiscard]] std::vector<std::string> wordsOf(std::string_view name);

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
