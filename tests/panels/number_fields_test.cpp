// tests/panels/number_fields_test.cpp: dragging and typing in number fields: double click types, Shift is precise, Ctrl
// snaps.

#include <cmath>

#include "tests/support/editor/drawn_text.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

class NumberFields : public HeadlessEditor {
 protected:
  static constexpr int kShift = 340;

  void dragHolding(const std::string& id, float by, int key) {
    const glm::vec2 from = center(id);
    queue.move(from);
    settle();
    if (key != 0) queue.key(key, true);
    settle();
    queue.button(0, true);
    for (int i = 1; i <= 10; ++i) {
      queue.move(from + glm::vec2(by * (static_cast<float>(i) / 10.0f), 0.0f));
      frame();
    }
    queue.button(0, false);
    settle();
    if (key != 0) queue.key(key, false);
    settle();
  }
  [[nodiscard]] float iso() const { return state.document.rig().surface.iso; }
};

TEST_F(NumberFields, DoubleClickStartsTypingInSliders) {
  for (const auto& [id, text] :
       {std::pair{"smoothing/tolerance", "0.25"}, std::pair{"surface/iso", "0.31"}, std::pair{"surface/grooves", "2.5"},
        std::pair{"surface/skin-blend", "4.5"}, std::pair{"smoothing/crease", "77"}}) {
    const std::size_t before = steps();
    doubleClick(id);
    press(kKeyA, true);
    type(text);
    press(kEnter);
    EXPECT_EQ(steps(), before + 1) << id;
  }
  EXPECT_FLOAT_EQ(state.document.rig().smoothing.tolerance, 0.0025f);
  EXPECT_FLOAT_EQ(iso(), 0.31f);
  EXPECT_FLOAT_EQ(state.document.rig().surface.grooves, 0.025f);
  EXPECT_FLOAT_EQ(state.document.rig().surface.skinBlend, 0.045f);
  EXPECT_FLOAT_EQ(state.document.rig().smoothing.creaseAngle, 77.0f);
}

TEST_F(NumberFields, ShiftIsPreciseAndCtrlStepsInSliders) {
  const float start = iso();
  dragHolding("surface/iso", 40.0f, 0);
  const float plain = iso() - start;
  ASSERT_GT(plain, 0.05f);
  state.document.commands.undo();
  dragHolding("surface/iso", 40.0f, kShift);
  EXPECT_NEAR(iso() - start, 0.1f * plain, 0.03f * plain);
  state.document.commands.undo();
  dragHolding("surface/iso", 40.0f, kLeftControl);
  EXPECT_NEAR(iso() / 0.05f, std::round(iso() / 0.05f), 1e-3f);
  EXPECT_NEAR(iso() - start, plain, 0.051f) << "what a step leaves over is not lost";
}

TEST_F(NumberFields, ShiftIsPreciseAndCtrlStepsInFields) {
  addOne();
  const float start = muscle().placement.center.x;
  dragHolding("inspector/center.x", 60.0f, 0);
  const float plain = muscle().placement.center.x - start;
  ASSERT_NE(plain, 0.0f);
  state.document.commands.undo();
  settle();
  dragHolding("inspector/center.x", 60.0f, kShift);
  EXPECT_NEAR((muscle().placement.center.x - start) / plain, 0.1f, 0.03f);
  state.document.commands.undo();
  settle();
  dragHolding("inspector/rotation.y", 100.0f, kLeftControl);
  const float degrees = state.open.euler.degrees.y;
  EXPECT_GT(std::abs(degrees), 10.0f);
  EXPECT_NEAR(degrees / 15.0f, std::round(degrees / 15.0f), 1e-3f);
}

TEST_F(NumberFields, CtrlClickStartsTyping) {
  queue.move(center("surface/iso"));
  settle();
  queue.key(kLeftControl, true);
  queue.button(0, true);
  queue.button(0, false);
  queue.key(kLeftControl, false);
  settle();
  press(kKeyA, true);
  type("0.4");
  press(kEnter);
  EXPECT_FLOAT_EQ(iso(), 0.4f);
}

TEST_F(NumberFields, NothingIsDrawnOverASlidersNumber) {
  // At all values, nothing drawn after the letters overlaps them.
  for (float value = 0.05f; value <= 0.9f; value += 0.05f) {
    SurfaceSettings settings = state.document.rig().surface;
    settings.iso = value;
    state.document.commands.apply("Tightness", setSurface(state.document.rig(), settings).value());
    frame();
    frame();
    ImGui::Render();
    const glm::vec4 box = widgets().rectangles().at("surface/iso");
    const ImDrawList* panel = nullptr;
    for (int l = 0; l < ImGui::GetDrawData()->CmdListsCount; ++l) {
      const ImDrawList* list = ImGui::GetDrawData()->CmdLists[l];
      if (list->_OwnerName != nullptr && std::string(list->_OwnerName) == "region-right") panel = list;
    }
    ASSERT_NE(panel, nullptr);
    // In drawing order: after the first letter within the slider, only letters lie within it.
    const float white = ImGui::GetIO().Fonts->TexUvWhitePixel.x;
    bool letters = false;
    for (const ImDrawVert& vertex : panel->VtxBuffer) {
      const bool within = vertex.pos.x > box.x + 1.0f && vertex.pos.x < box.x + box.z - 1.0f &&
                          vertex.pos.y > box.y + 1.0f && vertex.pos.y < box.y + box.w - 1.0f;
      if (!within) continue;
      if (vertex.uv.x != white) letters = true;
      EXPECT_TRUE(!letters || vertex.uv.x != white) << "something is drawn over the number at " << value;
    }
    EXPECT_TRUE(letters);
  }
}

class Arithmetic : public NumberFields {
 protected:
  void SetUp() override {
    NumberFields::SetUp();
    state.document.symmetry = false;
    addOne();
  }
  /// Waits, so that clicks count as two double clicks, not as four clicks.
  void wait() {
    ImGui::GetIO().DeltaTime = 1.0f;
    frame();
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
  }
  void enter(const std::string& id, const std::string& text, int last = kEnter) {
    wait();
    doubleClick(id);
    press(kKeyA, true);
    type(text);
    press(last);
  }
  [[nodiscard]] float reach() const { return muscle().reach; }
  [[nodiscard]] std::string said() const { return state.session.toast ? state.session.toast->text : ""; }
};

TEST_F(Arithmetic, FieldsAndSlidersEvaluateExpressions) {
  const std::size_t before = steps();
  enter("inspector/reach", "12/5");
  EXPECT_FLOAT_EQ(reach(), 2.4f);
  enter("inspector/reach", "+=0.1");
  EXPECT_FLOAT_EQ(reach(), 2.5f);
  enter("inspector/reach", "*=(1+1)/2");
  EXPECT_FLOAT_EQ(reach(), 2.5f);
  EXPECT_EQ(steps(), before + 2) << "nothing changed the last time";
  enter("inspector/rotation.y", "180/4");
  EXPECT_NEAR(state.open.euler.degrees.y, 45.0f, 1e-4f);
  enter("surface/iso", "0.2*1.5");
  EXPECT_FLOAT_EQ(iso(), 0.3f);
  enter("smoothing/tolerance", "0.1*2");
  EXPECT_FLOAT_EQ(state.document.rig().smoothing.tolerance, 0.002f);
  enter("timeline/speed", "1/2");
  EXPECT_FLOAT_EQ(state.open.transport.speed, 0.5f);
}

TEST_F(Arithmetic, ErrorsAreReportedAndChangeNothing) {
  const float start = reach();
  const std::size_t before = steps();
  for (const auto& [text, reason] : {std::pair{"12/", "a number is missing at the end"},
                                     std::pair{"2*(1+1", "\")\" is missing"}, std::pair{"3 apples", "is not known"}}) {
    state.session.toast.reset();
    enter("inspector/reach", text);
    EXPECT_EQ(reach(), start) << text;
    EXPECT_NE(said().find(reason), std::string::npos) << said();
    EXPECT_NE(said().find(text), std::string::npos) << said();
  }
  state.session.toast.reset();
  enter("surface/iso", "1/0");
  EXPECT_NE(said().find("division by zero"), std::string::npos) << said();
  state.session.toast.reset();
  enter("timeline/speed", "fast");
  EXPECT_NE(said().find("is not known"), std::string::npos) << said();
  EXPECT_EQ(state.open.transport.speed, 1.0f);
  EXPECT_EQ(steps(), before);
}

TEST_F(Arithmetic, EscapeAndUneditedTextKeepTheValueBitForBit) {
  Rig rig = state.document.rig();
  rig.primitives[0].reach = 2.3456789f;
  state.document.commands.apply("Reach", rig);
  settle();
  const std::size_t before = steps();
  enter("inspector/reach", "5*1", kEscape);
  EXPECT_EQ(reach(), 2.3456789f);
  wait();
  doubleClick("inspector/reach");
  press(kEnter);
  EXPECT_EQ(reach(), 2.3456789f);
  EXPECT_EQ(steps(), before);
}

TEST_F(Arithmetic, RelativeChangeAppliesOnceToAllMuscles) {
  addMuscle(state, 1);
  Rig rig = state.document.rig();
  rig.primitives[0].placement.radii.x = 0.1f;
  rig.primitives[1].placement.radii.x = 0.2f;
  state.document.commands.apply("Radii", rig);
  state.document.selection.setAll(std::array{state.document.idAt(0), state.document.idAt(1)});
  settle();
  enter("inspector/radius.x", "*=0.5");
  EXPECT_NEAR(state.document.rig().primitives[0].placement.radii.x, 0.05f, 1e-6f);
  EXPECT_NEAR(state.document.rig().primitives[1].placement.radii.x, 0.1f, 1e-6f);
  enter("inspector/radius.x", "0.07 +");
  EXPECT_NEAR(state.document.rig().primitives[0].placement.radii.x, 0.05f, 1e-6f);
  EXPECT_NEAR(state.document.rig().primitives[1].placement.radii.x, 0.1f, 1e-6f);
}

}  // namespace
}  // namespace sinew::app
