// core/smoothing/finish/shading_normals.h: normals that agree with the triangles they are drawn on.
// docs/design.md, Normals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/smoothing/finish/moved_triangles.h"

namespace sinew {

/// Holds the field's normals to what the mesh can show, in two steps on delta = normal - n_patch, the turn that the
/// muscles give to the patch's normal.
///
/// 1. The field knows more than the mesh: where a muscle's rim is narrower than an edge, its gradient turns between two
///    vertices while the triangle between them is flat, and interpolated shading shows saw teeth. With N the normal of
///    the faces around a vertex (weighted by the corners' angles) and delta' the turn that the least rotation from
///    N(patch) to N(surface) gives to n_patch, delta is moved towards delta' until it is within kFreedom of it. Smooth
///    places keep the field's normal exactly.
/// 2. The faces themselves alternate along a rim that runs across the mesh. With M the mean over a vertex's neighbours,
///    delta -= weight (M - 1)^2 delta: nearly all of what alternates from vertex to vertex, little of what spreads over
///    several. The weight is 0 where neighbours differ little, where the vertex itself is not turned, and on cliffs,
///    which are meant.
///
/// Where heights were filtered (lift_filter.h) the field's normal is not that of the surface, and a cliff is not meant:
/// there, by the filter's weight, delta goes over into delta', and cliffs are no exception in the second step.
///
/// Continuous in time. A vertex that has not moved and has no moved neighbour keeps its normal bit for bit.
class ShadingNormals {
 public:
  /// @param moved  of these positions.  @param patch, positions [V'] world.  @param patchNormals [V'] unit.
  /// @param filtered [V'] 0..1, the weights of lift_filter.h; empty: all are 0.
  /// @param normals [V'] unit: in: the field's where a vertex has moved, else the patch's; out: for shading.
  void apply(const Refinement& refinement, const MovedTriangles& moved, std::span<const glm::vec3> patch,
             std::span<const glm::vec3> positions, std::span<const glm::vec3> patchNormals,
             std::span<const float> filtered, std::span<glm::vec3> normals);

 private:
  /// Sums over the faces around one vertex.
  struct Faces {
    glm::vec3 patch{0.0f};
    glm::vec3 surface{0.0f};
  };
  void sumFaces(const Refinement& refinement, const MovedTriangles& moved, std::span<const glm::vec3> patch,
                std::span<const glm::vec3> positions);
  void holdToFaces(const MovedTriangles& moved, std::span<const glm::vec3> patchNormals,
                   std::span<const float> filtered, std::span<const glm::vec3> normals);
  [[nodiscard]] bool findTeeth(const Refinement& refinement, const MovedTriangles& moved);
  void gatherAroundTeeth(const Refinement& refinement, const MovedTriangles& moved);
  /// (M - 1) values at the vertices near teeth, 0 at the other corners.
  void laplacianOf(const std::vector<glm::vec3>& values, const Refinement& refinement, const MovedTriangles& moved,
                   std::vector<glm::vec3>& out) const;
  void removeTeeth(const Refinement& refinement, const MovedTriangles& moved, std::span<const float> filtered);

  // All read and written at moved.corners alone.
  std::vector<Faces> faces_;             ///< [V']
  std::vector<glm::vec3> deltas_;        ///< [V']
  std::vector<float> turn_;              ///< [V'] squared: the larger of the turns that the field and the faces show.
  std::vector<float> spread_;            ///< [V'] largest squared difference to a neighbour's delta; 0: no tooth.
  std::vector<std::uint8_t> isTurned_;   ///< [V'] delta is large enough to make a tooth.
  std::vector<std::uint8_t> nearTeeth_;  ///< [V'] a tooth or next to one.
  std::vector<int> aroundTeeth_;         ///< Refined triangles at vertices near teeth.
  std::vector<glm::vec3> first_;         ///< [V'] (M - 1) delta
  std::vector<glm::vec3> second_;        ///< [V'] (M - 1)^2 delta
};

}  // namespace sinew
