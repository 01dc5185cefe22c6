// tests/viewport/tools/gizmo_draw_test.cpp: handles are drawn where they can be hit. No window: ImGui only fills lists.

#include "app/viewport/tools/draw_tools.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <glm/geometric.hpp>

#include "tests/viewport/tools/random_gizmo.h"

namespace sinew::app {
namespace {

using test::GizmoScene;

constexpr ImU32 kNoAlpha = ~static_cast<ImU32>(IM_COL32_A_MASK);
constexpr ImU32 kHover = IM_COL32(255, 214, 64, 255) & kNoAlpha;

class GizmoDraw : public ::testing::Test {
 protected:
  void SetUp() override {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1600, 1000};
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    ImGui::NewFrame();
  }
  void TearDown() override {
    ImGui::EndFrame();
    ImGui::DestroyContext();
  }
  static ImDrawList& drawn(const GizmoState& state, const GizmoLayout& layout, const GizmoContext& context) {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    drawGizmo(list, state, layout, context, kTopLeft, kUnitsPerPixel);
    return list;
  }
  static int countOf(const ImDrawList& list, ImU32 color) {
    return static_cast<int>(std::ranges::count_if(list.VtxBuffer, [&](const ImDrawVert& v) {
      return (v.col & kNoAlpha) == color && (v.col & IM_COL32_A_MASK) != 0;
    }));
  }
  static constexpr glm::vec2 kTopLeft{100, 50};
  static constexpr float kUnitsPerPixel = 0.5f;
};

TEST_F(GizmoDraw, EveryHandleIsDrawnAtItsPixel) {
  const GizmoScene scene = test::plainGizmo();
  for (const GizmoMode mode : {GizmoMode::kPoles, GizmoMode::kMove, GizmoMode::kRotate, GizmoMode::kScale}) {
    GizmoState state;
    state.mode = mode;
    const GizmoLayout layout = layoutGizmo(state, scene.placement, scene.context);
    const ImDrawList& list = drawn(state, layout, scene.context);
    for (const HandleShape& shape : layout.handles) {
      const glm::vec2 at = kTopLeft + kUnitsPerPixel * shape.anchor;
      float nearest = 1e9f;
      for (const ImDrawVert& v : list.VtxBuffer) {
        nearest = std::min(nearest, glm::length(glm::vec2(v.pos.x, v.pos.y) - at));
      }
      EXPECT_LT(nearest, 9.0f) << nameOf(shape.handle);
    }
    EXPECT_EQ(countOf(list, kHover), 0);
  }
}

TEST_F(GizmoDraw, HoveredHandleIsHighlighted) {
  const GizmoScene scene = test::plainGizmo();
  GizmoState state;
  state.hovered = GizmoHandle::kMoveY;
  const GizmoLayout layout = layoutGizmo(state, scene.placement, scene.context);
  const ImDrawList& list = drawn(state, layout, scene.context);
  EXPECT_GT(countOf(list, kHover), 3);
  // Only along its arrow.
  const HandleShape* arrow = layout.find(GizmoHandle::kMoveY);
  ASSERT_NE(arrow, nullptr);
  for (const ImDrawVert& v : list.VtxBuffer) {
    if ((v.col & kNoAlpha) != kHover) continue;
    const glm::vec2 pixel = (glm::vec2(v.pos.x, v.pos.y) - kTopLeft) / kUnitsPerPixel;
    const glm::vec2 low = glm::min(arrow->outline[0], arrow->outline[1]) - 12.0f;
    const glm::vec2 high = glm::max(arrow->outline[0], arrow->outline[1]) + 12.0f;
    EXPECT_TRUE(pixel.x > low.x && pixel.y > low.y && pixel.x < high.x && pixel.y < high.y);
  }
}

TEST_F(GizmoDraw, DragsDrawGuidesAndNothingOnAFlatBone) {
  for (const GizmoHandle handle : {GizmoHandle::kMoveX, GizmoHandle::kMoveYZ, GizmoHandle::kRotateY,
                                   GizmoHandle::kScaleZ, GizmoHandle::kPolePlusX}) {
    GizmoScene scene = test::plainGizmo();
    GizmoState state;
    const GizmoLayout layout = layoutGizmo(state, scene.placement, scene.context);
    const int resting = drawn(state, layout, scene.context).VtxBuffer.Size;
    beginDrag(state, handle, scene.placement, {700, 380}, scene.context);
    static_cast<void>(updateDrag(state, test::pointerAt({760, 350}), scene.context));
    EXPECT_FALSE(state.drag->value.empty());
    const GizmoLayout during = layoutGizmo(state, state.drag->current, scene.context);
    EXPECT_GT(drawn(state, during, scene.context).VtxBuffer.Size, resting + 40) << nameOf(handle);
    const int before = ImGui::GetForegroundDrawList()->VtxBuffer.Size;
    drawn(state, GizmoLayout{}, scene.context);
    EXPECT_EQ(ImGui::GetForegroundDrawList()->VtxBuffer.Size, before);
  }
}

}  // namespace
}  // namespace sinew::app
