// tests/panels/muscle_set_test.cpp: Muscles > Add muscle set through its dialog: one step, adjusted by two sliders.
#include <algorithm>

#include "app/editor/actions.h"
#include "core/rig/validation.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class MuscleSetPanel : public HeadlessEditor {
 protected:
  void open(const char* file) {
    ASSERT_TRUE(openFile(state, fs::path(SINEW_SOURCE_DIR) / "assets" / file));
    state.open.transport.playing = false;
    settle();
  }
  void addSet() {
    run(action("muscles/add-set"), state);
    settle();
  }
  [[nodiscard]] float volume() const {
    float sum = 0.0f;
    for (const Primitive& each : state.document.rig().primitives) {
      const glm::vec3 r = each.placement.radii;
      sum += r.x * r.y * r.z;
    }
    return sum;
  }
};

TEST_F(MuscleSetPanel, AddingASetIsOneStep) {
  open("humanoid.glb");
  addSet();
  EXPECT_EQ(steps(), 1u);
  EXPECT_GT(state.document.rig().primitives.size(), 60u);
  EXPECT_TRUE(validate(state.document.rig()).ok());
  EXPECT_TRUE(shown("muscle-set/mass"));
  click("muscle-set/done");
  EXPECT_FALSE(shown("muscle-set/mass"));
  run(action("edit/undo"), state);
  settle();
  EXPECT_TRUE(state.document.rig().primitives.empty());
}

TEST_F(MuscleSetPanel, SlidersAmendTheSameStep) {
  open("humanoid.glb");
  addSet();
  const float before = volume();
  drag("muscle-set/mass", {60.0f, 0.0f});
  EXPECT_GT(state.open.muscleSet.tuning.mass, 1.1f);
  EXPECT_GT(volume(), 1.1f * before);
  EXPECT_EQ(state.document.commands.stepCount(), 1u);
  drag("muscle-set/definition", {40.0f, 0.0f});
  EXPECT_GT(state.open.muscleSet.tuning.definition.value(), 0.36f);
  EXPECT_EQ(state.document.commands.stepCount(), 1u);
  EXPECT_FALSE(state.document.commands.inGesture());
  run(action("edit/undo"), state);
  settle();
  EXPECT_TRUE(state.document.rig().primitives.empty());
  EXPECT_FALSE(shown("muscle-set/mass"));
}

TEST_F(MuscleSetPanel, EscapeRestoresTheValueBeforeTheDrag) {
  open("humanoid.glb");
  addSet();
  const Rig before = state.document.rig();
  queue.move(center("muscle-set/mass"));
  settle();
  queue.button(0, true);
  queue.move(center("muscle-set/mass") + glm::vec2(50.0f, 0.0f));
  settle();
  EXPECT_NE(state.document.rig(), before);
  press(kEscape);
  queue.button(0, false);
  settle();
  EXPECT_EQ(state.document.rig(), before);
  EXPECT_FLOAT_EQ(state.open.muscleSet.tuning.mass, 1.0f);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(MuscleSetPanel, ExistingMusclesAreKept) {
  open("humanoid.rig.json");
  const Rig before = state.document.rig();
  addSet();
  drag("muscle-set/mass", {-40.0f, 0.0f});
  ASSERT_GT(state.document.rig().primitives.size(), before.primitives.size());
  EXPECT_TRUE(std::equal(before.primitives.begin(), before.primitives.end(), state.document.rig().primitives.begin()));
  click("muscle-set/remove");
  EXPECT_EQ(state.document.rig(), before);
}

TEST_F(MuscleSetPanel, AnotherEditClosesThePanel) {
  open("horse.glb");
  addSet();
  ASSERT_TRUE(shown("muscle-set/summary"));
  addMuscle(state, 0);
  settle();
  EXPECT_FALSE(shown("muscle-set/summary"));
  EXPECT_EQ(steps(), 2u);
}

TEST_F(MuscleSetPanel, UnknownBodyIsRefused) {
  open("tangle.glb");
  addSet();
  EXPECT_EQ(steps(), 0u);
  EXPECT_FALSE(shown("muscle-set/summary"));
  ASSERT_TRUE(state.session.toast.has_value());
  EXPECT_TRUE(state.session.toast->refusal) << state.session.toast->text;
}

}  // namespace
}  // namespace sinew::app
