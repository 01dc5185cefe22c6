// core/smoothing/patches/refinement.cpp: the n^2 split with shared vertices.
#include "sinew/smoothing/refinement.h"

#include <cassert>

#include "core/base/at.h"
#include "core/mesh/index_table.h"
#include "sinew/rig/rig.h"

namespace sinew {
namespace {

/// Position in a control triangle's lattice: barycentric (n-j-k, j, k) / n.
struct LatticePoint {
  int j = 0;
  int k = 0;
};

/// Index of (j, k) among the inner lattice points, row by row (j = 1 first).
int interiorIndex(int depth, int j, int k) {
  int index = k - 1;
  for (int row = 1; row < j; ++row) index += depth - 1 - row;
  return index;
}

/// Splits each control triangle into a lattice of n^2 triangles. Vertices on an edge belong to the edge and are
/// numbered in its own direction, so that the triangles at it share them and cracks cannot open. Vertices as drawn have
/// texture coordinates and colors besides: they are shared along an edge only where both triangles have the same two
/// wedges. docs/design.md, Refinement.
class Builder {
 public:
  Builder(const ControlMesh& mesh, int depth)
      : mesh_(mesh), colored_(hasColors(mesh)), runs_(depth > 1 ? 3 * mesh.triangles.size() : 0) {
    out_.depth = depth;
    out_.controlVertices = static_cast<int>(mesh.positions.size());
    out_.controlEdges = static_cast<int>(mesh.edges.size());
    out_.edgeVertices = depth - 1;
    out_.interiorVertices = (depth - 1) * (depth - 2) / 2;
    out_.vertexCount = static_cast<int>(refinedVertexCount(mesh, depth));
  }

  Refinement build() {
    fillInterior();
    fillCornerWedges();
    lattice_.resize(static_cast<std::size_t>((out_.depth + 1) * (out_.depth + 1)));
    drawLattice_.resize(lattice_.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) splitTriangle(static_cast<int>(t));
    countTriangles();
    return std::move(out_);
  }

 private:
  void fillInterior() {
    for (int j = 1; j <= out_.depth - 2; ++j) {
      for (int k = 1; k <= out_.depth - 1 - j; ++k) out_.interior.push_back({j, k});
    }
  }

  void fillCornerWedges() {
    for (const Wedge& wedge : mesh_.wedges) addDrawn(wedge.vertex, wedge.uv, wedge.color);
  }

  int addDrawn(int refinedVertex, const glm::vec2& uv, const glm::vec4& color) {
    out_.drawVertex.push_back(refinedVertex);
    out_.drawUv.push_back(uv);
    // Shares of 1 need not sum to 1 in floats, and glTF allows no color above 1.
    if (colored_) out_.drawColor.push_back(glm::clamp(color, 0.0f, 1.0f));
    return static_cast<int>(out_.drawVertex.size()) - 1;
  }

  std::size_t indexOf(LatticePoint p) const { return static_cast<std::size_t>(p.j * (out_.depth + 1) + p.k); }

  void splitTriangle(int t) {
    const ControlTriangle& triangle = at(mesh_.triangles, t);
    placeCorners(triangle);
    for (int side = 0; side < 3; ++side) placeEdge(triangle, side);
    placeInterior(t, triangle);
    emitTriangles();
  }

  void placeCorners(const ControlTriangle& triangle) {
    const std::array<LatticePoint, 3> corners{{{0, 0}, {out_.depth, 0}, {0, out_.depth}}};
    for (std::size_t c = 0; c < 3; ++c) {
      lattice_[indexOf(corners[c])] = triangle.vertices[c];
      drawLattice_[indexOf(corners[c])] = triangle.wedges[c];
    }
  }

  /// Lattice point `step` from corner `side` towards corner side + 1.
  LatticePoint onSide(int side, int step) const {
    if (side == 0) return {step, 0};
    if (side == 1) return {out_.depth - step, step};
    return {0, out_.depth - step};
  }

  void placeEdge(const ControlTriangle& triangle, int side) {
    if (out_.edgeVertices == 0) return;
    const auto from = static_cast<std::size_t>(side);
    const auto to = static_cast<std::size_t>((side + 1) % 3);
    const int edge = triangle.edges[from];
    const bool forward = at(mesh_.edges, edge).vertices[0] == triangle.vertices[from];
    const int base = forward ? edgeRun(edge, {triangle.wedges[from], triangle.wedges[to]})
                             : edgeRun(edge, {triangle.wedges[to], triangle.wedges[from]});
    for (int step = 1; step < out_.depth; ++step) {
      const int stepOnEdge = forward ? step : out_.depth - step;
      lattice_[indexOf(onSide(side, step))] = out_.edgeVertex(edge, stepOnEdge);
      drawLattice_[indexOf(onSide(side, step))] = base + stepOnEdge - 1;
    }
  }

  /// First drawn vertex of the edge between these two wedges; made when first asked for.
  int edgeRun(int edge, const std::array<int, 2>& wedges) {
    const std::uint64_t hash =
        hashCombine(static_cast<std::uint64_t>(wedges[0]), static_cast<std::uint64_t>(wedges[1]));
    const int next = static_cast<int>(out_.drawRuns.size());
    const int run =
        runs_.findOrInsert(hash, next, [&](int other) { return at(out_.drawRuns, other).wedges == wedges; });
    if (run != next) return at(out_.drawRuns, run).first;
    const int first = static_cast<int>(out_.drawVertex.size());
    const Wedge& wedge0 = at(mesh_.wedges, wedges[0]);
    const Wedge& wedge1 = at(mesh_.wedges, wedges[1]);
    for (int step = 1; step < out_.depth; ++step) {
      const float w = static_cast<float>(step) / static_cast<float>(out_.depth);
      addDrawn(out_.edgeVertex(edge, step), wedge0.uv * (1.0f - w) + wedge1.uv * w,
               wedge0.color * (1.0f - w) + wedge1.color * w);
    }
    out_.drawRuns.push_back({edge, wedges, first});
    return first;
  }

  void placeInterior(int t, const ControlTriangle& triangle) {
    const Wedge& wedge0 = at(mesh_.wedges, triangle.wedges[0]);
    const Wedge& wedge1 = at(mesh_.wedges, triangle.wedges[1]);
    const Wedge& wedge2 = at(mesh_.wedges, triangle.wedges[2]);
    const float n = static_cast<float>(out_.depth);
    if (!out_.interior.empty()) out_.drawInterior.push_back(static_cast<int>(out_.drawVertex.size()));
    for (const auto& [j, k] : out_.interior) {
      const int vertex = out_.interiorVertex(t, interiorIndex(out_.depth, j, k));
      const float v = static_cast<float>(j) / n;
      const float w = static_cast<float>(k) / n;
      lattice_[indexOf({j, k})] = vertex;
      drawLattice_[indexOf({j, k})] = addDrawn(vertex, wedge0.uv * (1.0f - v - w) + wedge1.uv * v + wedge2.uv * w,
                                               wedge0.color * (1.0f - v - w) + wedge1.color * v + wedge2.color * w);
    }
  }

  void countTriangles() {
    out_.trianglesAt.assign(static_cast<std::size_t>(out_.vertexCount), 0);
    for (const std::array<int, 3>& triangle : out_.triangles) {
      for (const int vertex : triangle) ++at(out_.trianglesAt, vertex);
    }
  }

  void emitTriangles() {
    const int n = out_.depth;
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n - j; ++k) {
        emit({j, k}, {j + 1, k}, {j, k + 1});
        if (k < n - j - 1) emit({j + 1, k}, {j + 1, k + 1}, {j, k + 1});
      }
    }
  }

  void emit(LatticePoint a, LatticePoint b, LatticePoint c) {
    out_.triangles.push_back({lattice_[indexOf(a)], lattice_[indexOf(b)], lattice_[indexOf(c)]});
    out_.drawTriangles.push_back({static_cast<std::uint32_t>(drawLattice_[indexOf(a)]),
                                  static_cast<std::uint32_t>(drawLattice_[indexOf(b)]),
                                  static_cast<std::uint32_t>(drawLattice_[indexOf(c)])});
  }

  const ControlMesh& mesh_;
  bool colored_ = false;
  Refinement out_;
  IndexTable runs_;               ///< Finds drawRuns by their wedges, which name the edge too.
  std::vector<int> lattice_;      ///< Refined vertices of the triangle at hand.
  std::vector<int> drawLattice_;  ///< Drawn vertices of the triangle at hand.
};

}  // namespace

Refinement refine(const ControlMesh& mesh, int depth) {
  assert(depth >= 1 && depth <= kMaxDepth);
  return Builder(mesh, depth).build();
}

std::int64_t refinedVertexCount(const ControlMesh& mesh, int depth) {
  const std::int64_t n = depth;
  return static_cast<std::int64_t>(mesh.positions.size()) + static_cast<std::int64_t>(mesh.edges.size()) * (n - 1) +
         static_cast<std::int64_t>(mesh.triangles.size()) * ((n - 1) * (n - 2) / 2);
}

}  // namespace sinew
