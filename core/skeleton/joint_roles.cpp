// core/skeleton/joint_roles.cpp: words in joint names.
#include "core/skeleton/joint_roles.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

#include "core/base/at.h"
#include "core/skeleton/name_words.h"
#include "core/skeleton/side_names.h"

namespace sinew {
namespace {

struct JointName {
  std::string letters;
  std::vector<std::string> words;
  bool sided = false;

  explicit JointName(const std::string& name)
      : letters(lettersOf(name)), words(wordsOf(name)), sided(sideNamed(name).has_value()) {}

  /// One of these is in it, anywhere.
  [[nodiscard]] bool holds(std::initializer_list<std::string_view> parts) const {
    return std::ranges::any_of(parts, [&](auto part) { return letters.find(part) != std::string::npos; });
  }
  /// One of these stands in it as a word.
  [[nodiscard]] bool says(std::initializer_list<std::string_view> parts) const {
    return std::ranges::any_of(parts, [&](auto part) { return std::ranges::find(words, part) != words.end(); });
  }
};

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
      return JointName(at(skeleton.bones, child).name).holds({"arm", "humerus"});
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

JointRole roleOf(const Bone& bone, const Above& above) {
  const JointName name(bone.name);
  if (bone.parent < 0 || movesNothingSeen(name, bone)) return JointRole::kStill;
  const bool limb = above.has({JointRole::kShoulder, JointRole::kElbow, JointRole::kWrist, JointRole::kHip,
                               JointRole::kKnee, JointRole::kAnkle});
  if (limb && name.holds({"finger", "thumb", "index", "middle", "ring", "pinky", "pinkie", "little", "toe", "palm"})) {
    return JointRole::kDigit;
  }
  if (name.holds({"tail"})) return JointRole::kTail;
  if (name.holds({"arm", "elbow", "hand", "wrist", "shoulder", "clavicle", "collar", "humerus", "scapula"}) &&
      !name.holds({"armature"})) {
    return armRole(name, above);
  }
  if (name.holds({"leg", "thigh", "knee", "shin", "calf", "foot", "ankle", "femur", "tibia", "paw", "hoof"}) ||
      (name.sided && name.says({"hip"}))) {
    return legRole(name, above);
  }
  if (name.holds({"root", "pelvis", "hips", "armature", "master", "origin"}) || name.says({"hip", "cog", "global"})) {
    return above.has({JointRole::kTrunk}) ? JointRole::kTrunk : JointRole::kStill;
  }
  if (name.holds({"neck", "head"})) return JointRole::kNeck;
  if (name.holds({"spine", "chest", "torso", "abdomen", "waist", "body", "back", "belly", "trunk", "ribcage"})) {
    return JointRole::kTrunk;
  }
  return JointRole::kFree;
}

}  // namespace

std::vector<JointRole> jointRoles(const Skeleton& skeleton) {
  std::vector<JointRole> roles(skeleton.bones.size(), JointRole::kStill);
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    roles[i] = roleOf(skeleton.bones[i], {skeleton, roles, static_cast<int>(i)});
  }
  return roles;
}

}  // namespace sinew
