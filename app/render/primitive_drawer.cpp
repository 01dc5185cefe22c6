// app/render/primitive_drawer.cpp: translucent shells with three rings each.
#include "app/render/primitive_drawer.h"

#include <algorithm>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

namespace sinew::app {
namespace {

constexpr int kRingVertices = 3 * 64 * 6;  ///< As shaders/ring.vert numbers them.
constexpr glm::vec3 kAdds{0.85f, 0.20f, 0.11f};
constexpr glm::vec3 kCarves{0.06f, 0.34f, 0.80f};
constexpr glm::vec3 kSelected{1.00f, 0.50f, 0.06f};
constexpr glm::vec3 kSelectedCarve{0.10f, 0.62f, 1.00f};

glm::vec3 colorOf(const PrimitiveShape& shape) {
  if (shape.sign < 0) return shape.selected ? kSelectedCarve : kCarves;
  return shape.selected ? kSelected : kAdds;
}

/// Furthest first, so that nearer shells are blended over them.
std::vector<const PrimitiveShape*> backToFront(const Frame& frame) {
  std::vector<const PrimitiveShape*> order;
  for (const PrimitiveShape& shape : frame.scene.primitives) order.push_back(&shape);
  const glm::vec3 forward = frame.view.forwardInWorld();
  std::ranges::stable_sort(order, std::greater<>{}, [&](const PrimitiveShape* shape) {
    return glm::dot(glm::vec3(shape->unitBallInWorld[3]), forward);
  });
  return order;
}

}  // namespace

PrimitiveDrawer::PrimitiveDrawer() : visible_(ShapeMesh::ball(20)), influence_(ShapeMesh::ball(20)) {}

Result<PrimitiveDrawer> PrimitiveDrawer::create() {
  PrimitiveDrawer drawer;
  Result<GlProgram> fill = GlProgram::load({"shaders/shape.vert", "shaders/ellipsoid.frag"});
  if (!fill) return fill.error();
  Result<GlProgram> ring = GlProgram::load({"shaders/ring.vert", "shaders/line.frag"});
  if (!ring) return ring.error();
  drawer.fillProgram_ = std::move(fill).value();
  drawer.ringProgram_ = std::move(ring).value();
  return drawer;
}

void PrimitiveDrawer::drawShells(const ShapeMesh& shells, float width, float dashes, float strength) const {
  struct Pass {
    GLenum depth;
    float opacity;
  };
  for (const Pass& pass : {Pass{GL_GREATER, 0.42f}, Pass{GL_LEQUAL, 1.0f}}) {
    glDepthFunc(pass.depth);
    fillProgram_.use();
    fillProgram_.set("opacity", pass.opacity * strength);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    shells.draw();
    glDisable(GL_CULL_FACE);
    ringProgram_.use();
    ringProgram_.set("opacity", pass.opacity * (dashes > 0.0f ? 0.55f : 0.9f));
    ringProgram_.set("width", width);
    ringProgram_.set("dashes", dashes);
    shells.drawNumbered(kRingVertices);
  }
}

void PrimitiveDrawer::draw(const Frame& frame) {
  if (frame.scene.primitives.empty()) return;
  std::vector<ShapeInstance> visible, influence;
  for (const PrimitiveShape* shape : backToFront(frame)) {
    const glm::vec3 color = colorOf(*shape);
    const glm::vec4 style(shape->selected ? 1.0f : 0.0f, shape->hovered ? 1.0f : 0.0f, 0, 0);
    visible.push_back({shape->unitBallInWorld, glm::vec4(color, 0.34f), style});
    const glm::mat4 reach = glm::scale(shape->unitBallInWorld, glm::vec3(shape->reach));
    influence.push_back({reach, glm::vec4(color, 0.10f), glm::vec4(0.0f, style.y, 0, 0)});
  }
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  blendPremultiplied();
  if (frame.settings.influence) {
    influence_.setInstances(influence);
    drawShells(influence_, 1.0f * frame.settings.lineScale, 40.0f, 0.7f);
  }
  if (frame.settings.primitives) {
    visible_.setInstances(visible);
    drawShells(visible_, 1.4f * frame.settings.lineScale, 0.0f, 1.0f);
  }
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

}  // namespace sinew::app
