// tests/support/oracle_finish.cpp: every triangle and every vertex in every round.

#include "tests/support/oracle_finish.h"

#include <algorithm>
#include <array>

namespace sinew::oracle {
namespace {

constexpr int kRounds = 32;
constexpr double kSafeArea = 0.25;
constexpr double kNoFront = 0.02;
constexpr double kWholeFront = 0.17;
constexpr double kFreedom = 0.145;

using Triangles = std::vector<std::array<int, 3>>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

Vec faceOf(const std::vector<Vec>& at, const std::array<int, 3>& t) {
  return cross(at[index(t[1])] - at[index(t[0])], at[index(t[2])] - at[index(t[0])]);
}

std::vector<Vec> vecs(const std::vector<glm::vec3>& from) {
  std::vector<Vec> out;
  for (const glm::vec3& v : from) out.push_back(vec(v));
  return out;
}

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// How much a triangle of the patch faces along its vertices' normals; below 0 where it folds back.
double frontOf(const std::array<int, 3>& t, const std::vector<Vec>& patch, const std::vector<Vec>& normals) {
  double edges = 0.0;
  Vec mean;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec edge = patch[index(t[(i + 1) % 3])] - patch[index(t[i])];
    edges += dot(edge, edge);
    mean = mean + (1.0 / 3.0) * normals[index(t[i])];
  }
  return edges > 0.0 ? dot(faceOf(patch, t), mean) / edges : 0.0;
}

/// Least share of their lift that triangles ask each corner to keep, as things are.
std::vector<double> sharesAsked(const Triangles& triangles, const std::vector<Vec>& patch,
                                const std::vector<Vec>& normals, const std::vector<double>& bindFronts,
                                const std::vector<Vec>& at) {
  std::vector<double> shares(patch.size(), 1.0);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    const Vec before = faceOf(patch, t);
    const double squared = dot(before, before);
    if (squared == 0.0) continue;
    const double q = dot(faceOf(at, t), before) / squared;
    if (q >= kSafeArea) continue;
    if (bindFronts[i] <= 0.0) continue;
    const double weight = smoothstep(kNoFront, kWholeFront, frontOf(t, patch, normals) / bindFronts[i]);
    const double asked = 1.0 - weight * (1.0 - (1.0 - kSafeArea) / (1.0 - q));
    for (const int v : t) shares[index(v)] = std::min(shares[index(v)], asked);
  }
  return shares;
}

void guardFolds(const Triangles& triangles, const std::vector<Vec>& patch, const std::vector<Vec>& normals,
                const std::vector<double>& bindFronts, Finished& out) {
  out.kept.assign(patch.size(), 1.0);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<double> shares = sharesAsked(triangles, patch, normals, bindFronts, out.positions);
    for (std::size_t v = 0; v < patch.size(); ++v) {
      if (shares[v] == 1.0) continue;
      out.kept[v] *= shares[v];
      out.positions[v] = patch[v] + shares[v] * (out.positions[v] - patch[v]);
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

using Neighbours = std::vector<std::vector<std::size_t>>;

/// The other corners of the triangles around each vertex: a neighbour counts once for every triangle it shares, so that
/// neighbours along a border count half.
Neighbours neighboursOf(const Triangles& triangles, std::size_t count) {
  Neighbours out(count);
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      out[index(t[i])].push_back(index(t[(i + 1) % 3]));
      out[index(t[i])].push_back(index(t[(i + 2) % 3]));
    }
  }
  return out;
}

/// Mean over the neighbours less the value itself.
std::vector<Vec> laplacian(const Neighbours& neighbours, const std::vector<Vec>& values) {
  std::vector<Vec> out(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (neighbours[v].empty()) continue;
    Vec sum;
    for (const std::size_t u : neighbours[v]) sum = sum + values[u];
    out[v] = (1.0 / static_cast<double>(neighbours[v].size())) * sum - values[v];
  }
  return out;
}

/// w of the largest difference to a neighbour's delta, and of the larger of the vertex's own delta and delta'.
double toothWeight(double difference, double own) {
  const double betweenNeighbours = smoothstep(0.22, 0.45, difference) * (1.0 - smoothstep(0.45, 0.8, difference));
  return 0.23 * betweenNeighbours * smoothstep(0.0, 0.1, own);
}

/// @param turns  of each vertex: the larger of its delta' and of its delta before it was held to the faces.
void removeTeeth(const Triangles& triangles, const std::vector<double>& turns, std::vector<Vec>& deltas) {
  const Neighbours neighbours = neighboursOf(triangles, deltas.size());
  const std::vector<Vec> squared = laplacian(neighbours, laplacian(neighbours, deltas));
  std::vector<Vec> out = deltas;
  for (std::size_t v = 0; v < deltas.size(); ++v) {
    double difference = 0.0;
    for (const std::size_t u : neighbours[v]) difference = std::max(difference, length(deltas[u] - deltas[v]));
    out[v] = deltas[v] - toothWeight(difference, turns[v]) * squared[v];
  }
  deltas = out;
}

}  // namespace

Finished finish(const Surface& bindPatch, const Surface& patch, const Surface& raw) {
  const Triangles& triangles = raw.refinement->triangles;
  const std::vector<Vec> patchPositions = vecs(patch.positions);
  const std::vector<Vec> patchNormals = vecs(patch.normals);
  const std::vector<Vec> fieldNormals = vecs(raw.normals);
  Finished out;
  out.positions = vecs(raw.positions);
  const std::vector<Vec> bindPositions = vecs(bindPatch.positions);
  const std::vector<Vec> bindNormals = vecs(bindPatch.normals);
  std::vector<double> bindFronts;
  for (const auto& t : triangles) bindFronts.push_back(frontOf(t, bindPositions, bindNormals));
  guardFolds(triangles, patchPositions, patchNormals, bindFronts, out);

  const std::vector<Vec> patchFaces = faceNormals(triangles, patchPositions);
  const std::vector<Vec> faces = faceNormals(triangles, out.positions);
  std::vector<double> turns;
  std::vector<Vec> deltas;
  for (std::size_t v = 0; v < patchNormals.size(); ++v) {
    const Vec ofField = fieldNormals[v] - patchNormals[v];
    const Vec ofFaces = turnOf(patchNormals[v], patchFaces[v], faces[v]);
    const double distance = length(ofField - ofFaces);
    deltas.push_back(ofFaces + (distance > kFreedom ? kFreedom / distance : 1.0) * (ofField - ofFaces));
    turns.push_back(std::max(length(ofField), length(ofFaces)));
  }
  removeTeeth(triangles, turns, deltas);
  for (std::size_t v = 0; v < deltas.size(); ++v) {
    out.normals.push_back(unitOr(patchNormals[v] + deltas[v], patchNormals[v]));
  }
  return out;
}

Finished unfinished(const Surface& raw) {
  return {std::vector<double>(raw.positions.size(), 1.0), vecs(raw.positions), vecs(raw.normals)};
}

}  // namespace sinew::oracle
