// core/surface/finish/shading_normals.h: normals that agree with the drawn triangles. docs/design.md, Normals.
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

/// At the corner of a triangle: the unit normals of the patch and of the surface, times the angle. Four numbers each.
struct alignas(32) CornerNormals {
  std::array<float, 8> of;
};

/// Scratch of one vertex, 0 before and after. Fourth numbers are 0.
struct alignas(32) NormalsVertex {
  std::array<float, 4> delta{};  ///< normal - n_patch: of the field, then held to the faces.
  std::array<float, 4> first{};  ///< (M - 1) delta; where normals are softened, first what that adds.
};

/// Vertex arrays are [V']; all but `rings` are used only at moved.corners. The kernel allocates nothing.
struct NormalsInputs {
  const Refinement* refinement = nullptr;
  const VertexRings* rings = nullptr;
  const MovedTriangles* moved = nullptr;
  const VertexPair* pairs = nullptr;
  std::span<const glm::vec3> patchNormals;
  std::span<const float> filtered;   ///< Empty: all are 0.
  std::span<glm::vec3> normals;      ///< In and out: as ShadingNormals::apply.
  CornerNormals* corners = nullptr;  ///< [3 T n^2] scratch, in the order of rings->corners, for moved.refined.
  NormalsVertex* vertices = nullptr;
  float* turns = nullptr;    ///< Squared delta, the larger of the field's and the faces'; 0 before and after.
  std::span<int> teeth;      ///< [moved.corners] scratch: vertices found by each block, at its place. First rims.
  std::span<float> weights;  ///< [moved.corners] of the teeth.
};

/// Stages, in this order. Threads can share each of them, as its parts write to different places. A part goes from
/// begin to end in the named span of `moved`.
struct NormalsKernel {
  void (*takeDeltas)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);        ///< moved.corners
  std::size_t (*findRims)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);   ///< moved.near
  void (*softenRims)(const NormalsInputs& inputs, std::size_t begin, std::size_t count);      ///< Vertices found there.
  void (*faces)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);             ///< moved.refined
  void (*hold)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);              ///< moved.near
  std::size_t (*findTeeth)(const NormalsInputs& inputs, std::size_t begin, std::size_t end);  ///< moved.corners
  void (*removeTeeth)(const NormalsInputs& inputs, std::size_t begin, std::size_t count);     ///< Vertices found there.
};

[[nodiscard]] NormalsKernel normalsKernel(InstructionSet set);

/// Limits the field's normals to what the mesh can show, in steps on delta = normal - n_patch, the change that muscles
/// make to the patch's normal.
///
/// 0. With adaptive detail only: where a vertex's normal differs much from a neighbor's, as across a muscle's rim, it
///    moves towards the ring's mean.
/// 1. The field has more detail than the mesh: where a muscle's rim is narrower than an edge, its gradient rotates
///    between two vertices while the triangle between them is flat, and interpolated shading shows saw teeth. With N
///    the normal of the faces around a vertex (weighted by the corners' angles) and delta' the change of n_patch by the
///    least rotation from N(patch) to N(surface), delta moves towards delta' until it is within kFreedom of it. Smooth
///    places keep the field's normal exactly.
/// 2. The faces themselves alternate along a rim that runs across the mesh. With M the mean over a vertex's neighbors,
///    delta -= weight (M - 1)^2 delta: nearly all that alternates from vertex to vertex, little that spreads over
///    several. The weight is 0 where neighbors differ little, where delta is 0, and on cliffs, which are intended.
///
/// Where heights were filtered (LiftFilter) the field's normal is not that of the surface, and cliffs are not intended:
/// there, by the filter's weight, delta becomes delta', and step 2 treats cliffs like the rest.
///
/// Continuous in time. A vertex that has not moved, nor any neighbor, keeps its normal to the bit.
class ShadingNormals {
 public:
  /// @param rings  of the refinement.  @param moved  of these positions.  @param pairs  of moved.corners.
  /// @param patchNormals [V'] unit.
  /// @param filtered [V'] 0..1, the weights of LiftFilter; empty: all are 0.
  /// @param softensRims  for adaptive detail.
  /// @param normals [V'] unit. In: the field's where a vertex has moved, else the patch's; out: for shading.
  void apply(const Refinement& refinement, const VertexRings& rings, const MovedTriangles& moved,
             const VertexPairs& pairs, std::span<const glm::vec3> patchNormals, std::span<const float> filtered,
             bool softensRims, std::span<glm::vec3> normals);

 private:
  void softenRims(const NormalsInputs& inputs, const NormalsKernel& kernel);

  // Scratch of NormalsInputs. Parts that no muscle reaches are never written, and take no memory.
  ScratchArray<CornerNormals> corners_;
  std::vector<NormalsVertex> vertices_;
  std::vector<float> turns_;
  std::vector<int> teeth_;
  std::vector<float> weights_;
  std::vector<std::size_t> foundIn_;  ///< [blocks] rims, then teeth.
};

/// Makes the same changes at creases; exact where the patch is not creased or has not moved.
/// @param surface  with normals from apply().  @param patchNormals [V'] unit.
/// @param shading [D] unit. In: of the wedges' patch; out: changed as the surface's normals differ from the patch's.
void turnWithSurface(const Surface& surface, std::span<const glm::vec3> patchNormals, std::vector<glm::vec3>& shading);

}  // namespace sinew
