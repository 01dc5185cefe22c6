// app/viewport/render/occlusion.cpp: the body as voxels, and rays that leave it.
#include "app/viewport/render/occlusion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "core/surface/patches/patch.h"

namespace sinew::app {
namespace {

constexpr int kCells = 56;      ///< Along the longest side of the body.
constexpr int kRays = 80;       ///< Over the whole sphere; half of them leave a surface.
constexpr int kMostSteps = 19;  ///< Cells a ray goes: a third of the body.
constexpr float kStart = 2.1f;  ///< Cells above the surface where a ray starts: out of the body's own shell.
constexpr int kSmoothings = 2;

/// A box of cells, those that the surface passes through set.
class Voxels {
 public:
  explicit Voxels(const Bounds& bounds) {
    const glm::vec3 extent = bounds.extent();
    cell_ = std::max({extent.x, extent.y, extent.z, 1e-20f}) / static_cast<float>(kCells);
    low_ = bounds.low - cell_;
    for (int axis = 0; axis < 3; ++axis) count_[axis] = static_cast<int>(std::ceil(extent[axis] / cell_)) + 3;
    set_.assign(
        static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) * static_cast<std::size_t>(count_.z),
        0);
  }

  [[nodiscard]] float cell() const { return cell_; }
  /// In cells from the low corner.
  [[nodiscard]] glm::vec3 inCells(const glm::vec3& world) const { return (world - low_) / cell_; }
  [[nodiscard]] bool isInside(const glm::ivec3& c) const {
    return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < count_.x && c.y < count_.y && c.z < count_.z;
  }
  [[nodiscard]] bool at(const glm::ivec3& c) const { return set_[indexOf(c)] != 0; }
  void mark(const glm::vec3& cells) {
    const glm::ivec3 c(cells);
    if (isInside(c)) set_[indexOf(c)] = 1;
  }

 private:
  [[nodiscard]] std::size_t indexOf(const glm::ivec3& c) const {
    return static_cast<std::size_t>(c.x) +
           static_cast<std::size_t>(count_.x) *
               (static_cast<std::size_t>(c.y) + static_cast<std::size_t>(count_.y) * static_cast<std::size_t>(c.z));
  }

  glm::vec3 low_{0.0f};
  float cell_ = 1.0f;
  glm::ivec3 count_{1};
  std::vector<std::uint8_t> set_;
};

Voxels voxelsOf(const ControlMesh& mesh) {
  Voxels voxels(boundsOf(mesh.positions));
  for (const ControlTriangle& triangle : mesh.triangles) {
    std::array<glm::vec3, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = voxels.inCells(mesh.positions[static_cast<std::size_t>(triangle.vertices[i])]);
    }
    const float longest = std::sqrt(std::max(
        {glm::dot(p[1] - p[0], p[1] - p[0]), glm::dot(p[2] - p[1], p[2] - p[1]), glm::dot(p[0] - p[2], p[0] - p[2])}));
    const int steps = std::clamp(static_cast<int>(std::ceil(longest * 1.6f)), 1, 4 * kCells);
    for (int j = 0; j <= steps; ++j) {
      for (int k = 0; j + k <= steps; ++k) {
        const float u = static_cast<float>(j) / static_cast<float>(steps);
        const float v = static_cast<float>(k) / static_cast<float>(steps);
        voxels.mark(p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]));
      }
    }
  }
  return voxels;
}

std::array<glm::vec3, kRays> evenDirections() {
  std::array<glm::vec3, kRays> directions{};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(kRays);
    const float angle = 2.3999632f * static_cast<float>(i);  // The golden angle.
    const float ring = std::sqrt(1.0f - y * y);
    directions[i] = {ring * std::cos(angle), y, ring * std::sin(angle)};
  }
  return directions;
}

/// How much a ray keeps of its light: 0 stopped at once, 1 gets away.
float passage(const Voxels& voxels, const glm::vec3& start, const glm::vec3& direction) {
  for (int step = 1; step <= kMostSteps; ++step) {
    const glm::vec3 at = start + direction * static_cast<float>(step);
    const glm::ivec3 cell(glm::floor(at));
    if (!voxels.isInside(cell)) return 1.0f;
    if (voxels.at(cell)) return static_cast<float>(step - 1) / static_cast<float>(kMostSteps);
  }
  return 1.0f;
}

float opennessAt(const Voxels& voxels, const std::array<glm::vec3, kRays>& directions, const glm::vec3& position,
                 const glm::vec3& normal) {
  const glm::vec3 start = voxels.inCells(position) + kStart * normal;
  float seen = 0.0f, all = 0.0f;
  for (const glm::vec3& direction : directions) {
    const float facing = glm::dot(direction, normal);
    if (facing <= 0.05f) continue;
    seen += facing * passage(voxels, start, direction);
    all += facing;
  }
  return all > 0.0f ? seen / all : 1.0f;
}

/// Each vertex half way to the mean of its neighbors.
void smoothAlongEdges(const ControlMesh& mesh, std::vector<float>& values) {
  std::vector<float> sum(values.size(), 0.0f), count(values.size(), 0.0f);
  for (const Edge& edge : mesh.edges) {
    const auto a = static_cast<std::size_t>(edge.vertices[0]), b = static_cast<std::size_t>(edge.vertices[1]);
    sum[a] += values[b];
    sum[b] += values[a];
    count[a] += 1.0f;
    count[b] += 1.0f;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (count[i] > 0.0f) values[i] = 0.5f * (values[i] + sum[i] / count[i]);
  }
}

}  // namespace

std::vector<float> bakeOpenness(const ControlMesh& mesh) {
  std::vector<float> open(mesh.positions.size(), 1.0f);
  if (open.empty() || mesh.triangles.empty()) return open;
  const Voxels voxels = voxelsOf(mesh);
  const std::array<glm::vec3, kRays> directions = evenDirections();
  for (std::size_t i = 0; i < open.size(); ++i) {
    open[i] = opennessAt(voxels, directions, mesh.positions[i], mesh.normals[i]);
  }
  for (int i = 0; i < kSmoothings; ++i) smoothAlongEdges(mesh, open);
  return open;
}

std::vector<float> spreadOverRefinement(std::span<const float> values, const ControlMesh& mesh,
                                        const Refinement& refinement) {
  assert(values.size() == mesh.positions.size());
  std::vector<float> spread(static_cast<std::size_t>(refinement.vertexCount));
  interpolateValues(mesh, refinement, values, spread);
  return spread;
}

}  // namespace sinew::app
