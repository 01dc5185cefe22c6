// core/surface/sampling.h: the surface at points of the control mesh, before any stage that needs neighbors.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/surface/posed_field.h"
#include "core/surface/preparation.h"
#include "core/surface/workspace.h"

namespace sinew {

/// Some triangles as a mesh of their own, with all that sampling reads: a sample, and its cost, depend only on its edge
/// or triangle.
struct SampledPart {
  std::shared_ptr<const Preparation> preparation;  ///< Of the part as a mesh, without anything that needs a refinement.
  std::vector<int> edges;                          ///< Indices of the part's edges in the whole mesh, ascending.
  std::vector<int> triangles;                      ///< Likewise.
  std::vector<int> asked;                          ///< Those of the part's triangles that its piece has, ascending.

  [[nodiscard]] const ControlMesh& mesh() const { return preparation->mesh(); }
};

using SampledPiece = std::vector<int>;  ///< Triangles, ascending.

/// Divides triangles into pieces that fit the cache. In `replace` there is one piece, as its part has the whole mesh.
/// @param triangles [T] 0: not to be sampled
[[nodiscard]] std::vector<SampledPiece> sampledPieces(const Preparation& next,
                                                      const std::vector<std::uint8_t>& triangles);

/// The triangles of a piece with all their edges. In `replace` the whole mesh, which decides whether muscles wrap the
/// body.  @param next  attached, with candidates
[[nodiscard]] SampledPart sampledPart(const Preparation& next, const SampledPiece& piece);

/// Skin, patch and projection at given points, pose after pose.
class SurfaceSampler {
 public:
  SurfaceSampler(const SampledPart& part, Refinement points);  ///< @param points  of the part's mesh

  /// Valid until the next call.  @param triangles  of the part: samples on others stay on the patch.
  [[nodiscard]] const Surface& sample(const Pose& pose, std::span<const int> triangles);

 private:
  void skipAllBut(std::span<const int> triangles);

  std::shared_ptr<const Preparation> preparation_;
  std::vector<std::uint8_t> skipped_;  ///< [V+E+T] 1: not projected.
  PosedRig rig_;
  PosedField posed_;
  Workspace workspace_;
  Surface surface_;
};

}  // namespace sinew
