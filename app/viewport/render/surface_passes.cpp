// app/viewport/render/surface_passes.cpp: the surface as it casts its shadow, and parts of it as a tint.
#include "app/viewport/render/color_scales.h"
#include "app/viewport/render/surface_drawer.h"

namespace sinew::app {
namespace {

// Opacity of the tint of a part.
constexpr float kHoveredPart = 0.52f;
constexpr float kChosenPart = 0.40f;
constexpr float kHiddenPart = 0.85f;  ///< Share of these where nothing is seen of it.

}  // namespace

void SurfaceDrawer::drawForShadow(const Frame& frame, const GlProgram& solid, const GlProgram& withAlpha) const {
  if (refinement_ == nullptr) return;
  glBindVertexArray(array_.id());
  glVertexArrayElementBuffer(array_.id(), isSoftwareRenderer() ? shadowIndices_.id() : indices_.id());
  glVertexAttrib4f(5, 1.0f, 1.0f, 1.0f, 1.0f);  // For surfaces without colors.
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
    drawTriangles(range.firstTriangle, range.triangles);
  }
  glVertexArrayElementBuffer(array_.id(), culled_.empty() ? indices_.id() : keptIndices_.id());
}

void SurfaceDrawer::drawPart(const Frame& frame, const LitPart& lit, float strength) const {
  if (lit.part >= static_cast<int>(materialOfPart_.size())) return;
  const int material = materialOfPart_[static_cast<std::size_t>(lit.part)];
  partProgram_.set("part", lit.part);
  partProgram_.set("tint", glm::vec4(linearFromSrgb(layerColor(lit.layer).srgb), strength));
  for (const Range& range : ranges_) {
    if (range.material == material) drawRange(partProgram_, frame, range, 0);
  }
}

void SurfaceDrawer::drawLitParts(const Frame& frame) const {
  if (refinement_ == nullptr || frame.scene.litParts.empty()) return;
  partProgram_.use();
  partProgram_.set("baseMap", 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, parts_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, controlOf_.id());
  glBindVertexArray(array_.id());
  glVertexAttrib4f(5, 1.0f, 1.0f, 1.0f, 1.0f);  // For surfaces without colors.
  blendPremultiplied();
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  for (const LitPart& lit : frame.scene.litParts) {
    const float strength = lit.hovered ? kHoveredPart : kChosenPart;
    glDepthFunc(GL_LEQUAL);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, partSeen_.id());
    drawPart(frame, lit, strength);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    glDepthFunc(GL_GREATER);
    glBeginConditionalRender(partSeen_.id(), GL_QUERY_WAIT_INVERTED);
    drawPart(frame, lit, strength * kHiddenPart);
    glEndConditionalRender();
  }
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace sinew::app
