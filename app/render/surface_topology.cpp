// app/render/surface_topology.cpp: index buffers of a refinement: triangles by material, and one for each control
// triangle.
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

/// Drawn vertices at the corners of the control triangles, three each.
std::vector<std::uint32_t> controlCorners(const ControlMesh& mesh, const Refinement& refinement,
                                          std::span<const int> order) {
  std::vector<std::uint32_t> corners;
  for (const int control : order) {
    std::array<std::uint32_t, 3> own{};
    for (const auto& triangle : drawTrianglesOf(refinement, control)) {
      for (const std::uint32_t vertex : triangle) {
        const int refined = refinement.drawVertex[vertex];
        if (refined >= refinement.controlVertices) continue;
        const auto& vertices = mesh.triangles[static_cast<std::size_t>(control)].vertices;
        own[static_cast<std::size_t>(std::ranges::find(vertices, refined) - vertices.begin())] = vertex;
      }
    }
    corners.insert(corners.end(), own.begin(), own.end());
  }
  return corners;
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
      ranges_.push_back({materialIndex(t), static_cast<int>(ordered.size()), 0, 0});
    }
    const auto own = drawTrianglesOf(*refinement_, t);
    ordered.insert(ordered.end(), own.begin(), own.end());
    controlOf.insert(controlOf.end(), own.size(), t);
    ranges_.back().triangles += static_cast<int>(own.size());
    ++ranges_.back().controlTriangles;
  }
  uploadBuffer(indices, std::span<const std::array<std::uint32_t, 3>>(ordered), usage);
  uploadBuffer(controlOf_, std::span<const int>(controlOf), usage);
  glVertexArrayElementBuffer(array_.id(), indices.id());
}

void SurfaceDrawer::rebuildTopology(const ControlMesh& mesh) {
  const Refinement& refinement = *refinement_;
  culled_.clear();
  rebuildOrder(mesh, indices_, GL_STATIC_DRAW);
  shadowRanges_ = ranges_;
  uploadBuffer(uvs_, std::span<const glm::vec2>(refinement.drawUv), GL_STATIC_DRAW);
  uploadBuffer(colors_, std::span<const glm::vec4>(refinement.drawColor), GL_STATIC_DRAW);
  if (refinement.drawColor.empty()) glDisableVertexArrayAttrib(array_.id(), 5);
  else glEnableVertexArrayAttrib(array_.id(), 5);
  coarseIndexCount_ = 0;
  if (refinement.depth < 2 || !isSoftwareRenderer()) return;
  const std::vector<std::uint32_t> corners = controlCorners(mesh, refinement, controlOrder_);
  uploadBuffer(coarseIndices_, std::span<const std::uint32_t>(corners), GL_STATIC_DRAW);
  coarseIndexCount_ = static_cast<GLsizei>(corners.size());
}

}  // namespace sinew::app
