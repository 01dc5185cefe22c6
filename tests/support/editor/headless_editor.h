// tests/support/editor/headless_editor.h: the panels without window and OpenGL, driven by simulated input.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "app/editor/actions.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/open_file.h"
#include "app/editor/visibility_commands.h"
#include "app/ui/imgui_layer.h"
#include "app/ui/style.h"
#include "app/viewport/tools/viewport_tools.h"
#include "app/window/editor_step.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {

/// Panels over the bundled character, 1280x800, paused.
class HeadlessEditor : public testing::Test {
 protected:
  void SetUp() override {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1280.0f, 800.0f};
    io.DeltaTime = 1.0f / 60.0f;
    mapKeys();
    applyStyle(1.0f);
    ImFont* font = io.Fonts->AddFontDefault();
    fonts = {font, font, font};
    io.Fonts->Build();
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb"));
    state.open.transport.playing = false;
    state.session.program = SINEW_PROGRAM;  // Program that draws pictures; by default the tests would run themselves.
    frame();
    frame();
  }
  void TearDown() override { ImGui::DestroyContext(); }

  /// Draws one frame with the queued input.
  void frame() {
    const RawInput& input = queue.next();
    feedImGui(input);
    ImGui::NewFrame();
    step.run(state, input, fonts, 1.0 / 60.0);
    std::set<std::string_view> ids;
    for (const LaidOut& each : widgets().laidOut()) {
      if (each.visible.z < 3.0f || each.visible.w < 3.0f) continue;
      EXPECT_TRUE(ids.insert(each.id).second) << "named twice: " << each.id;
    }
    ImGui::EndFrame();
  }
  void settle() {
    while (queue.pending()) frame();
    frame();
    frame();
  }

  [[nodiscard]] const WidgetLog& widgets() const { return step.widgets(); }
  [[nodiscard]] bool shown(const std::string& id) const { return widgets().rectangles().contains(id); }
  [[nodiscard]] glm::vec2 center(const std::string& id) const {
    EXPECT_TRUE(shown(id)) << id;
    if (!shown(id)) return glm::vec2(-1.0f);
    const glm::vec4 box = widgets().rectangles().at(id);
    return {box.x + 0.5f * box.z, box.y + 0.5f * box.w};
  }
  void click(const std::string& id, int button = 0) {
    queue.move(center(id));
    settle();
    queue.button(button, true);
    queue.button(button, false);
    settle();
  }
  /// Clicks in the viewport. @param at  window coordinates
  void clickAt(const glm::vec2& at) {
    queue.move(at);
    settle();
    queue.button(0, true);
    queue.button(0, false);
    settle();
  }
  /// The middle of a bone in the picture, window coordinates.
  [[nodiscard]] glm::vec2 pixelOfBone(int bone) const {
    const auto index = static_cast<std::size_t>(bone);
    const glm::vec4 middle(0.5f * state.character().skeleton.bones[index].tip, 1.0f);
    const glm::vec3 pixel = state.frame.route.view.toPixel(glm::vec3(state.live->pose().boneInWorld[index] * middle));
    return glm::vec2(state.frame.viewport) + glm::vec2(pixel);
  }
  void doubleClick(const std::string& id) {
    queue.move(center(id));
    for (int i = 0; i < 2; ++i) {
      queue.button(0, true);
      queue.button(0, false);
    }
    settle();
  }
  void drag(const std::string& id, const glm::vec2& by) {
    const glm::vec2 from = center(id);
    queue.move(from);
    settle();
    queue.button(0, true);
    for (int i = 1; i <= 5; ++i) {
      queue.move(from + by * (static_cast<float>(i) / 5.0f));
      frame();
    }
    queue.button(0, false);
    settle();
  }
  void press(int key, bool control = false) {
    if (control) queue.key(kLeftControl, true);
    queue.key(key, true);
    queue.key(key, false);
    if (control) queue.key(kLeftControl, false);
    settle();
  }
  void type(const std::string& text) {
    for (const char c : text) queue.character(static_cast<char32_t>(c));
    settle();
  }
  /// Types a number into its field.
  void typeInto(const std::string& id, const std::string& text) {
    doubleClick(id);
    press(kKeyA, true);
    type(text);
    press(kEnter);
  }
  /// Adds a muscle on the first bone, selected.
  void addOne() {
    addMuscle(state, 0);
    ASSERT_EQ(state.document.activePrimitive(), 0);
    settle();
  }
  [[nodiscard]] const Primitive& muscle() const { return state.document.rig().primitives.at(0); }
  [[nodiscard]] Rig setPlacementOf(const Placement& placement) const {
    return setPlacement(state.document.rig(), 0, placement).value();
  }
  [[nodiscard]] std::size_t steps() const { return state.document.commands.position(); }

  static constexpr int kLeftControl = 341;
  static constexpr int kEscape = 256;
  static constexpr int kEnter = 257;
  static constexpr int kDelete = 261;
  static constexpr int kKeyA = 65;
  static constexpr int kKeyZ = 90;
  static constexpr int kSpace = 32;
  static constexpr int kF2 = 291;

  EditorState state;
  InputQueue queue;
  EditorStep step;
  Fonts fonts;
};

}  // namespace sinew::app
