// core/character/limb_parts.cpp: the best way to lay a limb's parts over its bones, in order, by names and proportions.
#include "core/character/limb_parts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kShortPart = 0.04f;  ///< Of H: shorter is no upper or lower part of a limb.
constexpr float kNever = -1e6f;

/// One limb against one list of parts.
struct Laying {
  const SlotSearch& search;
  const LimbChain& chain;
  std::span<const Slot> parts;

  [[nodiscard]] const BoneName& name(std::size_t i) const { return at(search.names, chain.bones[i]); }
  [[nodiscard]] float lateral(std::size_t i) const {
    return std::abs(glm::dot(at(search.joints, chain.bones[i]), search.left) - search.middle);
  }
  /// The second half of a bone that is split along its length has the name of the first.
  [[nodiscard]] bool goesOn(std::size_t i) const {
    return i > 0 && !name(i).key.empty() && name(i).key == name(i - 1).key && !name(i).digit;
  }
  [[nodiscard]] bool isSideways(std::size_t i) const {
    const glm::vec3 along = chain.segment(i, search);
    return std::abs(along.y) < 0.5f * glm::length(along);
  }
  /// Bones from here on that may be parts.
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
  [[nodiscard]] float shape(std::size_t i, Slot slot) const;
  [[nodiscard]] float taken(std::size_t i, Slot slot) const {
    if (name(i).helper || name(i).digit) return kNever;
    return 1.0f + static_cast<float>(nameFits(name(i), slot)) + shape(i, slot);
  }
};

/// What proportions say, beside the order alone.
float Laying::shape(std::size_t i, Slot slot) const {
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

}  // namespace

std::vector<SlotBone> partsOfLimb(const SlotSearch& search, const LimbChain& chain, std::span<const Slot> parts) {
  const Laying laying{search, chain, parts};
  const std::size_t bones = chain.bones.size();
  // score[i][j]: the best for the bones from i on and the parts from j on.
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

}  // namespace sinew
