// app/render/surface_shadow.cpp: the surface as it casts its shadow.
#include "app/render/surface_drawer.h"

namespace sinew::app {

void SurfaceDrawer::drawForShadow(const Frame& frame, const GlProgram& solid, const GlProgram& withAlpha) const {
  if (refinement_ == nullptr) return;
  const bool coarse = coarseIndexCount_ > 0;
  glBindVertexArray(array_.id());
  glVertexArrayElementBuffer(array_.id(), coarse ? coarseIndices_.id() : indices_.id());
  glVertexAttrib4f(5, 1.0f, 1.0f, 1.0f, 1.0f);  // For surfaces without colors.
  int coarseFirst = 0;
  for (const Range& range : shadowRanges_) {
    const Material& material = materialOf(range);
    const AlphaMode alpha = alphaIn(frame, material);
    const GlProgram& program = alpha == AlphaMode::kOpaque ? solid : withAlpha;
    program.use();
    if (alpha != AlphaMode::kOpaque) {
      program.set("baseMap", 0);
      program.set("alpha", glm::vec2(material.baseColor.a, alpha == AlphaMode::kMask ? material.alphaCutoff : -1.0f));
      textures_.bindBase(material);
    }
    const int first = coarse ? coarseFirst : range.firstTriangle;
    const int triangles = coarse ? range.controlTriangles : range.triangles;
    coarseFirst += range.controlTriangles;
    const auto offset = static_cast<std::uintptr_t>(first) * 3 * sizeof(std::uint32_t);
    glDrawElements(GL_TRIANGLES, triangles * 3, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
  }
  glVertexArrayElementBuffer(array_.id(), culled_.empty() ? indices_.id() : keptIndices_.id());
}

}  // namespace sinew::app
