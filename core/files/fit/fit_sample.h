// core/files/fit/fit_sample.h: some vertices that stand for all while joints are fitted.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/files/fit/four_weights.h"

namespace sinew::exporting {

/// Vertices spread evenly over all of them: each stands for about as many, so none has to count more than another.
struct FitSample {
  std::vector<int> vertices;                  ///< Ascending.
  std::vector<int> cell;                      ///< [all] index in `vertices` of the nearest along edges.
  std::vector<std::array<int, 3>> triangles;  ///< Indices in `vertices`: where three cells meet.

  [[nodiscard]] bool isWhole() const { return vertices.size() == cell.size(); }
};

/// About `most` vertices along a Morton curve, at least one of everything that hangs together; all of them where there
/// are no more, with their own triangles.
/// @param triangles  between the vertices; those with a corner beyond them are skipped
[[nodiscard]] FitSample sampleVertices(std::span<const glm::vec3> rest, std::span<const std::array<int, 3>> triangles,
                                       std::size_t most);

/// [all] bindings that each vertex may follow: its own, then what its cell and the cells around that follow, the most
/// followed first; kMostNear, or its own alone if these are more.
/// @param weights  [sample.vertices]  @param own  [all]
[[nodiscard]] std::vector<std::vector<int>> candidatesNear(const FitSample& sample,
                                                           std::span<const FourWeights> weights,
                                                           std::span<const FourWeights> own);

inline constexpr std::size_t kMostNear = 12;

}  // namespace sinew::exporting
