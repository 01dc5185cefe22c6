// core/surface/projection/candidates.h: which primitives each piece of the control mesh can ever see.
// Made once per edit.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry/at.h"
#include "core/rig/attachment.h"
#include "core/rig/mesh_layers.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// A primitive with its territory weights m_i at a carrier's corners; unused corners hold 0.
struct CarrierCandidate {
  int primitive = 0;
  int slot = 0;  ///< See Candidate::slot.
  std::array<float, 3> weights{};

  /// m_i at barycentric coordinates of the carrier.
  [[nodiscard]] float weightAt(const std::array<float, 3>& barycentric) const {
    return weights[0] * barycentric[0] + weights[1] * barycentric[1] + weights[2] * barycentric[2];
  }
};

/// Candidate lists per carrier: control vertices first, then edges (corners: smaller vertex, larger), then triangles.
/// Both triangles at an edge see its refined vertices through the edge's own list: the surface cannot crack there.
struct CandidateLists {
  std::vector<int> begin;  ///< [V+E+T+1]
  std::vector<CarrierCandidate> items;
  std::vector<int> cliqueSet;           ///< [V+E+T] index into cliqueSets.
  std::vector<CliqueLists> cliqueSets;  ///< [0] is empty: everything sums.

  [[nodiscard]] std::span<const CarrierCandidate> of(int carrier) const {
    const auto c = static_cast<std::size_t>(carrier);
    return std::span(items).subspan(static_cast<std::size_t>(begin[c]),
                                    static_cast<std::size_t>(begin[c + 1] - begin[c]));
  }
  [[nodiscard]] const CliqueLists& cliquesOf(int carrier) const { return at(cliqueSets, at(cliqueSet, carrier)); }
};

/// @param layers  pieces that are not skin see nothing; null: all is skin
[[nodiscard]] CandidateLists makeCandidateLists(const ControlMesh& mesh, const Attachment& attachment,
                                                const MeshLayers* layers = nullptr);

/// The lists as they would be without some primitives, which keep their indices: slots and cliques are those of the
/// groups that are left. Reads no territory anew.
/// @param hidden [A]
[[nodiscard]] CandidateLists withoutHidden(const CandidateLists& lists, const Attachment& attachment,
                                           const std::vector<bool>& hidden);

}  // namespace sinew
