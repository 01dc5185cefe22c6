// app/render/primitive_drawer.cpp: translucent shells with three rings each, and outlines.
#include "app/render/primitive_drawer.h"

#include <algorithm>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "app/render/shape_colors.h"

namespace sinew::app {
namespace {

constexpr int kRingVertices = 3 * 64 * 6;  ///< As shaders/ring.vert numbers them.
constexpr int kOutlineVertices = 96 * 6;   ///< As shaders/outline.vert numbers them.
constexpr float kHaloWidth = 2.2f;         ///< Pixels more than the outline: a dark edge that any skin sets off.

/// How near an ellipsoid comes to the eye, along the view. Smaller is nearer.
float nearestDepth(const PrimitiveShape& shape, const glm::vec3& forward) {
  const glm::vec3 centre(shape.unitBallInWorld[3]);
  return glm::dot(centre, forward) - glm::length(glm::transpose(glm::mat3(shape.unitBallInWorld)) * forward);
}

/// Furthest first, so that nearer shells are blended over them; one inside another comes before it.
std::vector<const PrimitiveShape*> backToFront(const Frame& frame) {
  std::vector<const PrimitiveShape*> order;
  for (const PrimitiveShape& shape : frame.scene.primitives) order.push_back(&shape);
  const glm::vec3 forward = frame.view.forwardInWorld();
  std::ranges::stable_sort(order, std::greater<>{},
                           [&](const PrimitiveShape* shape) { return nearestDepth(*shape, forward); });
  return order;
}

}  // namespace

PrimitiveDrawer::PrimitiveDrawer()
    : visible_(ShapeMesh::ball(20)), influence_(ShapeMesh::ball(20)), outlined_(ShapeMesh::ball(3)) {}

Result<PrimitiveDrawer> PrimitiveDrawer::create() {
  PrimitiveDrawer drawer;
  Result<GlProgram> fill = GlProgram::load({"shaders/shape.vert", "shaders/ellipsoid.frag"});
  if (!fill) return fill.error();
  Result<GlProgram> ring = GlProgram::load({"shaders/ring.vert", "shaders/line.frag"});
  if (!ring) return ring.error();
  Result<GlProgram> outline = GlProgram::load({"shaders/outline.vert", "shaders/line.frag"});
  if (!outline) return outline.error();
  drawer.fillProgram_ = std::move(fill).value();
  drawer.ringProgram_ = std::move(ring).value();
  drawer.outlineProgram_ = std::move(outline).value();
  return drawer;
}

void PrimitiveDrawer::drawFamily(const ShapeMesh& shells, const ShellLook& look) const {
  struct Pass {
    GLenum depth;
    float opacity;
  };
  for (const Pass& pass : {Pass{GL_GREATER, 0.55f}, Pass{GL_LEQUAL, 1.0f}}) {
    glDepthFunc(pass.depth);
    fillProgram_.use();
    fillProgram_.set("opacity", pass.opacity * look.strength);
    glEnable(GL_CULL_FACE);
    // The far walls of all shells lie behind the near walls: with them a shell is a body of glass, not a disc.
    for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
      if (hidden == GL_FRONT && pass.depth == GL_GREATER) continue;  // Under the skin one wall is enough.
      glCullFace(hidden);
      fillProgram_.set("inner", hidden == GL_FRONT ? 1.0f : 0.0f);
      shells.draw();
    }
    glDisable(GL_CULL_FACE);
    ringProgram_.use();
    ringProgram_.set("opacity", pass.opacity * (look.dashes > 0.0f ? 0.50f : 0.85f));
    ringProgram_.set("width", look.ringWidth);
    ringProgram_.set("dashes", look.dashes);
    shells.drawNumbered(kRingVertices);
  }
}

void PrimitiveDrawer::drawShells(const Frame& frame) {
  if (frame.scene.primitives.empty()) return;
  std::vector<ShapeInstance> visible, influence;
  for (const PrimitiveShape* shape : backToFront(frame)) {
    const glm::vec3 color = shapeColor(*shape);
    const glm::vec4 style(shape->selected ? 1.0f : 0.0f, shape->hovered ? 1.0f : 0.0f, 0, 0);
    visible.push_back({shape->unitBallInWorld, glm::vec4(color, 0.34f), style});
    const glm::mat4 reach = glm::scale(shape->unitBallInWorld, glm::vec3(shape->reach));
    influence.push_back({reach, glm::vec4(color, 0.09f), style});
  }
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  blendPremultiplied();
  const float scale = frame.settings.lineScale;
  if (frame.settings.influence) {
    influence_.setInstances(influence);
    drawFamily(influence_, {1.0f * scale, 36.0f, 0.7f});
  }
  if (frame.settings.primitives) {
    visible_.setInstances(visible);
    drawFamily(visible_, {1.2f * scale, 0.0f, 1.0f});
  }
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

void PrimitiveDrawer::drawOutlines(const Frame& frame) {
  const float scale = frame.settings.lineScale;
  std::vector<ShapeInstance> outlined;
  for (const PrimitiveShape* shape : backToFront(frame)) {
    if (!shape->selected && !shape->hovered) continue;
    const bool selected = shape->selected;
    const glm::vec3 color = selected ? shapeColor(*shape) : glm::mix(shapeColor(*shape), glm::vec3(1.0f), 0.45f);
    const float width = (selected ? 2.4f : 1.5f) * scale;
    outlined.push_back({shape->unitBallInWorld, glm::vec4(color, selected ? 1.0f : 0.62f), glm::vec4(width, 0, 0, 0)});
  }
  if (outlined.empty()) return;
  outlined_.setInstances(outlined);
  glDisable(GL_DEPTH_TEST);
  blendPremultiplied();
  outlineProgram_.use();
  outlineProgram_.set("opacity", 1.0f);
  for (const bool halo : {true, false}) {
    outlineProgram_.set("extra", halo ? kHaloWidth * scale : 0.0f);
    outlineProgram_.set("halo", halo ? glm::vec4(0.01f, 0.01f, 0.012f, 0.42f) : glm::vec4(0.0f));
    outlined_.drawNumbered(kOutlineVertices);
  }
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace sinew::app
