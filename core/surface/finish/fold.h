// core/surface/finish/fold.h: how far a lifted triangle has turned over against its patch.
// docs/design.md, Folds.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// A patch in its pose.
struct PatchView {
  std::span<const glm::vec3> positions;  ///< [V'] world.
  std::span<const glm::vec3> normals;    ///< [V'] unit.
  std::span<const float> bindFronts;     ///< [T n^2] triangleFronts of the bind pose.
};

/// [T n^2] how much the refined triangles of a patch face along its normals: twice the area, along the mean of the
/// three normals, over the sum of the squared edges. 0.29 for a level equilateral triangle, less for thin ones, below 0
/// where the patch folds back.
[[nodiscard]] std::vector<float> triangleFronts(const Refinement& refinement, std::span<const glm::vec3> positions,
                                                std::span<const glm::vec3> normals);

/// A lifted triangle against its patch.
struct Fold {
  float area = 1.0f;    ///< q: its area over the patch's, signed along the patch's face normal; below 0: turned over.
  float weight = 0.0f;  ///< 0..1, how far q can be trusted: less where the pose has squeezed the patch itself below
                        ///< 5 % of its front in the bind pose. q jumps where that folds back.
};

/// A refined triangle's face: twice the area, along the normal.
[[nodiscard]] inline glm::vec3 faceOf(const std::array<int, 3>& t, std::span<const glm::vec3> positions) {
  const glm::vec3& a = at(positions, t[0]);
  return glm::cross(at(positions, t[1]) - a, at(positions, t[2]) - a);
}

/// How much a triangle of the patch faces along its normals, as triangleFronts() has it.
struct Front {
  float along = 0.0f;  ///< Twice the area, along the sum of the three normals.
  float edges = 0.0f;  ///< Three times the sum of the squared edges.

  [[nodiscard]] float ratio() const { return edges > 0.0f ? along / edges : 0.0f; }
};

/// @param face  of the triangle in the patch.
[[nodiscard]] inline Front frontOf(const std::array<int, 3>& t, const glm::vec3& face, const PatchView& patch) {
  const glm::vec3& a = at(patch.positions, t[0]);
  const glm::vec3 u = at(patch.positions, t[1]) - a;
  const glm::vec3 v = at(patch.positions, t[2]) - a;
  const glm::vec3 normals = at(patch.normals, t[0]) + at(patch.normals, t[1]) + at(patch.normals, t[2]);
  return {glm::dot(face, normals), 3.0f * (glm::dot(u, u) + glm::dot(v, v) + glm::dot(v - u, v - u))};
}

/// How far q can be trusted. @param face  of the triangle in the patch.
[[nodiscard]] float trustIn(const Refinement& refinement, std::size_t triangle, const PatchView& patch,
                            const glm::vec3& face);

}  // namespace sinew
