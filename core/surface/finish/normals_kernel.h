// core/surface/finish/normals_kernel.h: the faces around vertices, and normals for shading, by instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_pairs.h"
#include "core/surface/finish/vertex_rings.h"

namespace sinew {

/// At the corner of a triangle: the patch's unit normal, then the surface's, times the angle. Four numbers each.
struct alignas(32) CornerNormals {
  std::array<float, 8> of;
};

/// Scratch of one vertex, 0 before and after; one cache line. Unless said otherwise the fourth numbers are 0.
struct alignas(64) NormalsVertex {
  std::array<float, 4> delta{};   ///< What muscles turn the normal by: the field's, then held to the faces.
  std::array<float, 4> normal{};  ///< The field's. It follows `delta`: softening reads both as eight numbers.
  std::array<float, 4> first{};   ///< (M - 1) delta.
  std::array<float, 4> mean{};    ///< What the ring's mean adds to the normal; fourth: 0..1, how far that is in the
                                  ///< second step's place.
};

static_assert(offsetof(NormalsVertex, normal) == sizeof(NormalsVertex::delta));

/// What shading_normals.h passes to the kernel. Spans and arrays of vertices are [V']; all but `rings` are read and
/// written at moved.corners alone. Nothing is allocated.
struct NormalsInputs {
  const Refinement* refinement = nullptr;
  const VertexRings* rings = nullptr;
  const MovedTriangles* moved = nullptr;
  const VertexPair* pairs = nullptr;
  std::span<const glm::vec3> patchNormals;
  std::span<const float> filtered;   ///< Empty: all are 0.
  std::span<glm::vec3> normals;      ///< In and out: as ShadingNormals::apply.
  CornerNormals* corners = nullptr;  ///< [3 T n^2] scratch, vertex by vertex as rings->corners: those of moved.refined.
  NormalsVertex* vertices = nullptr;
  float* turns = nullptr;    ///< Squared, the larger of what the field and the faces show; 0 before and after.
  std::span<int> teeth;      ///< [moved.corners] scratch: vertices, rims first, those of a block from its place on.
  std::span<float> weights;  ///< [moved.corners] theirs.
};

/// Stages, one after the other: each can be shared out, as its parts write to different places. Of the spans of
/// `moved` from begin to end.
struct NormalsKernel {
  void (*takeTurns)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);         ///< moved.corners
  std::size_t (*findRims)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);   ///< moved.near
  void (*softenRims)(const NormalsInputs& inputs, std::size_t begin, std::size_t count);      ///< Those found there.
  void (*faces)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);             ///< moved.refined
  void (*hold)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);              ///< moved.near
  std::size_t (*findTeeth)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);  ///< moved.corners
  void (*removeTeeth)(const NormalsInputs& inputs, std::size_t begin, std::size_t count);     ///< Those found there.
};

/// All give the same bits.
[[nodiscard]] NormalsKernel normalsKernel(InstructionSet set);

}  // namespace sinew
