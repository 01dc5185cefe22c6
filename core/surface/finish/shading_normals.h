// core/surface/finish/shading_normals.h: normals that agree with the triangles they are drawn on.
// docs/design.md, Normals.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "core/geometry/parallel.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_rings.h"
#include "sinew/surface/surface.h"

namespace sinew {

// The faces around vertices, and normals for shading, by instruction set.

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

/// Holds the field's normals to what the mesh can show, in steps on delta = normal - n_patch, the turn that the muscles
/// give to the patch's normal.
///
/// 0. With adaptive detail only: along a muscle's rim the field turns within an edge, and where the rim runs across the
///    mesh, deltas alternate. As in step 2 what alternates is taken away, by nearly all of it from small differences
///    on, which show from close by; the more neighbors differ, the more goes over into the ring's mean.
/// 1. The field knows more than the mesh: where a muscle's rim is narrower than an edge, its gradient turns between two
///    vertices while the triangle between them is flat, and interpolated shading shows saw teeth. With N the normal of
///    the faces around a vertex (weighted by the corners' angles) and delta' the turn that the least rotation from
///    N(patch) to N(surface) gives to n_patch, delta is moved towards delta' until it is within kFreedom of it. Smooth
///    places keep the field's normal exactly.
/// 2. The faces themselves alternate along a rim that runs across the mesh. With M the mean over a vertex's neighbors,
///    delta -= weight (M - 1)^2 delta: nearly all of what alternates from vertex to vertex, little of what spreads over
///    several. The weight is 0 where neighbors differ little, where the vertex itself is not turned, and on cliffs,
///    which are meant.
///
/// Where heights were filtered (lift_filter.h) the field's normal is not that of the surface, and a cliff is not meant:
/// there, by the filter's weight, delta goes over into delta', and cliffs are no exception in the second step.
///
/// Continuous in time. A vertex that has not moved and has no moved neighbor keeps its normal bit for bit.
class ShadingNormals {
 public:
  /// @param rings  of the refinement.  @param moved  of these positions.  @param pairs  of moved.corners.
  /// @param patchNormals [V'] unit.
  /// @param filtered [V'] 0..1, the weights of lift_filter.h; empty: all are 0.
  /// @param softensRims  for adaptive detail.
  /// @param normals [V'] unit: in: the field's where a vertex has moved, else the patch's; out: for shading.
  void apply(const Refinement& refinement, const VertexRings& rings, const MovedTriangles& moved,
             const VertexPairs& pairs, std::span<const glm::vec3> patchNormals, std::span<const float> filtered,
             bool softensRims, std::span<glm::vec3> normals);

 private:
  void softenRims(const NormalsInputs& inputs, const NormalsKernel& kernel);

  // Scratch of NormalsInputs. What no muscle reaches is never written, and takes no memory.
  ScratchArray<CornerNormals> corners_;
  std::vector<NormalsVertex> vertices_;
  std::vector<float> turns_;
  std::vector<int> teeth_;
  std::vector<float> weights_;
  std::vector<std::size_t> foundIn_;  ///< [blocks] rims, then teeth.
};

/// The same turns for creases. Where the patch is not creased, or not moved, this is exact.
/// @param surface  with its normals as apply() leaves them.  @param patchNormals [V'] unit.
/// @param shading [D] unit: in: the wedges' patch; out: turned with the surface as it moves off its own patch.
void turnWithSurface(const Surface& surface, std::span<const glm::vec3> patchNormals, std::vector<glm::vec3>& shading);

}  // namespace sinew
