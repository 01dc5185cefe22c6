// core/rig/mirror_plan.cpp: finds the mirror plane of a character and the counterpart of each bone.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/character/bone_names.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/mirror.h"

namespace sinew {
namespace {

// Fractions of H.
constexpr double kNamedReach = 0.25;   // Largest distance of a bone from the image of its counterpart by name.
constexpr double kPlaceReach = 0.04;   // The same for counterparts by place.
constexpr double kCenterReach = 0.02;  // Largest distance of center bones from the plane.
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

/// A key for each marker, with the side replaced.
std::vector<SidedKey> keysOf(std::string_view name, bool numbers) {
  std::vector<SidedKey> keys;
  for (const SideMarker& marker : sideMarkers(name)) {
    const std::string key = lowerCase(sideless(name, marker));
    keys.push_back({numbers ? key : withoutNumber(key), marker.side});
  }
  return keys;
}

/// One key for the whole path, if all its markers are of one side.
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

/// Pairs bones whose key is unique on either side.
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

/// Bind pose, world.
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
  /// Distance of two bones from being mirror images, fraction of H.
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

bool hasSide(const Bone& bone) { return !sideMarkers(bone.name).empty(); }

/// The parents of bones a and b are counterparts, or both are roots.
bool parentsAgree(const Placing& placing, int a, int b) {
  const int parentA = placing.bone(a).parent;
  const int parentB = placing.bone(b).parent;
  if (parentA < 0 || parentB < 0) return parentA == parentB;
  return at(placing.plan.twinOf, parentA) == parentB;
}

/// @param whole  the tip must lie in the plane, too: otherwise the bone may be one of a pair
void placeCenters(Placing& placing, bool whole) {
  for (int a = 0; a < static_cast<int>(placing.ends.size()); ++a) {
    if (!placing.isFree(a) || hasSide(placing.bone(a))) continue;
    if ((whole ? placing.offPlane(a) : placing.originOffPlane(a)) < kCenterReach) placing.pair(a, a, PairedBy::kCenter);
  }
}

struct Couple {
  double misfit = 0.0;
  int a = 0;
  int b = 0;
};

/// Pairs bones by place, the best fit first. @param kin  only bones whose parents are counterparts
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

/// {left, right} bone indices, one to one, by names that are equal except for the side marker, then also for the number
/// at the end, then with the marker in the name of an ancestor. Ambiguous names are left out.
std::vector<std::array<int, 2>> pairsByName(const Skeleton& skeleton) {
  std::vector<bool> taken(skeleton.bones.size(), false);
  std::vector<std::array<int, 2>> pairs;
  pairLevel(skeleton, taken, pairs, [](const Bone& bone) { return keysOf(bone.name, true); });
  pairLevel(skeleton, taken, pairs, [](const Bone& bone) { return keysOf(bone.name, false); });
  pairLevel(skeleton, taken, pairs, pathKeysOf);
  return pairs;
}

/// Fills twinOf and pairedBy of a plan with a plane. Pairs by name come first, unless the bones are far from opposite.
/// The rest is paired by place: center bones first, so that none is paired with another one near the plane; then
/// children of counterparts, as long as new pairs make their children eligible; then all others. docs/muscles.md, The
/// plane and the pairs.
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

// All lengths are fractions of H.
constexpr double kGridCell = 0.02;
constexpr std::size_t kMirrorPlanSamples = 2000;
constexpr double kMisfitCap = 0.06;      // Largest misfit of a vertex.
constexpr double kSymmetric = 0.025;     // Largest mean misfit of skin and bones of a symmetric character.
constexpr double kNoticeable = 0.0015;   // Improvement of the misfit that makes up for a less simple plane.
constexpr double kShortestPair = 0.005;  // Shortest distance between paired bones that gives a direction.
constexpr double kNearAxis = 0.9962;     // Cosine of 5 degrees.

glm::dvec3 originOf(const Bone& bone) { return glm::dvec3(bone.bindInWorld[3]); }

/// Vertices by grid cells, to find those near a point.
class VertexGrid {
 public:
  VertexGrid(const std::vector<glm::vec3>& points, double cell) : points_(points), cell_(cell) {
    for (std::size_t i = 0; i < points.size(); ++i) cells_[keyOf(cellOf(points[i]))].push_back(static_cast<int>(i));
  }

  /// Distance to the nearest vertex, at most `cap`.
  [[nodiscard]] double nearest(const glm::dvec3& point, double cap) const {
    const std::array<long long, 3> center = cellOf(point);
    const auto shells = static_cast<long long>(std::ceil(cap / cell_));
    double best = cap;
    // A vertex in shell n is at least n - 1 cells away.
    for (long long shell = 0; shell <= shells && best > cell_ * static_cast<double>(shell - 1); ++shell) {
      for (long long x = -shell; x <= shell; ++x) {
        for (long long y = -shell; y <= shell; ++y) {
          const bool isSide = std::max(std::abs(x), std::abs(y)) == shell;
          for (long long z = -shell; z <= shell; z += isSide ? 1 : 2 * shell) {
            best = std::min(best, nearestInCell({center[0] + x, center[1] + y, center[2] + z}, point));
          }
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] double nearestInCell(const std::array<long long, 3>& cell, const glm::dvec3& point) const {
    double best = std::numeric_limits<double>::infinity();
    const auto found = cells_.find(keyOf(cell));
    if (found == cells_.end()) return best;
    for (const int i : found->second) best = std::min(best, glm::distance(glm::dvec3(at(points_, i)), point));
    return best;
  }
  [[nodiscard]] std::array<long long, 3> cellOf(const glm::dvec3& point) const {
    return {std::llround(point.x / cell_), std::llround(point.y / cell_), std::llround(point.z / cell_)};
  }
  static std::uint64_t keyOf(const std::array<long long, 3>& cell) {
    std::uint64_t key = 0;
    for (const long long part : cell) key = (key << 21) ^ (static_cast<std::uint64_t>(part) & 0x1FFFFFu);
    return key;
  }

  const std::vector<glm::vec3>& points_;
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

struct Finder {
  const Character& character;
  double height;
  std::vector<std::array<int, 2>> named;
  VertexGrid grid;

  explicit Finder(const Character& of)
      : character(of),
        height(static_cast<double>(of.height)),
        named(pairsByName(of.skeleton)),
        grid(of.mesh.positions, kGridCell * static_cast<double>(of.height)) {}

  [[nodiscard]] const Bone& bone(int index) const { return at(character.skeleton.bones, index); }
};

// Candidates ------------------------------------------------------------------------------------------------------

/// The common direction between named pairs, if there is one.
std::optional<glm::dvec3> acrossNamedPairs(const Finder& finder) {
  glm::dvec3 sum(0.0);
  double lengths = 0.0;
  for (const auto& [left, right] : finder.named) {
    const glm::dvec3 apart = originOf(finder.bone(left)) - originOf(finder.bone(right));
    if (!(glm::length(apart) > kShortestPair * finder.height)) continue;
    sum += apart;
    lengths += glm::length(apart);
  }
  if (!(glm::length(sum) > 0.7 * lengths) || lengths == 0.0) return std::nullopt;
  return glm::normalize(sum);
}

/// Candidate normals, the simplest first. With named pairs only their direction, after an axis close to it.
std::vector<glm::dvec3> normals(const Finder& finder) {
  constexpr std::array<glm::dvec3, 3> axes = {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0)};
  const std::optional<glm::dvec3> across = acrossNamedPairs(finder);
  if (!across) return {axes.begin(), axes.end()};
  std::vector<glm::dvec3> result;
  for (const glm::dvec3& axis : axes) {
    if (std::abs(glm::dot(axis, *across)) > kNearAxis) result.push_back(axis);
  }
  result.push_back(*across);
  return result;
}

double middleOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Candidate offsets for a normal, simplest first: of the origin, the root, the middles of named pairs and of the skin.
std::vector<double> offsets(const Finder& finder, const glm::dvec3& normal) {
  std::vector<double> result{0.0};
  if (!finder.character.skeleton.bones.empty()) result.push_back(glm::dot(normal, originOf(finder.bone(0))));
  std::vector<double> middles;
  for (const auto& [left, right] : finder.named) {
    middles.push_back(0.5 * glm::dot(normal, originOf(finder.bone(left)) + originOf(finder.bone(right))));
  }
  if (!middles.empty()) result.push_back(middleOf(middles));
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const glm::vec3& position : finder.character.mesh.positions) {
    low = std::min(low, glm::dot(normal, glm::dvec3(position)));
    high = std::max(high, glm::dot(normal, glm::dvec3(position)));
  }
  if (high >= low) result.push_back(0.5 * (low + high));
  return result;
}

// Their fit -------------------------------------------------------------------------------------------------------

/// @param most  stops when the misfit reaches this
double skinMisfit(const Finder& finder, const MirrorPlane& plane, double most) {
  const std::vector<glm::vec3>& positions = finder.character.mesh.positions;
  if (positions.empty()) return 0.0;
  const std::size_t stride = (positions.size() + kMirrorPlanSamples - 1) / kMirrorPlanSamples;
  const auto count = static_cast<int>((positions.size() + stride - 1) / stride);
  double sum = 0.0;
  for (std::size_t i = 0; i < positions.size(); i += stride) {
    sum += finder.grid.nearest(reflected(plane, glm::dvec3(positions[i])), kMisfitCap * finder.height);
    if (sum / count / finder.height >= most) break;
  }
  return sum / count / finder.height;
}

/// Mean distance of bones from the images of their counterparts by name, or else of the nearest bones.
double boneMisfit(const Finder& finder, const MirrorPlane& plane) {
  const std::vector<Bone>& bones = finder.character.skeleton.bones;
  const double cap = kMisfitCap * finder.height;
  double sum = 0.0;
  int count = 0;
  for (const auto& [left, right] : finder.named) {
    const glm::dvec3 image = reflected(plane, originOf(finder.bone(left)));
    sum += std::min(cap, glm::distance(image, originOf(finder.bone(right))));
    ++count;
  }
  if (count == 0) {
    for (const Bone& bone : bones) {
      const glm::dvec3 image = reflected(plane, originOf(bone));
      double nearest = cap;
      for (const Bone& other : bones) nearest = std::min(nearest, glm::distance(image, originOf(other)));
      sum += nearest;
      ++count;
    }
  }
  return count > 0 ? sum / count / finder.height : 0.0;
}

struct Found {
  MirrorPlane plane;
  double misfit = std::numeric_limits<double>::infinity();
};

/// Tries each candidate normal with each candidate offset. The misfit is the mean distance of the images of skin
/// samples and bones from the nearest ones, each limited so that a bag on one shoulder does not matter. Simple planes
/// are preferred unless another fits noticeably better: in a plane through the origin normal to an axis, mirrored
/// numbers are the originals with other signs. docs/muscles.md, The plane and the pairs.
Found bestPlane(const Finder& finder) {
  Found best;
  for (const glm::dvec3& normal : normals(finder)) {
    std::vector<double> tried;
    for (const double offset : offsets(finder, normal)) {
      if (std::ranges::find(tried, offset) != tried.end()) continue;
      tried.push_back(offset);
      const MirrorPlane plane{normal, offset};
      const double most = best.misfit - kNoticeable;
      const double misfit = skinMisfit(finder, plane, most) + boneMisfit(finder, plane);
      if (misfit < most) best = {plane, misfit};
    }
  }
  return best;
}

MirrorPlan emptyPlan(const Skeleton& skeleton, float height) {
  MirrorPlan plan;
  plan.twinOf.assign(skeleton.bones.size(), -1);
  plan.pairedBy.assign(skeleton.bones.size(), PairedBy::kNothing);
  plan.mirrors.assign(skeleton.bones.size(), std::nullopt);
  plan.skeleton = skeleton;
  plan.characterHeight = height;
  return plan;
}

}  // namespace

MirrorPlan pairBones(const Skeleton& skeleton, const MirrorPlane& plane, float characterHeight) {
  MirrorPlan plan = emptyPlan(skeleton, characterHeight);
  plan.plane = plane;
  pairAll(plan, pairsByName(skeleton));
  for (std::size_t i = 0; i < plan.twinOf.size(); ++i) {
    if (plan.twinOf[i] < 0) continue;
    const Bone& twin = at(skeleton.bones, plan.twinOf[i]);
    plan.mirrors[i] = boneMirror(skeleton.bones[i].bindInWorld, twin.bindInWorld, plane);
  }
  // Flat bones and their counterparts cannot be mirrored.
  for (std::size_t i = 0; i < plan.twinOf.size(); ++i) {
    if (plan.twinOf[i] < 0 || plan.mirrors[i]) continue;
    plan.twinOf[i] = -1;
    plan.pairedBy[i] = PairedBy::kNothing;
  }
  return plan;
}

MirrorPlan makeMirrorPlan(const Character& character) {
  const Finder finder(character);
  const Found found = bestPlane(finder);
  if (found.misfit > kSymmetric && finder.named.empty()) return emptyPlan(character.skeleton, character.height);
  return pairBones(character.skeleton, found.plane, character.height);
}

}  // namespace sinew
