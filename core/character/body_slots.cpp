// core/character/body_slots.cpp: finds limbs first, then the bones that carry them, then those between.
#include "core/character/body_slots.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "core/character/joint_roles.h"
#include "core/geometry/at.h"

namespace sinew {

namespace {

constexpr std::array<const char*, kSlotCount> kNames{
    "hips",     "spine",      "chest",      "upperChest", "neck",      "head",      "tail",
    "shoulder", "upperArm",   "lowerArm",   "hand",       "upperLeg",  "lowerLeg",  "foot",
    "toes",     "frontUpper", "frontLower", "frontFoot",  "hindUpper", "hindLower", "hindFoot"};
constexpr int kCenterSlots = static_cast<int>(kFirstSidedSlot);
constexpr std::size_t kBodySlots = kCenterSlots + 2 * (kSlotCount - kCenterSlots);

std::array<std::string, kBodySlots> makeNames() {
  std::array<std::string, kBodySlots> names;
  for (std::size_t i = 0; i < kBodySlots; ++i) {
    const BodySlot slot = allBodySlots()[i];
    names[i] = nameOf(slot.slot);
    if (slot.isSided()) names[i] += slot.side == BodySide::kLeft ? ".L" : ".R";
  }
  return names;
}

}  // namespace

const char* nameOf(Slot slot) { return kNames[static_cast<std::size_t>(slot)]; }

std::optional<Slot> slotNamed(std::string_view name) {
  const auto found = std::ranges::find(kNames, name, [](const char* text) { return std::string_view(text); });
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Slot>(found - kNames.begin());
}

const std::array<BodySlot, kBodySlots>& allBodySlots() {
  static const std::array<BodySlot, kBodySlots> slots = [] {
    std::array<BodySlot, kBodySlots> all;
    for (int i = 0; i < kSlotCount; ++i) {
      const auto slot = static_cast<Slot>(i);
      const BodySlot left{slot, BodySide::kLeft};
      all[indexOf(left)] = left;
      if (left.isSided()) all[indexOf({slot, BodySide::kRight})] = {slot, BodySide::kRight};
    }
    return all;
  }();
  return slots;
}

std::size_t indexOf(BodySlot slot) {
  const int number = static_cast<int>(slot.slot);
  if (!slot.isSided()) return static_cast<std::size_t>(number);
  const int right = slot.side == BodySide::kRight ? 1 : 0;
  return static_cast<std::size_t>(kCenterSlots + 2 * (number - kCenterSlots) + right);
}

const char* nameOf(BodySlot slot) {
  static const std::array<std::string, kBodySlots> names = makeNames();
  return names[indexOf(slot)].c_str();
}

std::optional<BodySlot> bodySlotNamed(std::string_view name) {
  for (const BodySlot& slot : allBodySlots()) {
    if (nameOf(slot) == name) return slot;
  }
  return std::nullopt;
}

namespace {

constexpr float kShortPart = 0.04f;  ///< Shortest upper or lower part of a limb, fraction of H.
constexpr float kNever = -1e6f;

/// Scores for assigning the parts of a limb, in order, to its bones.
struct Laying {
  const SlotSearch& search;
  const LimbChain& chain;
  std::span<const Slot> parts;

  [[nodiscard]] const BoneName& name(std::size_t i) const { return at(search.names, chain.bones[i]); }
  [[nodiscard]] float lateral(std::size_t i) const {
    return std::abs(glm::dot(at(search.joints, chain.bones[i]), search.left) - search.middle);
  }
  /// Second half of a bone split along its length: it has the same name.
  [[nodiscard]] bool goesOn(std::size_t i) const {
    return i > 0 && !name(i).key.empty() && name(i).key == name(i - 1).key && !name(i).digit;
  }
  [[nodiscard]] bool isSideways(std::size_t i) const {
    const glm::vec3 along = chain.segment(i, search);
    return std::abs(along.y) < 0.5f * glm::length(along);
  }
  /// Number of bones from here on that may be parts.
  [[nodiscard]] int partsLeft(std::size_t i) const {
    int count = 0;
    for (; i < chain.bones.size(); ++i) {
      if (!name(i).helper && !name(i).digit && !goesOn(i)) ++count;
    }
    return count;
  }
  [[nodiscard]] float skipped(std::size_t i) const {
    const bool isNothing = name(i).helper || name(i).digit || goesOn(i);
    const bool isShort = glm::length(chain.segment(i, search)) < kShortPart * search.height;
    return isNothing || isShort || (i == 0 && isSideways(i)) ? 0.0f : -0.7f;
  }

  /// Score from proportions.
  float shape(std::size_t i, Slot slot) const {
    const bool named = nameFits(name(i), slot) > 0;
    const bool isShort = glm::length(chain.segment(i, search)) < kShortPart * search.height;
    switch (slot) {
      case Slot::kShoulder: {
        if (named) return 0.0f;
        const int rest = partsLeft(i + 1);
        const bool near = i + 1 < chain.bones.size() && lateral(i) < 0.45f * lateral(i + 1);
        return i == 0 && ((near && rest >= 3) || rest >= 4) ? 0.5f : -2.0f;
      }
      case Slot::kUpperLeg:
      case Slot::kHindUpper:
        if (isSideways(i) && !named && partsLeft(i + 1) >= 2) return -2.0f;
        return isShort ? -1.5f : 0.0f;
      case Slot::kUpperArm:
      case Slot::kLowerArm:
      case Slot::kLowerLeg:
      case Slot::kFrontUpper:
      case Slot::kHindLower:
        return isShort ? -1.5f : 0.0f;
      case Slot::kHand:
        return at(search.skeleton.bones, chain.bones[i]).children.size() >= 3 ? 0.5f : 0.0f;
      default:
        return 0.0f;
    }
  }

  [[nodiscard]] float taken(std::size_t i, Slot slot) const {
    if (name(i).helper || name(i).digit) return kNever;
    return 1.0f + static_cast<float>(nameFits(name(i), slot)) + shape(i, slot);
  }
};

/// Bone of each part, ever further out, by dynamic programming. @param parts  of one limb, from the trunk outwards
std::vector<SlotBone> partsOfLimb(const SlotSearch& search, const LimbChain& chain, std::span<const Slot> parts) {
  const Laying laying{search, chain, parts};
  const std::size_t bones = chain.bones.size();
  // score[i][j]: the best score for bones from i on and parts from j on.
  std::vector<std::vector<float>> score(bones + 1, std::vector<float>(parts.size() + 1, 0.0f));
  const auto takes = [&](std::size_t i, std::size_t j) { return laying.taken(i, parts[j]) + score[i + 1][j + 1]; };
  for (std::size_t i = bones; i-- > 0;) {
    for (std::size_t j = parts.size(); j-- > 0;) {
      const float cost = j == 0 || j + 1 < parts.size() ? laying.skipped(i) : 0.0f;
      score[i][j] = std::max({takes(i, j), score[i + 1][j] + cost, score[i][j + 1]});
    }
  }
  std::vector<SlotBone> found(parts.size());
  for (std::size_t i = 0, j = 0; i < bones && j < parts.size();) {
    const float best = score[i][j];
    if (best == takes(i, j)) {
      const bool named = nameFits(laying.name(i), parts[j]) > 0;
      found[j] = {chain.bones[i], named ? SlotConfidence::kSure : SlotConfidence::kPlaced};
      ++i;
      ++j;
    } else if (best == score[i][j + 1]) {
      ++j;
    } else {
      ++i;
    }
  }
  return found;
}

constexpr float kReachesGround = 0.55f;  ///< Height of a limb's end over that of its root, below which it does.
constexpr float kNearHips = 0.2f;        ///< Largest difference in height of hips and legs, fraction of H.
constexpr float kElbowCut = 0.4f;        ///< Elbow of a bone that is humerus and radius.
constexpr Slot kArm[] = {Slot::kShoulder, Slot::kUpperArm, Slot::kLowerArm, Slot::kHand};
constexpr Slot kLeg[] = {Slot::kUpperLeg, Slot::kLowerLeg, Slot::kFoot, Slot::kToes};
constexpr Slot kFrontLeg[] = {Slot::kShoulder, Slot::kFrontUpper, Slot::kFrontLower, Slot::kFrontFoot};
constexpr Slot kHindLeg[] = {Slot::kHindUpper, Slot::kHindLower, Slot::kHindFoot};
constexpr glm::vec3 kUp(0.0f, 1.0f, 0.0f);

struct Limbs {
  std::optional<LimbChain> legs;  ///< Hind legs of quadrupeds.
  std::optional<LimbChain> arms;
  bool quadruped = false;
};

glm::vec3 rootOf(const SlotSearch& search, const LimbChain& chain) { return at(search.joints, chain.bones.front()); }

bool reachesGround(const SlotSearch& search, const LimbChain& chain) {
  return chain.lowest - search.ground < kReachesGround * (rootOf(search, chain).y - search.ground);
}

bool isLegByName(const LimbChain& chain) { return chain.word == LimbWord::kLeg || chain.word == LimbWord::kHindLeg; }
bool isArmByName(const LimbChain& chain) { return chain.word == LimbWord::kArm || chain.word == LimbWord::kFrontLeg; }

float legScore(const SlotSearch& search, const LimbChain& chain) {
  float score = chain.length / search.height - (chain.lowest - search.ground) / search.height;
  if (isLegByName(chain)) score += 10.0f;
  if (isArmByName(chain)) score -= 10.0f;
  if (chain.bones.size() < 2) score -= 5.0f;
  return score;
}

float armScore(const SlotSearch& search, const LimbChain& chain) {
  float score = (rootOf(search, chain).y - search.ground + chain.length) / search.height;
  if (isArmByName(chain)) score += 10.0f;
  if (isLegByName(chain)) score -= 10.0f;
  return score;
}

template <class Score>
int bestOf(const std::vector<LimbChain>& chains, Score score, int besides = -1) {
  int best = -1;
  for (int i = 0; i < static_cast<int>(chains.size()); ++i) {
    if (i != besides && (best < 0 || score(at(chains, i)) > score(at(chains, best)))) best = i;
  }
  return best;
}

/// For two unnamed limbs that reach the ground: the one attached nearer to the root is the hind leg.
bool isBehind(const SlotSearch& search, const LimbChain& one, const LimbChain& other) {
  return one.attach != other.attach && one.attach >= 0 && search.isAbove(one.attach, other.attach);
}

Limbs findLimbs(const SlotSearch& search) {
  Limbs limbs;
  const std::vector<LimbChain> chains = leftLimbs(search);
  const auto unnamedLow = std::ranges::count_if(chains, [&](const LimbChain& chain) {
    return chain.word == LimbWord::kNone && chain.length > 0.2f * search.height && reachesGround(search, chain);
  });
  if (unnamedLow > 2) return limbs;  // An insect, or a table.
  int legs = bestOf(chains, [&](const LimbChain& chain) { return legScore(search, chain); });
  if (legs < 0) return limbs;
  const auto isLeg = [&](int i) {
    return isLegByName(at(chains, i)) || (!isArmByName(at(chains, i)) && reachesGround(search, at(chains, i)));
  };
  int arms = bestOf(
      chains, [&](const LimbChain& chain) { return armScore(search, chain); }, isLeg(legs) ? legs : -1);
  if (!isLeg(legs)) legs = -1;
  if (arms >= 0 && isLegByName(at(chains, arms))) arms = -1;
  // An unnamed arm has at least two bones and begins above the legs or in front of them.
  if (arms >= 0 && !isArmByName(at(chains, arms)) && at(chains, arms).bones.size() < 2) arms = -1;
  if (legs >= 0 && arms >= 0) {
    const LimbChain& a = at(chains, arms);
    const LimbChain& l = at(chains, legs);
    const glm::vec3 apart = rootOf(search, a) - rootOf(search, l);
    const glm::vec3 level = apart - apart.y * kUp - glm::dot(apart, search.left) * search.left;
    const bool trunkIsLevel = glm::length(level) > std::abs(apart.y);
    limbs.quadruped = trunkIsLevel && reachesGround(search, a) && reachesGround(search, l);
    const bool unnamed = a.word == LimbWord::kNone && l.word == LimbWord::kNone;
    if (limbs.quadruped && unnamed && isBehind(search, a, l)) std::swap(arms, legs);
    if (!limbs.quadruped && unnamed && apart.y < 0.1f * search.height) arms = -1;
  }
  if (legs >= 0) limbs.legs = at(chains, legs);
  if (arms >= 0) limbs.arms = at(chains, arms);
  return limbs;
}

// Parts in the middle -----------------------------------------------------------------------------------------------

class SlotFinder {
 public:
  explicit SlotFinder(const SlotSearch& search) : search_(search), limbs_(findLimbs(search)) {}

  BodySlots find() {
    found_.left = search_.left;
    found_.forward = glm::normalize(glm::cross(search_.left, kUp));
    if (!limbs_.legs && !limbs_.arms) return found_;
    found_.kind = limbs_.quadruped ? BodyKind::kQuadruped : BodyKind::kHumanoid;
    if (limbs_.legs) layLimb(*limbs_.legs, limbs_.quadruped ? std::span<const Slot>(kHindLeg) : kLeg);
    if (limbs_.arms) layLimb(*limbs_.arms, limbs_.quadruped ? std::span<const Slot>(kFrontLeg) : kArm);
    if (limbs_.quadruped) cutFrontLeg();
    findLooseFeet();
    findHips();
    findTrunk();
    findHead();
    findTail();
    return found_;
  }

 private:
  [[nodiscard]] const BoneName& name(int bone) const { return at(search_.names, bone); }
  [[nodiscard]] const glm::vec3& joint(int bone) const { return at(search_.joints, bone); }

  /// No bone is two parts.
  [[nodiscard]] bool isTaken(int bone) const {
    return std::ranges::find(found_.bones, bone, &SlotBone::bone) != found_.bones.end();
  }
  void set(Slot slot, int bone, SlotConfidence confidence) {
    if (!isTaken(bone)) found_[{slot, BodySide::kLeft}] = {bone, confidence};
  }

  /// A part on the left and its twin on the right.
  void setPair(Slot slot, const SlotBone& left) {
    if (left.bone >= 0 && isTaken(left.bone)) return;
    found_[{slot, BodySide::kLeft}] = left;
    const int twin = left.bone < 0 ? -1 : at(search_.twinOf, left.bone);
    if (twin < 0 || twin == left.bone || isTaken(twin)) return;
    SlotBone right = left;
    right.bone = twin;
    found_[{slot, BodySide::kRight}] = right;
  }

  void layLimb(const LimbChain& chain, std::span<const Slot> parts) {
    const std::vector<SlotBone> bones = partsOfLimb(search_, chain, parts);
    for (std::size_t i = 0; i < parts.size(); ++i) setPair(parts[i], bones[i]);
  }

  /// Splits the first bone if it is both humerus and radius, as in rigs for games: it ends at the carpus, half way
  /// down, and is not named as an arm.
  void cutFrontLeg() {
    const SlotBone upper = found_[{Slot::kFrontUpper}];
    const SlotBone lower = found_[{Slot::kFrontLower}];
    if (upper.bone < 0 || lower.bone < 0) return;
    const float top = joint(upper.bone).y - search_.ground;
    const float end = joint(lower.bone).y - search_.ground;
    const bool saysArm = nameFits(name(upper.bone), Slot::kFrontUpper) > 1;
    if (saysArm || !(end < 0.6f * top)) return;
    for (const BodySide side : {BodySide::kLeft, BodySide::kRight}) {
      SlotBone& humerus = found_[{Slot::kFrontUpper, side}];
      SlotBone& radius = found_[{Slot::kFrontLower, side}];
      if (humerus.bone < 0 || radius.bone < 0) continue;
      found_[{Slot::kFrontFoot, side}] = {radius.bone, SlotConfidence::kPlaced};
      radius = {humerus.bone, SlotConfidence::kPlaced, kElbowCut, 1.0f};
      humerus.to = kElbowCut;
    }
  }

  /// Finds feet that follow a target and are attached to the root, by name, below the limb's end.
  void findLooseFeet() {
    const auto find = [&](Slot foot, Slot above, LimbWord other) {
      const int upper = found_.boneOf(above);
      if (found_.boneOf(foot) >= 0 || upper < 0) return;
      int best = -1;
      for (int i = 0; i < static_cast<int>(search_.joints.size()); ++i) {
        const LimbWord word = limbWord(name(i));
        if (!at(search_.active, i) || search_.sideOf(i) <= 0 || search_.isAbove(upper, i) || name(i).helper) continue;
        if (word == LimbWord::kNone || word == LimbWord::kArm || word == other) continue;
        const glm::vec3 away = joint(i) - joint(upper);
        const float aside = glm::length(glm::vec3(away.x, 0.0f, away.z));
        if (!(away.y < -0.05f * search_.height) || aside > 0.15f * search_.height) continue;
        if (!isTaken(i) && (best < 0 || joint(i).y > joint(best).y)) best = i;
      }
      if (best >= 0) setPair(foot, {best, SlotConfidence::kNamed});
    };
    if (limbs_.quadruped) {
      find(Slot::kHindFoot, Slot::kHindLower, LimbWord::kFrontLeg);
      find(Slot::kFrontFoot, Slot::kFrontLower, LimbWord::kHindLeg);
    } else {
      find(Slot::kFoot, Slot::kLowerLeg, LimbWord::kFrontLeg);
    }
  }

  void findHips() {
    if (!limbs_.legs) {
      for (int i = 0; i < static_cast<int>(search_.joints.size()); ++i) {
        if (isMiddle(i) && nameFits(name(i), Slot::kHips) >= 2 && found_.boneOf(Slot::kHips) < 0) {
          set(Slot::kHips, i, SlotConfidence::kNamed);
        }
      }
      return;
    }
    const int twin = at(search_.twinOf, limbs_.legs->bones.front());
    const int other = twin >= 0 ? search_.parentOf(twin) : limbs_.legs->attach;
    const int carrier = search_.commonAncestor(limbs_.legs->attach, other);
    if (carrier < 0) return;
    const int arms = limbs_.arms ? limbs_.arms->attach : -1;
    const glm::vec3 height = joint(limbs_.legs->bones.front());
    int best = carrier;
    float bestScore = 2.0f + static_cast<float>(nameFits(name(carrier), Slot::kHips));
    for (int i = 0; i < static_cast<int>(search_.joints.size()); ++i) {
      const bool onTheWay = search_.isAbove(i, carrier) || (search_.isAbove(carrier, i) && search_.isAbove(i, arms));
      if (i == carrier || !isMiddle(i) || !onTheWay) continue;
      if (std::abs(joint(i).y - height.y) > kNearHips * search_.height) continue;
      const auto score = static_cast<float>(nameFits(name(i), Slot::kHips));
      if (score > bestScore) {
        best = i;
        bestScore = score;
      }
    }
    // The root of the mesh is no hips, although it may carry both legs and spine.
    const int fit = nameFits(name(best), Slot::kHips);
    if (fit <= 0 && search_.parentOf(best) < 0 && joint(best).y - search_.ground < 0.5f * (height.y - search_.ground))
      return;
    set(Slot::kHips, best,
        best != carrier ? SlotConfidence::kNamed
        : fit > 0       ? SlotConfidence::kSure
                        : SlotConfidence::kPlaced);
  }

  void findTrunk() {
    const int hips = found_.boneOf(Slot::kHips);
    if (limbs_.arms && limbs_.arms->attach >= 0 && hips >= 0) {
      for (const int bone : pathBetween(hips, limbs_.arms->attach)) {
        if (nameFits(name(bone), Slot::kNeck) <= 0 && !name(bone).helper) found_.trunk.push_back(bone);
      }
    } else if (hips >= 0) {
      for (int i = upwards(hips); i >= 0 && found_.trunk.size() < 64; i = upwards(i)) {
        if (nameFits(name(i), Slot::kNeck) > 0 || nameFits(name(i), Slot::kHead) > 0) break;
        found_.trunk.push_back(i);
      }
    }
    // The back may go on beyond the front legs.
    const auto isTrunk = [&](int bone) {
      return limbs_.quadruped &&
             (nameFits(name(bone), Slot::kSpine) > 0 || nameFits(name(bone), Slot::kUpperChest) > 0);
    };
    for (int i = found_.trunk.empty() ? -1 : upwards(found_.trunk.back()); i >= 0 && isTrunk(i); i = upwards(i)) {
      found_.trunk.push_back(i);
    }
    const std::vector<int>& trunk = found_.trunk;
    const auto put = [&](Slot slot, int bone) {
      set(slot, bone, nameFits(name(bone), slot) > 0 ? SlotConfidence::kSure : SlotConfidence::kPlaced);
    };
    if (trunk.empty()) return;
    if (trunk.size() == 1)
      return put(nameFits(name(trunk[0]), Slot::kChest) > 2 ? Slot::kChest : Slot::kSpine, trunk[0]);
    put(Slot::kSpine, trunk.front());
    if (trunk.size() == 2) return put(Slot::kChest, trunk[1]);
    put(Slot::kChest, trunk[trunk.size() / 2]);
    put(Slot::kUpperChest, trunk.back());
  }

  void findHead() {
    int from = found_.trunk.empty() ? (limbs_.arms ? limbs_.arms->attach : -1) : found_.trunk.back();
    if (from < 0) from = found_.boneOf(Slot::kHips);
    if (from < 0) return;
    std::vector<int> way;
    int head = -1;
    for (int i = upwards(from); i >= 0 && way.size() < 64 && head < 0; i = upwards(i)) {
      if (nameFits(name(i), Slot::kHead) > 0) head = i;
      way.push_back(i);
    }
    if (way.empty()) return;
    if (head < 0) {
      // If no bone is named head, the last of at least two is.
      if (way.size() < 2 || nameFits(name(way.back()), Slot::kNeck) > 0) {
        if (nameFits(name(way.front()), Slot::kNeck) <= 0) return;
        found_.neck = way;
        return set(Slot::kNeck, way.front(), SlotConfidence::kSure);
      }
      set(Slot::kHead, way.back(), SlotConfidence::kPlaced);
    } else {
      set(Slot::kHead, head, SlotConfidence::kSure);
    }
    way.pop_back();
    found_.neck = way;
    if (way.empty()) return;
    const bool named = nameFits(name(way.front()), Slot::kNeck) > 0;
    set(Slot::kNeck, way.front(), named ? SlotConfidence::kSure : SlotConfidence::kPlaced);
  }

  void findTail() {
    for (int i = 0; i < static_cast<int>(search_.joints.size()); ++i) {
      if (!isMiddle(i) || name(i).helper || nameFits(name(i), Slot::kTail) <= 0) continue;
      const bool hangsThere = found_.boneOf(Slot::kHips) < 0 || glm::dot(joint(i) - joint(found_.boneOf(Slot::kHips)),
                                                                         found_.forward) < 0.1f * search_.height;
      return set(Slot::kTail, i, hangsThere ? SlotConfidence::kSure : SlotConfidence::kNamed);
    }
  }

  std::vector<int> pathBetween(int from, int to) const {
    const int top = search_.commonAncestor(from, to);
    if (top < 0) return {};
    std::vector<int> down;
    for (int i = to; i != top; i = search_.parentOf(i)) down.push_back(i);
    return {down.rbegin(), down.rend()};
  }

  /// The center child that leads to the head.
  int upwards(int bone) const {
    int best = -1;
    float bestScore = 0.0f;
    for (const int child : at(search_.skeleton.bones, bone).children) {
      const bool named = nameFits(name(child), Slot::kNeck) > 0 || nameFits(name(child), Slot::kHead) > 0;
      if (!isMiddle(child) || (name(child).helper && !named) || nameFits(name(child), Slot::kTail) > 0) continue;
      const glm::vec3 step = joint(child) - joint(bone);
      const float rises = glm::dot(step, kUp) + (limbs_.quadruped ? std::abs(glm::dot(step, found_.forward)) : 0.0f);
      const float score = rises / search_.height + (named ? 10.0f : 0.0f);
      if ((named || rises > 0.0f) && (best < 0 || score > bestScore)) {
        best = child;
        bestScore = score;
      }
    }
    return best;
  }

  [[nodiscard]] bool isMiddle(int bone) const { return at(search_.active, bone) && search_.sideOf(bone) == 0; }

  const SlotSearch& search_;
  Limbs limbs_;
  BodySlots found_;
};

/// Positive if the body faces `slots.forward`, by its feet or, on four legs, from hind to front legs.
float facing(const SlotSearch& search, const BodySlots& slots) {
  const auto way = [&](Slot from, Slot to) {
    const int a = slots.boneOf(from);
    const int b = slots.boneOf(to);
    return a < 0 || b < 0 ? 0.0f : glm::dot(at(search.joints, b) - at(search.joints, a), slots.forward);
  };
  if (slots.kind == BodyKind::kQuadruped) return way(Slot::kHindUpper, Slot::kFrontUpper);
  return way(Slot::kFoot, Slot::kToes);
}

}  // namespace

BodySlots findBodySlots(const Skeleton& skeleton, const SlotHints& hints) {
  SlotSearch search = makeSearch(skeleton, hints);
  if (skeleton.bones.empty()) return {};
  BodySlots slots = SlotFinder(search).find();
  const bool sidesAreNamed =
      std::ranges::any_of(search.names, [](const BoneName& name) { return name.side.has_value(); });
  if (sidesAreNamed || facing(search, slots) >= 0.0f) return slots;
  search.left = -search.left;
  search.middle = -search.middle;
  return SlotFinder(search).find();
}

const char* nameOf(SlotConfidence confidence) {
  constexpr std::array kConfidences{"missing", "placed", "named", "sure", "given"};
  return kConfidences[static_cast<std::size_t>(confidence)];
}

const char* nameOf(BodyKind kind) {
  constexpr std::array kKinds{"unknown", "humanoid", "quadruped"};
  return kKinds[static_cast<std::size_t>(kind)];
}

}  // namespace sinew
