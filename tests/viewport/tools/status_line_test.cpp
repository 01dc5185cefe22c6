// tests/viewport/tools/status_line_test.cpp: the status line has one form in every state of every tool
// (app/viewport/tools/status_line.h).

#include "app/viewport/tools/status_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "app/viewport/tools/viewport_tools.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

using test::LimbScene;

/// Inputs in the order in which a line may name them.
constexpr std::array<const char*, 19> kInputs{"Click", "Shift+click", "Right+click", "Release",  "Drop",
                                              "Drag",  "Ctrl+drag",   "Shift+drag",  "Alt+drag", "Right+drag",
                                              "Wheel", "Ctrl",        "Shift",       "Alt",      "X/Y/Z",
                                              "0-9",   "Enter",       "Esc",         ""};

/// The input's position in the order, or -1 if the text begins with none.
int rankOf(const std::string& act) {
  const std::string input = act.substr(0, act.find(' '));
  const auto found = std::ranges::find(kInputs, input);
  return input.empty() || found == kInputs.end() ? -1 : static_cast<int>(found - kInputs.begin());
}

/// "Click on an axis looks" -> its verb ends in s.
bool saysWhatItDoes(const std::string& act) {
  std::size_t at = act.find(' ');
  while (at != std::string::npos) {
    const std::size_t end = act.find(' ', at + 1);
    const std::string word = act.substr(at + 1, end == std::string::npos ? end : end - at - 1);
    if (word.size() > 2 && word.ends_with('s') && word != "axis" && word != "its") return true;
    at = end;
  }
  return false;
}

std::vector<std::string> split(const std::string& text, const std::string& between) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at = text.find(between); at != std::string::npos; at = text.find(between, from)) {
    parts.push_back(text.substr(from, at - from));
    from = at + between.size();
  }
  parts.push_back(text.substr(from));
  return parts;
}

void expectForm(const std::string& line, const std::string& where) {
  SCOPED_TRACE(where + ": " + line);
  const std::vector<std::string> halves = split(line, " \xc2\xb7 ");
  ASSERT_EQ(halves.size(), 2u);
  EXPECT_FALSE(halves[0].empty());
  EXPECT_EQ(rankOf(halves[0]), -1) << "the subject is no instruction";
  int last = 0;
  for (const std::string& act : split(halves[1], ", ")) {
    EXPECT_GE(rankOf(act), last) << act;
    EXPECT_TRUE(saysWhatItDoes(act)) << act;
    last = std::max(last, rankOf(act));
  }
  EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(line.back()))) << "no full stop";
}

/// A limb with one selected muscle.
struct Worked : LimbScene {
  Worked() {
    static_cast<void>(addMuscleOnBone(document, 1));
    smooth();
  }
};

TEST(StatusLine, JoinsSubjectAndActs) {
  EXPECT_EQ(statusLine("Box", {"Click adds", "Esc ends"}), "Box \xc2\xb7 Click adds, Esc ends");
  EXPECT_EQ(statusLine("Box", {}), "Box");
}

TEST(StatusLine, FormatCheckDetectsViolations) {
  EXPECT_EQ(rankOf("press here"), -1);
  EXPECT_FALSE(saysWhatItDoes("Click axis"));
  EXPECT_GT(rankOf("Esc ends"), rankOf("Drag orbits"));
}

TEST(StatusLine, IsWellFormedForEveryTool) {
  for (std::size_t tool = 0; tool < kToolCount; ++tool) {
    for (const bool selected : {true, false}) {
      for (const bool skeleton : {true, false}) {
        Worked scene;
        if (!selected) scene.document.selection.clear();
        scene.display.skeleton = skeleton;
        setTool(scene.tools, static_cast<ToolKind>(tool));
        const std::string where = tools()[tool]->label;
        expectForm(scene.move({5, 300}).status, where + " over nothing");
        expectForm(scene.move(scene.skinPixel()).status, where + " over the skin");
        expectForm(scene.press({5, 300}).status, where + " pressed over nothing");
        expectForm(scene.drag({60, 340}).status, where + " orbiting");
        scene.release({60, 340});
        expectForm(scene.press({5, 300}, MouseButton::kRight).status, where + " panning");
        scene.release({5, 300}, MouseButton::kRight);
        const glm::vec2 skin = scene.skinPixel();
        scene.move(skin);
        expectForm(scene.press(skin).status, where + " pressed on the skin");
        expectForm(scene.drag(skin + glm::vec2(9, 40)).status, where + " dragging on the skin");
      }
    }
  }
}

TEST(StatusLine, IsWellFormedForEveryHandle) {
  int handles = 0;
  for (std::size_t tool = 0; tool < kToolCount; ++tool) {
    Worked scene;
    setTool(scene.tools, static_cast<ToolKind>(tool));
    const GizmoLayout layout = scene.move({5, 300}).gizmo;
    if (!layout.visible) continue;
    for (const auto& [name, pixel] : layout.namedPixels()) {
      Worked own;
      setTool(own.tools, static_cast<ToolKind>(tool));
      own.move({5, 300});
      expectForm(own.move(pixel).status, name);
      if (own.tools.gizmo.hovered == GizmoHandle::kNone) continue;
      own.press(pixel);
      expectForm(own.drag(pixel + glm::vec2(14, 9)).status, name);
      EXPECT_TRUE(own.tools.gizmo.drag.has_value()) << name;
      ++handles;
    }
  }
  EXPECT_GT(handles, 12);
}

TEST(StatusLine, IsWellFormedForBoxAndTerritory) {
  Worked scene;
  armBox(scene.tools);
  expectForm(scene.move({5, 300}).status, "box armed");
  scene.press({5, 300});
  expectForm(scene.drag({100, 400}).status, "box");
  scene.release({100, 400});
  scene.tools.territoryMode = true;
  static_cast<void>(addMuscleOnBone(scene.document, 1));
  expectForm(scene.move({5, 300}).status, "territory over nothing");
  expectForm(scene.move(scene.skinPixel()).status, "territory over the skin");
}

TEST(StatusLine, IsWellFormedForTheAxisTriad) {
  AxisTriad triad;
  EXPECT_EQ(describe(triad), "");
  triad.ballHovered = true;
  expectForm(describe(triad), "ball");
  for (const AxisEnd end :
       {AxisEnd::kX, AxisEnd::kMinusX, AxisEnd::kY, AxisEnd::kMinusY, AxisEnd::kZ, AxisEnd::kMinusZ}) {
    triad.hovered = end;
    expectForm(describe(triad), "end");
  }
  triad.turning = true;
  expectForm(describe(triad), "turning");
}

}  // namespace
}  // namespace sinew::app
