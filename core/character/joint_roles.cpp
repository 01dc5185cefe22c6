// core/character/joint_roles.cpp: follows limbs from the trunk outwards; looks for words in the names of joints.
#include "core/character/joint_roles.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

#include <glm/geometric.hpp>

#include "core/character/bone_names.h"
#include "core/geometry/at.h"

namespace sinew {

namespace {

constexpr float kLooseFoot = 0.15f;     ///< Horizontal distance, fraction of H.
constexpr float kShortestLimb = 0.12f;  ///< Length of unnamed limbs, fraction of H.

/// Length of the longest path down from a bone's joint.
float reachBelow(const SlotSearch& search, int bone, int depth = 0) {
  float longest = 0.0f;
  if (depth > 64) return longest;
  for (const int child : at(search.skeleton.bones, bone).children) {
    if (!at(search.active, child)) continue;
    const float step = glm::distance(at(search.joints, bone), at(search.joints, child));
    longest = std::max(longest, step + reachBelow(search, child, depth + 1));
  }
  return longest;
}

/// The child that continues a limb, past twists and fingers.
int nextInLimb(const SlotSearch& search, int bone) {
  int best = -1;
  float bestScore = 0.0f;
  for (const int child : at(search.skeleton.bones, bone).children) {
    if (!at(search.active, child)) continue;
    const BoneName& name = at(search.names, child);
    const std::vector<int>& below = at(search.skeleton.bones, child).children;
    float score = 1.0f + reachBelow(search, child) / search.height;
    if (limbWord(name) != LimbWord::kNone) score += 4.0f;
    if (name.helper) score -= below.empty() ? 3.0f : 0.5f;
    if (name.digit) score -= 0.9f;
    if (best < 0 || score > bestScore) {
      best = child;
      bestScore = score;
    }
  }
  return bestScore > 0.0f ? best : -1;
}

LimbWord wordOf(const SlotSearch& search, const std::vector<int>& bones) {
  std::array<int, 5> counts{};
  for (const int bone : bones) ++counts[static_cast<std::size_t>(limbWord(at(search.names, bone)))];
  if (counts[3] > 0) return LimbWord::kFrontLeg;
  if (counts[4] > 0) return LimbWord::kHindLeg;
  if (counts[1] == 0 && counts[2] == 0) return LimbWord::kNone;
  return counts[1] >= counts[2] ? LimbWord::kArm : LimbWord::kLeg;
}

/// A foot that follows a target and is attached to the root, below a limb's end.
bool isLooseFoot(const SlotSearch& search, const LimbChain& chain, int bone) {
  if (!at(search.active, bone) || search.sideOf(bone) <= 0 || search.isAbove(chain.bones.front(), bone)) return false;
  const LimbWord word = limbWord(at(search.names, bone));
  if (word == LimbWord::kNone || word == LimbWord::kArm) return false;
  glm::vec3 away = at(search.joints, bone) - at(search.joints, chain.bones.back());
  const bool below = away.y < 0.0f;
  away.y = 0.0f;
  return below && glm::length(away) < kLooseFoot * search.height;
}

LimbChain chainFrom(const SlotSearch& search, int first) {
  LimbChain chain;
  chain.attach = search.parentOf(first);
  for (int bone = first; bone >= 0 && chain.bones.size() < 64; bone = nextInLimb(search, bone))
    chain.bones.push_back(bone);
  chain.lowest = at(search.joints, first).y;
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    const Bone& bone = at(search.skeleton.bones, chain.bones[i]);
    const bool last = i + 1 == chain.bones.size();
    chain.ends.push_back(last ? glm::vec3(bone.bindInWorld * glm::vec4(bone.tip, 1.0f))
                              : at(search.joints, chain.bones[i + 1]));
    chain.length += glm::length(chain.segment(i, search));
    chain.lowest = std::min(chain.lowest, chain.ends.back().y);
  }
  chain.word = wordOf(search, chain.bones);
  for (int i = 0; i < static_cast<int>(search.joints.size()); ++i) {
    if (isLooseFoot(search, chain, i)) chain.lowest = std::min(chain.lowest, at(search.joints, i).y);
  }
  return chain;
}

/// Positive if the normal points to the left by the names of bones.
float leftFromNames(const SlotSearch& search, const glm::vec3& normal) {
  float sum = 0.0f;
  for (std::size_t i = 0; i < search.names.size(); ++i) {
    if (!search.names[i].side) continue;
    const float along = glm::dot(search.joints[i] - search.joints[0], normal);
    sum += *search.names[i].side == Side::kLeft ? along : -along;
  }
  return sum;
}

/// Pairs bones whose sides only BoneName recognizes: the twin has the same key at the same depth of the tree.
void pairByKeys(SlotSearch& search) {
  const auto depth = [&](int bone) {
    int steps = 0;
    for (; bone >= 0; bone = search.parentOf(bone)) ++steps;
    return steps;
  };
  const auto count = static_cast<int>(search.names.size());
  for (int i = 0; i < count; ++i) {
    const BoneName& name = at(search.names, i);
    if (at(search.twinOf, i) >= 0 && at(search.twinOf, i) != i) continue;
    if (name.side != Side::kLeft || name.key.empty()) continue;
    for (int j = 0; j < count; ++j) {
      const BoneName& other = at(search.names, j);
      const bool free = at(search.twinOf, j) < 0 || at(search.twinOf, j) == j;
      if (!free || other.side != Side::kRight || other.key != name.key || depth(i) != depth(j)) continue;
      at(search.twinOf, i) = j;
      at(search.twinOf, j) = i;
      break;
    }
  }
}

float middleOf(const SlotSearch& search) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < search.joints.size(); ++i) {
    const int twin = at(search.twinOf, static_cast<int>(i));
    if (twin < 0) continue;
    sum += 0.5 * static_cast<double>(glm::dot(search.joints[i] + at(search.joints, twin), search.left));
    ++count;
  }
  if (count > 0) return static_cast<float>(sum / count);
  return search.joints.empty() ? 0.0f : glm::dot(search.joints[0], search.left);
}

}  // namespace

int SlotSearch::parentOf(int bone) const { return at(skeleton.bones, bone).parent; }

int SlotSearch::sideOf(int bone) const {
  if (const auto& side = at(names, bone).side) return *side == Side::kLeft ? 1 : -1;
  const int twin = at(twinOf, bone);
  if (twin < 0 || twin == bone) return 0;
  return glm::dot(at(joints, bone), left) > middle ? 1 : -1;
}

bool SlotSearch::isAbove(int above, int bone) const {
  while (bone > above) bone = parentOf(bone);
  return above >= 0 && bone == above;
}

int SlotSearch::commonAncestor(int a, int b) const {
  while (a != b && a >= 0 && b >= 0) {
    int& later = a > b ? a : b;
    later = parentOf(later);
  }
  return a == b ? a : -1;
}

SlotSearch makeSearch(const Skeleton& skeleton, const SlotHints& hints) {
  const std::size_t count = skeleton.bones.size();
  SlotSearch search{skeleton, boneNames(skeleton), bonesThatMoveSkin(skeleton, hints.carriesSkin), hints.twinOf, {}};
  search.twinOf.resize(count, -1);
  Bounds bounds;
  for (const Bone& bone : skeleton.bones) {
    search.joints.emplace_back(bone.bindInWorld[3]);
    bounds.add(search.joints.back());
  }
  if (count == 0) return search;
  glm::vec3 normal(hints.planeNormal.x, 0.0f, hints.planeNormal.z);
  normal = normalizeOr(normal, {1.0f, 0.0f, 0.0f});
  search.left = leftFromNames(search, normal) < 0.0f ? -normal : normal;
  pairByKeys(search);
  search.middle = middleOf(search);
  search.ground = bounds.low.y;
  const glm::vec3 extent = bounds.extent();
  const float most = std::max({extent.x, extent.y, extent.z});
  search.height = hints.height > 0.0f ? hints.height : (extent.y > 0.2f * most ? extent.y : most);
  if (!(search.height > 0.0f)) search.height = 1.0f;
  return search;
}

glm::vec3 LimbChain::segment(std::size_t i, const SlotSearch& search) const {
  return ends[i] - at(search.joints, bones[i]);
}

std::vector<LimbChain> leftLimbs(const SlotSearch& search) {
  std::vector<LimbChain> limbs;
  for (std::size_t i = 0; i < search.joints.size(); ++i) {
    const auto bone = static_cast<int>(i);
    if (!search.active[i] || search.sideOf(bone) <= 0) continue;
    const int parent = search.parentOf(bone);
    if (parent >= 0 && search.sideOf(parent) > 0) continue;
    LimbChain chain = chainFrom(search, bone);
    const bool named = chain.word != LimbWord::kNone;
    if (!named && (chain.bones.size() < 2 || chain.length < kShortestLimb * search.height)) continue;
    limbs.push_back(std::move(chain));
  }
  return limbs;
}

std::vector<bool> bonesThatMoveSkin(const Skeleton& skeleton, const std::vector<bool>& carriesSkin) {
  const std::size_t count = skeleton.bones.size();
  std::vector<bool> moves = carriesSkin;
  moves.resize(count, carriesSkin.empty());
  // Parents come first.
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

  /// Contains one of these anywhere.
  [[nodiscard]] bool holds(std::initializer_list<std::string_view> parts) const {
    return std::ranges::any_of(parts, [&](auto part) { return letters.find(part) != std::string::npos; });
  }
  /// Contains one of these as a word.
  [[nodiscard]] bool says(std::initializer_list<std::string_view> parts) const {
    return std::ranges::any_of(parts, [&](auto part) { return std::ranges::find(words, part) != words.end(); });
  }
};

JointName jointName(const std::string& given) {
  std::string name = inEnglish(given);
  // "Armature|mixamorig:Spine" -> "Spine".
  if (const std::size_t cut = name.find_last_of(":|"); cut != std::string::npos) name.erase(0, cut + 1);
  return {lettersOf(name), wordsOf(name), sideNamed(name).has_value()};
}

/// The roles of the bones above a bone.
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
  // "toe end" is the end of a toe, but "end" alone a name.
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
  // A piece of a limb rotates with its parent.
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
  using enum JointRole;
  constexpr std::array<JointRole, kSlotCount> kRoles{kStill,  kTrunk,    kTrunk, kTrunk, kNeck, kNeck, kTail,
                                                     kCollar, kShoulder, kElbow, kWrist, kHip,  kKnee, kAnkle,
                                                     kDigit,  kShoulder, kElbow, kWrist, kHip,  kKnee, kAnkle};
  return kRoles[static_cast<std::size_t>(part)];
}

/// The names of most body parts are unknown.
bool sayLittle(const std::vector<JointRole>& roles, std::span<const std::optional<Slot>> parts) {
  int unknown = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i]) unknown += roles[i] == JointRole::kFree ? 1 : -1;
  }
  return unknown > 0;
}

/// Bones between a part of the same name and the next part: "thigh.L.001" above "shin.L" rotates with "thigh.L".
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

/// Finds roles of bones with unknown names.
class RolesByPart {
 public:
  RolesByPart(const Skeleton& skeleton, std::span<const std::optional<Slot>> parts)
      : skeleton_(skeleton), parts_(parts), found_(skeleton.bones.size()), carriesHips_(skeleton.bones.size()) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i] != Slot::kHips) continue;
      for (int b = skeleton.bones[i].parent; b >= 0; b = at(skeleton.bones, b).parent) carriesHips_[toIndex(b)] = true;
    }
  }

  /// Must be called for parents first.
  JointRole find(int bone) {
    const auto i = toIndex(bone);
    if (i < parts_.size() && parts_[i]) {
      found_[i] = roleOfPart(*parts_[i]);
    } else if (carriesHips_[i]) {
      found_[i] = JointRole::kStill;  // It moves the whole body.
    } else if (const int parent = at(skeleton_.bones, bone).parent; parent >= 0) {
      // Children of hands and feet are fingers and toes.
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
