// core/character/joint_roles.cpp: words in joint names.
#include "core/character/joint_roles.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

#include "core/character/bone_names.h"
#include "core/geometry/at.h"

namespace sinew {

// Bones that move no skin.

std::vector<bool> bonesThatMoveSkin(const Skeleton& skeleton, const std::vector<bool>& carriesSkin) {
  const std::size_t count = skeleton.bones.size();
  std::vector<bool> moves = carriesSkin;
  moves.resize(count, carriesSkin.empty());
  // Children stand behind their parents.
  for (std::size_t i = count; i-- > 0;) {
    if (moves[i] && skeleton.bones[i].parent >= 0) at(moves, skeleton.bones[i].parent) = true;
  }
  return moves;
}

std::vector<bool> helperBones(const Skeleton& skeleton, const std::vector<bool>& carriesSkin) {
  std::vector<bool> helpers = bonesThatMoveSkin(skeleton, carriesSkin);
  helpers.flip();
  if (std::ranges::find(helpers, false) == helpers.end()) helpers.flip();
  return helpers;
}

namespace {

struct JointName {
  std::string letters;
  std::vector<std::string> words;
  bool sided = false;

  /// One of these is in it, anywhere.
  [[nodiscard]] bool holds(std::initializer_list<std::string_view> parts) const {
    return std::ranges::any_of(parts, [&](auto part) { return letters.find(part) != std::string::npos; });
  }
  /// One of these stands in it as a word.
  [[nodiscard]] bool says(std::initializer_list<std::string_view> parts) const {
    return std::ranges::any_of(parts, [&](auto part) { return std::ranges::find(words, part) != words.end(); });
  }
};

JointName jointName(const std::string& given) {
  std::string name = inEnglish(given);
  // "Armature|mixamorig:Spine": what all names begin with says nothing.
  if (const std::size_t cut = name.find_last_of(":|"); cut != std::string::npos) name.erase(0, cut + 1);
  return {lettersOf(name), wordsOf(name), sideNamed(name).has_value()};
}

/// The tree above a bone, as far as roles are known.
struct Above {
  const Skeleton& skeleton;
  const std::vector<JointRole>& roles;
  int bone;

  [[nodiscard]] bool has(std::initializer_list<JointRole> wanted) const {
    for (int i = at(skeleton.bones, bone).parent; i >= 0; i = at(skeleton.bones, i).parent) {
      const JointRole role = at(roles, i);
      if (std::ranges::find(wanted, role) != wanted.end()) return true;
    }
    return false;
  }
  [[nodiscard]] bool childIsArm() const {
    return std::ranges::any_of(at(skeleton.bones, bone).children, [&](int child) {
      return jointName(at(skeleton.bones, child).name).holds({"arm", "humerus"});
    });
  }
};

JointRole armRole(const JointName& name, const Above& above) {
  if (name.holds({"clavicle", "collar"})) return JointRole::kCollar;
  if (name.holds({"shoulder", "scapula"})) return above.childIsArm() ? JointRole::kCollar : JointRole::kShoulder;
  if (!above.has({JointRole::kShoulder})) return JointRole::kShoulder;
  if (name.holds({"hand", "wrist", "palm"})) return JointRole::kWrist;
  return above.has({JointRole::kElbow}) ? JointRole::kWrist : JointRole::kElbow;
}

JointRole legRole(const JointName& name, const Above& above) {
  if (name.holds({"foot", "ankle", "paw", "hoof"})) return JointRole::kAnkle;
  if (!above.has({JointRole::kHip})) return JointRole::kHip;
  return above.has({JointRole::kKnee}) ? JointRole::kAnkle : JointRole::kKnee;
}

bool movesNothingSeen(const JointName& name, const Bone& bone) {
  if (name.says({"ik", "pole", "target", "ctrl", "control", "socket", "poletarget"})) return true;
  // "end" alone is a name; "toe end" is the end of a toe.
  return bone.children.empty() && name.words.size() > 1 && name.says({"nub", "end", "tip", "effector", "null"});
}

JointRole roleByName(const Bone& bone, const Above& above) {
  const JointName name = jointName(bone.name);
  if (bone.parent < 0 || movesNothingSeen(name, bone)) return JointRole::kStill;
  const bool limb = above.has({JointRole::kShoulder, JointRole::kElbow, JointRole::kWrist, JointRole::kHip,
                               JointRole::kKnee, JointRole::kAnkle});
  if (limb && name.holds({"finger", "thumb", "index", "middle", "ring", "pinky", "pinkie", "little", "toe", "palm"})) {
    return JointRole::kDigit;
  }
  // A piece of a limb, which turns with what it hangs on.
  if (limb && (name.holds({"twist"}) || name.says({"roll", "share"}))) return JointRole::kStill;
  if (name.holds({"tail"})) return JointRole::kTail;
  if (name.holds({"arm", "elbow", "hand", "wrist", "shoulder", "shldr", "clavicle", "collar", "humerus", "scapula"}) &&
      !name.holds({"armature"})) {
    return armRole(name, above);
  }
  if (name.holds({"leg", "thigh", "knee", "shin", "calf", "foot", "ankle", "femur", "tibia", "paw", "hoof"}) ||
      (name.sided && name.says({"hip"}))) {
    return legRole(name, above);
  }
  if (name.letters == "center" || name.letters == "groove") return JointRole::kStill;
  if (name.holds({"root", "pelvis", "hips", "armature", "master", "origin", "lowerbody"}) ||
      name.says({"hip", "cog", "global"})) {
    return above.has({JointRole::kTrunk}) ? JointRole::kTrunk : JointRole::kStill;
  }
  if (name.holds({"neck", "head"})) return JointRole::kNeck;
  if (name.holds({"spine", "chest", "torso", "abdomen", "waist", "body", "back", "belly", "trunk", "ribcage"})) {
    return JointRole::kTrunk;
  }
  return JointRole::kFree;
}

JointRole roleOfPart(Slot part) {
  switch (part) {
    case Slot::kHips:
      return JointRole::kStill;
    case Slot::kSpine:
    case Slot::kChest:
    case Slot::kUpperChest:
      return JointRole::kTrunk;
    case Slot::kNeck:
    case Slot::kHead:
      return JointRole::kNeck;
    case Slot::kTail:
      return JointRole::kTail;
    case Slot::kShoulder:
      return JointRole::kCollar;
    case Slot::kUpperArm:
    case Slot::kFrontUpper:
      return JointRole::kShoulder;
    case Slot::kLowerArm:
    case Slot::kFrontLower:
      return JointRole::kElbow;
    case Slot::kHand:
    case Slot::kFrontFoot:
      return JointRole::kWrist;
    case Slot::kUpperLeg:
    case Slot::kHindUpper:
      return JointRole::kHip;
    case Slot::kLowerLeg:
    case Slot::kHindLower:
      return JointRole::kKnee;
    case Slot::kFoot:
    case Slot::kHindFoot:
      return JointRole::kAnkle;
    case Slot::kToes:
      return JointRole::kDigit;
  }
  return JointRole::kFree;
}

/// Of most parts of the body, names say nothing.
bool sayLittle(const std::vector<JointRole>& roles, std::span<const std::optional<Slot>> parts) {
  int unknown = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i]) unknown += roles[i] == JointRole::kFree ? 1 : -1;
  }
  return unknown > 0;
}

/// Bones between the part that they are called as and the next one: "thigh.L.001" above "shin.L" turns with "thigh.L".
std::vector<bool> secondPieces(const Skeleton& skeleton, std::span<const std::optional<Slot>> parts) {
  std::vector<bool> pieces(skeleton.bones.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != Slot::kLowerArm && parts[i] != Slot::kLowerLeg) continue;
    for (int b = skeleton.bones[i].parent; b >= 0 && !at(parts, b); b = at(skeleton.bones, b).parent) {
      const int parent = at(skeleton.bones, b).parent;
      const bool sameName =
          parent >= 0 && lettersOf(at(skeleton.bones, b).name) == lettersOf(at(skeleton.bones, parent).name);
      pieces[toIndex(b)] = sameName;
    }
  }
  return pieces;
}

/// Of bones whose names say nothing.
class RolesByPart {
 public:
  RolesByPart(const Skeleton& skeleton, std::span<const std::optional<Slot>> parts)
      : skeleton_(skeleton), parts_(parts), found_(skeleton.bones.size()), carriesHips_(skeleton.bones.size()) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i] != Slot::kHips) continue;
      for (int b = skeleton.bones[i].parent; b >= 0; b = at(skeleton.bones, b).parent) carriesHips_[toIndex(b)] = true;
    }
  }

  /// Parents first.
  JointRole find(int bone) {
    const auto i = toIndex(bone);
    if (i < parts_.size() && parts_[i]) {
      found_[i] = roleOfPart(*parts_[i]);
    } else if (carriesHips_[i]) {
      found_[i] = JointRole::kStill;  // It moves the whole body.
    } else if (const int parent = at(skeleton_.bones, bone).parent; parent >= 0) {
      // What is on a hand or a foot that only its place tells are fingers or toes.
      const auto& above = at(found_, parent);
      const bool onLimbsEnd = above == JointRole::kWrist || above == JointRole::kAnkle || above == JointRole::kDigit;
      if (onLimbsEnd) found_[i] = JointRole::kDigit;
    }
    return found_[i].value_or(JointRole::kFree);
  }

 private:
  const Skeleton& skeleton_;
  std::span<const std::optional<Slot>> parts_;
  std::vector<std::optional<JointRole>> found_;  ///< [bones]
  std::vector<bool> carriesHips_;                ///< [bones] the hips are below it.
};

}  // namespace

std::vector<JointRole> jointRoles(const Skeleton& skeleton, std::span<const std::optional<Slot>> parts) {
  std::vector<JointRole> roles(skeleton.bones.size(), JointRole::kStill);
  const std::vector<bool> pieces = secondPieces(skeleton, parts);
  const auto byName = [&](std::size_t i) {
    if (pieces[i]) return JointRole::kStill;
    return roleByName(skeleton.bones[i], {skeleton, roles, static_cast<int>(i)});
  };
  for (std::size_t i = 0; i < roles.size(); ++i) roles[i] = byName(i);
  if (!sayLittle(roles, parts)) return roles;
  RolesByPart byPart(skeleton, parts);
  for (std::size_t i = 0; i < roles.size(); ++i) {
    roles[i] = byName(i);
    if (roles[i] == JointRole::kFree) roles[i] = byPart.find(static_cast<int>(i));
  }
  return roles;
}

}  // namespace sinew
