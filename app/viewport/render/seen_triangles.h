// app/viewport/render/seen_triangles.h: the triangles that leave a trace in a picture, for pictures the processor
// draws.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/viewport/render/shadow_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew::app {

/// Leaves out what faces away, what lies beside the picture and what covers no pixel's center, before vertices are
/// shaded and triangles are sorted into tiles: where triangles are smaller than pixels, that is most of them. Kept from
/// picture to picture for its memory.
class SeenTriangles {
 public:
  using Range = ShadowMesh::Range;
  using Corners = std::array<std::uint32_t, 3>;  ///< Drawn vertices.

  /// What is drawn.
  struct Input {
    const Refinement& refinement;
    std::span<const glm::vec3> positions;      ///< [V'] world, finite.
    std::span<const int> order;                ///< Refined triangles in the order drawn.
    std::span<const Range> ranges;             ///< Of `order`, one after the other.
    std::span<const std::uint8_t> keepsBacks;  ///< [ranges] 1: both sides are drawn.
  };

  /// @param size  of the picture in pixels, which have one sample each.
  void find(const Input& input, const glm::mat4& clipFromWorld, const glm::ivec2& size);

  /// In the order drawn. All that OpenGL would draw is among them, and so are those for which rounding could decide:
  /// ours, or that of OpenGL to fractions of a pixel.
  [[nodiscard]] std::span<const Corners> triangles() const { return triangles_; }
  /// The same materials, of triangles().
  [[nodiscard]] std::span<const Range> ranges() const { return ranges_; }

 private:
  void place(std::span<const glm::vec3> positions, const glm::mat4& clipFromWorld, const glm::vec2& size);
  [[nodiscard]] bool leavesTrace(const std::array<int, 3>& triangle, const glm::vec2& size, bool keepsBack) const;

  std::vector<glm::vec2> pixels_;  ///< [V'] from the lower left; NaN: left to OpenGL, as is every triangle there.
  std::vector<Corners> triangles_;
  std::vector<Range> ranges_;
};

}  // namespace sinew::app
