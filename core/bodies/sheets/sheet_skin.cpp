// core/bodies/sheets/sheet_skin.cpp: the bare surface as a tree of triangles and a grid of samples.
#include "core/bodies/sheets/sheet_skin.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/vector_relational.hpp>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/mesh_layers.h"
#include "sinew/surface/smoother.h"

namespace sinew {
namespace {

constexpr int kWantedTriangles = 40000;  ///< Of the refined body.
constexpr int kMostSheetDepth = 6;
constexpr float kClothCost = 0.03f;  ///< Skin so much farther away than cloth still counts, fraction of H.
constexpr float kLeastFacing = 0.1f;
constexpr float kSampleCell = 0.03f;  ///< Fraction of H.

int depthFor(std::size_t triangles) {
  const auto wanted =
      std::sqrt(static_cast<float>(kWantedTriangles) / static_cast<float>(std::max<std::size_t>(triangles, 1)));
  return std::clamp(static_cast<int>(std::lround(wanted)), 1, kMostSheetDepth);
}

/// The surface without muscles; none if it cannot be made.
Surface bareSurface(const std::shared_ptr<const Character>& character, const Rig& rig) {
  Rig bare;
  bare.character = rig.character;
  bare.layers = rig.layers;
  bare.smoothing.patch = rig.smoothing.patch;
  bare.smoothing.depth = depthFor(character->mesh.triangles.size());
  Smoother smoother(character);
  Surface surface;
  if (smoother.prepare(bare)) smoother.smooth(bindPose(character->skeleton), surface);
  return surface;
}

}  // namespace

SheetSkin::SheetSkin(std::shared_ptr<const Character> character, const Rig& rig)
    : character_(std::move(character)), cell_(kSampleCell * character_->height) {
  const Surface surface = bareSurface(character_, rig);
  const std::vector<SkinLayer> layers = layersOf(rig, *character_, guessLayers(*character_));
  if (!surface.refinement) return;
  const Refinement& refinement = *surface.refinement;
  std::vector<glm::vec3> areas(surface.positions.size(), glm::vec3(0.0f));
  for (std::size_t t = 0; t < refinement.triangles.size(); ++t) {
    const auto& [a, b, c] = refinement.triangles[t];
    const ControlTriangle& control = at(character_->mesh.triangles, refinement.controlOf[t]);
    const SkinLayer layer = layers.empty() ? SkinLayer::kSkin : at(layers, control.part);  // Made without parts.
    if (layer == SkinLayer::kRigid) continue;
    const TriangleCorners corners{at(surface.positions, a), at(surface.positions, b), at(surface.positions, c)};
    const glm::vec3 area = 0.5f * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float size = glm::length(area);
    if (!(size > 0.0f)) continue;
    corners_.push_back(corners);
    control_.push_back(refinement.controlOf[t]);
    cloth_.push_back(layer == SkinLayer::kCloth);
    normals_.push_back(area / size);
    for (const int corner : {a, b, c}) at(areas, corner) += area / 3.0f;
  }
  std::vector<int> numbers(corners_.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  tree_.emplace(corners_, numbers);
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (areas[v] == glm::vec3(0.0f)) continue;
    samples_[cellOf(cellAt(surface.positions[v]))].push_back({surface.positions[v], areas[v]});
  }
}

glm::ivec3 SheetSkin::cellAt(const glm::vec3& point) const { return glm::ivec3(glm::floor(point / cell_)); }

std::uint64_t SheetSkin::cellOf(const glm::ivec3& cell) const {
  const auto part = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) & 0x1FFFFFu; };
  return part(cell.x) | part(cell.y) << 21u | part(cell.z) << 42u;
}

int SheetSkin::nearestTriangle(const glm::vec3& point, const glm::vec3* outwards) const {
  if (!tree_) return -1;
  const float away = 10.0f * height();
  const NearestPoint found = tree_->nearest(point, 3.0f * away, [&](int t) {
    const float cloth = at(cloth_, t) ? kClothCost * height() : 0.0f;
    return outwards != nullptr && glm::dot(at(normals_, t), *outwards) < kLeastFacing ? away : cloth;
  });
  return found.triangle;
}

glm::vec3 SheetSkin::nearest(const glm::vec3& point, const glm::vec3& outwards) const {
  const int triangle = nearestTriangle(point, &outwards);
  if (triangle < 0) return point;
  return mixed(at(corners_, triangle), nearestOnTriangle(point, at(corners_, triangle)));
}

glm::vec3 SheetSkin::nearest(const glm::vec3& point) const {
  const int triangle = nearestTriangle(point, nullptr);
  if (triangle < 0) return point;
  return mixed(at(corners_, triangle), nearestOnTriangle(point, at(corners_, triangle)));
}

glm::vec3 SheetSkin::normalAround(const glm::vec3& point, float radius) const {
  const int nearest = nearestTriangle(point, nullptr);
  if (nearest < 0) return {0.0f, 1.0f, 0.0f};
  const glm::vec3& facing = at(normals_, nearest);
  glm::vec3 sum(0.0f);
  const glm::ivec3 low = cellAt(point - radius);
  const glm::ivec3 high = cellAt(point + radius);
  for (int x = low.x; x <= high.x; ++x) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int z = low.z; z <= high.z; ++z) {
        const auto cell = samples_.find(cellOf({x, y, z}));
        if (cell == samples_.end()) continue;
        for (const Sample& sample : cell->second) {
          if (glm::distance(sample.position, point) > radius || glm::dot(sample.areaNormal, facing) <= 0.0f) continue;
          // Fades to the border, so that the normal is continuous along the skin.
          const float share = 1.0f - glm::distance(sample.position, point) / radius;
          sum += share * sample.areaNormal;
        }
      }
    }
  }
  const float length = glm::length(sum);
  return length > 0.0f ? sum / length : facing;
}

std::map<int, float> SheetSkin::weightsAt(const glm::vec3& point) const {
  std::map<int, float> weights;
  const int triangle = nearestTriangle(point, nullptr);
  if (triangle < 0) return weights;
  const int control = at(control_, triangle);
  const auto& vertices = at(character_->mesh.triangles, control).vertices;
  const glm::vec3 shares = nearestOnTriangle(point, controlCorners(character_->mesh, control));
  for (int k = 0; k < 3; ++k) {
    for (const WeightedBinding follows : bindingsOf(*character_, vertices[toIndex(k)])) {
      weights[follows.bone()] += shares[k] * follows.weight;
    }
  }
  return weights;
}

}  // namespace sinew
