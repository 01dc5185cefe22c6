// core/geometry/normals.cpp: angle-weighted vertex normals.
// Source: G. Thuermer, C. A. Wuethrich, "Computing vertex normals from polygonal facets", J. Graphics Tools 3(1), 1998.
#include "core/geometry/normals.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"
#include "core/geometry/edge_sides.h"
#include "core/geometry/index_table.h"

namespace sinew {

namespace {

/// Rounding tolerance of angles: an edge of exactly the crease angle is no crease.
constexpr double kDegreesOfRounding = 0.01;
constexpr double kFlatness = 1e-6;  ///< Height over longest edge below which a triangle has no direction.
/// Number of triangles of an edge with which each is compared; bounds the work for edges with very many.
constexpr std::size_t kMostCreasesCompared = 16;

/// Unit normal of a face; zero if it has no area.
glm::dvec3 faceNormal(const ControlMesh& mesh, const ControlTriangle& triangle) {
  std::array<glm::dvec3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = glm::dvec3(at(mesh.positions, triangle.vertices[i]));
  const std::array<glm::dvec3, 3> along{p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  const double longest = std::max({glm::length(along[0]), glm::length(along[1]), glm::length(along[2])});
  if (!(longest > 0.0)) return glm::dvec3(0.0);
  const glm::dvec3 cross = glm::cross(along[0] / longest, along[1] / longest);
  const double height = glm::length(cross);
  return height > kFlatness ? cross / height : glm::dvec3(0.0);
}

int numberOfLongestSide(const ControlMesh& mesh, const ControlTriangle& triangle) {
  int longest = 0;
  double most = -1.0;
  for (int i = 0; i < 3; ++i) {
    const auto& ends = at(mesh.edges, at(triangle.edges, i)).vertices;
    const double length =
        glm::distance(glm::dvec3(at(mesh.positions, ends[0])), glm::dvec3(at(mesh.positions, ends[1])));
    if (length > most) longest = i;
    most = std::max(most, length);
  }
  return longest;
}

/// [T] Direction of each face; zero only if it has no area and its neighbors neither.
std::vector<glm::dvec3> faceNormals(const ControlMesh& mesh, const EdgeSides& sides) {
  std::vector<glm::dvec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const ControlTriangle& triangle : mesh.triangles) normals.push_back(faceNormal(mesh, triangle));
  std::vector<glm::dvec3> result = normals;
  for (std::size_t t = 0; t < result.size(); ++t) {
    if (result[t] != glm::dvec3(0.0)) continue;
    const ControlTriangle& triangle = mesh.triangles[t];
    for (const EdgeSide& other : sides.of(at(triangle.edges, numberOfLongestSide(mesh, triangle)))) {
      if (at(normals, other.triangle) == glm::dvec3(0.0)) continue;
      result[t] = at(normals, other.triangle);
      break;
    }
  }
  return result;
}

/// Disjoint sets of corners, represented by their smallest. A corner is 3 * triangle + its number there.
class Fans {
 public:
  explicit Fans(std::size_t corners) {
    parent_.reserve(corners);
    for (std::size_t corner = 0; corner < corners; ++corner) parent_.push_back(static_cast<int>(corner));
  }

  [[nodiscard]] int find(int corner) {
    while (at(parent_, corner) != corner) {
      at(parent_, corner) = at(parent_, at(parent_, corner));
      corner = at(parent_, corner);
    }
    return corner;
  }

  void join(int a, int b) {
    const int first = find(a);
    const int second = find(b);
    at(parent_, std::max(first, second)) = std::min(first, second);
  }

 private:
  std::vector<int> parent_;
};

int cornerAt(const ControlMesh& mesh, const EdgeSide& side, int vertex) {
  const bool first = at(at(mesh.triangles, side.triangle).vertices, side.side) == vertex;
  return 3 * side.triangle + (first ? side.side : (side.side + 1) % 3);
}

/// Joins corners into fans at both ends of every edge across which the surface bends by at most the angle. Union-find
/// over edges needs no order of faces around a vertex, so borders and edges of more than two faces are no special
/// cases. The normals in the file are ignored (docs/design.md, Creases).  @return [3T] representative of each corner's
/// fan
std::vector<int> fansOf(const ControlMesh& mesh, float degrees) {
  const EdgeSides sides(mesh);
  const std::vector<glm::dvec3> normals = faceNormals(mesh, sides);
  const double angle = (static_cast<double>(degrees) + kDegreesOfRounding) * std::numbers::pi / 180.0;
  const auto smooth = [&](int s, int t) {
    const glm::dvec3& a = at(normals, s);
    const glm::dvec3& b = at(normals, t);
    return a != glm::dvec3(0.0) && b != glm::dvec3(0.0) &&
           std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) <= angle;
  };
  Fans fans(3 * mesh.triangles.size());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const std::span<const EdgeSide> around = sides.of(static_cast<int>(e));
    for (std::size_t i = 0; i < around.size(); ++i) {
      for (std::size_t j = i + 1; j < std::min(around.size(), i + 1 + kMostCreasesCompared); ++j) {
        if (!smooth(around[i].triangle, around[j].triangle)) continue;
        for (const int vertex : mesh.edges[e].vertices) {
          fans.join(cornerAt(mesh, around[i], vertex), cornerAt(mesh, around[j], vertex));
        }
      }
    }
  }
  std::vector<int> result(3 * mesh.triangles.size());
  for (std::size_t c = 0; c < result.size(); ++c) result[c] = fans.find(static_cast<int>(c));
  return result;
}

int vertexOf(const ControlMesh& mesh, int corner) { return at(at(mesh.triangles, corner / 3).vertices, corner % 3); }

/// [V] whether the vertex has more than one fan.
std::vector<bool> creasedVertices(const ControlMesh& mesh, const std::vector<int>& fans) {
  std::vector<int> only(mesh.positions.size(), -1);
  std::vector<bool> result(mesh.positions.size(), false);
  for (std::size_t c = 0; c < fans.size(); ++c) {
    const auto vertex = toIndex(vertexOf(mesh, static_cast<int>(c)));
    if (only[vertex] < 0) only[vertex] = fans[c];
    if (only[vertex] != fans[c]) result[vertex] = true;
  }
  return result;
}

/// [3T] normals of the fans, at their representatives, from a mesh with one vertex for each fan.
std::vector<glm::vec3> fanNormals(const ControlMesh& mesh, const std::vector<int>& fans) {
  std::vector<glm::vec3> positions(fans.size());
  std::vector<ControlTriangle> triangles(mesh.triangles.size());
  for (std::size_t c = 0; c < fans.size(); ++c) {
    positions[c] = at(mesh.positions, vertexOf(mesh, static_cast<int>(c)));
    triangles[c / 3].vertices[c % 3] = fans[c];
  }
  return vertexNormals(positions, triangles);
}

}  // namespace

ControlMesh creased(const ControlMesh& mesh, float degrees) {
  assert(degrees >= 0.0f && degrees <= kNoCreases && !hasCreases(mesh));
  ControlMesh result = mesh;
  if (degrees >= kNoCreases) return result;
  const std::vector<int> fans = fansOf(mesh, degrees);
  const std::vector<bool> split = creasedVertices(mesh, fans);
  if (std::ranges::find(split, true) == split.end()) return result;
  const std::vector<glm::vec3> normals = fanNormals(mesh, fans);

  result.wedges.clear();
  std::vector<std::array<int, 2>> sources;  // [W] original wedge, and its fan or -1 if the vertex has only one.
  IndexTable table(fans.size());
  std::vector<int> numberOf(fans.size(), -1);
  int numbered = 0;
  for (std::size_t c = 0; c < fans.size(); ++c) {
    int& corner = result.triangles[c / 3].wedges[c % 3];
    Wedge wedge = at(mesh.wedges, corner);
    wedge.creased = at(split, wedge.vertex);
    if (wedge.creased) {
      int& number = at(numberOf, fans[c]);
      if (number < 0) number = numbered++;
      wedge.fan = number;
      wedge.normal = at(normals, fans[c]);
    }
    const std::array<int, 2> source{corner, wedge.creased ? fans[c] : -1};
    const int next = static_cast<int>(sources.size());
    corner = table.findOrInsert(
        hashCombine(hashCombine(0, static_cast<std::uint64_t>(source[0])), static_cast<std::uint64_t>(source[1])), next,
        [&](int other) { return at(sources, other) == source; });
    if (corner != next) continue;
    sources.push_back(source);
    result.wedges.push_back(wedge);
  }
  return result;
}

bool hasCreases(const ControlMesh& mesh) { return std::ranges::any_of(mesh.wedges, &Wedge::creased); }

bool isFlat(const glm::dmat3& matrix) {
  constexpr double kFlat = 1e-6;
  const double lengths = glm::length(matrix[0]) * glm::length(matrix[1]) * glm::length(matrix[2]);
  const double volume = std::abs(glm::determinant(matrix));
  return !(volume > kFlat * lengths) || !std::isfinite(volume);
}

namespace {

/// Angle at `a` between the directions to b and c; 0 if one has no length.
double cornerAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a;
  const glm::dvec3 v = c - a;
  // atan2 is accurate for slivers, unlike acos of the normalized dot product.
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

glm::dvec3 pointOf(std::span<const glm::vec3> positions, int vertex) { return glm::dvec3(at(positions, vertex)); }

/// Scale to the size of the mesh, since squares of very small or large coordinates would under- or overflow.
double scaleOf(std::span<const glm::vec3> positions) {
  const Bounds bounds = boundsOf(positions);
  const glm::dvec3 extent = bounds.isEmpty() ? glm::dvec3(1.0) : glm::dvec3(bounds.high) - glm::dvec3(bounds.low);
  const double largest = std::max({extent.x, extent.y, extent.z});
  return largest > 0.0 ? 1.0 / largest : 1.0;
}

/// Adds the face's unit normal times the angle of each corner to the sums of its vertices.
void addFace(std::span<const glm::vec3> positions, const ControlTriangle& triangle, double scale,
             std::vector<glm::dvec3>& sums) {
  std::array<glm::dvec3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = scale * pointOf(positions, triangle.vertices[i]);
  const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double area = glm::length(cross);
  if (!(area > 0.0)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = cornerAngle(p[i], p[(i + 1) % 3], p[(i + 2) % 3]);
    at(sums, triangle.vertices[i]) += (angle / area) * cross;
  }
}

glm::vec3 normalFrom(const glm::dvec3& sum) {
  // Faces that cancel leave only rounding; even one sliver weighs far more than this.
  constexpr double kCanceled = 1e-10;
  const double length = glm::length(sum);
  return length > kCanceled ? glm::vec3(sum / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

}  // namespace

std::vector<glm::vec3> vertexNormals(std::span<const glm::vec3> positions, std::span<const ControlTriangle> triangles) {
  const double scale = scaleOf(positions);
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
  for (const ControlTriangle& triangle : triangles) addFace(positions, triangle, scale, sums);
  std::vector<glm::vec3> normals(positions.size());
  std::ranges::transform(sums, normals.begin(), normalFrom);
  return normals;
}

void updateVertexNormals(std::span<const glm::vec3> positions, std::span<const ControlTriangle> triangles,
                         const std::vector<bool>& asked, std::span<glm::vec3> normals) {
  const double scale = scaleOf(positions);
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
  for (const ControlTriangle& triangle : triangles) {
    const bool counts = std::ranges::any_of(triangle.vertices, [&](int v) { return asked[toIndex(v)]; });
    if (counts) addFace(positions, triangle, scale, sums);
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (asked[v]) normals[v] = normalFrom(sums[v]);
  }
}

}  // namespace sinew
