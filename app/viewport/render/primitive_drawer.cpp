// app/viewport/render/primitive_drawer.cpp: translucent shells with three rings, and outlines.
#include "app/viewport/render/primitive_drawer.h"

#include <algorithm>
#include <vector>

#include "app/viewport/render/color_scales.h"
#include "core/geometry/silhouette.h"

namespace sinew::app {
namespace {

constexpr int kRingVertices = 3 * 64 * 6;  ///< As shaders/ring.vert numbers them.
constexpr int kOutlineVertices = 96 * 6;   ///< As shaders/outline.vert numbers them.
constexpr float kHaloWidth = 2.2f;         ///< Pixels around the outline, dark.
constexpr float kRimWidth = 1.3f;          ///< Pixels.
constexpr float kHidden = 0.5f;            ///< Opacity behind the surface.
const glm::vec4 kHalo{0.01f, 0.01f, 0.012f, 0.42f};

/// Smallest depth of an ellipsoid along the view.
float nearestDepth(const PrimitiveShape& shape, const glm::vec3& forward) {
  const glm::vec3 center(shape.unitBallInWorld[3]);
  return glm::dot(center, forward) - glm::length(glm::transpose(glm::mat3(shape.unitBallInWorld)) * forward);
}

ShapeInstance shellOf(const PrimitiveShape& shape, float scale, const glm::vec4& color, const glm::vec3& style) {
  ShapeInstance shell = app::shellOf(shape, scale);
  shell.color = color;
  shell.style = glm::vec4(style, shell.style.w);
  return shell;
}

/// Furthest first, for blending; a shell inside another comes before it.
std::vector<const PrimitiveShape*> backToFront(const Frame& frame) {
  std::vector<const PrimitiveShape*> order;
  for (const PrimitiveShape& shape : frame.scene.primitives) order.push_back(&shape);
  const glm::vec3 forward = frame.view.forwardInWorld();
  std::ranges::stable_sort(order, std::greater<>{},
                           [&](const PrimitiveShape* shape) { return nearestDepth(*shape, forward); });
  return order;
}

/// An ellipsoid as the eye sees it.
struct SeenBall {
  glm::mat3 toBall{1.0f};
  glm::vec3 eye{0.0f};     ///< In the ball's space; without perspective the direction of sight.
  glm::vec3 center{0.0f};  ///< World.
  bool parallel = false;

  /// Whether the sight through a point passes well inside.
  [[nodiscard]] bool covers(const glm::vec3& point) const {
    constexpr float kWellInside = 0.99f;
    const glm::vec3 at = toBall * (point - center);
    const glm::vec3 along = parallel ? eye : at - eye;
    const float share = glm::dot(at, along) / glm::dot(along, along);
    const glm::vec3 nearest = at - share * along;
    return glm::dot(nearest, nearest) < kWellInside * kWellInside;
  }
};

/// The other bellies of a shape's sheet.
std::vector<SeenBall> ballsBeside(const PrimitiveShape& shape, const View& view, const Scene& scene) {
  std::vector<SeenBall> balls;
  if (shape.sheet < 0) return balls;
  for (const PrimitiveShape& other : scene.primitives) {
    if (other.sheet != shape.sheet || other.rigIndex == shape.rigIndex) continue;
    SeenBall ball;
    ball.toBall = glm::inverse(glm::mat3(other.unitBallInWorld));
    ball.center = glm::vec3(other.unitBallInWorld[3]);
    ball.parallel = view.orthographic;
    ball.eye = ball.toBall * (view.orthographic ? view.forwardInWorld() : view.eyeInWorld - ball.center);
    balls.push_back(ball);
  }
  return balls;
}

}  // namespace

PrimitiveDrawer::PrimitiveDrawer()
    : visible_(ShapeMesh::ball(20)),
      influence_(ShapeMesh::ball(20)),
      outlined_(ShapeMesh::ball(3)),
      rims_(ShapeMesh::ball(3)),
      outlines_(makeBuffer()) {}

Result<PrimitiveDrawer> PrimitiveDrawer::create() {
  PrimitiveDrawer drawer;
  const Result<void> loaded = loadPrograms({{drawer.fillProgram_, {"shaders/shape.vert", "shaders/ellipsoid.frag"}},
                                            {drawer.ringProgram_, {"shaders/ring.vert", "shaders/line.frag"}},
                                            {drawer.outlineProgram_, {"shaders/outline.vert", "shaders/line.frag"}}});
  if (!loaded) return loaded.error();
  return drawer;
}

void PrimitiveDrawer::drawFamily(const ShapeMesh& shells, const ShellLook& look) const {
  for (const bool inSight : {false, true}) {
    const float opacity = inSight ? 1.0f : kHidden;
    glDepthFunc(inSight ? GL_LEQUAL : GL_GREATER);
    fillProgram_.use();
    fillProgram_.set("opacity", opacity * look.strength);
    fillProgram_.set("lineScale", look.lineScale);
    fillProgram_.set("meets", look.meets ? 1.0f : 0.0f);
    glEnable(GL_CULL_FACE);
    // With its far walls behind the near ones, a shell looks like glass rather than a disc.
    for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
      if (hidden == GL_FRONT && !inSight) continue;  // One wall is enough under the skin.
      glCullFace(hidden);
      fillProgram_.set("inner", hidden == GL_FRONT ? 1.0f : 0.0f);
      shells.draw();
    }
    glDisable(GL_CULL_FACE);
    ringProgram_.use();
    ringProgram_.set("opacity", opacity * (look.dashes > 0.0f ? 0.50f : 0.85f));
    ringProgram_.set("width", look.ringWidth);
    ringProgram_.set("dashes", look.dashes);
    shells.drawNumbered(kRingVertices);
  }
}

void PrimitiveDrawer::drawShells(const Frame& frame) {
  const bool bodies = frame.settings.primitives && !frame.settings.anatomy;
  if (frame.scene.primitives.empty() || !(bodies || frame.settings.influence)) return;
  const float scale = frame.settings.lineScale;
  std::vector<ShapeInstance> visible, influence, rims;
  outlinePoints_.clear();
  for (const PrimitiveShape* shape : backToFront(frame)) {
    const glm::vec3 color = shapeColor(*shape);
    const glm::vec3 style(shape->selected ? 1.0f : 0.0f, shape->hovered ? 1.0f : 0.0f, shape->sign < 0 ? 1.0f : 0.0f);
    visible.push_back(shellOf(*shape, 1.0f, glm::vec4(color, 0.34f), style));
    influence.push_back(shellOf(*shape, shape->reach, glm::vec4(color, 0.09f), style));
    if (outlineLook(*shape).width > 0.0f) continue;
    const glm::vec3 pale = glm::mix(color, glm::vec3(1.0f), 0.35f);
    rims.push_back({shape->unitBallInWorld, glm::vec4(pale, 0.95f),
                    glm::vec4(kRimWidth * scale, 0, outlineNumber(*shape, frame.view, frame.scene), 0)});
  }
  copyDepth(frame);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  blendPremultiplied();
  fillProgram_.use();
  const glm::mat4& clip = frame.view.clipFromView;
  fillProgram_.set("depthScale", glm::vec4(clip[2][2], clip[3][2], 0.0f, 0.0f));
  glBindTextureUnit(0, depth_.id());
  if (frame.settings.influence) {
    influence_.setInstances(influence);
    drawFamily(influence_, {1.0f * scale, 36.0f, 0.7f, scale, false});
  }
  if (bodies) {
    visible_.setInstances(visible);
    drawFamily(visible_, {1.0f * scale, 0.0f, 1.0f, scale, true});
    rims_.setInstances(rims);
    bindOutlines();
    drawRims(scale);
  }
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

float PrimitiveDrawer::outlineNumber(const PrimitiveShape& shape, const View& view, const Scene& scene) {
  if (shape.shape.isPlain() && shape.sheet < 0) return 0.0f;
  const std::vector<SeenBall> others = ballsBeside(shape, view, scene);
  const glm::vec3 eye = view.orthographic ? view.forwardInWorld() : view.eyeInWorld;
  for (const glm::vec3& point : silhouetteOf(shape.shape, shape.unitBallInWorld, eye, view.orthographic)) {
    const bool covered = std::ranges::any_of(others, [&](const SeenBall& ball) { return ball.covers(point); });
    outlinePoints_.emplace_back(point, covered ? 0.0f : 1.0f);
  }
  return static_cast<float>(outlinePoints_.size() / kSilhouettePoints);
}

void PrimitiveDrawer::bindOutlines() const {
  uploadBuffer(outlines_, std::span<const glm::vec4>(outlinePoints_));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, outlines_.id());
}

void PrimitiveDrawer::drawRims(float scale) const {
  outlineProgram_.use();
  for (const GLenum depth : {GL_GREATER, GL_LEQUAL}) {
    glDepthFunc(depth);
    const bool shown = depth == GL_LEQUAL;
    for (const bool halo : {true, false}) {
      outlineProgram_.set("opacity", shown ? 1.0f : (halo ? 0.6f : 0.7f) * kHidden);
      outlineProgram_.set("extra", halo ? kHaloWidth * scale : 0.0f);
      outlineProgram_.set("halo", halo ? kHalo : glm::vec4(0.0f));
      rims_.drawNumbered(kOutlineVertices);
    }
  }
}

void PrimitiveDrawer::copyDepth(const Frame& frame) {
  const glm::ivec2 size = frame.view.size;
  if (size != depthSize_) {
    depthSize_ = size;
    depth_ = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(depth_.id(), 1, GL_DEPTH_COMPONENT32F, size.x, size.y);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      glTextureParameteri(depth_.id(), filter, GL_NEAREST);
    }
    depthCopy_ = makeFramebuffer();
    glNamedFramebufferTexture(depthCopy_.id(), GL_DEPTH_ATTACHMENT, depth_.id(), 0);
    glNamedFramebufferDrawBuffer(depthCopy_.id(), GL_NONE);
  }
  GLint drawn = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  glBlitNamedFramebuffer(static_cast<GLuint>(drawn), depthCopy_.id(), 0, 0, size.x, size.y, 0, 0, size.x, size.y,
                         GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

void PrimitiveDrawer::drawOutlines(const Frame& frame) {
  const float scale = frame.settings.lineScale;
  std::vector<ShapeInstance> outlined;
  outlinePoints_.clear();
  for (const PrimitiveShape* shape : backToFront(frame)) {
    const OutlineLook look = outlineLook(*shape);
    if (!(look.width > 0.0f)) continue;
    outlined.push_back({shape->unitBallInWorld, glm::vec4(look.color, look.opacity),
                        glm::vec4(look.width * scale, look.dashes, outlineNumber(*shape, frame.view, frame.scene), 0)});
  }
  if (outlined.empty()) return;
  outlined_.setInstances(outlined);
  bindOutlines();
  glDisable(GL_DEPTH_TEST);
  blendPremultiplied();
  outlineProgram_.use();
  outlineProgram_.set("opacity", 1.0f);
  for (const bool halo : {true, false}) {
    outlineProgram_.set("extra", halo ? kHaloWidth * scale : 0.0f);
    outlineProgram_.set("halo", halo ? kHalo : glm::vec4(0.0f));
    outlined_.drawNumbered(kOutlineVertices);
  }
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace sinew::app
