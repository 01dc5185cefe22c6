// core/bodies/cloth_check.cpp: compares each cloth vertex with a tree of the skin's triangles in every pose.
#include "core/bodies/cloth_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/triangle_tree.h"
#include "core/rig/mesh_layers.h"
#include "sinew/geometry/geometry.h"
#include "sinew/surface/smoother.h"

namespace sinew {

namespace {

constexpr std::size_t kDirections = 256;

/// Evenly spread: a spiral that advances by the golden angle.
std::array<glm::vec3, kDirections> spreadDirections() {
  std::array<glm::vec3, kDirections> out;
  const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double y = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(kDirections);
    const double radius = std::sqrt(1.0 - y * y);
    const double angle = turn * static_cast<double>(i);
    out[i] = glm::vec3(glm::dvec3(radius * std::cos(angle), y, radius * std::sin(angle)));
  }
  return out;
}

}  // namespace

bool isSeen(const TriangleTree& triangles, const glm::vec3& place, const glm::vec3& normal, float off) {
  static const std::array<glm::vec3, kDirections> kAround = spreadDirections();
  const glm::vec3 unit = normalizeOr(normal, glm::vec3(0.0f));
  const glm::vec3 from = place + off * unit;
  for (const glm::vec3& direction : kAround) {
    if (glm::dot(direction, unit) > 0.0f && !triangles.isMetBy(from, direction)) return true;
  }
  return false;
}

namespace {

constexpr float kInsideBody = 0.5f;  ///< Winding number.

std::vector<int> clothVertices(const ControlMesh& mesh, const MeshLayers& layers, const Refinement& refinement) {
  std::vector<int> out;
  const auto take = [&](int carrier, int first, int end) {
    for (int v = first; v < end && at(layers.carriers, carrier) == SkinLayer::kCloth; ++v) out.push_back(v);
  };
  const int vertices = refinement.controlVertices;
  for (int v = 0; v < vertices; ++v) take(v, v, v + 1);
  for (int e = 0; e < refinement.controlEdges; ++e) {
    take(vertices + e, at(refinement.edgeBegin, e), at(refinement.edgeBegin, e + 1));
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    take(vertices + refinement.controlEdges + t, at(refinement.insideBegin, t), at(refinement.insideBegin, t + 1));
  }
  return out;
}

TriangleCorners cornersIn(const Surface& surface, int triangle) {
  const std::array<int, 3>& t = at(surface.refinement->triangles, triangle);
  return {at(surface.positions, t[0]), at(surface.positions, t[1]), at(surface.positions, t[2])};
}

glm::vec3 faceNormal(const TriangleCorners& c) {
  return normalizeOr(glm::cross(c[1] - c[0], c[2] - c[0]), glm::vec3(0.0f));
}

TriangleTree treeOf(const Surface& surface, std::span<const int> triangles) {
  std::vector<TriangleCorners> corners;
  for (const int t : triangles) corners.push_back(cornersIn(surface, t));
  return {corners, triangles};
}

/// [V'] angle-weighted vertex normals, whose sign separates inside from outside (Baerentzen and Aanaes 2005).
std::vector<glm::vec3> vertexNormals(const Surface& surface, std::span<const int> triangles) {
  std::vector<glm::vec3> normals(surface.positions.size(), glm::vec3(0.0f));
  for (const int t : triangles) {
    const TriangleCorners c = cornersIn(surface, t);
    const glm::vec3 face = faceNormal(c);
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 a = normalizeOr(c[(k + 1) % 3] - c[k], face);
      const glm::vec3 b = normalizeOr(c[(k + 2) % 3] - c[k], face);
      at(normals, at(surface.refinement->triangles, t)[k]) += std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f)) * face;
    }
  }
  return normals;
}

/// [T'] triangle across each edge, or -1.
std::vector<std::array<int, 3>> acrossEdges(const Refinement& refinement, std::span<const int> triangles) {
  std::vector<std::array<int, 3>> across(refinement.triangles.size(), {-1, -1, -1});
  std::map<std::array<int, 2>, std::array<int, 2>> open;  // Edge to triangle and corner.
  for (const int t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::array<int, 3>& v = at(refinement.triangles, t);
      const int a = at(v, k);
      const int b = at(v, (k + 1) % 3);
      const auto [found, isNew] = open.try_emplace({std::min(a, b), std::max(a, b)}, std::array{t, k});
      if (isNew) continue;
      at(at(across, t), k) = found->second[0];
      at(at(across, found->second[0]), found->second[1]) = t;
    }
  }
  return across;
}

std::vector<int> upTo(std::size_t count) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Finds out whether a viewer would notice cloth below the skin.
class ClothSight {
 public:
  ClothSight(const Surface& surface, std::span<const int> skin)
      : all_(treeOf(surface, upTo(surface.refinement->triangles.size()))), skin_(treeOf(surface, skin)) {}

  /// The cloth is inside the body, and the skin over it is visible.
  [[nodiscard]] bool shows(const ClothSunk& sunk, const glm::vec3& cloth, float off) const {
    return skin_.windingAt(cloth) > kInsideBody && isSeen(all_, sunk.place, sunk.normal, off);
  }

 private:
  TriangleTree all_;  ///< Every part hides what is behind it.
  TriangleTree skin_;
};

}  // namespace

ClothMeter::ClothMeter(const ControlMesh& mesh, const MeshLayers& layers, const Surface& bind, float height)
    : height_(height), cloth_(clothVertices(mesh, layers, *bind.refinement)), bind_(bind.positions) {
  const std::size_t first = mesh.positions.size() + mesh.edges.size();
  const int triangles = static_cast<int>(bind.refinement->triangles.size());
  for (int i = 0; i < triangles; ++i) {
    bindFaces_.push_back(faceNormal(cornersIn(bind, i)));
    if (layers.carriers[first + toIndex(at(bind.refinement->controlOf, i))] == SkinLayer::kSkin) skin_.push_back(i);
  }
  across_ = acrossEdges(*bind.refinement, skin_);
  const TriangleTree tree = treeOf(bind, skin_);
  for (const int v : cloth_) {
    const NearestPoint found = tree.nearest(at(bind_, v), kClothReach * height_);
    under_.push_back(found.triangle < 0 ? glm::vec3(0.0f) : at(bindFaces_, found.triangle));
  }
}

std::vector<ClothSunk> ClothMeter::below(const Surface& surface) const {
  std::vector<ClothSunk> out(cloth_.size());
  const TriangleTree tree = treeOf(surface, skin_);
  const std::vector<glm::vec3> normals = vertexNormals(surface, skin_);
  const float within = kClothSunk * height_;
  forEachIndex(out.size(), 256, [&](std::size_t i) {
    const glm::vec3& p = at(surface.positions, cloth_[i]);
    const auto extraOfOtherSkin = [&](int triangle) {
      const glm::vec3& corner = at(bind_, at(surface.refinement->triangles, triangle)[0]);
      const bool isUnder = glm::distance(corner, at(bind_, cloth_[i])) <= kClothReach * height_ &&
                           glm::dot(at(bindFaces_, triangle), under_[i]) > 0.0f;
      return isUnder ? 0.0f : 2.0f * within;
    };
    const NearestPoint found = tree.nearest(p, within, extraOfOtherSkin);
    if (found.triangle < 0) return;
    const TriangleCorners c = cornersIn(surface, found.triangle);
    const glm::vec3& s = found.shares;
    glm::vec3 normal = faceNormal(c);
    for (int k = 0; k < 3; ++k) {
      if (s[k] == 1.0f) normal = at(normals, at(at(surface.refinement->triangles, found.triangle), k));
      const int other = at(at(across_, found.triangle), k);
      const bool isOnEdge = s[(k + 2) % 3] == 0.0f && s[k] > 0.0f && s[(k + 1) % 3] > 0.0f;
      if (isOnEdge && other >= 0) normal += faceNormal(cornersIn(surface, other));
    }
    if (glm::dot(p - mixed(c, s), normal) < 0.0f) out[i] = {found.distance, mixed(c, s), normal};
  });
  return out;
}

Result<ClothCount> countClothBelow(const std::shared_ptr<const Character>& character, const Rig& rig,
                                   std::span<const Pose> poses) {
  ClothCount count;
  const MeshLayers layers = meshLayers(*character, layersOf(rig, *character, guessLayers(*character)));
  if (!layers.hasCloth()) return count;
  Smoother lifted(character);
  Rig whole = rig;
  whole.smoothing.detail = DetailKind::kUniform;
  if (auto prepared = lifted.prepare(whole); !prepared) return prepared.error();
  Smoother bare(character);  // The same mesh with every muscle hidden, so that vertices correspond.
  if (auto prepared = bare.prepare(whole, upTo(whole.primitives.size())); !prepared) return prepared.error();
  Surface surface;
  bare.smooth(bindPose(character->skeleton), surface);
  const ClothMeter meter(character->mesh, layers, surface, character->height);
  count.vertices = static_cast<int>(meter.cloth().size());
  const float least = kClothBelow * character->height;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!bare.smooth(poses[i], surface)) continue;
    const std::vector<ClothSunk> before = meter.below(surface);
    lifted.smooth(poses[i], surface);
    const std::vector<ClothSunk> after = meter.below(surface);
    std::optional<ClothSight> sight;
    for (std::size_t v = 0; v < after.size(); ++v) {
      if (before[v].depth > least) ++count.bare;
      if (!(after[v].depth > least)) continue;
      ++count.below;
      if (before[v].depth > least) continue;
      ++count.more;
      if (!sight) sight.emplace(surface, meter.skin());
      if (after[v].depth - before[v].depth > least &&
          sight->shows(after[v], at(surface.positions, meter.cloth()[v]), least)) {
        ++count.seen;
        count.lastSeen = static_cast<int>(i);
      }
      if (after[v].depth / character->height <= count.deepest) continue;
      count.deepest = after[v].depth / character->height;
      count.worst = static_cast<int>(i);
    }
  }
  return count;
}

}  // namespace sinew
