// tests/support/oracle/heights.cpp: repeats all steps until nothing changes.

#include "tests/support/oracle/heights.h"

#include <map>

namespace sinew::oracle {
namespace {

/// Fraction of each height that a pose's creases leave: how much the control triangles around a control vertex still
/// face outwards, linearly interpolated. Control vertices come first among the refined ones, and lie on the patch.
std::vector<double> creaseShares(const ControlMesh& mesh, const Refinement& refinement, const PatchOf& bind,
                                 const PatchOf& patch) {
  std::vector<double> rho(mesh.positions.size(), 1.0);
  for (const ControlTriangle& t : mesh.triangles) {
    const double before = frontOf(t.vertices, bind.positions, bind.normals);
    if (before <= 0.05) continue;
    const double ratio = std::max(-1.0, frontOf(t.vertices, patch.positions, patch.normals) / before);
    for (const int v : t.vertices) rho[index(v)] = std::min(rho[index(v)], ratio);
  }
  std::vector<double> out(patch.positions.size(), 1.0);
  for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
    const int control = refinement.controlOf[i];
    for (const int v : refinement.triangles[i]) {
      const glm::dvec3 place = controlCoordinates(mesh, refinement, control, v);
      double here = 0.0;
      for (int k = 0; k < 3; ++k) here += place[k] * rho[index(mesh.triangles[index(control)].vertices[index(k)])];
      out[index(v)] = 0.4 + 0.6 * smoothstep(-0.3, 0.4, here);
    }
  }
  return out;
}

/// Possible steps of a path over the patch: along edges, and across them to the next triangle's third corner.
std::vector<std::array<std::size_t, 2>> stepsOf(const Triangles& triangles) {
  std::vector<std::array<std::size_t, 2>> out;
  std::map<std::array<int, 2>, std::vector<int>> thirds;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[(i + 1) % 3];
      const int b = t[(i + 2) % 3];
      out.push_back({index(a), index(b)});
      out.push_back({index(b), index(a)});
      std::vector<int>& others = thirds[{std::min(a, b), std::max(a, b)}];
      for (const int other : others) {
        out.push_back({index(other), index(t[i])});
        out.push_back({index(t[i]), index(other)});
      }
      others.push_back(t[i]);
    }
  }
  return out;
}

/// Limits the slope to 1.5 along any path by repeating all steps until nothing changes.
void boundSlopes(const Triangles& triangles, const std::vector<Vec>& patch, std::vector<double>& heights) {
  const auto steps = stepsOf(triangles);
  bool changed = true;
  while (changed) {
    changed = false;
    for (const auto& [p, q] : steps) {
      const double sign = heights[p] < 0.0 ? -1.0 : 1.0;
      const double most = std::max(0.0, sign * heights[q]) + 1.5 * length(patch[q] - patch[p]);
      if (sign * heights[p] <= most * (1.0 + 1e-12)) continue;
      heights[p] = sign * most;
      changed = true;
    }
  }
}

}  // namespace

std::vector<double> boundHeights(const ControlMesh& mesh, const Refinement& refinement, const PatchOf& bind,
                                 const PatchOf& patch, const std::vector<float>& raw) {
  std::vector<double> out = creaseShares(mesh, refinement, bind, patch);
  for (std::size_t v = 0; v < out.size(); ++v) out[v] *= static_cast<double>(raw[v]);
  boundSlopes(refinement.triangles, patch.positions, out);
  return out;
}

Sampling filterHeights(const Triangles& triangles, const std::vector<Vec>& patch, const std::vector<double>& start) {
  const Neighbors neighbors = neighborsOf(triangles, patch.size());
  const auto perLength = [&](std::size_t v, std::size_t u) {
    const double apart = length(patch[u] - patch[v]);
    return apart > 0.0 ? 1.0 / apart : 0.0;
  };
  Sampling out{std::vector<double>(start.size(), 0.0), start};
  const auto towardsMean = [&](std::size_t v, double& sum) {
    double difference = 0.0;
    sum = 0.0;
    for (const std::size_t u : neighbors[v]) {
      sum += perLength(v, u);
      difference += perLength(v, u) * (out.heights[u] - out.heights[v]);
    }
    return sum > 0.0 ? difference / sum : 0.0;
  };
  for (std::size_t v = 0; v < start.size(); ++v) {
    double sum = 0.0;
    const double bend = std::abs(towardsMean(v, sum));
    if (start[v] == 0.0 || neighbors[v].empty()) continue;
    const double weight = smoothstep(0.15, 0.5, bend * sum / static_cast<double>(neighbors[v].size()));
    out.weights[v] = std::max(out.weights[v], weight);
    const double edges = std::abs(start[v]) * sum / static_cast<double>(neighbors[v].size());
    const double passed = weight * smoothstep(0.0, 0.1, edges);
    for (const std::size_t u : neighbors[v]) out.weights[u] = std::max(out.weights[u], passed);
  }
  for (int round = 0; round < 4; ++round) {
    std::vector<double> next = out.heights;
    for (std::size_t v = 0; v < start.size(); ++v) {
      double sum = 0.0;
      next[v] += 0.5 * out.weights[v] * towardsMean(v, sum);
      next[v] = std::clamp(next[v], std::min(0.0, start[v]), std::max(0.0, start[v]));
    }
    out.heights = next;
  }
  return out;
}

}  // namespace sinew::oracle
