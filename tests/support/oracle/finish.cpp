// tests/support/oracle/finish.cpp: all triangles and all vertices in every round.

#include "tests/support/oracle/finish.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "tests/support/oracle/heights.h"

namespace sinew::oracle {
namespace {

constexpr double kSpreadArea = 0.3;
constexpr double kWholeFront = 0.05;
constexpr double kFreedom = 0.145;

std::vector<Vec> vecs(const std::vector<glm::vec3>& from) {
  std::vector<Vec> out;
  for (const glm::vec3& v : from) out.push_back(vec(v));
  return out;
}

/// The patch and its bind pose, as the search for folds sees them.
struct Folds {
  const Triangles& triangles;
  std::vector<Vec> patch;
  std::vector<Vec> normals;
  std::vector<double> bindFronts;

  /// q of a lifted triangle; nothing where it has none.
  std::optional<double> areaOf(std::size_t i, const std::vector<Vec>& at) const {
    const Vec before = faceOf(patch, triangles[i]);
    const double squared = dot(before, before);
    if (squared == 0.0 || bindFronts[i] <= 0.0) return std::nullopt;
    return dot(faceOf(at, triangles[i]), before) / squared;
  }

  double trustIn(std::size_t i) const {
    return smoothstep(0.0, kWholeFront, frontOf(triangles[i], patch, normals) / bindFronts[i]);
  }
};

/// Inside, every neighbor is met twice, or more often where more than two triangles meet.
std::vector<bool> bordersOf(const Neighbors& neighbors) {
  std::vector<bool> out;
  for (const std::vector<std::size_t>& around : neighbors) {
    out.push_back(std::ranges::any_of(around, [&](std::size_t u) { return std::ranges::count(around, u) == 1; }));
  }
  return out;
}

/// Mean over the neighbors less the value itself.
std::vector<Vec> laplacian(const Neighbors& neighbors, const std::vector<Vec>& values) {
  std::vector<Vec> out(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (neighbors[v].empty()) continue;
    Vec sum;
    for (const std::size_t u : neighbors[v]) sum = sum + values[u];
    out[v] = (1.0 / static_cast<double>(neighbors[v].size())) * sum - values[v];
  }
  return out;
}

/// No further from `start` than that is from the patch.
Vec held(const Vec& start, const Vec& patch, const Vec& to) {
  const Vec way = to - start;
  return start + std::min(1.0, length(start - patch) / std::max(1e-300, length(way))) * way;
}

/// A triangle's moves towards q = 0.3, for its three corners: along the gradients of its area, as little as will do.
/// @return  also the factor on the gradients: about the moves over the edges.
std::pair<std::array<Vec, 3>, double> spreadOf(const Folds& folds, std::size_t i, double q,
                                               const std::vector<Vec>& at) {
  const auto& t = folds.triangles[i];
  const Vec face = faceOf(folds.patch, t);
  std::array<Vec, 3> gradients;
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    gradients[k] = cross(unitOr(face, {}), at[index(t[(k + 2) % 3])] - at[index(t[(k + 1) % 3])]);
    squared += dot(gradients[k], gradients[k]);
  }
  const double step = (kSpreadArea - q) * length(face) / std::max(squared, length(face));
  for (Vec& gradient : gradients) gradient = step * gradient;
  return {gradients, step};
}

void spreadFolds(const Folds& folds, const Neighbors& neighbors, const std::vector<Vec>& start, std::vector<Vec>& at) {
  const std::vector<bool> borders = bordersOf(neighbors);
  for (int round = 0; round < 8; ++round) {
    std::vector<double> weights(at.size(), 0.0);
    std::vector<Vec> ways(at.size());
    for (std::size_t i = 0; i < folds.triangles.size(); ++i) {
      const std::optional<double> q = folds.areaOf(i, at);
      if (!q || *q >= kSpreadArea) continue;
      const auto [moves, step] = spreadOf(folds, i, *q, at);
      const double weight = folds.trustIn(i) * std::min({1.0, (kSpreadArea - *q) / 0.1, step / 0.01});
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = index(folds.triangles[i][k]);
        weights[v] += weight;
        ways[v] = ways[v] + weight * moves[k];
      }
    }
    for (std::size_t v = 0; v < at.size(); ++v) {
      if (borders[v] || weights[v] == 0.0) continue;
      at[v] = held(start[v], folds.patch[v], at[v] + (1.5 / std::max(1.0, weights[v])) * ways[v]);
    }
  }
}

/// Unit normals of the faces around each vertex, each face weighted by its angle there.
std::vector<Vec> faceNormals(const Triangles& triangles, const std::vector<Vec>& at) {
  std::vector<Vec> sums(at.size());
  for (const auto& t : triangles) {
    const Vec normal = unitOr(faceOf(at, t), {});
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec corner = at[index(t[i])];
      const Vec one = at[index(t[(i + 1) % 3])] - corner;
      const Vec other = at[index(t[(i + 2) % 3])] - corner;
      const double angle = std::atan2(length(cross(one, other)), dot(one, other));
      sums[index(t[i])] = sums[index(t[i])] + angle * normal;
    }
  }
  for (Vec& sum : sums) sum = unitOr(sum, {});
  return sums;
}

/// What the least rotation that takes the unit vector `from` to the unit vector `to` adds to v; towards opposite ones
/// their plain difference.
Vec turnOf(const Vec& v, const Vec& from, const Vec& to) {
  if (length(from) == 0.0 || length(to) == 0.0) return {};
  const double cosine = dot(from, to);
  const double share = smoothstep(-0.95, -0.7, cosine);
  const Vec difference = to - from;
  if (share == 0.0) return difference;
  const Vec axis = cross(from, to);
  const Vec turned = cosine * v + cross(axis, v) + (dot(axis, v) / (1.0 + cosine)) * axis;
  return share * (turned - v) + (1.0 - share) * difference;
}

/// w of the largest difference to a neighbor's delta, of the larger of the vertex's own delta and delta', and of how
/// much its height was filtered.
double toothWeight(double difference, double own, double filtered) {
  const double betweenNeighbors =
      smoothstep(0.22, 0.45, difference) * (1.0 - (1.0 - filtered) * smoothstep(0.45, 0.8, difference));
  return 0.23 * betweenNeighbors * smoothstep(0.0, 0.1, own);
}

/// @param turns  of each vertex: the larger of its delta' and of its delta before it was held to the faces.
void removeTeeth(const Triangles& triangles, const std::vector<double>& turns, const std::vector<double>& filtered,
                 std::vector<Vec>& deltas) {
  const Neighbors neighbors = neighborsOf(triangles, deltas.size());
  const std::vector<Vec> squared = laplacian(neighbors, laplacian(neighbors, deltas));
  std::vector<Vec> out = deltas;
  for (std::size_t v = 0; v < deltas.size(); ++v) {
    double difference = 0.0;
    for (const std::size_t u : neighbors[v]) difference = std::max(difference, length(deltas[u] - deltas[v]));
    out[v] = deltas[v] - toothWeight(difference, turns[v], filtered[v]) * squared[v];
  }
  deltas = out;
}

}  // namespace

Finished finish(const ControlMesh& mesh, const Surface& bindPatch, const Surface& patch, const Surface& raw,
                bool swells) {
  const Triangles& triangles = raw.refinement->triangles;
  const std::vector<Vec> patchPositions = vecs(patch.positions);
  const std::vector<Vec> patchNormals = vecs(patch.normals);
  std::vector<Vec> fieldNormals = vecs(raw.normals);
  Finished out;
  out.positions = vecs(raw.positions);
  const std::vector<Vec> bindPositions = vecs(bindPatch.positions);
  const std::vector<Vec> bindNormals = vecs(bindPatch.normals);
  Folds folds{triangles, patchPositions, patchNormals, {}};
  for (const auto& t : triangles) folds.bindFronts.push_back(frontOf(t, bindPositions, bindNormals));
  const std::vector<Vec> projected = out.positions;
  const auto scale = [&](std::size_t v, double share) {
    out.positions[v] = patchPositions[v] + share * (out.positions[v] - patchPositions[v]);
  };
  const std::vector<double> bounded = boundHeights(mesh, *raw.refinement, {bindPositions, bindNormals},
                                                   {patchPositions, patchNormals}, raw.displacement);
  for (std::size_t v = 0; v < projected.size(); ++v) {
    const double height = static_cast<double>(raw.displacement[v]);
    if (height == 0.0 || bounded[v] == height) continue;
    scale(v, bounded[v] / height);
    fieldNormals[v] =
        unitOr(patchNormals[v] + (bounded[v] / height) * (fieldNormals[v] - patchNormals[v]), patchNormals[v]);
  }
  const Sampling sampling =
      filterHeights(triangles, patchPositions, swells ? bounded : std::vector<double>(projected.size(), 0.0));
  for (std::size_t v = 0; v < projected.size() && swells; ++v) {
    if (bounded[v] != 0.0 && sampling.heights[v] != bounded[v]) scale(v, sampling.heights[v] / bounded[v]);
  }
  const Neighbors neighbors = neighborsOf(triangles, projected.size());
  const std::vector<Vec> start = out.positions;
  spreadFolds(folds, neighbors, start, out.positions);
  for (std::size_t v = 0; v < projected.size(); ++v) {
    out.guarded.push_back(length(out.positions[v] - projected[v]) > 0.0);
  }

  const std::vector<Vec> patchFaces = faceNormals(triangles, patchPositions);
  const std::vector<Vec> faces = faceNormals(triangles, out.positions);
  std::vector<double> turns;
  std::vector<Vec> deltas;
  for (std::size_t v = 0; v < patchNormals.size(); ++v) {
    const Vec ofField = fieldNormals[v] - patchNormals[v];
    const Vec ofFaces = turnOf(patchNormals[v], patchFaces[v], faces[v]);
    const double distance = length(ofField - ofFaces);
    const double freedom = kFreedom * (1.0 - sampling.weights[v]);
    deltas.push_back(ofFaces + (distance > freedom ? freedom / distance : 1.0) * (ofField - ofFaces));
    turns.push_back(std::max(length(ofField), length(ofFaces)));
  }
  removeTeeth(triangles, turns, sampling.weights, deltas);
  for (std::size_t v = 0; v < deltas.size(); ++v) {
    out.normals.push_back(unitOr(patchNormals[v] + deltas[v], patchNormals[v]));
  }
  return out;
}

Finished unfinished(const Surface& raw) {
  return {std::vector<bool>(raw.positions.size(), false), vecs(raw.positions), vecs(raw.normals)};
}

}  // namespace sinew::oracle
