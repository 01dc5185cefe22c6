// app/viewport/render/screen_occlusion.cpp: normals and depths, what they hide of each other, a blur.
#include "app/viewport/render/screen_occlusion.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace sinew::app {
namespace {

constexpr float kRadius = 0.075f;        ///< How far a surface darkens its neighbors, fraction of the height.
constexpr float kMuscleRadius = 0.040f;  ///< The same for muscles, which lie close together.
constexpr GLuint kUnit = 5;              ///< Texture unit of shaders/surface.frag.
constexpr int kTaps = 16;
constexpr int kTapsOnProcessor = 12;

GlTexture target(GlFramebuffer& framebuffer, GLenum format, const glm::ivec2& size) {
  GlTexture texture = makeTexture(GL_TEXTURE_2D);
  glTextureStorage2D(texture.id(), 1, format, size.x, size.y);
  glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  framebuffer = makeFramebuffer();
  glNamedFramebufferTexture(framebuffer.id(), GL_COLOR_ATTACHMENT0, texture.id(), 0);
  return texture;
}

/// A pixel's place, from the eye, one unit along the view; without perspective, in the eye's plane.
glm::vec3 pixelPlace(const View& view, const glm::vec2& pixel) {
  const Ray ray = view.rayThrough(pixel);
  const glm::vec3 forward = view.forwardInWorld();
  if (!view.orthographic) return ray.direction / glm::dot(ray.direction, forward);
  const glm::vec3 from = ray.origin - view.eyeInWorld;
  return from - forward * glm::dot(from, forward);
}

void setPixels(const GlProgram& program, const View& view) {
  const glm::vec2 size(view.size);
  const glm::vec3 corner = pixelPlace(view, {0.0f, size.y});  // OpenGL counts rows from below.
  program.set("corner", corner);
  program.set("stepX", (pixelPlace(view, size) - corner) / size.x);
  program.set("stepY", (pixelPlace(view, {0.0f, 0.0f}) - corner) / size.y);
}

}  // namespace

ScreenOcclusion::ScreenOcclusion() : empty_(makeVertexArray()) {}

Result<ScreenOcclusion> ScreenOcclusion::create() {
  ScreenOcclusion made;
  struct Wanted {
    GlProgram* program;
    const char* vertex;
    const char* fragment;
  };
  for (const Wanted& wanted : {Wanted{&made.surfaceProgram_, "shaders/depth.vert", "shaders/depth.frag"},
                               Wanted{&made.occlusionProgram_, "shaders/fullscreen.vert", "shaders/occlusion.frag"},
                               Wanted{&made.blurProgram_, "shaders/fullscreen.vert", "shaders/occlusion_blur.frag"}}) {
    Result<GlProgram> program = GlProgram::load({wanted.vertex, wanted.fragment});
    if (!program) return program.error();
    *wanted.program = std::move(program).value();
  }
  return made;
}

void ScreenOcclusion::resize(const glm::ivec2& size) {
  if (size == size_) return;
  size_ = size;
  surface_ = target(surfaceTarget_, GL_RGBA32F, size);
  depth_ = makeRenderbuffer();
  glNamedRenderbufferStorage(depth_.id(), GL_DEPTH_COMPONENT32F, size.x, size.y);
  glNamedFramebufferRenderbuffer(surfaceTarget_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  open_ = target(openTarget_, GL_R16F, size);
  blurred_ = target(blurredTarget_, GL_R16F, size);
}

void ScreenOcclusion::drawSurface(const Frame& frame, const SurfaceDrawer& surface, const MuscleDrawer& muscles) const {
  glBindFramebuffer(GL_FRAMEBUFFER, surfaceTarget_.id());
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(1.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  if (frame.settings.anatomy) {
    muscles.drawDepths();
  } else {
    glDisable(GL_BLEND);
    surfaceProgram_.use();
    surfaceProgram_.set("baseMap", 0);
    surface.drawOpaque(surfaceProgram_, frame);
  }
  glDisable(GL_DEPTH_TEST);
}

void ScreenOcclusion::prepare(const Frame& frame, const SurfaceDrawer& surface, const MuscleDrawer& muscles,
                              int sample) {
  resize(frame.view.size);
  glViewport(0, 0, size_.x, size_.y);
  glDisable(GL_BLEND);
  glDisable(GL_FRAMEBUFFER_SRGB);
  drawSurface(frame, surface, muscles);

  const float radius = (frame.settings.anatomy ? kMuscleRadius : kRadius) * frame.height;
  const auto turn = static_cast<float>(sample < 0 ? 0 : sample);
  glBindFramebuffer(GL_FRAMEBUFFER, openTarget_.id());
  glBindTextureUnit(0, surface_.id());
  occlusionProgram_.use();
  occlusionProgram_.set("surface", 0);
  setPixels(occlusionProgram_, frame.view);
  // Each sample falls between those before it. Not the golden ratio: the taps of one sample already turn by that.
  occlusionProgram_.set("reach",
                        glm::vec4(radius, 0.5f * radius * frame.view.clipFromView[1][1] * static_cast<float>(size_.y),
                                  turn * 0.75487767f, turn * 0.56984029f));
  occlusionProgram_.set("taps", isSoftwareRenderer() ? kTapsOnProcessor : kTaps);
  glBindVertexArray(empty_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindFramebuffer(GL_FRAMEBUFFER, blurredTarget_.id());
  glBindTextureUnit(1, open_.id());
  blurProgram_.use();
  blurProgram_.set("surface", 0);
  blurProgram_.set("source", 1);
  blurProgram_.set("width", sample < 0 ? 3 : 2);
  blurProgram_.set("range", 0.3f * radius);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindTextureUnit(kUnit, blurred_.id());
}

}  // namespace sinew::app
