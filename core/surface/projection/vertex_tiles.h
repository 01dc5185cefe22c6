// core/surface/projection/vertex_tiles.h: tiles of 16 neighboring vertices with one list of muscles, made per edit.
#pragma once

#include <array>
#include <vector>

#include "core/surface/projection/candidates.h"
#include "core/surface/roots/lane_terms.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Up to 16 refined vertices of neighboring carriers with the same cliques.
struct VertexTile {
  std::array<int, kLanes> vertices{};  ///< Lanes beyond `used` repeat the first, with weights 0.
  std::array<int, kLanes> carriers{};
  int used = 0;
  int firstCandidate = 0;
  int candidateCount = 0;
  int cliqueSet = 0;  ///< Index into CandidateLists::cliqueSets.
};

struct TileCandidate {
  int primitive = 0;
  int slot = 0;  ///< See Candidate::slot.
};

struct VertexTiles {
  std::vector<VertexTile> tiles;
  std::vector<TileCandidate> candidates;  ///< Tile by tile, ascending by primitive.
  std::vector<LaneFloats> weights;        ///< m_i of each candidate at each lane; 0 if the carrier does not see it.
  std::size_t mostCandidates = 0;
};

[[nodiscard]] VertexTiles makeVertexTiles(const ControlMesh& mesh, const Refinement& refinement,
                                          const CandidateLists& lists);

}  // namespace sinew
