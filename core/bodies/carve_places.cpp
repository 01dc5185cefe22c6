// core/bodies/carve_places.cpp: the lowest places of what is left, smoothed, and the hollows around them.
#include "core/bodies/carve_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {
namespace {

// Fractions of H.
constexpr float kSmoothWidth = 0.012f;  ///< Standard deviation.
constexpr float kSmoothReach = 0.03f;
constexpr float kHollowReach = 0.09f;
constexpr float kHollowWidth = 0.035f;
constexpr float kLeastHollow = 0.0004f;
constexpr float kNarrowestCarve = 0.012f;
constexpr float kWidestCarve = 0.09f;
constexpr float kThinnestCarve = 0.008f;
constexpr float kThickestCarve = 0.03f;

constexpr float kCarveAmount = 0.4f;
constexpr float kCarveReach = 1.35f;
constexpr float kLeastTerritory = 0.05f;  ///< Of the skin weights over the hollow.

class CarvePlaces {
 public:
  CarvePlaces(const SkinPoints& points, std::span<const float> left, const Character& character)
      : points_(points), left_(left), character_(character), height_(character.height) {
    for (std::size_t v = 0; v < left.size(); ++v) cells_[cellOf(points.positions[v])].push_back(static_cast<int>(v));
    for (std::size_t v = 0; v < left.size(); ++v) depth_.push_back(left[v] == 0.0f ? 0.0f : smoothedAt(v));
  }

  /// The deepest hollow that is still free; takes it. @param allowed  (vertex)
  template <class Allowed>
  std::optional<Primitive> next(Allowed allowed) {
    std::optional<std::size_t> deepest;
    for (std::size_t v = 0; v < depth_.size(); ++v) {
      if (allowed(points_.positions[v]) && (!deepest || depth_[v] > depth_[*deepest])) deepest = v;
    }
    if (!deepest || !(depth_[*deepest] > kLeastHollow * height_)) return std::nullopt;
    const std::size_t v = *deepest;
    const Primitive carve = carveAt(v);
    const float apart = 0.5f * (carve.placement.radii.x + carve.placement.radii.y) * scaleOf(carve);
    forEachNear(points_.positions[v], kHollowReach * height_, [&](std::size_t u) {
      if (glm::distance(points_.positions[u], points_.positions[v]) < apart) depth_[u] = 0.0f;
    });
    depth_[v] = 0.0f;
    return carve;
  }

 private:
  using Cell = std::array<int, 3>;

  [[nodiscard]] Cell cellOf(const glm::vec3& p) const {
    const glm::vec3 cell = glm::floor(p / (kSmoothReach * height_));
    return {static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)};
  }

  /// Vertices in the cells within a reach; some are farther.
  template <class Visit>
  void forEachNear(const glm::vec3& p, float reach, Visit visit) const {
    const Cell low = cellOf(p - reach);
    const Cell high = cellOf(p + reach);
    for (int x = low[0]; x <= high[0]; ++x) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int z = low[2]; z <= high[2]; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (const int v : found->second) visit(toIndex(v));
        }
      }
    }
  }

  /// Mean depth of the sculpt below the skin around a vertex, of skin that faces the same way.
  [[nodiscard]] float smoothedAt(std::size_t v) const {
    float sum = 0.0f;
    float whole = 0.0f;
    forEachNear(points_.positions[v], kSmoothReach * height_, [&](std::size_t u) {
      const float far = glm::distance(points_.positions[u], points_.positions[v]) / (kSmoothWidth * height_);
      const float share = std::exp(-0.5f * far * far) * points_.areas[u] *
                          std::max(glm::dot(points_.normals[u], points_.normals[v]), 0.0f);
      sum -= share * left_[u];
      whole += share;
    });
    return whole > 0.0f ? sum / whole : 0.0f;
  }

  [[nodiscard]] float scaleOf(const Primitive& carve) const {
    const auto bone = character_.skeleton.findBone(carve.bone);
    const glm::mat3 axes(at(character_.skeleton.bones, *bone).bindInWorld);
    return std::cbrt(std::abs(glm::determinant(axes)));
  }

  [[nodiscard]] Primitive carveAt(std::size_t v) const {
    const glm::vec3 n = points_.normals[v];
    const glm::vec3 side = glm::normalize(std::abs(n.y) < 0.9f ? glm::cross(n, glm::vec3(0.0f, 1.0f, 0.0f))
                                                               : glm::cross(n, glm::vec3(1.0f, 0.0f, 0.0f)));
    const glm::vec3 along = glm::cross(n, side);
    std::vector<std::pair<std::size_t, float>> hollow;
    glm::vec3 middle(0.0f);
    float whole = 0.0f;
    forEachNear(points_.positions[v], kHollowReach * height_, [&](std::size_t u) {
      const float far = glm::distance(points_.positions[u], points_.positions[v]) / (kHollowWidth * height_);
      if (glm::dot(points_.normals[u], n) < 0.2f || !(-left_[u] > 0.25f * depth_[v])) return;
      const float share = -left_[u] * points_.areas[u] * std::exp(-0.5f * far * far);
      hollow.emplace_back(u, share);
      middle += share * points_.positions[u];
      whole += share;
    });
    if (whole > 0.0f) middle /= whole;
    // Second moments in the tangent plane: their axes.
    float xx = 0.0f;
    float xy = 0.0f;
    float yy = 0.0f;
    std::vector<float> weights(character_.skeleton.bones.size(), 0.0f);
    for (const auto& [u, share] : hollow) {
      const glm::vec3 q = points_.positions[u] - middle;
      const float x = glm::dot(q, side);
      const float y = glm::dot(q, along);
      xx += share / whole * x * x;
      xy += share / whole * x * y;
      yy += share / whole * y * y;
      for (const Influence& influence : character_.mesh.influencesOf(static_cast<int>(u))) {
        at(weights, at(character_.skeleton.bindings, influence.binding).bone) += share / whole * influence.weight;
      }
    }
    const float turn = 0.5f * std::atan2(2.0f * xy, xx - yy);
    const float middleOfBoth = 0.5f * (xx + yy);
    const float spread = std::hypot(0.5f * (xx - yy), xy);
    const glm::vec3 longAxis = std::cos(turn) * side + std::sin(turn) * along;
    const auto radius = [&](float square) {
      return std::clamp(1.7f * std::sqrt(std::max(square, 0.0f)), kNarrowestCarve * height_, kWidestCarve * height_);
    };
    Placement world;
    world.radii = {radius(middleOfBoth - spread), radius(middleOfBoth + spread), 0.0f};
    world.radii.z = std::clamp(0.7f * world.radii.x, kThinnestCarve * height_, kThickestCarve * height_);
    world.rotation = glm::normalize(glm::quat_cast(glm::mat3(glm::cross(longAxis, n), longAxis, n)));
    world.center = points_.positions[v] + n * (left_[v] + depth_[v] - 0.5f * world.radii.z);
    Primitive carve;
    carve.sign = -1;
    carve.amount = kCarveAmount;
    carve.reach = kCarveReach;
    const auto bone = std::ranges::max_element(weights) - weights.begin();
    carve.bone = character_.skeleton.fileName(static_cast<int>(bone));
    carve.territory.emplace();
    for (std::size_t b = 0; b < weights.size(); ++b) {
      if (weights[b] >= kLeastTerritory) carve.territory->push_back(character_.skeleton.fileName(static_cast<int>(b)));
    }
    const glm::dmat4 toBone =
        glm::inverse(glm::dmat4(at(character_.skeleton.bones, static_cast<int>(bone)).bindInWorld));
    carve.placement = imageOf(world, {glm::dmat3(toBone), glm::dvec3(toBone[3])});
    return carve;
  }

  const SkinPoints& points_;
  std::span<const float> left_;
  const Character& character_;
  float height_;
  std::map<Cell, std::vector<int>> cells_;
  std::vector<float> depth_;  ///< [V] smoothed; 0: taken, or not known.
};

}  // namespace

Rig withCarves(Rig rig, int count, const SkinPoints& points, std::span<const float> left, const Character& character,
               const MirrorPlan* plan) {
  CarvePlaces places(points, left, character);
  const auto isAllowed = [&](const glm::vec3& p) { return !plan || distanceTo(plan->plane, glm::dvec3(p)) >= 0.0; };
  std::string group;
  for (int i = 0; i < count; ++i) {
    std::optional<Primitive> carve = places.next(isAllowed);
    if (!carve) break;
    if (group.empty()) {
      group = freeGroupName(rig, "carves");
      rig.groups.push_back({group, {}, {}});
    }
    carve->group = group;
    carve->name = freePrimitiveName(rig, "carve");
    Result<Rig> added = plan ? addPair(rig, *carve, *plan) : addPrimitive(rig, *carve);
    if (!added && plan) added = addPrimitive(rig, *carve);  // Its bone has no counterpart.
    if (!added) break;
    rig = std::move(added).value();
  }
  return rig;
}

}  // namespace sinew
