// tests/support/surface/scalar_patches.cpp: the four patches, one vertex after the other.
#include "tests/support/surface/scalar_patches.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew::test {
namespace {

/// A control vertex in its pose, or a point of a patch.
struct Point {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
};
using Corner = Point;

/// Control triangle or edge in its pose; an edge has its third corner unused and weight 0 there.
struct Corners {
  std::array<Corner, 3> at;
  std::size_t count = 3;
};

using Barycentric = std::array<float, 3>;

glm::vec3 flatPosition(const Corners& c, const Barycentric& w) {
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < c.count; ++i) sum += c.at[i].position * w[i];
  return sum;
}

glm::vec3 phongNormal(const Corners& c, const Barycentric& w) {
  glm::vec3 sum(0.0f);
  std::size_t heaviest = 0;
  for (std::size_t i = 0; i < c.count; ++i) {
    sum += c.at[i].normal * w[i];
    if (w[i] > w[heaviest]) heaviest = i;
  }
  return normalizeOr(sum, c.at[heaviest].normal);
}

Point flatPoint(const Corners& c, const Barycentric& w) { return {flatPosition(c, w), phongNormal(c, w)}; }

/// Phong tessellation: pulled towards the mean of its projections on the corners' tangent planes.
Point phongPoint(const Corners& c, const Barycentric& w) {
  constexpr float kAlpha = 0.75f;
  const glm::vec3 flat = flatPosition(c, w);
  glm::vec3 pulled(0.0f);
  for (std::size_t i = 0; i < c.count; ++i) {
    const Corner& corner = c.at[i];
    pulled += (flat - glm::dot(flat - corner.position, corner.normal) * corner.normal) * w[i];
  }
  return {flat * (1.0f - kAlpha) + pulled * kAlpha, phongNormal(c, w)};
}

/// Spherigon: mean of the points on the spheres through each corner, along the Phong normal.
Point spherigonPoint(const Corners& c, const Barycentric& w) {
  const glm::vec3 flat = flatPosition(c, w);
  const glm::vec3 normal = phongNormal(c, w);
  float height = 0.0f;
  float weights = 0.0f;
  for (std::size_t i = 0; i < c.count; ++i) {
    const Corner& corner = c.at[i];
    // 1 + N.Ni goes to 0 for opposite normals, where no such sphere exists.
    const float along = std::max(1.0f + glm::dot(normal, corner.normal), 0.1f);
    height += w[i] * w[i] * glm::dot(corner.position - flat, normal + corner.normal) / along;
    weights += w[i] * w[i];
  }
  return {flat + normal * (height / weights), normal};
}

/// Tangent control point a third of the way from a to b, moved into a's tangent plane.
glm::vec3 pnTangentPoint(const Corner& a, const Corner& b) {
  const float height = glm::dot(b.position - a.position, a.normal);
  return (2.0f * a.position + b.position - height * a.normal) / 3.0f;
}

/// Mid-edge normal: the mean reflected in the plane across the edge, so that inflections show.
glm::vec3 pnEdgeNormal(const Corner& a, const Corner& b) {
  const glm::vec3 along = b.position - a.position;
  const glm::vec3 sum = a.normal + b.normal;
  const float squared = glm::dot(along, along);
  const float v = squared > 0.0f ? 2.0f * glm::dot(along, sum) / squared : 0.0f;
  return normalizeOr(sum - v * along, a.normal);
}

Point pnEdgePoint(const Corner& a, const Corner& b, float v) {
  const float u = 1.0f - v;
  const glm::vec3 position = a.position * (u * u * u) + pnTangentPoint(a, b) * (3.0f * u * u * v) +
                             pnTangentPoint(b, a) * (3.0f * u * v * v) + b.position * (v * v * v);
  const glm::vec3 normal = a.normal * (u * u) + pnEdgeNormal(a, b) * (u * v) + b.normal * (v * v);
  return {position, normalizeOr(normal, u >= v ? a.normal : b.normal)};
}

/// The ten control points and six normals of one PN triangle.
struct PnTriangle {
  glm::vec3 b300, b030, b003, b210, b120, b021, b012, b102, b201, b111;
  glm::vec3 n200, n020, n002, n110, n011, n101;

  explicit PnTriangle(const Corners& c) {
    const auto& [p0, p1, p2] = c.at;
    b300 = p0.position;
    b030 = p1.position;
    b003 = p2.position;
    b210 = pnTangentPoint(p0, p1);
    b120 = pnTangentPoint(p1, p0);
    b021 = pnTangentPoint(p1, p2);
    b012 = pnTangentPoint(p2, p1);
    b102 = pnTangentPoint(p2, p0);
    b201 = pnTangentPoint(p0, p2);
    const glm::vec3 edgeMean = (b210 + b120 + b021 + b012 + b102 + b201) / 6.0f;
    const glm::vec3 cornerMean = (b300 + b030 + b003) / 3.0f;
    b111 = edgeMean + (edgeMean - cornerMean) * 0.5f;
    n200 = p0.normal;
    n020 = p1.normal;
    n002 = p2.normal;
    n110 = pnEdgeNormal(p0, p1);
    n011 = pnEdgeNormal(p1, p2);
    n101 = pnEdgeNormal(p2, p0);
  }

  Point at(const Barycentric& w) const {
    const float u = w[0];
    const float v = w[1];
    const float s = w[2];
    const glm::vec3 position = b300 * (u * u * u) + b030 * (v * v * v) + b003 * (s * s * s) +
                               (b210 * (u * u * v) + b120 * (u * v * v) + b021 * (v * v * s) + b012 * (v * s * s) +
                                b102 * (u * s * s) + b201 * (u * u * s)) *
                                   3.0f +
                               b111 * (6.0f * u * v * s);
    const glm::vec3 normal =
        n200 * (u * u) + n020 * (v * v) + n002 * (s * s) + n110 * (u * v) + n011 * (v * s) + n101 * (u * s);
    return {position, normalizeOr(normal, u >= v && u >= s ? n200 : v >= s ? n020 : n002)};
  }
};

Point patchPoint(PatchKind kind, const Corners& corners, const Barycentric& w) {
  switch (kind) {
    case PatchKind::kPhong:
      return phongPoint(corners, w);
    case PatchKind::kSpherigon:
      return spherigonPoint(corners, w);
    case PatchKind::kPn:  // has its own, with shared control points
    case PatchKind::kFlat:
      break;
  }
  return flatPoint(corners, w);
}

/// Point of an edge's curve, w from a to b.
Point edgePoint(PatchKind kind, const Corner& a, const Corner& b, float w) {
  if (kind == PatchKind::kPn) return pnEdgePoint(a, b, w);
  return patchPoint(kind, Corners{{a, b, Corner{}}, 2}, {1.0f - w, w, 0.0f});
}

/// Weights of a vertex inside a triangle.
Barycentric insideWeights(const Refinement& refinement, int vertex) {
  const glm::dvec2& at = refinement.insideAt(vertex);
  return {static_cast<float>(1.0 - at.x - at.y), static_cast<float>(at.x), static_cast<float>(at.y)};
}

/// Points inside a triangle, at the refinement's lattice.
class Inside {
 public:
  Inside(PatchKind kind, const Corners& corners, const Refinement& refinement)
      : kind_(kind), corners_(corners), pn_(corners), refinement_(refinement) {}

  Point point(int vertex) const {
    const Barycentric w = insideWeights(refinement_, vertex);
    return kind_ == PatchKind::kPn ? pn_.at(w) : patchPoint(kind_, corners_, w);
  }

 private:
  PatchKind kind_;
  Corners corners_;
  PnTriangle pn_;
  const Refinement& refinement_;
};

void evaluate(const PatchInputs& inputs) {
  const Refinement& refinement = *inputs.refinement;
  const auto corner = [&](int vertex) { return Corner{at(inputs.positions, vertex), at(inputs.normals, vertex)}; };
  const auto store = [&](int vertex, const Point& result) {
    at(inputs.outPositions, vertex) = result.position;
    at(inputs.outNormals, vertex) = result.normal;
  };

  for (int e = 0; e < refinement.controlEdges; ++e) {
    const auto& ends = at(inputs.mesh->edges, e).vertices;
    const Corner a = corner(ends[0]);
    const Corner b = corner(ends[1]);
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      store(refinement.edgeVertex(e, step),
            edgePoint(inputs.kind, a, b, static_cast<float>(refinement.shareAt(e, step))));
    }
  }

  for (std::size_t t = 0; t < inputs.mesh->triangles.size(); ++t) {
    const auto& vertices = inputs.mesh->triangles[t].vertices;
    const Inside inside(inputs.kind, {{corner(vertices[0]), corner(vertices[1]), corner(vertices[2])}, 3}, refinement);
    for (int v = refinement.insideBegin[t]; v < refinement.insideBegin[t + 1]; ++v) store(v, inside.point(v));
  }
}

void interpolate(const DirectionInputs& inputs) {
  const Refinement& refinement = *inputs.refinement;
  const auto corner = [&](int vertex) { return Corner{glm::vec3(0.0f), at(inputs.control, vertex)}; };
  for (int e = 0; e < refinement.controlEdges; ++e) {
    const auto& ends = at(inputs.mesh->edges, e).vertices;
    const Corners corners{{corner(ends[0]), corner(ends[1]), Corner{}}, 2};
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      const auto w = static_cast<float>(refinement.shareAt(e, step));
      at(inputs.out, refinement.edgeVertex(e, step)) = phongNormal(corners, {1.0f - w, w, 0.0f});
    }
  }
  for (std::size_t t = 0; t < inputs.mesh->triangles.size(); ++t) {
    const auto& vertices = inputs.mesh->triangles[t].vertices;
    const Corners corners{{corner(vertices[0]), corner(vertices[1]), corner(vertices[2])}, 3};
    for (int v = refinement.insideBegin[t]; v < refinement.insideBegin[t + 1]; ++v) {
      at(inputs.out, v) = phongNormal(corners, insideWeights(refinement, v));
    }
  }
}

void shade(const ShadingInputs& inputs) {
  const ControlMesh& mesh = *inputs.mesh;
  const Refinement& refinement = *inputs.refinement;
  const auto isCreased = [&](int wedge) { return at(mesh.wedges, wedge).creased; };
  const auto corner = [&](int wedge) {
    const auto w = static_cast<std::size_t>(wedge);
    return Corner{at(inputs.positions, mesh.wedges[w].vertex), inputs.wedgeNormals[w]};
  };

  for (const DrawnRun& run : refinement.drawRuns) {
    if (std::ranges::none_of(run.wedges, isCreased)) continue;
    const Corner a = corner(run.wedges[0]);
    const Corner b = corner(run.wedges[1]);
    for (int step = 1; step <= refinement.edgeVertices(run.edge); ++step) {
      const auto w = static_cast<float>(refinement.shareAt(run.edge, step));
      const glm::vec3 normal = edgePoint(inputs.kind, a, b, w).normal;
      at(inputs.outNormals, run.first + step - 1) = normal;
    }
  }

  for (std::size_t t = 0; t < refinement.drawInside.size(); ++t) {
    const auto& wedges = mesh.triangles[t].wedges;
    if (std::ranges::none_of(wedges, isCreased)) continue;
    const Inside inside(inputs.kind, {{corner(wedges[0]), corner(wedges[1]), corner(wedges[2])}, 3}, refinement);
    for (int i = 0; i < refinement.insideVertices(static_cast<int>(t)); ++i) {
      at(inputs.outNormals, refinement.drawInside[t] + i) = inside.point(refinement.insideBegin[t] + i).normal;
    }
  }
}

}  // namespace

PatchKernels scalarPatchKernels() { return {&evaluate, &interpolate, &shade}; }

}  // namespace sinew::test
