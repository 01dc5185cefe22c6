// core/character/skinning.cpp: matrices of a pose, then the kernels.
#include "core/character/skinning.h"

#include <algorithm>
#include <cassert>

#include "core/character/skinning_kernel.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/geometry/parallel.h"

namespace sinew {

// Deltas added up, then normals of what has changed.

namespace {

/// @return [V] true for vertices that have moved
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
  // Makes each fan a vertex; the corners of other wedges become vertices that are not used.
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

namespace {

void poseMatrices(const Skeleton& skeleton, const Pose& pose, std::vector<glm::mat4>& out) {
  out.clear();
  for (const Binding& binding : skeleton.bindings) {
    out.push_back(at(pose.boneInWorld, binding.bone) * binding.inverseBind);
  }
}

void skinVertices(const SkinInputs& inputs) {
  constexpr std::size_t kFew = 2048;  // For one thread.
  const SkinKernels kernels = skinKernels(chosenVectorSet());
  forRanges(inputs.directions.size(), kFew,
            [&](std::size_t begin, std::size_t end) { kernels.vertices(inputs, begin, end); });
}

}  // namespace

void skin(const Character& character, const Pose& pose, std::span<const float> morphWeights, SkinnedMesh& out) {
  const ControlMesh& mesh = character.mesh;
  if (character.morphTargets.empty()) out.morphed.isMorphed = false;
  else if (morphWeights.empty()) morph(character, morphWeightsOr(character, {}), out.morphed);
  else morph(character, morphWeights, out.morphed);
  const bool morphed = out.morphed.isMorphed;
  poseMatrices(character.skeleton, pose, out.matrices);
  out.positions.resize(mesh.positions.size());
  out.normals.resize(mesh.positions.size());
  skinVertices({&mesh, out.matrices, morphed ? out.morphed.positions : mesh.positions,
                morphed ? out.morphed.normals : mesh.normals, out.positions, out.normals});
}

void skin(const Character& character, const Pose& pose, SkinnedMesh& out) {
  skin(character, pose, pose.morphWeights, out);
}

void skinDirections(const Character& character, std::span<const glm::vec3> bind, const SkinnedMesh& skinned,
                    std::vector<glm::vec3>& out) {
  out.resize(bind.size());
  skinVertices({&character.mesh, skinned.matrices, {}, bind, {}, out});
}

void skinWedgeNormals(const Character& character, std::span<const Wedge> wedges, const SkinnedMesh& skinned,
                      std::vector<glm::vec3>& out) {
  out.resize(wedges.size());
  for (std::size_t w = 0; w < wedges.size(); ++w) out[w] = at(skinned.normals, wedges[w].vertex);
  WedgeInputs inputs{&character.mesh, skinned.matrices, wedges, {}, nullptr, out};
  if (skinned.morphed.isMorphed) {
    assert(skinned.morphed.fansMade);
    inputs.fanNormals = skinned.morphed.fanNormals;
    inputs.fanChanged = &skinned.morphed.fanChanged;
  }
  skinKernels(chosenVectorSet()).wedges(inputs);
}

}  // namespace sinew
