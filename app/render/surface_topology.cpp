// app/render/surface_topology.cpp: index buffers of a refinement: triangles by material, and those of the shadow.
#include <algorithm>
#include <numeric>

#include "app/render/gl_objects.h"
#include "app/render/surface_drawer.h"

namespace sinew::app {
namespace {

std::span<const std::array<std::uint32_t, 3>> drawTrianglesOf(const Refinement& refinement, int control) {
  const auto first = static_cast<std::size_t>(refinement.triangleBegin[static_cast<std::size_t>(control)]);
  return std::span(refinement.drawTriangles)
      .subspan(first, static_cast<std::size_t>(refinement.refinedTriangles(control)));
}

}  // namespace

void SurfaceDrawer::rebuildOrder(const ControlMesh& mesh, const GlBuffer& indices, GLenum usage) {
  const auto materialIndex = [&](int t) { return mesh.triangles[static_cast<std::size_t>(t)].material; };
  controlOrder_.resize(mesh.triangles.size());
  std::iota(controlOrder_.begin(), controlOrder_.end(), 0);
  if (!culled_.empty()) std::erase_if(controlOrder_, [&](int t) { return culled_[static_cast<std::size_t>(t)] != 0; });
  std::ranges::stable_sort(controlOrder_, {}, materialIndex);
  std::vector<std::array<std::uint32_t, 3>> ordered;
  ordered.reserve(refinement_->drawTriangles.size());
  std::vector<int> controlOf;
  controlOf.reserve(refinement_->drawTriangles.size());
  ranges_.clear();
  for (const int t : controlOrder_) {
    if (ranges_.empty() || ranges_.back().material != materialIndex(t)) {
      ranges_.push_back({materialIndex(t), static_cast<int>(ordered.size()), 0});
    }
    const auto own = drawTrianglesOf(*refinement_, t);
    ordered.insert(ordered.end(), own.begin(), own.end());
    controlOf.insert(controlOf.end(), own.size(), t);
    ranges_.back().triangles += static_cast<int>(own.size());
  }
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
