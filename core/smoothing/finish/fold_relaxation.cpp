// core/smoothing/finish/fold_relaxation.cpp: vertices of folded triangles move to the mean of their neighbors.
#include "core/smoothing/finish/fold_relaxation.h"

#include <algorithm>

#include "core/base/smoothstep.h"

namespace sinew {
namespace {

constexpr float kRelaxStep =
    0.2f;                       ///< Of the way to the mean, per round. Whole steps swing, and amplify what is small.
constexpr float kFade = 0.25f;  ///< Change of a weight per round: weights that came and went would swing.

/// How much a lifted triangle asks for, 0..1: all of it from q = 0 on.
float weightOf(const Fold& fold) {
  return fold.weight * (1.0f - smoothstep(0.0f, FoldRelaxation::kWholeArea, fold.area));
}

}  // namespace

void FoldRelaxation::askOf(int triangle, FoldMesh& mesh) {
  const float weight = weightOf(mesh.foldOf(triangle, kWholeArea));
  if (weight == 0.0f) return;
  mesh.add(triangle);
  for (const int corner : mesh.cornersOf(triangle)) {
    FoldVertex& vertex = mesh.vertex(corner);
    if (vertex.most == 0.0f) continue;
    if (vertex.asked == 0.0f) asking_.push_back(corner);
    vertex.asked = std::max(vertex.asked, weight);
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
    for (std::size_t i = 0; i < folding_.size(); ++i) {
      const FoldVertex& vertex = mesh.vertex(folding_[i]);
      mesh.move(folding_[i], vertex.position + kRelaxStep * vertex.weight * (means_[i] - vertex.position));
    }
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
