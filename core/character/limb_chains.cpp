// core/character/limb_chains.cpp: from the trunk outwards, past twists and fingers.
#include "core/character/limb_chains.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "core/character/joint_roles.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kLooseFoot = 0.15f;     ///< Of H, level.
constexpr float kShortestLimb = 0.12f;  ///< Of H, of limbs without names.

/// Sum of the longest way down from a bone's joint.
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

/// The child that goes on with a limb.
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

/// A foot that follows a target of its own, hanging from the root below a limb's end.
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

/// Which way names say left is, along the normal.
float leftFromNames(const SlotSearch& search, const glm::vec3& normal) {
  float sum = 0.0f;
  for (std::size_t i = 0; i < search.names.size(); ++i) {
    if (!search.names[i].side) continue;
    const float along = glm::dot(search.joints[i] - search.joints[0], normal);
    sum += *search.names[i].side == Side::kLeft ? along : -along;
  }
  return sum;
}

/// Sides that only names say, in words that mirror planes do not read: the twin has the same key as deep in the tree.
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

}  // namespace sinew
