// core/surface/projection/vertex_tiles.cpp: tiles packed from carriers along a space-filling curve.
#include "core/surface/projection/vertex_tiles.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/geometry/parallel.h"

namespace sinew {
namespace {

/// Spreads the bits of x to every third bit.
std::uint32_t spread(std::uint32_t x) {
  x &= 0x3ff;
  x = (x | (x << 16)) & 0x030000ff;
  x = (x | (x << 8)) & 0x0300f00f;
  x = (x | (x << 4)) & 0x030c30c3;
  return (x | (x << 2)) & 0x09249249;
}

/// Control triangles along a Morton curve through the bind pose, so that neighbors in the list are neighbors in space.
std::vector<int> alongCurve(const ControlMesh& mesh) {
  const Bounds box = boundsOf(mesh.positions);
  const float longest = std::max({box.extent().x, box.extent().y, box.extent().z, 1e-30f});
  std::vector<std::pair<std::uint32_t, int>> keyed;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    glm::vec3 sum(0.0f);
    for (const int corner : at(mesh.triangles, t).vertices) sum += at(mesh.positions, corner);
    const glm::vec3 cell = (sum / 3.0f - box.low) / longest * 1023.0f;
    keyed.emplace_back(spread(static_cast<std::uint32_t>(cell.x)) | spread(static_cast<std::uint32_t>(cell.y)) << 1 |
                           spread(static_cast<std::uint32_t>(cell.z)) << 2,
                       t);
  }
  std::ranges::sort(keyed);
  std::vector<int> order;
  for (const auto& [key, triangle] : keyed) order.push_back(triangle);
  return order;
}

/// Packs refined vertices, carrier by carrier, into tiles. The vertices of a tile lie close together and see nearly the
/// same muscles, so one list of candidates serves all of them, with weight 0 for lanes that do not see a muscle.
class Packer {
 public:
  Packer(const CandidateLists& lists, VertexTiles& out) : lists_(lists), out_(out), open_(lists.cliqueSets.size()) {}

  void addCarrier(int carrier, int firstVertex, int count) {
    if (count == 0 || lists_.of(carrier).empty()) return;
    VertexTile& tile = at(open_, at(lists_.cliqueSet, carrier));
    for (int i = 0; i < count; ++i) {
      tile.cliqueSet = at(lists_.cliqueSet, carrier);
      at(tile.vertices, tile.used) = firstVertex + i;
      at(tile.carriers, tile.used) = carrier;
      if (++tile.used == static_cast<int>(kLanes)) close(tile);
    }
  }

  void closeAll() {
    for (VertexTile& tile : open_) {
      if (tile.used > 0) close(tile);
    }
  }

 private:
  void close(VertexTile& tile) {
    for (std::size_t lane = toIndex(tile.used); lane < kLanes; ++lane) {
      tile.vertices[lane] = tile.vertices[0];
      tile.carriers[lane] = tile.carriers[0];
    }
    gatherCandidates(tile);
    tile.firstCandidate = static_cast<int>(out_.candidates.size());
    tile.candidateCount = static_cast<int>(gathered_.size());
    out_.candidates.insert(out_.candidates.end(), gathered_.begin(), gathered_.end());
    out_.mostCandidates = std::max(out_.mostCandidates, gathered_.size());
    out_.tiles.push_back(tile);
    tile = {};
  }

  /// Merges the candidates of all lanes, ascending.
  void gatherCandidates(const VertexTile& tile) {
    gathered_.clear();
    for (int lane = 0; lane < tile.used; ++lane) {
      if (lane > 0 && at(tile.carriers, lane) == at(tile.carriers, lane - 1)) continue;
      std::size_t place = 0;
      for (const CarrierCandidate& candidate : lists_.of(at(tile.carriers, lane))) {
        while (place < gathered_.size() && gathered_[place].primitive < candidate.primitive) ++place;
        if (place < gathered_.size() && gathered_[place].primitive == candidate.primitive) continue;
        gathered_.insert(gathered_.begin() + static_cast<std::ptrdiff_t>(place), {candidate.primitive, candidate.slot});
      }
    }
  }

  const CandidateLists& lists_;
  VertexTiles& out_;
  std::vector<VertexTile> open_;         ///< One per clique set, since each numbers its groups in its own way.
  std::vector<TileCandidate> gathered_;  ///< Candidates of the tile being closed.
};

CarriedVertex carriedBy(int carrier, int vertex, const ControlMesh& mesh, const Refinement& refinement) {
  const int edge = carrier - refinement.controlVertices;
  const int triangle = edge - refinement.controlEdges;
  if (edge < 0) return controlCarried(vertex);
  if (triangle < 0) return edgeCarried(mesh, refinement, edge, vertex);
  return insideCarried(mesh, refinement, triangle, vertex);
}

/// Weights of a tile's candidates at its lanes.
void fillWeights(const VertexTile& tile, const ControlMesh& mesh, const Refinement& refinement,
                 const CandidateLists& lists, VertexTiles& out) {
  for (int lane = 0; lane < tile.used; ++lane) {
    const CarriedVertex vertex = carriedBy(at(tile.carriers, lane), at(tile.vertices, lane), mesh, refinement);
    std::size_t place = toIndex(tile.firstCandidate);
    for (const CarrierCandidate& candidate : lists.of(vertex.carrier)) {
      while (out.candidates[place].primitive < candidate.primitive) ++place;
      at(out.weights[place].lane, lane) = candidate.weightAt(vertex.barycentric);
    }
  }
}

}  // namespace

CarriedVertex edgeCarried(const ControlMesh& mesh, const Refinement& refinement, int edge, int vertex) {
  const auto& ends = at(mesh.edges, edge).vertices;
  const int step = vertex - refinement.edgeVertex(edge, 1) + 1;
  const auto w = static_cast<float>(refinement.shareAt(edge, step));
  return {vertex, refinement.controlVertices + edge, {ends[0], ends[1], ends[1]}, {1.0f - w, w, 0.0f}};
}

CarriedVertex insideCarried(const ControlMesh& mesh, const Refinement& refinement, int triangle, int vertex) {
  const glm::dvec2& place = refinement.insideAt(vertex);
  return {vertex,
          refinement.controlVertices + refinement.controlEdges + triangle,
          at(mesh.triangles, triangle).vertices,
          {static_cast<float>(1.0 - place.x - place.y), static_cast<float>(place.x), static_cast<float>(place.y)}};
}

CarriedVertex carriedVertex(const ControlMesh& mesh, const Refinement& refinement, int vertex) {
  const auto pieceOf = [&](std::span<const int> begin) {
    return static_cast<int>(std::ranges::upper_bound(begin, vertex) - begin.begin()) - 1;
  };
  if (vertex < refinement.controlVertices) return controlCarried(vertex);
  if (vertex < refinement.insideBegin.front()) {
    return edgeCarried(mesh, refinement, pieceOf(refinement.edgeBegin), vertex);
  }
  return insideCarried(mesh, refinement, pieceOf(refinement.insideBegin), vertex);
}

VertexTiles makeVertexTiles(const ControlMesh& mesh, const Refinement& refinement, const CandidateLists& lists) {
  VertexTiles out;
  Packer packer(lists, out);
  std::vector<bool> known(toIndex(refinement.controlVertices + refinement.controlEdges), false);
  const auto once = [&](int carrier) {
    if (known[toIndex(carrier)]) return false;
    known[toIndex(carrier)] = true;
    return true;
  };
  const auto addVertex = [&](int v) {
    if (once(v)) packer.addCarrier(v, v, 1);
  };
  const auto addEdge = [&](int e) {
    const int carrier = refinement.controlVertices + e;
    if (once(carrier)) packer.addCarrier(carrier, refinement.edgeVertex(e, 1), refinement.edgeVertices(e));
  };
  for (const int t : alongCurve(mesh)) {
    const ControlTriangle& triangle = at(mesh.triangles, t);
    std::ranges::for_each(triangle.vertices, addVertex);
    std::ranges::for_each(triangle.edges, addEdge);
    packer.addCarrier(refinement.controlVertices + refinement.controlEdges + t, at(refinement.insideBegin, t),
                      refinement.insideVertices(t));
  }
  // Edges and vertices without triangles are projected as well.
  for (int e = 0; e < refinement.controlEdges; ++e) addEdge(e);
  for (int v = 0; v < refinement.controlVertices; ++v) addVertex(v);
  packer.closeAll();
  out.weights.resize(out.candidates.size());
  forEachIndex(out.tiles.size(), 64, [&](std::size_t i) { fillWeights(out.tiles[i], mesh, refinement, lists, out); });
  return out;
}

}  // namespace sinew
