// app/viewport/render/shadow_mesh.h: fewer triangles of the surface, for a blurred shadow that the processor draws.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/surface/refinement.h"

namespace sinew::app {

/// Between drawn vertices of a refinement. Moves with them: pose and muscles need no new one.
struct ShadowMesh {
  /// Consecutive triangles with one material.
  struct Range {
    int material = 0;
    int firstTriangle = 0;
    int triangles = 0;
  };
  std::vector<std::uint32_t> indices;  ///< Of drawn vertices, three a triangle; either side may face the light.
  std::vector<Range> ranges;
};

/// [V] the control vertex that stands for each in shadows: vertices that lie in one cell of the bind pose,
/// kShadowCell of the height, and follow the same bone most become one of them. Empty: each stands for itself, since
/// there are at most kFewShadowTriangles.
[[nodiscard]] std::vector<int> shadowClusters(const Character& character);

/// One triangle for each control triangle, between its corners; of opaque materials between those that stand for them,
/// without those that are degenerate then or repeat another one.
/// @param clusters  shadowClusters() of the character
/// @param order  control triangles, those of a material in a row; all of them
[[nodiscard]] ShadowMesh makeShadowMesh(const Character& character, std::span<const int> clusters,
                                        const Refinement& refinement, std::span<const int> order);

inline constexpr std::size_t kFewShadowTriangles = 4000;
inline constexpr float kShadowCell = 0.015f;  ///< The blur's standard deviation is 0.018.

}  // namespace sinew::app
