// tests/support/oracle/triangles.h: triangles of a refined patch, in double.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "tests/support/oracle/math.h"

namespace sinew::oracle {

using Triangles = std::vector<std::array<int, 3>>;

inline std::size_t index(int i) { return static_cast<std::size_t>(i); }

inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Vec faceOf(const std::vector<Vec>& at, const std::array<int, 3>& t) {
  return cross(at[index(t[1])] - at[index(t[0])], at[index(t[2])] - at[index(t[0])]);
}

inline double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// How much a triangle of the patch faces along its vertices' normals; below 0 where it folds back.
inline double frontOf(const std::array<int, 3>& t, const std::vector<Vec>& patch, const std::vector<Vec>& normals) {
  double edges = 0.0;
  Vec mean;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec edge = patch[index(t[(i + 1) % 3])] - patch[index(t[i])];
    edges += dot(edge, edge);
    mean = mean + (1.0 / 3.0) * normals[index(t[i])];
  }
  return edges > 0.0 ? dot(faceOf(patch, t), mean) / edges : 0.0;
}

using Neighbors = std::vector<std::vector<std::size_t>>;

/// The other corners of the triangles around each vertex: a neighbor counts once for every triangle it shares, so that
/// neighbors along a border count half.
inline Neighbors neighborsOf(const Triangles& triangles, std::size_t count) {
  Neighbors out(count);
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      out[index(t[i])].push_back(index(t[(i + 1) % 3]));
      out[index(t[i])].push_back(index(t[(i + 2) % 3]));
    }
  }
  return out;
}

}  // namespace sinew::oracle
