// core/surface/finish/fold.cpp: fronts of triangles; one look at all moved triangles, then only around folds.
#include "core/surface/finish/fold.h"

#include <utility>

#include "core/geometry/parallel.h"

namespace sinew {

std::vector<float> triangleFronts(const Refinement& refinement, std::span<const glm::vec3> positions,
                                  std::span<const glm::vec3> normals) {
  std::vector<float> fronts;
  fronts.reserve(refinement.triangles.size());
  for (const std::array<int, 3>& t : refinement.triangles) {
    fronts.push_back(frontOf(t, faceOf(t, positions), {positions, normals, {}}));
  }
  return fronts;
}

float trustIn(const Refinement& refinement, std::size_t triangle, const PatchView& patch, const glm::vec3& face) {
  const float bindFront = patch.bindFronts[triangle];
  if (!(bindFront > 0.0f)) return 0.0f;
  return in_float::foldTrust(frontOf(refinement.triangles[triangle], face, patch) / bindFront);
}

void FoldRegion::find(const ControlMesh& mesh, const Refinement& refinement, const VertexRings& rings,
                      const MovedTriangles& moved, const PatchView& patch, const VertexPairs& pairs,
                      std::span<const glm::vec3> positions, float least) {
  mesh_ = &mesh;
  refinement_ = &refinement;
  rings_ = &rings;
  isControl_ = moved.isControl;
  patch_ = patch;
  triangles_.clear();
  first_.assign(mesh.triangles.size(), -1);
  isFolding_.assign(mesh.triangles.size(), 0);
  isNear_.assign(mesh.positions.size(), 0);
  folding_.clear();

  findShrunk(moved.refined, pairs, least);
  for (const int i : shrunk_) {
    if (at(isFolding_, at(refinement.controlOf, i)) != 0) continue;
    FoldTriangle triangle = triangleOf(i);
    const float left = glm::dot(faceOf(triangle.corners, positions), triangle.face);
    if (left < least * triangle.whole && trustOf(triangle) != 0.0f) add(triangle);
  }
  grow();
}

void FoldRegion::findShrunk(std::span<const int> asked, const VertexPairs& pairs, float least) {
  constexpr std::size_t kFew = 2048;  // For one thread.
  constexpr std::size_t kRoom = 4;    // All blocks but the last are multiples of it.
  const FoldKernel kernel = foldKernel(chosenVectorSet());
  shrunk_.resize(asked.size() + kRoom);
  const auto list = [&](std::size_t begin, std::size_t end, int* shrunk) {
    return kernel({asked.subspan(begin, end - begin), refinement_->triangles.data(), pairs.data(), least, shrunk});
  };
  shrunk_.resize(listInBlocks(asked.size(), kFew, shrunk_.data(), list));
}

FoldTriangle FoldRegion::triangleOf(int index) const {
  const std::array<int, 3>& corners = at(refinement_->triangles, index);
  const glm::vec3 face = faceOf(corners, patch_.positions);
  return {index, corners, face, glm::dot(face, face)};
}

void FoldRegion::add(const FoldTriangle& folding) {
  const int control = at(refinement_->controlOf, folding.index);
  std::uint8_t& isFolding = at(isFolding_, control);
  if (isFolding != 0) return;
  isFolding = 1;
  folding_.push_back(control);
}

void FoldRegion::grow() {
  near_.clear();
  for (const int control : folding_) {
    for (const int v : at(mesh_->triangles, control).vertices) {
      if (std::exchange(at(isNear_, v), std::uint8_t{1}) != 0) continue;
      for (const int corner : rings_->cornersOf(v)) {
        const int t = at(refinement_->controlOf, corner / 3);
        if (at(isControl_, t) != 0 && at(first_, t) < 0) near_.push_back(t);
      }
    }
  }
  folding_.clear();
  std::ranges::sort(near_);
  for (const int t : near_) {
    if (at(first_, t) >= 0) continue;
    at(first_, t) = static_cast<int>(triangles_.size());
    for (int i = at(refinement_->triangleBegin, t); i < at(refinement_->triangleBegin, t + 1); ++i) {
      triangles_.push_back(triangleOf(i));
    }
  }
}

}  // namespace sinew
