// tests/support/oracle/patch.cpp: Bernstein sums with every control point spelled out.

#include "tests/support/oracle/patch.h"

#include <cassert>

namespace sinew::oracle {
namespace {

/// Control point at a third of the edge from corner i to corner j: the third point dropped into i's tangent plane.
Vec edgePoint(const Corners& c, std::size_t i, std::size_t j) {
  const double w = dot(c.position[j] - c.position[i], c.normal[i]);
  return (1.0 / 3.0) * (2.0 * c.position[i] + c.position[j] - w * c.normal[i]);
}

/// Mid-edge normal: the mean of the end normals mirrored in the plane across the middle of the edge.
Vec edgeNormal(const Corners& c, std::size_t i, std::size_t j) {
  const Vec edge = c.position[j] - c.position[i];
  const Vec sum = c.normal[i] + c.normal[j];
  const double squared = dot(edge, edge);
  const double v = squared > 0.0 ? 2.0 * dot(edge, sum) / squared : 0.0;
  return unitOr(sum - v * edge, c.normal[i]);
}

PatchPoint pnPoint(const Corners& c, const std::array<double, 3>& b) {
  const double w = b[0];
  const double u = b[1];
  const double v = b[2];
  const Vec b210 = edgePoint(c, 0, 1);
  const Vec b120 = edgePoint(c, 1, 0);
  const Vec b021 = edgePoint(c, 1, 2);
  const Vec b012 = edgePoint(c, 2, 1);
  const Vec b102 = edgePoint(c, 2, 0);
  const Vec b201 = edgePoint(c, 0, 2);
  const Vec mean = (1.0 / 6.0) * (b210 + b120 + b021 + b012 + b102 + b201);
  const Vec flat = (1.0 / 3.0) * (c.position[0] + c.position[1] + c.position[2]);
  const Vec b111 = mean + 0.5 * (mean - flat);
  PatchPoint out;
  out.position = (w * w * w) * c.position[0] + (u * u * u) * c.position[1] + (v * v * v) * c.position[2] +
                 (3 * w * w * u) * b210 + (3 * w * u * u) * b120 + (3 * u * u * v) * b021 + (3 * u * v * v) * b012 +
                 (3 * w * w * v) * b201 + (3 * w * v * v) * b102 + (6 * w * u * v) * b111;
  const Vec normal = (w * w) * c.normal[0] + (u * u) * c.normal[1] + (v * v) * c.normal[2] +
                     (w * u) * edgeNormal(c, 0, 1) + (u * v) * edgeNormal(c, 1, 2) + (w * v) * edgeNormal(c, 2, 0);
  out.normal = unitOr(normal, c.normal[0]);
  return out;
}

PatchPoint phongPoint(const Corners& c, const std::array<double, 3>& b) {
  PatchPoint out = flatPoint(c, b);
  Vec projected;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec onPlane = out.position - dot(out.position - c.position[i], c.normal[i]) * c.normal[i];
    projected = projected + b[i] * onPlane;
  }
  out.position = 0.25 * out.position + 0.75 * projected;
  return out;
}

}  // namespace

bool knowsPatch(PatchKind kind) { return kind != PatchKind::kSpherigon; }

PatchPoint flatPoint(const Corners& c, const std::array<double, 3>& b) {
  PatchPoint out;
  Vec normal;
  for (std::size_t i = 0; i < 3; ++i) {
    out.position = out.position + b[i] * c.position[i];
    normal = normal + b[i] * c.normal[i];
  }
  out.normal = unitOr(normal, c.normal[0]);
  return out;
}

PatchPoint patchPoint(PatchKind kind, const Corners& corners, const std::array<double, 3>& barycentric) {
  assert(knowsPatch(kind));
  if (kind == PatchKind::kPn) return pnPoint(corners, barycentric);
  if (kind == PatchKind::kPhong) return phongPoint(corners, barycentric);
  return flatPoint(corners, barycentric);
}

}  // namespace sinew::oracle
