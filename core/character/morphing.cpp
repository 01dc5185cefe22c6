// core/character/morphing.cpp: deltas added up, then normals of what has changed.
#include "core/character/morphing.h"

#include <algorithm>

#include "core/geometry/at.h"
#include "core/geometry/normals.h"

namespace sinew {
namespace {

/// @return [V] which have moved.
std::vector<bool> addDeltas(const Character& character, std::span<const float> weights,
                            std::vector<glm::vec3>& positions) {
  std::vector<bool> moved(positions.size(), false);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (weights[k] == 0.0f) continue;
    const MorphTarget& target = character.morphTargets[k];
    for (std::size_t i = 0; i < target.vertices.size(); ++i) {
      const auto v = toIndex(target.vertices[i]);
      positions[v] += weights[k] * target.deltas[i];
      moved[v] = true;
    }
  }
  return moved;
}

}  // namespace

void morph(const Character& character, std::span<const float> weights, MorphedMesh& out) {
  if (std::ranges::equal(out.madeWith, weights)) return;
  const ControlMesh& mesh = character.mesh;
  out.madeWith.assign(weights.begin(), weights.end());
  out.fansMade = false;
  out.isMorphed = std::ranges::any_of(weights, [](float weight) { return weight != 0.0f; });
  if (!out.isMorphed) return;
  out.positions = mesh.positions;
  out.normals = mesh.normals;
  const std::vector<bool> moved = addDeltas(character, weights, out.positions);
  out.changed.assign(mesh.triangles.size(), false);
  std::vector<bool> beside(mesh.positions.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t].vertices;
    if (std::ranges::none_of(corners, [&](int v) { return moved[toIndex(v)]; })) continue;
    out.changed[t] = true;
    for (const int v : corners) beside[toIndex(v)] = true;
  }
  updateVertexNormals(out.positions, mesh.triangles, beside, out.normals);
}

void morphFans(const ControlMesh& creased, MorphedMesh& morphed) {
  if (morphed.fansMade) return;
  morphed.fansMade = true;
  int fans = 0;
  for (const Wedge& wedge : creased.wedges) fans = std::max(fans, wedge.fan + 1);
  // Each fan as a vertex of its own: the corners of others go to one more, which nobody asks for.
  std::vector<glm::vec3> positions(toIndex(fans) + 3 * creased.triangles.size());
  std::vector<ControlTriangle> triangles;
  morphed.fanChanged.assign(positions.size(), false);
  std::size_t next = toIndex(fans);
  for (std::size_t t = 0; t < creased.triangles.size(); ++t) {
    const ControlTriangle& from = creased.triangles[t];
    ControlTriangle& to = triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const int fan = at(creased.wedges, from.wedges[i]).fan;
      to.vertices[i] = fan >= 0 ? fan : static_cast<int>(next++);
      at(positions, to.vertices[i]) = at(morphed.positions, from.vertices[i]);
      if (fan >= 0 && morphed.changed[t]) morphed.fanChanged[toIndex(fan)] = true;
    }
  }
  positions.resize(next);
  morphed.fanChanged.resize(next);
  morphed.fanNormals.resize(next);
  updateVertexNormals(positions, triangles, morphed.fanChanged, morphed.fanNormals);
}

std::vector<float> morphWeightsOr(const Character& character, std::span<const float> weights) {
  if (!weights.empty()) return {weights.begin(), weights.end()};
  std::vector<float> out;
  for (const MorphTarget& target : character.morphTargets) out.push_back(target.weight);
  return out;
}

}  // namespace sinew
