// app/viewport/render/fewer_triangles.h: fewer triangles for pictures that the processor draws.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sinew/character/character.h"
#include "sinew/surface/refinement.h"

namespace sinew::app {

/// Coarse surface for a blurred shadow, between drawn vertices of a refinement. Valid for all poses and muscles.
struct ShadowMesh {
  /// Consecutive triangles with one material.
  struct Range {
    int material = 0;
    int firstTriangle = 0;
    int triangles = 0;
  };
  std::vector<std::uint32_t> indices;  ///< Drawn vertices, three per triangle, in either order.
  std::vector<Range> ranges;
};

/// [V] the control vertex that replaces each in shadows: one of those in the same cell of the bind pose, kShadowCell of
/// the height, with the same strongest bone. Empty for at most kFewShadowTriangles.
[[nodiscard]] std::vector<int> shadowClusters(const Character& character);

/// The control triangles; those of opaque materials between clusters, without degenerate and repeated ones.
/// @param clusters  shadowClusters() of the character  @param order  all control triangles by material
[[nodiscard]] ShadowMesh makeShadowMesh(const Character& character, std::span<const int> clusters,
                                        const Refinement& refinement, std::span<const int> order);

inline constexpr std::size_t kFewShadowTriangles = 4000;
inline constexpr float kShadowCell = 0.015f;  ///< The blur's standard deviation is 0.018.

/// Leaves out triangles that face away, lie outside the picture or cover no pixel's center, before vertices are shaded
/// and triangles sorted into tiles: most of them where triangles are smaller than pixels. Reused for its memory.
class SeenTriangles {
 public:
  using Range = ShadowMesh::Range;
  using Corners = std::array<std::uint32_t, 3>;  ///< Drawn vertices.

  struct Input {
    const Refinement& refinement;
    std::span<const glm::vec3> positions;      ///< [V'] world, finite.
    std::span<const int> order;                ///< Refined triangles in the order drawn.
    std::span<const Range> ranges;             ///< Of `order`, consecutive.
    std::span<const std::uint8_t> keepsBacks;  ///< [ranges] 1: both sides.
  };

  /// @param size  pixels with one sample each
  void find(const Input& input, const glm::mat4& clipFromWorld, const glm::ivec2& size);

  /// In the order drawn: all that OpenGL draws, and those on which rounding might decide.
  [[nodiscard]] std::span<const Corners> triangles() const { return triangles_; }
  /// Parts of triangles() by material.
  [[nodiscard]] std::span<const Range> ranges() const { return ranges_; }

 private:
  void place(std::span<const glm::vec3> positions, const glm::mat4& clipFromWorld, const glm::vec2& size);
  [[nodiscard]] bool leavesTrace(const std::array<int, 3>& triangle, const glm::vec2& size, bool keepsBack) const;

  std::vector<glm::vec2> pixels_;  ///< [V'] from the lower left; NaN: its triangles are kept.
  std::vector<Corners> triangles_;
  std::vector<Range> ranges_;
};

}  // namespace sinew::app
