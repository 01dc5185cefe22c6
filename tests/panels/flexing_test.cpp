// tests/panels/flexing_test.cpp: a muscle drawn across a joint: at rest as drawn, fully active while its key is held.
#include <glm/common.hpp>

#include "app/viewport/tools/line_handles.h"
#include "tests/support/editor/headless_editor.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sinew::app {
namespace {

class Flexing : public HeadlessEditor {
 protected:
  [[nodiscard]] glm::vec2 on(const char* bone) const {
    return pixelOfBone(state.character().skeleton.findBone(bone).value());
  }
  [[nodiscard]] ShownLine line() const {
    const auto active = activeLine(state.document, state.live->pose());
    EXPECT_TRUE(active);
    return active.value_or(ShownLine{});
  }
};

TEST_F(Flexing, MuscleDrawnAcrossAJointFlexesWhileTheKeyIsHeld) {
  chooseClip(state.open.transport, -1, state.character());
  run(action("tool/muscle-line"), state);
  settle();
  const glm::vec2 from = on("thigh.L");
  const glm::vec2 to = on("shin.L");
  queue.move(from);
  settle();
  queue.button(0, true);
  for (const float share : {0.3f, 0.6f, 1.0f}) {
    queue.move(glm::mix(from, to, share));
    settle();
  }
  EXPECT_EQ(state.frame.route.status.find("From thigh.L to shin.L"), 0u) << state.frame.route.status;
  queue.button(0, false);
  settle();
  EXPECT_EQ(steps(), 1u);
  ASSERT_EQ(state.document.rig().lines.size(), 2u) << "and its twin";
  EXPECT_EQ(state.document.rig().lines[0].origin.bone, "thigh.L");
  EXPECT_EQ(state.document.rig().lines[0].insertion.bone, "shin.L");
  EXPECT_NEAR(line().stretch, 1.0f, 1e-4f) << "at rest in the bind pose";
  EXPECT_EQ(line().activation, 0.0f);
  for (const bool held : {true, false}) {
    queue.key(GLFW_KEY_LEFT_SHIFT, held);
    queue.key(GLFW_KEY_F, held);
    settle();
    EXPECT_EQ(line().activation, held ? 1.0f : 0.0f);
  }
  EXPECT_EQ(steps(), 1u);
}

}  // namespace
}  // namespace sinew::app
