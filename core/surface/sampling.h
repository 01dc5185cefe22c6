// core/surface/sampling.h: the surface at points of the control mesh, before any stage that needs neighbors.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/surface/posed_field.h"
#include "core/surface/preparation.h"
#include "core/surface/workspace.h"

namespace sinew {

// Some edges and triangles of a mesh as a mesh of their own, with all that sampling
// reads.

/// A part of a mesh: what a sample shows follows from its edge or triangle alone, and so does what it costs.
struct SampledPart {
  std::shared_ptr<const Preparation> preparation;  ///< Of the part as a mesh; nothing that needs a refinement is made.
  std::vector<int> edges;                          ///< Of the part's edges in the whole mesh, ascending.
  std::vector<int> triangles;                      ///< Likewise.
  std::vector<std::uint8_t> skipped;  ///< [V+E+T] of the part: 1: nobody asks for its samples. Empty: none.

  [[nodiscard]] const ControlMesh& mesh() const { return preparation->mesh(); }
};

/// Where some of a part's edges or triangles are in it. @param inWhole  SampledPart::edges or triangles.  @param asked
/// ascending, among them
[[nodiscard]] std::vector<int> placesIn(const std::vector<int>& inWhole, const std::vector<int>& asked);

/// Edges and triangles that are looked at together.
struct SampledPiece {
  std::vector<int> edges;      ///< Ascending.
  std::vector<int> triangles;  ///< Ascending.
};

/// Pieces of a size that stays in the cache, each edge and triangle asked for in one of them. A part of each has its
/// triangles' other edges besides. In `replace` there is one piece, as a part then holds the whole mesh.
/// @param edges [E], triangles [T] 1: asked for
[[nodiscard]] std::vector<SampledPiece> sampledPieces(const Preparation& next, std::vector<std::uint8_t> edges,
                                                      const std::vector<std::uint8_t>& triangles);

/// The triangles of a piece with their edges, and its other edges. In `replace` the whole mesh, since whether muscles
/// wrap the body is read off all of it, and what is not asked for is skipped.
/// @param next  attached, with its candidates
[[nodiscard]] SampledPart sampledPart(const Preparation& next, const SampledPiece& piece);

/// Skin, patch and projection at given points, pose after pose.
class SurfaceSampler {
 public:
  /// @param points  of the part's mesh
  SurfaceSampler(const SampledPart& part, Refinement points);

  /// Valid until the next call.
  [[nodiscard]] const Surface& sample(const Pose& pose);

 private:
  std::shared_ptr<const Preparation> preparation_;
  std::vector<std::uint8_t> skipped_;
  PosedRig rig_;
  PosedField posed_;
  Workspace workspace_;
  Surface surface_;
};

}  // namespace sinew
