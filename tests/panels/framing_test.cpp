// tests/panels/framing_test.cpp: framing fits its target into the part of the viewport that no panel covers.

#include <filesystem>
#include <string>
#include <tuple>

#include "app/editor/edit.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

/// Muscles on lines, so that the flex slider covers part of the viewport too.
class Framing : public HeadlessEditor {
 protected:
  void use(float width, float height, float scale) {
    ImGui::GetIO().DisplaySize = {width, height};
    applyStyle(scale);
    state.frame.uiScale = scale;
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid-flex.rig.json"));
    state.open.transport.playing = false;
    settle();
  }
  /// Bounds of the character in the picture, window coordinates: low x and y, high x and y.
  [[nodiscard]] glm::vec4 body() const {
    glm::vec2 low(1e9f), high(-1e9f);
    for (const glm::vec3& point : state.live->surface().positions) {
      const glm::vec2 pixel = glm::vec2(state.frame.viewport) + glm::vec2(state.frame.route.view.toPixel(point));
      low = glm::min(low, pixel);
      high = glm::max(high, pixel);
    }
    return {low, high};
  }
  /// @param least  fraction of the picture's height
  void expectClear(const std::string& what, float least = 0.45f) const {
    const glm::vec4 at = body();
    const glm::vec4& v = state.frame.viewport;
    EXPECT_TRUE(at.x >= v.x && at.y >= v.y && at.z <= v.x + v.z && at.w <= v.y + v.w) << what;
    int over = 0;
    for (const auto& [id, box] : widgets().rectangles()) {
      const std::string panel = id.substr(0, id.find('/'));
      const bool inPicture = panel == "toolstrip" || panel == "display" || panel == "overlay" || panel == "messages" ||
                             panel == "legend" || id == "view/flex-slider" || id.ends_with("/banner");
      if (!inPicture) continue;
      ++over;
      EXPECT_FALSE(at.x < box.x + box.z && box.x < at.z && at.y < box.y + box.w && box.y < at.w) << what << ": " << id;
    }
    EXPECT_GT(over, 10) << what;
    EXPECT_GT((at.w - at.y) / v.w, least) << what << ": it is small";
  }
};

TEST_F(Framing, OpenedCharacterIsFramedClearOfToolsAndBars) {
  for (const auto& [width, height, scale] : {std::tuple{1280.0f, 800.0f, 1.0f}, std::tuple{900.0f, 600.0f, 1.0f},
                                             std::tuple{2560.0f, 1440.0f, 1.0f}, std::tuple{1920.0f, 1200.0f, 1.5f}}) {
    use(width, height, scale);
    expectClear(std::to_string(static_cast<int>(width)) + " wide");
  }
}

TEST_F(Framing, FrameAllAvoidsPanelsOpenedLater) {
  use(1280.0f, 800.0f, 1.0f);
  state.view.layout.overlay = true;
  state.view.display.shading = Shading::kHeat;
  addMessage(state.session, MessageKind::kNote, "Something to read");
  settle();
  run(action("view/frame-all"), state);
  for (int i = 0; i < 40; ++i) frame();
  ASSERT_FALSE(isMoving(state.view.tools.camera));
  expectClear("with numbers, a legend and messages", 0.25f);
}

TEST_F(Framing, OrbitKeepsTheFramedTargetInPlace) {
  use(1280.0f, 800.0f, 1.0f);
  const glm::vec3 target = state.view.tools.camera.stand.target;
  const glm::vec3 before = state.frame.route.view.toPixel(target);
  orbit(state.view.tools.camera, {220.0f, 30.0f}, state.frame.viewportPixels);
  settle();
  const glm::vec3 after = state.frame.route.view.toPixel(target);
  EXPECT_NEAR(after.x, before.x, 0.1f);
  EXPECT_NEAR(after.y, before.y, 0.1f);
}

}  // namespace
}  // namespace sinew::app
