// core/surface/patches/refinement.cpp: control triangles split with shared vertices.
#include "sinew/surface/refinement.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <span>

#include "core/geometry/at.h"
#include "core/geometry/index_table.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/patches/split_triangle.h"
#include "core/surface/patches/triangulation.h"
#include "sinew/rig/rig.h"

namespace sinew {
namespace {

/// Pieces with vertices, those with the most first. @param begin  first vertex of each piece.
std::vector<int> mostFirst(std::span<const int> begin) {
  const auto count = [&](int i) { return at(begin, i + 1) - at(begin, i); };
  std::vector<int> order;
  for (int i = 0; i + 1 < static_cast<int>(begin.size()); ++i) {
    if (count(i) > 0) order.push_back(i);
  }
  std::ranges::stable_sort(order, std::ranges::greater(), count);
  return order;
}

/// Vertices on an edge belong to the edge and are numbered in its own direction, so that its triangles share them and
/// no crack can open. Drawn vertices also have texture coordinates and colors: triangles share them along an edge only
/// if both have the same two wedges. docs/design.md, Refinement.
class Builder {
 public:
  Builder(const ControlMesh& mesh, const RefinementLevels& levels, const AlignedSplits& splits)
      : mesh_(mesh), levels_(levels), splits_(splits), colored_(hasColors(mesh)), runs_(3 * mesh.triangles.size()) {
    assert(levels.edges.size() == mesh.edges.size() && levels.triangles.size() == mesh.triangles.size());
  }

  Refinement build() {
    out_.controlVertices = static_cast<int>(mesh_.positions.size());
    out_.controlEdges = static_cast<int>(mesh_.edges.size());
    numberEdges();
    placeOnEdges();
    out_.insideBegin.push_back(out_.edgeBegin.back());
    out_.triangleBegin.push_back(0);
    for (const Wedge& wedge : mesh_.wedges) addDrawn(wedge.vertex, wedge.uv, wedge.color);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) splitTriangle(static_cast<int>(t));
    out_.vertexCount = out_.insideBegin.back();
    countTriangles();
    out_.edgeOrder = mostFirst(out_.edgeBegin);
    out_.insideOrder = mostFirst(out_.insideBegin);
    return std::move(out_);
  }

 private:
  void numberEdges() {
    out_.depth = 1;
    int first = out_.controlVertices;
    for (const std::uint8_t level : levels_.edges) {
      assert(level >= 1 && level <= kMaxDepth);
      out_.depth = std::max<int>(out_.depth, level);
      out_.edgeBegin.push_back(first);
      first += level - 1;
    }
    out_.edgeBegin.push_back(first);
    for (const std::uint8_t level : levels_.triangles) out_.depth = std::max<int>(out_.depth, level);
    const auto isDeepest = [&](std::uint8_t level) { return level == out_.depth; };
    out_.isUniform = std::ranges::all_of(levels_.edges, isDeepest) && std::ranges::all_of(levels_.triangles, isDeepest);
  }

  [[nodiscard]] bool isMoved(std::size_t edge) const {
    return !splits_.edges.empty() && !splits_.edges[edge].empty() &&
           splits_.edges[edge].size() + 1 == levels_.edges[edge];
  }

  void placeOnEdges() {
    for (std::size_t e = 0; e < mesh_.edges.size() && !movesEdges_; ++e) movesEdges_ = isMoved(e);
    if (!movesEdges_) return;
    out_.isUniform = false;
    std::vector<double> shares;
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      const auto edge = static_cast<int>(e);
      for (int step = 1; step < out_.edgeLevel(edge); ++step) {
        shares.push_back(isMoved(e) ? splits_.edges[e][toIndex(step - 1)] : out_.shareAt(edge, step));
      }
    }
    out_.onEdges = std::move(shares);
  }

  int addDrawn(int refinedVertex, const glm::vec2& uv, const glm::vec4& color) {
    out_.drawVertex.push_back(refinedVertex);
    out_.drawUv.push_back(uv);
    // Weights need not sum to 1 in floats, and glTF allows no color above 1.
    if (colored_) out_.drawColor.push_back(glm::clamp(color, 0.0f, 1.0f));
    return static_cast<int>(out_.drawVertex.size()) - 1;
  }

  /// Fills points_ and drawPoints_, numbered as SplitTriangle numbers them.
  void splitTriangle(int t) {
    const ControlTriangle& triangle = at(mesh_.triangles, t);
    points_.assign(triangle.vertices.begin(), triangle.vertices.end());
    drawPoints_.assign(triangle.wedges.begin(), triangle.wedges.end());
    const SplitLevels levels = splitOf(mesh_, levels_, t);
    for (std::size_t side = 0; side < 3; ++side) placeSide(triangle, side);
    if (const Triangulation* own = triangulationOf(t, levels)) {
      out_.isUniform = false;
      placeInside(triangle, own->inside);
      addTriangles(t, own->triangles);
    } else {
      split(t, levels);
      placeInside(triangle, split_.inside());
      addTriangles(t, split_.triangles());
    }
    out_.triangleBegin.push_back(static_cast<int>(out_.triangles.size()));
  }

  [[nodiscard]] const Triangulation* triangulationOf(int t, const SplitLevels& levels) const {
    if (splits_.triangles.empty()) return nullptr;
    const Triangulation& own = at(splits_.triangles, t);
    return own.levels == levels && !own.triangles.empty() ? &own : nullptr;
  }

  void split(int t, const SplitLevels& levels) {
    // Most meshes have one level: all triangles are split alike.
    if (levels.isUniform() && !movesEdges_ && splitUniformly_ == levels.inside) return;
    const auto corner = [&](std::size_t c) { return at(mesh_.positions, at(mesh_.triangles, t).vertices[c]); };
    const SideShares sides = movesEdges_ ? sidesOf(mesh_, levels_, splits_.edges, t) : SideShares{};
    split_.split(levels, {corner(0), corner(1), corner(2)}, sides);
    splitUniformly_ = levels.isUniform() ? levels.inside : 0;
  }

  /// @param small  points of the split
  void addTriangles(int t, const auto& small) {
    for (const auto& [a, b, c] : small) {
      const auto refined = [&](int point) { return at(points_, point); };
      const auto drawn = [&](int point) { return static_cast<std::uint32_t>(at(drawPoints_, point)); };
      out_.triangles.push_back({refined(a), refined(b), refined(c)});
      out_.drawTriangles.push_back({drawn(a), drawn(b), drawn(c)});
      out_.controlOf.push_back(t);
    }
  }

  void placeSide(const ControlTriangle& triangle, std::size_t side) {
    const int edge = triangle.edges[side];
    const int level = out_.edgeLevel(edge);
    if (level == 1) return;
    const std::size_t to = (side + 1) % 3;
    const bool forward = at(mesh_.edges, edge).vertices[0] == triangle.vertices[side];
    const int base = forward ? edgeRun(edge, {triangle.wedges[side], triangle.wedges[to]})
                             : edgeRun(edge, {triangle.wedges[to], triangle.wedges[side]});
    for (int step = 1; step < level; ++step) {
      const int stepOnEdge = forward ? step : level - step;
      points_.push_back(out_.edgeVertex(edge, stepOnEdge));
      drawPoints_.push_back(base + stepOnEdge - 1);
    }
  }

  /// First drawn vertex of the edge between two wedges, created on first use.
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
    for (int step = 1; step < out_.edgeLevel(edge); ++step) {
      const auto w = static_cast<float>(out_.shareAt(edge, step));
      addDrawn(out_.edgeVertex(edge, step), wedge0.uv * (1.0f - w) + wedge1.uv * w,
               wedge0.color * (1.0f - w) + wedge1.color * w);
    }
    out_.drawRuns.push_back({edge, wedges, first});
    return first;
  }

  void placeInside(const ControlTriangle& triangle, std::span<const glm::dvec2> inside) {
    const Wedge& wedge0 = at(mesh_.wedges, triangle.wedges[0]);
    const Wedge& wedge1 = at(mesh_.wedges, triangle.wedges[1]);
    const Wedge& wedge2 = at(mesh_.wedges, triangle.wedges[2]);
    out_.drawInside.push_back(static_cast<int>(out_.drawVertex.size()));
    int vertex = out_.insideBegin.back();
    for (const glm::dvec2& place : inside) {
      const auto v = static_cast<float>(place.x);
      const auto w = static_cast<float>(place.y);
      out_.inside.push_back(place);
      points_.push_back(vertex);
      drawPoints_.push_back(addDrawn(vertex++, wedge0.uv * (1.0f - v - w) + wedge1.uv * v + wedge2.uv * w,
                                     wedge0.color * (1.0f - v - w) + wedge1.color * v + wedge2.color * w));
    }
    out_.insideBegin.push_back(vertex);
  }

  void countTriangles() {
    out_.trianglesAt.assign(toIndex(out_.vertexCount), 0);
    for (const std::array<int, 3>& triangle : out_.triangles) {
      for (const int vertex : triangle) ++at(out_.trianglesAt, vertex);
    }
  }

  const ControlMesh& mesh_;
  const RefinementLevels& levels_;
  const AlignedSplits& splits_;
  bool movesEdges_ = false;
  bool colored_ = false;
  Refinement out_;
  IndexTable runs_;  ///< Finds drawRuns by their wedges, which identify the edge.
  SplitTriangle split_;
  int splitUniformly_ = 0;       ///< split_ holds the n^2 split of this n; 0: another split.
  std::vector<int> points_;      ///< Refined vertices of the current triangle.
  std::vector<int> drawPoints_;  ///< Its drawn vertices.
};

}  // namespace

RefinementLevels uniformLevels(const ControlMesh& mesh, int depth) {
  const auto level = static_cast<std::uint8_t>(depth);
  return {std::vector<std::uint8_t>(mesh.edges.size(), level), std::vector<std::uint8_t>(mesh.triangles.size(), level)};
}

Refinement refine(const ControlMesh& mesh, int depth) {
  assert(depth >= 1 && depth <= kMaxDepth);
  Refinement refinement = refine(mesh, uniformLevels(mesh, depth));
  refinement.depth = depth;  // For an empty mesh too.
  return refinement;
}

Refinement samplePoints(const ControlMesh& mesh, const RefinementLevels& samples) {
  Refinement out;
  out.isUniform = false;
  out.controlVertices = static_cast<int>(mesh.positions.size());
  out.controlEdges = static_cast<int>(mesh.edges.size());
  out.edgeBegin.push_back(out.controlVertices);
  for (const int level : samples.edges) out.edgeBegin.push_back(out.edgeBegin.back() + std::max(level, 1) - 1);
  out.insideBegin.push_back(out.edgeBegin.back());
  std::array<SplitTriangle, kMaxDepth + 1> splits;
  for (const int level : samples.triangles) {
    SplitTriangle& split = at(splits, level);
    if (split.triangles().empty()) split.split({{level, level, level}, level}, {});
    out.inside.insert(out.inside.end(), split.inside().begin(), split.inside().end());
    out.insideBegin.push_back(out.insideBegin.back() + static_cast<int>(split.inside().size()));
  }
  out.vertexCount = out.insideBegin.back();
  out.edgeOrder = mostFirst(out.edgeBegin);
  out.insideOrder = mostFirst(out.insideBegin);
  return out;
}

Refinement refine(const ControlMesh& mesh, const RefinementLevels& levels) {
  return refine(mesh, levels, AlignedSplits{});
}

Refinement refine(const ControlMesh& mesh, const RefinementLevels& levels, const AlignedSplits& splits) {
  return Builder(mesh, levels, splits).build();
}

SplitLevels splitOf(const ControlMesh& mesh, const RefinementLevels& levels, int triangle) {
  SplitLevels out;
  out.inside = at(levels.triangles, triangle);
  for (std::size_t i = 0; i < 3; ++i) out.sides[i] = at(levels.edges, at(mesh.triangles, triangle).edges[i]);
  return out;
}

SideShares sidesOf(const ControlMesh& mesh, const RefinementLevels& levels,
                   const std::vector<std::vector<double>>& edges, int triangle) {
  SideShares out;
  const ControlTriangle& own = at(mesh.triangles, triangle);
  for (std::size_t side = 0; side < 3; ++side) {
    const int edge = own.edges[side];
    if (at(edges, edge).size() + 1 != at(levels.edges, edge)) continue;
    out[side] = at(edges, edge);
    if (at(mesh.edges, edge).vertices[0] == own.vertices[side]) continue;
    std::ranges::reverse(out[side]);
    for (double& share : out[side]) share = 1.0 - share;
  }
  return out;
}

std::int64_t refinedVertexCount(const ControlMesh& mesh, int depth) {
  const std::int64_t n = depth;
  return static_cast<std::int64_t>(mesh.positions.size()) + static_cast<std::int64_t>(mesh.edges.size()) * (n - 1) +
         static_cast<std::int64_t>(mesh.triangles.size()) * ((n - 1) * (n - 2) / 2);
}

glm::dvec3 controlCoordinates(const ControlMesh& mesh, const Refinement& refinement, int triangle, int vertex) {
  const std::array<int, 3>& corners = at(mesh.triangles, triangle).vertices;
  glm::dvec3 out(0.0);
  const auto add = [&](int controlVertex, double share) {
    for (int c = 0; c < 3; ++c) {
      if (at(corners, c) == controlVertex) out[c] += share;
    }
  };
  if (vertex < refinement.controlVertices) {
    add(vertex, 1.0);
  } else if (vertex < refinement.insideBegin.front()) {
    const auto next = std::ranges::upper_bound(refinement.edgeBegin, vertex);
    const int edge = static_cast<int>(next - refinement.edgeBegin.begin()) - 1;
    const double share = refinement.shareAt(edge, vertex - at(refinement.edgeBegin, edge) + 1);
    add(at(mesh.edges, edge).vertices[0], 1.0 - share);
    add(at(mesh.edges, edge).vertices[1], share);
  } else {
    const glm::dvec2& place = refinement.insideAt(vertex);
    out = {1.0 - place.x - place.y, place.x, place.y};
  }
  return out;
}

}  // namespace sinew
