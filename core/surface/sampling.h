// core/surface/sampling.h: the surface at points of the control mesh, before any stage that needs neighbors.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/surface/posed_field.h"
#include "core/surface/preparation.h"
#include "core/surface/workspace.h"

namespace sinew {

/// Some edges and triangles as a mesh of their own, with all that sampling reads: a sample, and its cost, depend only
/// on its edge or triangle.
struct SampledPart {
  std::shared_ptr<const Preparation> preparation;  ///< Of the part as a mesh, without anything that needs a refinement.
  std::vector<int> edges;                          ///< Indices of the part's edges in the whole mesh, ascending.
  std::vector<int> triangles;                      ///< Likewise.
  std::vector<std::uint8_t> skipped;               ///< [V+E+T] of the part, 1: needs no samples. Empty: none.

  [[nodiscard]] const ControlMesh& mesh() const { return preparation->mesh(); }
};

/// Indices in a part.  @param inWhole  SampledPart::edges or triangles.  @param asked  some of these, ascending
[[nodiscard]] std::vector<int> placesIn(const std::vector<int>& inWhole, const std::vector<int>& asked);

struct SampledPiece {
  std::vector<int> edges;      ///< Ascending.
  std::vector<int> triangles;  ///< Ascending.
};

/// Divides edges and triangles into pieces that fit the cache. In `replace` there is one piece, as its part has the
/// whole mesh.  @param edges [E], triangles [T] 1: to be sampled
[[nodiscard]] std::vector<SampledPiece> sampledPieces(const Preparation& next, std::vector<std::uint8_t> edges,
                                                      const std::vector<std::uint8_t>& triangles);

/// The triangles of a piece with all their edges, and its other edges. In `replace` the whole mesh, which decides
/// whether muscles wrap the body, with the rest skipped.  @param next  attached, with candidates
[[nodiscard]] SampledPart sampledPart(const Preparation& next, const SampledPiece& piece);

/// Skin, patch and projection at given points, pose after pose.
class SurfaceSampler {
 public:
  SurfaceSampler(const SampledPart& part, Refinement points);  ///< @param points  of the part's mesh

  [[nodiscard]] const Surface& sample(const Pose& pose);  ///< Valid until the next call.

 private:
  std::shared_ptr<const Preparation> preparation_;
  std::vector<std::uint8_t> skipped_;
  PosedRig rig_;
  PosedField posed_;
  Workspace workspace_;
  Surface surface_;
};

}  // namespace sinew
