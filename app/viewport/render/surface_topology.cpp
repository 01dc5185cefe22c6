// app/viewport/render/surface_topology.cpp: index buffers of a refinement: triangles by material, and those of the
// shadow.
#include <algorithm>
#include <numeric>

#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/surface_drawer.h"

namespace sinew::app {
namespace {

/// Refined triangles of control triangles, one after the other.
std::vector<int> refinedOf(const Refinement& refinement, std::span<const int> controls) {
  std::vector<int> refined;
  refined.reserve(refinement.drawTriangles.size());
  for (const int t : controls) {
    const int first = refinement.triangleBegin[static_cast<std::size_t>(t)];
    for (int i = 0; i < refinement.refinedTriangles(t); ++i) refined.push_back(first + i);
  }
  return refined;
}

}  // namespace

void SurfaceDrawer::rebuildOrder(const ControlMesh& mesh, const GlBuffer& indices, GLenum usage) {
  const auto materialIndex = [&](int t) { return mesh.triangles[static_cast<std::size_t>(t)].material; };
  controlOrder_.resize(mesh.triangles.size());
  std::iota(controlOrder_.begin(), controlOrder_.end(), 0);
  if (!culled_.empty()) std::erase_if(controlOrder_, [&](int t) { return culled_[static_cast<std::size_t>(t)] != 0; });
  std::ranges::stable_sort(controlOrder_, {}, materialIndex);
  refinedOrder_ = refinedOf(*refinement_, controlOrder_);
  std::vector<std::array<std::uint32_t, 3>> ordered;
  std::vector<int> controlOf;
  ordered.reserve(refinedOrder_.size());
  controlOf.reserve(refinedOrder_.size());
  ranges_.clear();
  for (const int refined : refinedOrder_) {
    const int t = refinement_->controlOf[static_cast<std::size_t>(refined)];
    if (ranges_.empty() || ranges_.back().material != materialIndex(t)) {
      ranges_.push_back({materialIndex(t), static_cast<int>(ordered.size()), 0});
    }
    ordered.push_back(refinement_->drawTriangles[static_cast<std::size_t>(refined)]);
    controlOf.push_back(t);
    ++ranges_.back().triangles;
  }
  showsBacks_.clear();
  for (const Range& range : ranges_) showsBacks_.push_back(materialOf(range).doubleSided ? 1 : 0);
  uploadBuffer(indices, std::span<const std::array<std::uint32_t, 3>>(ordered), usage);
  uploadBuffer(controlOf_, std::span<const int>(controlOf), usage);
  glVertexArrayElementBuffer(array_.id(), indices.id());
}

void SurfaceDrawer::rebuildTopology(const Character& character) {
  const Refinement& refinement = *refinement_;
  culled_.clear();
  rebuildOrder(character.mesh, indices_, GL_STATIC_DRAW);
  uploadBuffer(uvs_, std::span<const glm::vec2>(refinement.drawUv), GL_STATIC_DRAW);
  uploadBuffer(colors_, std::span<const glm::vec4>(refinement.drawColor), GL_STATIC_DRAW);
  if (refinement.drawColor.empty()) glDisableVertexArrayAttrib(array_.id(), 5);
  else glEnableVertexArrayAttrib(array_.id(), 5);
  shadowRanges_ = ranges_;
  if (!isSoftwareRenderer()) return;
  const ShadowMesh shadow = makeShadowMesh(character, shadowClusters_, refinement, controlOrder_);
  uploadBuffer(shadowIndices_, std::span<const std::uint32_t>(shadow.indices), GL_STATIC_DRAW);
  shadowRanges_ = shadow.ranges;
}

}  // namespace sinew::app
