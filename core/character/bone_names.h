// core/character/bone_names.h: sides, words and body parts in the names of bones.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/character/skeleton.h"

namespace sinew {

// A side marker is left or right, l or r, lf or rt, fl or fr, bl or br, in any case, as a word: "arm_L", "L.arm",
// "Bip01 R Hand", "thigh L 2", "LeftArm", "handR", "hand.l.001". left and right also count inside a word ("armleft").

enum class Side { kLeft, kRight };

struct SideMarker {
  std::size_t begin = 0;   ///< Byte in the name.
  std::size_t length = 0;  ///< Bytes.
  Side side = Side::kLeft;
};

/// All markers, in order; only left and right if one of these is among them.
[[nodiscard]] std::vector<SideMarker> sideMarkers(std::string_view name);

/// The side in a name; nothing if it has no marker, or as many for either side.
[[nodiscard]] std::optional<Side> sideNamed(std::string_view name);

/// The name with its side changed, case kept: "thigh L" -> "thigh R", "LEFT_arm" -> "RIGHT_arm". Nothing if the name
/// has no marker or several. Its own inverse.
[[nodiscard]] std::optional<std::string> mirroredName(std::string_view name);

/// The name without its marker and separators: "biceps L" -> "biceps", "L_biceps" -> "biceps". The name itself if it
/// has no marker or several, or nothing would be left.
[[nodiscard]] std::string withoutSide(const std::string& name);

[[nodiscard]] std::string lettersOf(std::string_view name);  ///< Letters in lower case: "Upper_Arm.L" -> "upperarml".

/// Words in lower case, separated by anything but letters or by a capital after a small letter: "Armature|WalkCycle_01"
/// -> "armature", "walk", "cycle".
[[nodiscard]] std::vector<std::string> wordsOf(std::string_view name);

struct BoneName {
  std::string key;  ///< Lower case without shared prefix, side and number: "mixamorig:LeftUpLeg" -> "upleg".
  std::optional<Side> side;
  bool helper = false;  ///< Twists, corrects or controls another bone; no body part of its own.
  bool digit = false;   ///< Finger or single toe.
};

/// [bones] Reads English names, and the usual Japanese ones in kanji, kana and Latin letters.
[[nodiscard]] std::vector<BoneName> boneNames(const Skeleton& skeleton);

/// The usual Japanese words for parts and sides in English: "左腕" -> "left  upperarm ". Other names stay.
[[nodiscard]] std::string inEnglish(std::string name);

/// How well a name fits a part: 3 the usual word for it, 2 a word in some conventions, 1 may mean it, 0 unknown, below
/// 0 as well for something else.
[[nodiscard]] int nameFits(const BoneName& name, Slot slot);

enum class LimbWord { kNone, kArm, kLeg, kFrontLeg, kHindLeg };  ///< The kind of limb in a name.
[[nodiscard]] LimbWord limbWord(const BoneName& name);

}  // namespace sinew
