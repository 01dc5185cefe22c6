// tests/viewport/tools/limb_scene.h: a document with a smoothed surface in front of a camera.
#pragma once

#include "app/viewport/tools/input_router.h"
#include "sinew/rig/rig_edit.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {

/// The limb (H = 2, along +Y) in its bind pose, seen from the front, without muscles.
struct LimbScene {
  app::Document document;
  Pose pose;
  Surface surface;
  app::ViewportTools tools;
  app::DisplaySettings display;
  static constexpr glm::ivec2 kSize{1000, 800};

  explicit LimbScene(std::shared_ptr<const Character> character = makeLimb()) {
    document.character = std::move(character);
    pose = bindPose(document.character->skeleton);
    smooth();
    const Bounds box = boundsOf(document.character->mesh.positions);
    app::setScene(tools.camera, box, document.character->height);
    tools.camera.stand.yaw = 0.2f;
    tools.camera.stand.pitch = 0.1f;
    app::frameBounds(tools.camera, box, kSize, false);
  }

  void smooth() {
    Smoother smoother(document.character);
    if (smoother.prepare(document.rig())) smoother.smooth(pose, surface);
  }
  /// A pixel on the skin near the middle of the body.
  [[nodiscard]] glm::vec2 skinPixel() const {
    const Bounds box = boundsOf(surface.positions);
    return glm::round(glm::vec2(app::viewOf(tools.camera, kSize).toPixel(box.center())));
  }
  [[nodiscard]] app::ViewportContext context() { return {document, pose, &surface, display, kSize, 1.0f}; }
  app::RouteResult frame(const app::ViewportInput& input) { return app::routeInput(tools, input, context()); }

  static app::ViewportInput at(const glm::vec2& pixel) {
    app::ViewportInput input;
    input.mouse = pixel;
    input.deltaSeconds = 0.016f;
    return input;
  }
  app::RouteResult move(const glm::vec2& pixel) { return frame(at(pixel)); }
  app::RouteResult press(const glm::vec2& pixel, app::MouseButton button = app::MouseButton::kLeft,
                         app::ViewportInput with = {}) {
    with.mouse = pixel;
    with.buttons[static_cast<std::size_t>(button)] = {true, true, false, false};
    return frame(with);
  }
  app::RouteResult drag(const glm::vec2& pixel, app::MouseButton button = app::MouseButton::kLeft,
                        app::ViewportInput with = {}) {
    with.mouse = pixel;
    with.buttons[static_cast<std::size_t>(button)].down = true;
    return frame(with);
  }
  app::RouteResult release(const glm::vec2& pixel, app::MouseButton button = app::MouseButton::kLeft,
                           app::ViewportInput with = {}) {
    with.mouse = pixel;
    with.buttons[static_cast<std::size_t>(button)].released = true;
    return frame(with);
  }
  app::RouteResult click(const glm::vec2& pixel, app::ViewportInput with = {}) {
    move(pixel);
    press(pixel, app::MouseButton::kLeft, with);
    return release(pixel, app::MouseButton::kLeft, with);
  }
};

inline bool sameStand(const app::CameraStand& a, const app::CameraStand& b) {
  return a.target == b.target && a.distance == b.distance && a.yaw == b.yaw && a.pitch == b.pitch && a.aim == b.aim;
}

}  // namespace sinew::test
