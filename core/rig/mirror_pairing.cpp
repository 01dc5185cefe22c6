// core/rig/mirror_pairing.cpp: which bones belong together.
#include "core/rig/mirror_pairing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "core/character/side_names.h"
#include "core/geometry/at.h"
#include "core/geometry/lower_case.h"

namespace sinew {
namespace {

// Fractions of H.
constexpr double kNamedReach = 0.25;   // Named pairs further from being opposite than this are not believed.
constexpr double kPlaceReach = 0.04;   // Bones paired by place lie this near to each other's image.
constexpr double kCenterReach = 0.02;  // Bones this near to the plane, origin and tip, may be center bones.

constexpr char kAnySide = '\x01';

// By name ---------------------------------------------------------------------------------------------------------

/// "b_leg01_015" -> "b_leg01".
std::string withoutNumber(std::string name) {
  while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.pop_back();
  while (!name.empty() && (name.back() == '_' || name.back() == '.' || name.back() == '-' || name.back() == ' ')) {
    name.pop_back();
  }
  return name;
}

struct SidedKey {
  std::string key;
  Side side = Side::kLeft;
};

std::string sideless(std::string_view name, const SideMarker& marker) {
  return std::string(name.substr(0, marker.begin)) + kAnySide + std::string(name.substr(marker.begin + marker.length));
}

/// A key for each marker, the bone's side in it left open.
std::vector<SidedKey> keysOf(std::string_view name, bool numbers) {
  std::vector<SidedKey> keys;
  for (const SideMarker& marker : sideMarkers(name)) {
    const std::string key = lowerCase(sideless(name, marker));
    keys.push_back({numbers ? key : withoutNumber(key), marker.side});
  }
  return keys;
}

/// One key for the whole path, if all its markers mean one side.
std::vector<SidedKey> pathKeysOf(const Bone& bone) {
  std::string key;
  std::optional<Side> side;
  std::string_view rest = bone.path;
  while (true) {
    const std::size_t slash = rest.find('/');
    std::string part(rest.substr(0, slash));
    std::vector<SideMarker> markers = sideMarkers(part);
    std::ranges::reverse(markers);
    for (const SideMarker& marker : markers) {
      if (side && *side != marker.side) return {};
      side = marker.side;
      part = sideless(part, marker);
    }
    key += withoutNumber(lowerCase(part)) + '/';
    if (slash == std::string_view::npos) break;
    rest.remove_prefix(slash + 1);
  }
  return side ? std::vector<SidedKey>{{key, *side}} : std::vector<SidedKey>{};
}

/// Pairs the bones that are alone with their key on either side.
template <class Keys>
void pairLevel(const Skeleton& skeleton, std::vector<bool>& taken, std::vector<std::array<int, 2>>& pairs, Keys keys) {
  std::map<std::string, std::array<std::vector<int>, 2>> sides;
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    if (taken[i]) continue;
    for (const SidedKey& key : keys(skeleton.bones[i])) {
      sides[key.key][static_cast<std::size_t>(key.side)].push_back(static_cast<int>(i));
    }
  }
  for (const auto& [key, bones] : sides) {
    if (bones[0].size() != 1 || bones[1].size() != 1) continue;
    const auto left = static_cast<std::size_t>(bones[0][0]);
    const auto right = static_cast<std::size_t>(bones[1][0]);
    if (left == right || taken[left] || taken[right]) continue;
    taken[left] = taken[right] = true;
    pairs.push_back({bones[0][0], bones[1][0]});
  }
}

// By place --------------------------------------------------------------------------------------------------------

/// Bind pose, world, in double as the plane is.
struct BoneEnds {
  glm::dvec3 origin;
  glm::dvec3 tip;
};

struct Placing {
  MirrorPlan& plan;
  std::vector<BoneEnds> ends;
  double height;

  [[nodiscard]] const Bone& bone(int index) const { return at(plan.skeleton.bones, index); }
  [[nodiscard]] const BoneEnds& endsOf(int index) const { return at(ends, index); }
  [[nodiscard]] bool isFree(int index) const { return at(plan.twinOf, index) < 0; }

  void pair(int a, int b, PairedBy by) {
    at(plan.twinOf, a) = b;
    at(plan.twinOf, b) = a;
    at(plan.pairedBy, a) = at(plan.pairedBy, b) = by;
  }
  /// How far two bones are from being mirror images; of H.
  [[nodiscard]] double misfit(int a, int b) const {
    const double origins = glm::distance(reflected(plan.plane, endsOf(a).origin), endsOf(b).origin);
    const double tips = glm::distance(reflected(plan.plane, endsOf(a).tip), endsOf(b).tip);
    return std::max(origins, tips) / height;
  }
  [[nodiscard]] double originMisfit(int a, int b) const {
    return glm::distance(reflected(plan.plane, endsOf(a).origin), endsOf(b).origin) / height;
  }
  [[nodiscard]] double originOffPlane(int a) const {
    return std::abs(distanceTo(plan.plane, endsOf(a).origin)) / height;
  }
  [[nodiscard]] double offPlane(int a) const {
    return std::max(std::abs(distanceTo(plan.plane, endsOf(a).origin)),
                    std::abs(distanceTo(plan.plane, endsOf(a).tip))) /
           height;
  }
};

std::vector<BoneEnds> endsOfBones(const Skeleton& skeleton) {
  std::vector<BoneEnds> ends;
  for (const Bone& bone : skeleton.bones) {
    const glm::dmat4 bind(bone.bindInWorld);
    ends.push_back({glm::dvec3(bind[3]), glm::dvec3(bind * glm::dvec4(glm::dvec3(bone.tip), 1.0))});
  }
  return ends;
}

bool saysASide(const Bone& bone) { return !sideMarkers(bone.name).empty(); }

/// Bones a and b may be counterparts in the tree: their parents are, or neither has one.
bool parentsAgree(const Placing& placing, int a, int b) {
  const int parentA = placing.bone(a).parent;
  const int parentB = placing.bone(b).parent;
  if (parentA < 0 || parentB < 0) return parentA == parentB;
  return at(placing.plan.twinOf, parentA) == parentB;
}

/// @param whole  the tip must lie in the plane too: what only begins there may be one of a pair.
void placeCenters(Placing& placing, bool whole) {
  for (int a = 0; a < static_cast<int>(placing.ends.size()); ++a) {
    if (!placing.isFree(a) || saysASide(placing.bone(a))) continue;
    if ((whole ? placing.offPlane(a) : placing.originOffPlane(a)) < kCenterReach) placing.pair(a, a, PairedBy::kCenter);
  }
}

struct Couple {
  double misfit = 0.0;
  int a = 0;
  int b = 0;
};

/// Pairs what fits best first. @param kin  only bones whose parents are counterparts.
bool placePairs(Placing& placing, bool kin) {
  std::vector<Couple> couples;
  for (int a = 0; a < static_cast<int>(placing.ends.size()); ++a) {
    if (!placing.isFree(a)) continue;
    for (int b = a + 1; b < static_cast<int>(placing.ends.size()); ++b) {
      if (!placing.isFree(b) || (kin && !parentsAgree(placing, a, b))) continue;
      const double misfit = placing.misfit(a, b);
      if (misfit < kPlaceReach) couples.push_back({misfit, a, b});
    }
  }
  std::ranges::sort(couples, [](const Couple& x, const Couple& y) {
    return std::tie(x.misfit, x.a, x.b) < std::tie(y.misfit, y.a, y.b);
  });
  bool any = false;
  for (const Couple& couple : couples) {
    if (!placing.isFree(couple.a) || !placing.isFree(couple.b)) continue;
    placing.pair(couple.a, couple.b, PairedBy::kPlace);
    any = true;
  }
  return any;
}

}  // namespace

std::vector<std::array<int, 2>> pairsByName(const Skeleton& skeleton) {
  std::vector<bool> taken(skeleton.bones.size(), false);
  std::vector<std::array<int, 2>> pairs;
  pairLevel(skeleton, taken, pairs, [](const Bone& bone) { return keysOf(bone.name, true); });
  pairLevel(skeleton, taken, pairs, [](const Bone& bone) { return keysOf(bone.name, false); });
  pairLevel(skeleton, taken, pairs, pathKeysOf);
  return pairs;
}

/// Pairs by name come first, unless the bones are far from opposite: a name that lies should not win against the
/// skeleton. The rest is paired by place. Center bones go first, so that none is paired with another one near the
/// plane; then the children of counterparts, best fit first, as long as a new pair makes its children eligible; bones
/// without such kin come last. docs/symmetry.md, The plane and the pairs.
void pairAll(MirrorPlan& plan, const std::vector<std::array<int, 2>>& named) {
  Placing placing{plan, endsOfBones(plan.skeleton), static_cast<double>(plan.characterHeight)};
  for (const auto& [left, right] : named) {
    if (placing.originMisfit(left, right) < kNamedReach) placing.pair(left, right, PairedBy::kName);
  }
  placeCenters(placing, true);
  while (placePairs(placing, true)) {
  }
  placePairs(placing, false);
  placeCenters(placing, false);
}

}  // namespace sinew
