// core/smoothing/finish/fold_region.cpp: one look at all moved triangles, then only around those that fold.
#include "core/smoothing/finish/fold_region.h"

#include <algorithm>

namespace sinew {
namespace {

constexpr std::uint8_t kInside = 1;
constexpr std::uint8_t kFolding = 2;

}  // namespace

void FoldRegion::find(const ControlMesh& mesh, const Refinement& refinement, std::span<const int> control,
                      const PatchView& patch, std::span<const glm::vec3> positions, float least) {
  mesh_ = &mesh;
  refinement_ = &refinement;
  control_ = control;
  patch_ = patch;
  triangles_.clear();
  isNear_.assign(mesh.positions.size(), 0);
  isInside_.assign(mesh.triangles.size(), 0);
  grows_ = false;
  for (const int t : control) {
    for (int i = t * perTriangle(); i < (t + 1) * perTriangle(); ++i) {
      const std::array<int, 3>& corners = at(refinement.triangles, i);
      const glm::vec3 face = faceOf(corners, patch.positions);
      FoldTriangle triangle{i, corners, face, glm::dot(face, face)};
      if (foldOf(triangle, positions, least).weight == 0.0f) continue;
      add(triangle);
      break;
    }
  }
  grow();
}

void FoldRegion::add(const FoldTriangle& folding) {
  const int control = folding.index / perTriangle();
  std::uint8_t& state = at(isInside_, control);
  if ((state & kFolding) != 0) return;
  state |= kFolding;
  grows_ = true;
  for (const int v : at(mesh_->triangles, control).vertices) at(isNear_, v) = 1;
}

void FoldRegion::grow() {
  if (!grows_) return;
  grows_ = false;
  for (const int t : control_) {
    if ((at(isInside_, t) & kInside) != 0) continue;
    const auto near = [&](int corner) { return at(isNear_, corner) != 0; };
    if (std::ranges::any_of(at(mesh_->triangles, t).vertices, near)) addControl(t);
  }
}

void FoldRegion::addControl(int control) {
  at(isInside_, control) |= kInside;
  for (int i = control * perTriangle(); i < (control + 1) * perTriangle(); ++i) {
    const std::array<int, 3>& corners = at(refinement_->triangles, i);
    const glm::vec3 face = faceOf(corners, patch_.positions);
    triangles_.push_back({i, corners, face, glm::dot(face, face)});
  }
}

}  // namespace sinew
