// core/smoothing/finish/fold_relaxation.cpp: vertices of folded triangles move to the mean of their neighbors.
#include "core/smoothing/finish/fold_relaxation.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/smoothstep.h"

namespace sinew {
namespace {

/// Of the way to the mean, per round. Whole steps swing, and amplify what is small.
constexpr float kRelaxStep = 0.2f;
constexpr float kMostOfLack = 2.0f;  ///< Whole step over what a triangle lacks.
constexpr float kFade = 0.25f;       ///< Change of a weight per round: weights that came and went would swing.

/// How much a lifted triangle asks for, 0..1: all of it from q = 0 on.
float weightOf(const Fold& fold) {
  return fold.weight * (1.0f - smoothstep(0.0f, FoldRelaxation::kWholeArea, fold.area));
}

/// The length by which a lifted triangle is too narrow for q = 0.4: the area that is missing, over its edges.
float lackOf(int triangle, const Fold& fold, FoldMesh& mesh) {
  const std::array<int, 3>& corners = mesh.cornersOf(triangle);
  const glm::vec3& a = mesh.vertex(corners[0]).position;
  const glm::vec3 ab = mesh.vertex(corners[1]).position - a;
  const glm::vec3 ac = mesh.vertex(corners[2]).position - a;
  const float edges = glm::dot(ab, ab) + glm::dot(ac, ac) + glm::dot(ac - ab, ac - ab);
  const float area = std::sqrt(mesh.faceOfPatch(triangle).second);
  // Where it has shrunk to a line along the normal, those of its patch.
  return fold.weight * (FoldRelaxation::kWholeArea - fold.area) * area / std::sqrt(std::max(edges, area));
}

}  // namespace

void FoldRelaxation::askOf(int triangle, FoldMesh& mesh) {
  const Fold fold = mesh.foldOf(triangle, kWholeArea);
  const float weight = weightOf(fold);
  if (weight == 0.0f) return;
  mesh.add(triangle);
  const float lack = lackOf(triangle, fold, mesh);
  for (const int corner : mesh.cornersOf(triangle)) {
    FoldVertex& vertex = mesh.vertex(corner);
    if (vertex.most == 0.0f) continue;
    if (vertex.asked == 0.0f) asking_.push_back(corner);
    vertex.asked = std::max(vertex.asked, weight);
    vertex.lack = std::max(vertex.lack, lack);
  }
}

void FoldRelaxation::mergeWeights(FoldMesh& mesh) {
  for (const int v : folding_) {
    FoldVertex& vertex = mesh.vertex(v);
    vertex.weight = std::max(vertex.weight - kFade, vertex.asked);
  }
  for (const int v : asking_) {
    FoldVertex& vertex = mesh.vertex(v);
    if (vertex.weight < vertex.asked) {
      vertex.weight = vertex.asked;
      folding_.push_back(v);
    }
    vertex.asked = 0.0f;
  }
  asking_.clear();
  std::erase_if(folding_, [&](int v) {
    float& weight = mesh.vertex(v).weight;
    weight = std::max(0.0f, weight);
    return weight == 0.0f;
  });
}

void FoldRelaxation::findMeans(const VertexRings& rings, FoldMesh& mesh) {
  means_.clear();
  for (const int v : folding_) {
    const FoldVertex& own = mesh.vertex(v);
    glm::vec3 sum(0.0f);
    for (const int neighbor : rings.at(own.index)) sum += mesh.vertexOf(neighbor).position - own.position;
    means_.push_back(own.position + at(rings.share, own.index) * sum);
  }
}

void FoldRelaxation::moveToMeans(FoldMesh& mesh) {
  for (std::size_t i = 0; i < folding_.size(); ++i) {
    const FoldVertex& vertex = mesh.vertex(folding_[i]);
    const glm::vec3 way = vertex.weight * (means_[i] - vertex.position);
    const float length = std::sqrt(glm::dot(way, way));
    const float most = kMostOfLack * vertex.lack;
    mesh.move(folding_[i], vertex.position + (length > most ? kRelaxStep * most / length : kRelaxStep) * way);
  }
}

/// Moves the corners of folded triangles towards the mean of their neighbors. Such triangles mostly lie on the muscle
/// in the wrong order: the mean restores the order and stays on the muscle, while a move back to the patch would tear a
/// pit into it. Each round reads only the positions that the round before has left (Jacobi), so that the order of
/// triangles does not matter. After the first round only triangles at vertices with a weight are looked at again:
/// nothing else has changed. docs/design.md, Folds.
void FoldRelaxation::apply(const VertexRings& rings, FoldMesh& mesh) {
  for (int t = 0; t < mesh.triangleCount(); ++t) askOf(t, mesh);
  mergeWeights(mesh);
  for (int round = 0; round < kMostRounds && !folding_.empty(); ++round) {
    mesh.grow();  // All triangles at a folding vertex, and all that its move can fold.
    findMeans(rings, mesh);
    moveToMeans(mesh);
    // Elsewhere nothing has changed, and only corners that cannot move could be asked again.
    mesh.forEachAt(folding_, [&](int triangle) { askOf(triangle, mesh); });
    mergeWeights(mesh);
  }
  for (const int v : folding_) mesh.vertex(v).weight = 0.0f;
  folding_.clear();
  mesh.grow();
}

std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement) {
  std::vector<std::uint8_t> out(static_cast<std::size_t>(refinement.vertexCount), 0);
  for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e) {
    const Edge& edge = at(mesh.edges, e);
    if (edge.triangleCount > 1) continue;
    for (const int end : edge.vertices) at(out, end) = 1;
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      at(out, refinement.edgeVertex(e, step)) = 1;
    }
  }
  return out;
}

}  // namespace sinew
