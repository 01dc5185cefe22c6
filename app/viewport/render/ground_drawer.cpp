// app/viewport/render/ground_drawer.cpp: draws and keeps the background, the floor and the shadow.
#include "app/viewport/render/ground_drawer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sinew::app {
namespace {

constexpr float kShadowSoftness = 0.018f;  ///< Standard deviation, fraction of the height.
constexpr float kContactSoftness = 0.007f;
constexpr float kGroundReach = 3.4f;     ///< Half the floor's extent, heights, for near eyes.
constexpr float kShownByDefault = 2.2f;  ///< Heights in the picture up to which the floor keeps its extent.
constexpr float kGridRank = 5.0f;        ///< A large cell over a small one.

/// Area on the floor of the bounds' shadow, with room for the blur.
glm::vec4 shadowArea(const Frame& frame) {
  const glm::vec3 key = keyDirection(frame.settings.look.light);
  const Bounds& box = frame.surfaceBounds;
  glm::vec2 low(box.low.x, box.low.z), high(box.high.x, box.high.z);
  const float top = std::max(box.high.y - frame.floor, 0.0f);
  const glm::vec2 slide = -glm::vec2(key.x, key.z) / key.y * top;
  low += glm::min(slide, glm::vec2(0.0f));
  high += glm::max(slide, glm::vec2(0.0f));
  const float room = 4.0f * kShadowSoftness * frame.height;
  return {low - room, 1.0f / (high - low + 2.0f * room)};
}

/// Whether another background than the studio is shown.
bool isChosen(const Frame& frame) {
  return frame.settings.background && frame.settings.look.backdrop != Backdrop::kStudio;
}

/// Pixels of the surface below the floor, which may shine through: low corner and size, from below; nullopt: anywhere.
std::optional<glm::ivec4> sunkPixels(const Frame& frame) {
  const View& view = frame.view;
  const Bounds& box = frame.surfaceBounds;
  if (view.orthographic ? view.forwardInWorld().y >= 0.0f : view.eyeInWorld.y <= frame.floor) return std::nullopt;
  if (box.isEmpty() || box.low.y >= frame.floor) return glm::ivec4(0);
  const float top = std::min(frame.floor, box.high.y);
  glm::vec2 low(view.size), high(0.0f);
  for (const glm::vec3& corner : cornersOf({box.low, {box.high.x, top, box.high.z}})) {
    const glm::vec3 pixel = view.toPixel(corner);
    if (!(std::abs(pixel.z) <= 1.0f)) return std::nullopt;
    low = glm::min(low, glm::vec2(pixel));
    high = glm::max(high, glm::vec2(pixel));
  }
  constexpr float kRoom = 2.0f;
  const glm::ivec2 first(glm::clamp(glm::floor(low - kRoom), glm::vec2(0.0f), glm::vec2(view.size)));
  const glm::ivec2 last(glm::clamp(glm::ceil(high + kRoom), glm::vec2(first), glm::vec2(view.size)));
  return glm::ivec4(first.x, view.size.y - last.y, last - first);
}

/// Draws in these pixels only.
template <class Draw>
void within(const glm::ivec4& pixels, const Draw& draw) {
  if (pixels.z <= 0 || pixels.w <= 0) return;
  glEnable(GL_SCISSOR_TEST);
  glScissor(pixels.x, pixels.y, pixels.z, pixels.w);
  draw();
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace

float gridCell(float height) {
  const float wanted = 0.3f * height;
  const float decade = std::pow(10.0f, std::floor(std::log10(wanted)));
  const float factor = wanted / decade;
  return decade * (factor < 1.5f ? 1.0f : factor < 3.5f ? 2.0f : factor < 7.5f ? 5.0f : 10.0f);
}

GridZoom gridZoom(const View& view, const glm::vec3& center, float height) {
  // Height of the picture there, in characters.
  const float shown = view.unitsPerPixelAt(center) * static_cast<float>(view.size.y) / height;
  const float level = std::clamp(std::log(std::max(shown, 1e-6f)) / std::log(kGridRank), -2.0f, 4.0f);
  const float whole = std::floor(level);
  return {std::max(1.0f, shown / kShownByDefault), gridCell(height) * std::pow(kGridRank, whole), level - whole};
}

GroundDrawer::GroundDrawer() : empty_(makeVertexArray()), shadowSize_(isSoftwareRenderer() ? 160 : 512) {
  for (std::size_t i = 0; i < 2; ++i) {
    shadowTextures_[i] = makeTexture(GL_TEXTURE_2D);
    const GLuint id = shadowTextures_[i].id();
    glTextureStorage2D(id, 1, GL_RG8, shadowSize_, shadowSize_);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    shadowTargets_[i] = makeFramebuffer();
    glNamedFramebufferTexture(shadowTargets_[i].id(), GL_COLOR_ATTACHMENT0, id, 0);
  }
}

Result<GroundDrawer> GroundDrawer::create() {
  GroundDrawer drawer;
  const Result<void> loaded = loadPrograms(
      {{drawer.shadowProgram_, {"shaders/shadow.vert", "shaders/shadow.frag"}},
       {drawer.shadowAlphaProgram_, {"shaders/shadow.vert", "shaders/shadow.frag"}, {"ALPHA"}},
       {drawer.blurProgram_,
        {"shaders/fullscreen.vert", "shaders/blur.frag"},
        {isSoftwareRenderer() ? "FEW_TAPS" : "MANY_TAPS"}},
       {drawer.groundProgram_, {"shaders/ground.vert", "shaders/ground.frag"}},
       {drawer.groundShadowProgram_, {"shaders/ground_shadow.vert", "shaders/ground_shadow.frag"}},
       {drawer.backgroundProgram_, {"shaders/fullscreen.vert", "shaders/background.frag"}},
       {drawer.chosenGround_, {"shaders/ground.vert", "shaders/ground.frag"}, {"CHOSEN_LOOK"}},
       {drawer.chosenBackground_, {"shaders/fullscreen.vert", "shaders/background.frag"}, {"CHOSEN_LOOK"}}});
  if (!loaded) return loaded.error();
  return drawer;
}

void GroundDrawer::prepareShadow(const Frame& frame, const SurfaceDrawer& surface) {
  area_ = glm::vec4(0.0f);
  if (frame.surfaceBounds.isEmpty()) return;
  area_ = shadowArea(frame);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glViewport(0, 0, shadowSize_, shadowSize_);

  glBindFramebuffer(GL_FRAMEBUFFER, shadowTargets_[0].id());
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  glBlendFunc(GL_ONE, GL_ONE);
  for (const GlProgram* program : {&shadowProgram_, &shadowAlphaProgram_}) {
    program->use();
    program->set("area", area_);
  }
  surface.drawForShadow(frame, shadowProgram_, shadowAlphaProgram_);
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);

  const glm::vec2 perUnit(area_.z, area_.w);
  const glm::vec2 wide = perUnit * (kShadowSoftness * frame.height);
  const glm::vec2 narrow = perUnit * (kContactSoftness * frame.height);
  blurProgram_.use();
  blurProgram_.set("source", 0);
  glBindVertexArray(empty_.id());
  for (std::size_t pass = 0; pass < 2; ++pass) {
    const glm::vec2 direction = pass == 0 ? glm::vec2(1, 0) : glm::vec2(0, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, shadowTargets_[1 - pass].id());
    glBindTextureUnit(0, shadowTextures_[pass].id());
    blurProgram_.set("sigmaX", wide * direction);
    blurProgram_.set("sigmaY", narrow * direction);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

void GroundDrawer::drawBackground(const Frame& frame) const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  const BackdropStyle& style = backdropStyle(frame.settings.look.backdrop);
  const GlProgram& program = isChosen(frame) ? chosenBackground_ : backgroundProgram_;
  program.use();
  program.set("aspect", static_cast<float>(frame.view.size.x) / static_cast<float>(frame.view.size.y));
  program.set("kind", static_cast<int>(style.kind));
  program.set("low", style.low);
  program.set("high", style.high);
  program.set("square", 10.0f * frame.settings.lineScale);
  glBindVertexArray(empty_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GroundDrawer::drawGround(const Frame& frame) const {
  drawFloor(frame);
  drawShadow(frame);
}

bool GroundDrawer::copyKept(const RenderTarget& target, const Frame& frame, std::span<const glm::vec4> boxes) {
  const std::optional<glm::ivec4> sunk = sunkPixels(frame);
  if (!sunk || !frame.settings.background) return false;
  sunk_ = *sunk;
  KeptLook look{frame.view, frame.settings, frame.groundCenter};
  keptAnew_ = look != keptLook_;
  if (keptAnew_) {
    keptLook_ = std::move(look);
    kept_.resize(frame.view.size, 1);
    kept_.begin();
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    drawBackground(frame);
    if (frame.settings.ground) drawFloor(frame);
    kept_.end();
  }
  const glm::vec4 whole(0.0f, 0.0f, 1.0f, 1.0f);
  for (const glm::vec4& box : keptAnew_ || boxes.empty() ? std::span(&whole, 1) : boxes) {
    const glm::vec2 size(frame.view.size);
    const glm::ivec2 low(glm::floor(size * glm::vec2(box.x, 1.0f - box.w)));
    const glm::ivec2 high(glm::min(glm::ceil(size * glm::vec2(box.z, 1.0f - box.y)), size));
    glBlitNamedFramebuffer(kept_.framebuffer(), target.framebuffer(), low.x, low.y, high.x, high.y, low.x, low.y,
                           high.x, high.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  return true;
}

void GroundDrawer::drawSunkOverKept(const Frame& frame) const {
  within(sunk_, [&] { drawBackground(frame); });
}

void GroundDrawer::drawGroundOverKept(const Frame& frame) const {
  within(sunk_, [&] { drawFloor(frame); });
  drawShadow(frame);
}

void GroundDrawer::blendQuad() const {
  glBindVertexArray(empty_.id());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  blendPremultiplied();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void GroundDrawer::drawFloor(const Frame& frame) const {
  const glm::vec3& center = frame.groundCenter;
  const GridZoom zoom = gridZoom(frame.view, center, frame.height);
  const BackdropStyle& style = backdropStyle(frame.settings.look.backdrop);
  const GlProgram& program = isChosen(frame) ? chosenGround_ : groundProgram_;
  program.use();
  program.set("ground", glm::vec4(center.x, center.z, kGroundReach * zoom.reach * frame.height, zoom.cell));
  program.set("zoom", glm::vec2(zoom.reach, zoom.towardsNext));
  program.set("grid", glm::vec3(style.pool, style.lineTone, style.lines));
  program.set("lineScale", frame.settings.lineScale);
  blendQuad();
}

void GroundDrawer::drawShadow(const Frame& frame) const {
  if (frame.surfaceBounds.isEmpty()) return;
  groundShadowProgram_.use();
  groundShadowProgram_.set("area", area_);
  groundShadowProgram_.set("shadow", 0);
  glBindTextureUnit(0, shadowTextures_[0].id());
  blendQuad();
}

}  // namespace sinew::app
