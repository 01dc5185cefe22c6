// core/files/fit/four_weights.cpp: transfer over the patch, the largest four, skinning with them.
#include "core/files/fit/four_weights.h"

#include <algorithm>
#include <cassert>

#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

/// Adds `by` times a control vertex's weights.
void addVertex(const ControlMesh& mesh, int vertex, double by, std::vector<Share>& shares) {
  if (by <= 0.0) return;
  for (const Influence& influence : mesh.influencesOf(vertex)) {
    const auto place = std::ranges::lower_bound(shares, influence.binding, {}, &Share::binding);
    const double weight = by * static_cast<double>(influence.weight);
    if (place != shares.end() && place->binding == influence.binding) place->weight += weight;
    else shares.insert(place, {influence.binding, weight});
  }
}

}  // namespace

FourWeights fourLargest(std::vector<Share> shares) {
  std::erase_if(shares, [](const Share& share) { return !(share.weight > 0.0); });
  assert(!shares.empty());
  std::ranges::sort(shares, [](const Share& a, const Share& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.binding < b.binding;
  });
  if (shares.size() > kMostWeights) shares.resize(kMostWeights);
  double sum = 0.0;
  for (const Share& share : shares) sum += share.weight;
  FourWeights result;
  float others = 0.0f;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const auto weight = static_cast<float>(shares[i].weight / sum);
    if (!(weight > 0.0f)) break;
    result.binding[i] = shares[i].binding;
    result.weight[i] = weight;
    others += weight;
  }
  result.binding[0] = shares[0].binding;
  result.weight[0] = 1.0f - others;
  return result;
}

std::vector<std::vector<Share>> interpolatedWeights(const ControlMesh& mesh, const Refinement& refinement) {
  std::vector<std::vector<Share>> shares(toIndex(refinement.vertexCount));
  for (int v = 0; v < refinement.controlVertices; ++v) addVertex(mesh, v, 1.0, at(shares, v));
  for (int e = 0; e < refinement.controlEdges; ++e) {
    const auto& ends = at(mesh.edges, e).vertices;
    const double n = refinement.edgeLevel(e);
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      std::vector<Share>& own = at(shares, refinement.edgeVertex(e, step));
      addVertex(mesh, ends[0], 1.0 - step / n, own);
      addVertex(mesh, ends[1], step / n, own);
    }
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& corners = at(mesh.triangles, t).vertices;
    for (int v = at(refinement.insideBegin, t); v < at(refinement.insideBegin, t + 1); ++v) {
      const glm::dvec2& place = refinement.insideAt(v);
      std::vector<Share>& own = at(shares, v);
      addVertex(mesh, corners[0], 1.0 - place.x - place.y, own);
      addVertex(mesh, corners[1], place.x, own);
      addVertex(mesh, corners[2], place.y, own);
    }
  }
  return shares;
}

void bindingMatrices(const Skeleton& skeleton, const Pose& pose, std::vector<glm::dmat4>& out) {
  out.clear();
  for (const Binding& binding : skeleton.bindings) {
    out.push_back(glm::dmat4(at(pose.boneInWorld, binding.bone)) * glm::dmat4(binding.inverseBind));
  }
}

glm::dvec3 skinPoint(std::span<const glm::dmat4> matrices, const FourWeights& weights, const glm::dvec3& point) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < kMostWeights && weights.binding[i] >= 0; ++i) {
    sum += static_cast<double>(weights.weight[i]) * carryPoint(at(matrices, weights.binding[i]), point);
  }
  return sum;
}

}  // namespace sinew::exporting
