// core/geometry/weld.cpp: merges split vertices with a hash grid; hashes edges by their ends.
#include "core/geometry/weld.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/geometry/at.h"
#include "core/geometry/index_table.h"
#include "core/geometry/normals.h"

namespace sinew {

void findEdges(ControlMesh& mesh) {
  mesh.edges.clear();
  IndexTable table(3 * mesh.triangles.size());
  for (ControlTriangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = triangle.vertices[i];
      const int b = triangle.vertices[(i + 1) % 3];
      const std::array<int, 2> ends{std::min(a, b), std::max(a, b)};
      const std::uint64_t hash = hashCombine(static_cast<std::uint64_t>(ends[0]), static_cast<std::uint64_t>(ends[1]));
      const int next = static_cast<int>(mesh.edges.size());
      const int found = table.findOrInsert(hash, next, [&](int e) { return at(mesh.edges, e).vertices == ends; });
      if (found == next) mesh.edges.push_back({.vertices = ends});
      ++at(mesh.edges, found).triangleCount;
      triangle.edges[i] = found;
    }
  }
}

Topology topologyOf(std::span<const std::array<int, 3>> triangles) {
  std::vector<std::array<int, 2>> edges;
  std::vector<int> vertices;
  edges.reserve(3 * triangles.size());
  vertices.reserve(3 * triangles.size());
  for (const std::array<int, 3>& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      edges.push_back({low, high});
      vertices.push_back(triangle[i]);
    }
  }
  std::ranges::sort(edges);
  std::ranges::sort(vertices);

  Topology result;
  result.triangles = static_cast<int>(triangles.size());
  result.vertices = static_cast<int>(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    ++result.edges;
    if (end - i == 1) result.borderEdges.push_back(edges[i]);
    if (end - i > 2) result.nonManifoldEdges.push_back(edges[i]);
    i = end;
  }
  return result;
}

Topology topologyOf(const ControlMesh& mesh) {
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const ControlTriangle& triangle : mesh.triangles) triangles.push_back(triangle.vertices);
  return topologyOf(triangles);
}

namespace {

constexpr float kWeightTolerance = 1e-4f;  ///< Well below 0.004, the step of an 8-bit weight.
/// Width of cells in tolerances, so that a vertex rarely needs neighbor cells.
constexpr double kCellInTolerances = 8.0;
/// Most cells along the longest axis, so that cell numbers are exact in double and in 64 bits.
constexpr double kMostCells = 1e15;
/// Vertices of one cell compared by tolerance; in denser cells only equal ones merge, which bounds the work.
constexpr int kMostCompared = 64;

using Cell = std::array<std::int64_t, 3>;

/// Finds the representative of every used soup vertex: one at the same place with the same bindings and weights, since
/// pieces that are smoothed separately would tear the surface apart (docs/design.md, Welding). Exact duplicates are
/// found by a hash; others are compared, in order of arrival, with the representatives in the grid cells around them.
/// Only representatives are in the grid, so a chain of near vertices cannot collapse into one.
class Welder {
 public:
  Welder(const TriangleSoup& soup, float tolerance)
      : soup_(soup),
        tolerance_(tolerance),
        exact_(soup.positions.size()),
        cells_(soup.positions.size()),
        nextInCell_(soup.positions.size(), -1),
        representative_(soup.positions.size(), -1) {
    const Bounds bounds = boundsOf(soup.positions);
    if (bounds.isEmpty()) return;
    low_ = glm::dvec3(bounds.low);
    for (const RoundedPiece& piece : soup.pieces) mostRounded_ = std::max(mostRounded_, piece.place);
    const glm::dvec3 extent = glm::dvec3(bounds.high) - low_;
    const double longest = std::max({extent.x, extent.y, extent.z, 1e-300});
    const double reach = static_cast<double>(tolerance) + 2.0 * static_cast<double>(mostRounded_);
    cellSize_ = std::max(kCellInTolerances * reach, longest / kMostCells);
  }

  int representativeOf(int vertex) {
    int& known = at(representative_, vertex);
    if (known < 0) known = find(vertex);
    return known;
  }

 private:
  int find(int vertex) {
    const int same =
        exact_.findOrInsert(exactHash(vertex), vertex, [&](int other) { return exactlyEqual(vertex, other); });
    if (same != vertex) return at(representative_, same);
    const int near = nearest(vertex);
    if (near >= 0) return near;
    addToCell(vertex);
    return vertex;
  }

  [[nodiscard]] std::uint64_t exactHash(int vertex) const {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) hash = hashCombine(hash, floatBits(at(soup_.positions, vertex)[axis]));
    for (const Influence& influence : influencesOf(vertex)) {
      hash = hashCombine(hash, static_cast<std::uint64_t>(influence.binding));
      hash = hashCombine(hash, floatBits(influence.weight));
    }
    return hash;
  }

  [[nodiscard]] bool exactlyEqual(int a, int b) const {
    return at(soup_.positions, a) == at(soup_.positions, b) &&
           std::ranges::equal(influencesOf(a), influencesOf(b), [](const Influence& x, const Influence& y) {
             return x.binding == y.binding && x.weight == y.weight;
           });
  }

  /// The first representative, in order of arrival, within the tolerance and with the same bindings.
  [[nodiscard]] int nearest(int vertex) const {
    const glm::dvec3 p = glm::dvec3(at(soup_.positions, vertex));
    const double reach = static_cast<double>(tolerance_ + pieceOf(vertex).place + mostRounded_);
    const Cell first = cellOf(p - reach);
    const Cell last = cellOf(p + reach);
    int best = -1;
    for (std::int64_t x = first[0]; x <= last[0]; ++x) {
      for (std::int64_t y = first[1]; y <= last[1]; ++y) {
        for (std::int64_t z = first[2]; z <= last[2]; ++z) {
          const int found = firstAlike(vertex, Cell{x, y, z});
          if (found >= 0 && (best < 0 || at(order_, found) < at(order_, best))) best = found;
        }
      }
    }
    return best;
  }

  [[nodiscard]] int firstAlike(int vertex, const Cell& cell) const {
    int other = cells_.find(cellHash(cell), [&](int head) { return cellOf(head) == cell; });
    for (int compared = 0; other >= 0 && compared < kMostCompared; ++compared, other = at(nextInCell_, other)) {
      if (alike(vertex, other)) return other;
    }
    return -1;
  }

  [[nodiscard]] bool alike(int a, int b) const {
    const glm::dvec3 offset = glm::dvec3(at(soup_.positions, a)) - glm::dvec3(at(soup_.positions, b));
    const RoundedPiece rounded = between(a, b);
    const double reach = static_cast<double>(tolerance_ + rounded.place);
    if (!(glm::dot(offset, offset) <= reach * reach)) return false;
    return rounded.weight > 0.0f ? followAlike(a, b, kWeightTolerance + rounded.weight) : followSame(a, b);
  }

  [[nodiscard]] bool followSame(int a, int b) const {
    return std::ranges::equal(influencesOf(a), influencesOf(b), [](const Influence& x, const Influence& y) {
      return x.binding == y.binding && std::abs(x.weight - y.weight) <= kWeightTolerance;
    });
  }

  /// The same if small weights may have been rounded to 0.
  [[nodiscard]] bool followAlike(int a, int b, float most) const {
    const std::span<const Influence> left = influencesOf(a);
    const std::span<const Influence> right = influencesOf(b);
    for (std::size_t i = 0, j = 0; i < left.size() || j < right.size();) {
      const bool takeLeft = i < left.size() && (j == right.size() || left[i].binding <= right[j].binding);
      const bool takeRight = j < right.size() && (i == left.size() || right[j].binding <= left[i].binding);
      const float difference = (takeLeft ? left[i].weight : 0.0f) - (takeRight ? right[j].weight : 0.0f);
      if (std::abs(difference) > most) return false;
      i += takeLeft ? 1 : 0;
      j += takeRight ? 1 : 0;
    }
    return true;
  }

  [[nodiscard]] RoundedPiece pieceOf(int vertex) const {
    return soup_.pieces.empty() ? RoundedPiece{} : at(soup_.pieces, at(soup_.pieceOf, vertex));
  }

  /// Largest difference by rounding between two vertices; none within a piece.
  [[nodiscard]] RoundedPiece between(int a, int b) const {
    if (soup_.pieces.empty() || at(soup_.pieceOf, a) == at(soup_.pieceOf, b)) return {};
    const RoundedPiece left = pieceOf(a);
    const RoundedPiece right = pieceOf(b);
    return {left.place + right.place, left.weight + right.weight};
  }

  void addToCell(int vertex) {
    if (order_.empty()) {
      order_.assign(soup_.positions.size(), -1);
      tailOfCell_.assign(soup_.positions.size(), -1);
    }
    at(order_, vertex) = count_++;
    const Cell cell = cellOf(vertex);
    const int head = cells_.findOrInsert(cellHash(cell), vertex, [&](int other) { return cellOf(other) == cell; });
    if (head != vertex) at(nextInCell_, at(tailOfCell_, head)) = vertex;
    at(tailOfCell_, head) = vertex;
  }

  [[nodiscard]] Cell cellOf(const glm::dvec3& p) const {
    const glm::dvec3 cell = glm::floor((p - low_) / cellSize_);
    return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y), static_cast<std::int64_t>(cell.z)};
  }
  [[nodiscard]] Cell cellOf(int vertex) const { return cellOf(glm::dvec3(at(soup_.positions, vertex))); }

  [[nodiscard]] static std::uint64_t cellHash(const Cell& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t number : cell) hash = hashCombine(hash, static_cast<std::uint64_t>(number));
    return hash;
  }

  [[nodiscard]] std::span<const Influence> influencesOf(int vertex) const {
    const int begin = at(soup_.influenceBegin, vertex);
    return std::span(soup_.influences)
        .subspan(toIndex(begin), toIndex(soup_.influenceBegin[toIndex(vertex) + 1] - begin));
  }

  const TriangleSoup& soup_;
  float tolerance_;
  float mostRounded_ = 0.0f;  // of all pieces, RoundedPiece::place
  glm::dvec3 low_{0.0};
  double cellSize_ = 1.0;
  IndexTable exact_;             // one entry for each distinct (position, influences)
  IndexTable cells_;             // first representative of each cell
  std::vector<int> nextInCell_;  // [N] chain of the representatives of one cell
  std::vector<int> tailOfCell_;  // [N] for a cell's first representative: the last one
  std::vector<int> order_;       // [N] for representatives: when they came
  std::vector<int> representative_;
  int count_ = 0;
};

struct KeptTriangle {
  std::array<int, 3> representatives{};
  std::size_t soupTriangle = 0;
};

std::vector<KeptTriangle> keepTriangles(const TriangleSoup& soup, float tolerance) {
  Welder welder(soup, tolerance);
  std::vector<KeptTriangle> kept;
  kept.reserve(soup.triangles.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    KeptTriangle triangle{.representatives = {}, .soupTriangle = t};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.representatives[i] = welder.representativeOf(static_cast<int>(soup.triangles[t][i]));
    }
    const auto [a, b, c] = triangle.representatives;
    if (a != b && b != c && c != a) kept.push_back(triangle);
  }
  return kept;
}

/// Numbers vertices and wedges in order of first use while triangles are added.
class MeshBuilder {
 public:
  MeshBuilder(const TriangleSoup& soup, std::size_t triangles)
      : soup_(soup), vertexOf_(soup.positions.size(), -1), wedgeTable_(3 * triangles) {
    mesh_.triangles.reserve(triangles);
    mesh_.influenceBegin.push_back(0);
  }

  void add(const KeptTriangle& kept) {
    ControlTriangle triangle;
    triangle.material = soup_.materials[kept.soupTriangle];
    if (!soup_.parts.empty()) triangle.part = soup_.parts[kept.soupTriangle];
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.vertices[i] = vertex(kept.representatives[i]);
      triangle.wedges[i] = wedge(triangle.vertices[i], soup_.triangles[kept.soupTriangle][i]);
    }
    mesh_.triangles.push_back(triangle);
  }

  [[nodiscard]] const std::vector<int>& standsFor() const { return standsFor_; }
  ControlMesh take() && { return std::move(mesh_); }

 private:
  int vertex(int representative) {
    int& number = at(vertexOf_, representative);
    if (number >= 0) return number;
    number = static_cast<int>(mesh_.positions.size());
    standsFor_.push_back(representative);
    mesh_.positions.push_back(at(soup_.positions, representative));
    for (int i = at(soup_.influenceBegin, representative); i < soup_.influenceBegin[toIndex(representative) + 1]; ++i) {
      mesh_.influences.push_back(at(soup_.influences, i));
    }
    mesh_.influenceBegin.push_back(static_cast<int>(mesh_.influences.size()));
    return number;
  }

  int wedge(int vertex, std::size_t soupVertex) {
    const glm::vec2& uv = soup_.uvs[soupVertex];
    const glm::vec4 color = soup_.colors.empty() ? glm::vec4(1.0f) : soup_.colors[soupVertex];
    std::uint64_t hash = hashCombine(hashCombine(static_cast<std::uint64_t>(vertex), floatBits(uv.x)), floatBits(uv.y));
    if (!soup_.colors.empty()) {
      for (int channel = 0; channel < 4; ++channel) hash = hashCombine(hash, floatBits(color[channel]));
    }
    const int next = static_cast<int>(mesh_.wedges.size());
    const int found = wedgeTable_.findOrInsert(hash, next, [&](int w) {
      const Wedge& other = at(mesh_.wedges, w);
      return other.vertex == vertex && other.uv == uv && other.color == color;
    });
    if (found == next) mesh_.wedges.push_back({.vertex = vertex, .uv = uv, .color = color});
    return found;
  }

  const TriangleSoup& soup_;
  ControlMesh mesh_;
  std::vector<int> vertexOf_;   // [N] representative -> geometric vertex
  std::vector<int> standsFor_;  // [V] and back
  IndexTable wedgeTable_;
};

}  // namespace

ControlMesh weld(const TriangleSoup& soup, float tolerance, std::vector<int>* standsFor) {
  assert(tolerance >= 0.0f && soup.uvs.size() == soup.positions.size());
  assert(soup.colors.empty() || soup.colors.size() == soup.positions.size());
  assert(soup.influenceBegin.size() == soup.positions.size() + 1 && soup.materials.size() == soup.triangles.size());
  assert(soup.pieces.empty() || soup.pieceOf.size() == soup.positions.size());
  assert(soup.parts.empty() || soup.parts.size() == soup.triangles.size());
  const std::vector<KeptTriangle> kept = keepTriangles(soup, tolerance);
  MeshBuilder builder(soup, kept.size());
  for (const KeptTriangle& triangle : kept) builder.add(triangle);
  if (standsFor) *standsFor = builder.standsFor();
  ControlMesh mesh = std::move(builder).take();
  mesh.trianglesDropped = static_cast<int>(soup.triangles.size() - kept.size());
  findEdges(mesh);
  mesh.normals = vertexNormals(mesh.positions, mesh.triangles);
  return mesh;
}

std::vector<int> weldedTriangles(const TriangleSoup& soup, float tolerance) {
  std::vector<int> welded(soup.triangles.size(), -1);
  int next = 0;
  for (const KeptTriangle& triangle : keepTriangles(soup, tolerance)) welded[triangle.soupTriangle] = next++;
  return welded;
}

bool hasColors(const ControlMesh& mesh) {
  return std::ranges::any_of(mesh.wedges, [](const Wedge& wedge) { return wedge.color != glm::vec4(1.0f); });
}

ControlMesh joinedByPosition(const ControlMesh& mesh, float tolerance) {
  TriangleSoup soup;
  soup.positions = mesh.positions;
  soup.uvs.assign(mesh.positions.size(), glm::vec2(0.0f));
  soup.influences.assign(mesh.positions.size(), Influence{0, 1.0f});
  for (std::size_t v = 0; v <= mesh.positions.size(); ++v) soup.influenceBegin.push_back(static_cast<int>(v));
  for (const ControlTriangle& triangle : mesh.triangles) {
    const auto& v = triangle.vertices;
    soup.triangles.push_back(
        {static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]), static_cast<std::uint32_t>(v[2])});
    soup.materials.push_back(triangle.material);
  }
  return weld(soup, tolerance);
}

}  // namespace sinew
