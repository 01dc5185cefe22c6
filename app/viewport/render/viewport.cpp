// app/viewport/render/viewport.cpp: the order in which a picture is made.
#include "app/viewport/render/viewport.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

#include <glm/gtc/matrix_transform.hpp>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/ground_drawer.h"
#include "app/viewport/render/muscle_drawer.h"
#include "app/viewport/render/occlusion.h"
#include "app/viewport/render/overlay_drawers.h"
#include "app/viewport/render/primitive_drawer.h"
#include "app/viewport/render/reference_picture.h"
#include "app/viewport/render/surface_drawer.h"
#include "core/geometry/stopwatch.h"

namespace sinew::app {

struct Viewport::State {
  SurfaceDrawer surface;
  GroundDrawer ground;
  PrimitiveDrawer primitives;
  MuscleDrawer muscles;
  SkeletonDrawer skeleton;
  LineDrawer lines;
  ReferenceDrawer references;
  ScreenOcclusion occlusion;
  PictureMean mean;
  GlBuffer frameBlock;
  GlBuffer lightBlock;
  RenderTarget target{};
  RenderTarget sample{};  ///< One picture of the mean.
  int samples = 1;
  bool finish = false;
  bool occludesOnce = !isSoftwareRenderer();
  bool transparent = false;
  float floor = 0.0f;
  bool kept = false;               ///< The last picture shows the kept background outside of `boxes`.
  std::vector<glm::vec4> boxes{};  ///< The character and its shadow in the last picture.
  std::vector<glm::vec4> changed{};
  std::optional<glm::vec3> heldCenter{};  ///< Frame::groundCenter of the last picture of this character.
  DrawSeconds seconds{};
};

namespace {

/// For drawing on the processor: Mesa allocates and frees some hundred kilobytes for each piece of a mesh, which is
/// much slower if they go back to the system each time. Keeps 64 MB at most. Does nothing without glibc.
void keepFreedMemory() {
#ifdef M_TRIM_THRESHOLD
  mallopt(M_MMAP_THRESHOLD, 16 << 20);  // Larger ones go back at once.
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

// Fractions of the height. One step in 255 of the floor's light is at least 0.015.
constexpr float kHeldWithin = 0.06f;
constexpr float kDragged = 0.015f;

FrameBlock blockOf(const Frame& frame, bool occluded, bool ofMean) {
  FrameBlock block;
  block.clipFromWorld = frame.view.clipFromWorld();
  block.viewFromWorld = frame.view.viewFromWorld;
  block.eye = glm::vec4(frame.view.eyeInWorld, frame.view.orthographic ? 1.0f : 0.0f);
  block.forward = glm::vec4(frame.view.forwardInWorld(), 0.0f);
  block.picture = glm::vec4(glm::vec2(frame.view.size), frame.height, frame.floor);
  block.key = glm::vec4(keyDirection(frame.settings.look.light), 0.0f);
  block.occluded.x = occluded ? 1.0f : 0.0f;
  block.occluded.y = ofMean ? 1.0f : 0.0f;
  return block;
}

void resetState() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glFrontFace(GL_CCW);
  glBindSampler(0, 0);
}

/// Bounds in the picture, 0..1 from the top left, with room for linear scaling; nullopt: not all in front of the eye.
std::optional<glm::vec4> boxAround(const View& view, std::span<const glm::vec3> points) {
  constexpr float kRoom = 3.0f;
  const glm::vec2 size(view.size);
  glm::vec2 low(size), high(0.0f);
  for (const glm::vec3& point : points) {
    const glm::vec3 pixel = view.toPixel(point);
    if (!(std::abs(pixel.z) <= 1.0f)) return std::nullopt;
    low = glm::min(low, glm::vec2(pixel));
    high = glm::max(high, glm::vec2(pixel));
  }
  low = glm::clamp((low - kRoom) / size, 0.0f, 1.0f);
  return glm::vec4(low, glm::clamp((high + kRoom) / size, low, glm::vec2(1.0f)));
}

/// Boxes of the character and its shadow; empty if anything else is in front of the background.
std::vector<glm::vec4> boxesOf(const Frame& frame, const glm::vec4& shadow) {
  const DisplaySettings& shown = frame.settings;
  if (shown.controlMesh || !frame.scene.segments.empty() || shown.primitives || shown.influence || shown.skeleton ||
      !frame.scene.territoryBones.empty() || !frame.scene.primitives.empty() || !frame.scene.references.empty()) {
    return {};
  }
  const Bounds& box = frame.surfaceBounds;
  if (box.isEmpty()) return {};
  std::array<glm::vec3, 4> fallen;
  for (std::size_t i = 0; i < fallen.size(); ++i) {
    fallen[i] = {shadow.x + ((i & 1) != 0 ? 1.0f / shadow.z : 0.0f), frame.floor,
                 shadow.y + ((i & 2) != 0 ? 1.0f / shadow.w : 0.0f)};
  }
  std::vector<glm::vec4> boxes;
  if (const auto around = boxAround(frame.view, cornersOf(box))) boxes.push_back(*around);
  if (!shown.ground || boxes.empty()) return boxes;
  if (const auto around = boxAround(frame.view, fallen)) boxes.push_back(*around);
  else boxes.clear();
  return boxes;
}

/// Undoes the multiplication of colors by alpha, in linear light.
void divideByAlpha(std::vector<std::uint8_t>& rgba) {
  const auto decode = [](double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); };
  const auto encode = [](double l) { return l <= 0.0031308 ? l * 12.92 : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055; };
  for (std::size_t at = 0; at < rgba.size(); at += 4) {
    const double alpha = rgba[at + 3] / 255.0;
    if (rgba[at + 3] == 0 || rgba[at + 3] == 255) continue;
    for (std::size_t c = at; c < at + 3; ++c) {
      const double whole = std::min(decode(rgba[c] / 255.0) / alpha, 1.0);
      rgba[c] = static_cast<std::uint8_t>(std::lround(encode(whole) * 255.0));
    }
  }
}

bool showsSurface(const Frame& frame) {
  return frame.scene.surface != nullptr && !frame.surfaceBounds.isEmpty() && frame.settings.surface;
}

}  // namespace

Viewport::Viewport() = default;
Viewport::~Viewport() = default;

Result<std::unique_ptr<Viewport>> Viewport::create(int samples) {
  if (epoxy_gl_version() < 45) return Error{"", "", "the graphics driver does not offer OpenGL 4.5: " + rendererName()};
  if (isSoftwareRenderer()) keepFreedMemory();
  Result<SurfaceDrawer> surface = SurfaceDrawer::create();
  if (!surface) return surface.error();
  Result<GroundDrawer> ground = GroundDrawer::create();
  if (!ground) return ground.error();
  Result<PrimitiveDrawer> primitives = PrimitiveDrawer::create();
  if (!primitives) return primitives.error();
  Result<MuscleDrawer> muscles = MuscleDrawer::create();
  if (!muscles) return muscles.error();
  Result<SkeletonDrawer> skeleton = SkeletonDrawer::create();
  if (!skeleton) return skeleton.error();
  Result<LineDrawer> lines = LineDrawer::create();
  if (!lines) return lines.error();
  Result<ReferenceDrawer> references = ReferenceDrawer::create();
  if (!references) return references.error();
  Result<ScreenOcclusion> occlusion = ScreenOcclusion::create();
  if (!occlusion) return occlusion.error();
  Result<PictureMean> mean = PictureMean::create();
  if (!mean) return mean.error();
  std::unique_ptr<Viewport> viewport(new Viewport);
  viewport->state_ = std::make_unique<State>(State{
      std::move(surface).value(), std::move(ground).value(), std::move(primitives).value(), std::move(muscles).value(),
      std::move(skeleton).value(), std::move(lines).value(), std::move(references).value(),
      std::move(occlusion).value(), std::move(mean).value(), makeBuffer(), makeBuffer()});
  viewport->state_->samples = samples;
  return viewport;
}

int Viewport::defaultSamples() { return isSoftwareRenderer() ? 1 : 4; }

void Viewport::setCharacter(const Character& character) {
  state_->surface.setCharacter(character);
  state_->heldCenter.reset();
  state_->floor = 0.0f;
  if (!character.mesh.positions.empty()) {
    state_->floor = std::ranges::min(character.mesh.positions, {}, &glm::vec3::y).y;
  }
}

void Viewport::setCardVertices(const std::optional<CardVertices>& vertices) {
  state_->surface.setCardVertices(vertices);
}

/// Below the character. In a movement it moves only when it must, so that the floor under a swaying one can be kept.
glm::vec3 Viewport::groundCenter(const Frame& frame, bool moving) {
  const glm::vec3 below = frame.surfaceBounds.isEmpty() ? glm::vec3(0.0f) : frame.surfaceBounds.center();
  std::optional<glm::vec3>& held = state_->heldCenter;
  const float most = kHeldWithin * frame.height;
  const float away = held ? glm::distance(*held, below) : 0.0f;
  if (!held || !moving) held = below;
  else if (away > most) held = below + (*held - below) * ((most - kDragged * frame.height) / away);
  return *held;
}

void Viewport::noteChange(const Frame& frame, bool kept) {
  State& s = *state_;
  std::vector<glm::vec4> boxes = kept ? boxesOf(frame, s.ground.shadowPlace()) : std::vector<glm::vec4>{};
  const bool comparable = kept && s.kept && !s.ground.keptAnew() && !boxes.empty() && !s.boxes.empty();
  s.changed = comparable ? s.boxes : std::vector{glm::vec4(0.0f, 0.0f, 1.0f, 1.0f)};
  if (comparable) s.changed.insert(s.changed.end(), boxes.begin(), boxes.end());
  s.boxes = std::move(boxes);
  s.kept = kept;
}

/// Draws from back to front. @param kept  the target holds the kept background
void Viewport::drawInto(const RenderTarget& target, const Frame& frame, bool kept) {
  State& s = *state_;
  const DisplaySettings& settings = frame.settings;
  const bool showSurface = showsSurface(frame);
  target.begin();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(1.0);
  glClear(kept ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  noteChange(frame, kept);
  if (kept) s.ground.drawSunkOverKept(frame);
  else if (settings.background) s.ground.drawBackground(frame);
  glEnable(GL_DEPTH_TEST);
  s.references.draw(frame, false);
  if (settings.anatomy) s.muscles.drawFlesh(frame);
  else if (showSurface) s.surface.drawOpaque(frame);
  s.references.draw(frame, true);
  if (settings.ground && kept) s.ground.drawGroundOverKept(frame);
  else if (settings.ground) s.ground.drawGround(frame);
  if (settings.anatomy) s.muscles.drawHollows();
  if (showSurface && settings.anatomy) s.muscles.drawGlass(frame, s.surface);
  else if (showSurface) s.surface.drawBlended(frame);
  if (showSurface) s.surface.drawLitParts(frame);
  if (settings.controlMesh) s.lines.drawControlMesh(frame);
  if (settings.segments) s.lines.drawSegments(frame);
  if (settings.primitives || settings.influence) s.primitives.drawShells(frame);
  if (settings.primitives || settings.anatomy) s.lines.drawMuscleLines(frame);
  const bool bones = settings.skeleton || (settings.territory && !frame.scene.territoryBones.empty());
  if (bones && frame.scene.pose != nullptr) s.skeleton.draw(frame);
  s.primitives.drawOutlines(frame);
  target.end();
  resetState();
}

/// Uniforms of all shaders, and the occlusion texture. @param sample  in a mean; below 0: a single picture
void Viewport::shareFrame(const Frame& frame, int sample) {
  State& s = *state_;
  const bool surface = frame.settings.look.occlusion && frame.settings.surface && !frame.surfaceBounds.isEmpty();
  const bool occluded = (surface || frame.settings.anatomy) && (sample >= 0 || s.occludesOnce);
  const FrameBlock block = blockOf(frame, occluded, sample >= 0);
  uploadBuffer(s.frameBlock, std::span<const FrameBlock>(&block, 1));
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, s.frameBlock.id());
  uploadBuffer(s.lightBlock, std::span<const LightBlock>(&lightBlock(frame.settings.look.light), 1));
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, s.lightBlock.id());
  if (frame.settings.anatomy) s.muscles.place(frame);
  if (occluded) s.occlusion.prepare(frame, s.surface, s.muscles, sample);
}

void Viewport::leave() {
  resetState();
  glBindVertexArray(0);
  glUseProgram(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (state_->finish) glFinish();
}

/// Uploads the surface.
Frame Viewport::frameOf(const Scene& scene, const View& view, const DisplaySettings& settings, bool moving) {
  State& s = *state_;
  resetState();
  const bool surfaced = scene.surface != nullptr && scene.surface->refinement != nullptr;
  if (surfaced) s.surface.upload(scene, settings.shading == Shading::kClasses);
  Frame frame{scene, view, settings, scene.character->height, s.floor, surfaced ? s.surface.bounds() : Bounds{}};
  frame.groundCenter = groundCenter(frame, moving);
  return frame;
}

Frame Viewport::beginPicture(const Scene& scene, const View& view, const DisplaySettings& settings, bool moving) {
  State& s = *state_;
  Stopwatch watch;
  const Frame frame = frameOf(scene, view, settings, moving);
  s.references.prepare(frame);
  s.target.resize(view.size, s.samples);
  s.transparent = !settings.background;
  if (s.finish) glFinish();
  s.seconds.upload = watch.lap();
  return frame;
}

void Viewport::draw(const Scene& scene, const View& whole, const DisplaySettings& chosen, std::optional<float> moving) {
  const float scale = moving.value_or(1.0f);
  assert(scene.character != nullptr && whole.size.x > 0 && whole.size.y > 0 && scale > 0.0f && scale <= 1.0f);
  View view = whole;
  DisplaySettings settings = chosen;
  if (scale < 1.0f) {
    view.size = glm::max(glm::ivec2(glm::round(glm::vec2(whole.size) * scale)), glm::ivec2(1));
    settings.lineScale *= scale;
  }
  State& s = *state_;
  const Frame frame = beginPicture(scene, view, settings, moving.has_value());
  Stopwatch watch;
  if (moving && s.samples == 1 && showsSurface(frame)) s.surface.leaveOutUnseen(frame);
  s.mean.begin(whole.size);
  shareFrame(frame, -1);
  const bool keeps = moving.has_value() && s.samples == 1 && scene.references.empty();
  const bool kept = keeps && s.ground.copyKept(s.target, frame, s.kept ? s.boxes : std::vector<glm::vec4>{});
  if (settings.ground) s.ground.prepareShadow(frame, s.surface);
  drawInto(s.target, frame, kept);
  leave();
  s.seconds.draw = watch.lap();
}

void Viewport::drawMean(const Scene& scene, const View& view, const DisplaySettings& settings, int samples) {
  State& s = *state_;
  const Frame frame = beginPicture(scene, view, settings, false);
  Stopwatch watch;
  s.mean.begin(view.size);
  shareFrame(frame, 0);
  if (settings.ground) s.ground.prepareShadow(frame, s.surface);
  while (s.mean.count() < samples) refine(scene, view, settings);
  s.seconds.draw = watch.lap();
}

bool Viewport::refine(const Scene& scene, const View& view, const DisplaySettings& settings) {
  State& s = *state_;
  assert(view.size == s.target.size());
  const int sample = s.mean.count();
  if (sample >= kMeanSamples) return false;
  View aside = view;
  const glm::vec2 shift = 2.0f * sampleOffset(sample) / glm::vec2(view.size);
  aside.clipFromView = glm::translate(glm::mat4(1.0f), glm::vec3(shift, 0.0f)) * view.clipFromView;
  const Frame frame = frameOf(scene, aside, settings, false);
  s.sample.resize(view.size, 1);  // The mean smooths edges.
  shareFrame(frame, sample);
  drawInto(s.sample, frame);
  s.mean.add(s.sample);
  const bool shown = s.mean.count() == kFewSamples || s.mean.count() == kMeanSamples;
  if (shown) s.mean.writeTo(s.target);
  leave();
  return shown;
}

int Viewport::samplesTaken() const { return state_->mean.count(); }
bool Viewport::isRefined() const { return state_->mean.count() >= kMeanSamples; }

void Viewport::setFinishFrames(bool finish) { state_->finish = finish; }
void Viewport::setOccludesOnce(bool occludes) { state_->occludesOnce = occludes; }
const DrawSeconds& Viewport::seconds() const { return state_->seconds; }
const std::vector<glm::vec4>& Viewport::changed() const { return state_->changed; }
unsigned Viewport::colorTexture() const { return state_->target.texture(); }

Image Viewport::readPixels() const {
  const glm::ivec2 size = state_->target.size();
  Image image{size.x, size.y, {}};
  const std::size_t row = 4 * static_cast<std::size_t>(size.x);
  std::vector<std::uint8_t> bottomUp(row * static_cast<std::size_t>(size.y));
  if (bottomUp.empty()) return image;
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(colorTexture(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bottomUp.size()),
                    bottomUp.data());
  image.rgba.reserve(bottomUp.size());
  for (std::size_t y = static_cast<std::size_t>(size.y); y-- > 0;) {
    const auto first = bottomUp.begin() + static_cast<std::ptrdiff_t>(y * row);
    image.rgba.insert(image.rgba.end(), first, first + static_cast<std::ptrdiff_t>(row));
  }
  if (state_->transparent) divideByAlpha(image.rgba);
  return image;
}

}  // namespace sinew::app
