// tests/document/command_stack_test.cpp: undo, redo and gestures compared with a naive model.

#include "app/document/command_stack.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace sinew::app {
namespace {

Rig rigNumbered(int number) {
  Rig rig;
  rig.smoothing.depth = 1 + number;
  return rig;
}

int numberOf(const Rig& rig) { return rig.smoothing.depth - 1; }

/// Naive model of all that the stack guarantees.
struct Model {
  std::vector<int> states{0};
  std::size_t position = 0;
  int shown = 0;
  bool gesture = false;

  void end() {
    if (gesture && shown != states[position]) {
      states.resize(position + 1);
      states.push_back(shown);
      ++position;
    }
    gesture = false;
  }
  void cancel() {
    gesture = false;
    shown = states[position];
  }
};

TEST(CommandStack, FollowsANaiveModelUnderRandomOperations) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    CommandStack stack(rigNumbered(0));
    Model model;
    int saved = 0;
    for (int step = 0; step < 200; ++step) {
      const int value = static_cast<int>(random() % 4);
      switch (random() % 9) {
        case 0:
          stack.apply("apply", rigNumbered(value));
          model.end();
          model.shown = value;
          model.gesture = true;
          model.end();
          break;
        case 1:
          stack.beginGesture("gesture");
          model.end();
          model.gesture = true;
          break;
        case 2:
          if (model.gesture) {
            stack.updateGesture(rigNumbered(value));
            model.shown = value;
          }
          break;
        case 3:
          stack.endGesture();
          model.end();
          break;
        case 4:
          stack.cancelGesture();
          model.cancel();
          break;
        case 5:
          stack.undo();
          if (model.gesture) model.cancel();
          else if (model.position > 0) model.shown = model.states[--model.position];
          break;
        case 6:
          stack.redo();
          if (!model.gesture && model.position + 1 < model.states.size()) model.shown = model.states[++model.position];
          break;
        case 7:
          model.cancel();
          model.position = random() % model.states.size();
          model.shown = model.states[model.position];
          stack.jumpTo(model.position);
          break;
        default:
          stack.markSaved();
          saved = model.shown;
          break;
      }
      ASSERT_EQ(numberOf(stack.rig()), model.shown);
      ASSERT_EQ(stack.position(), model.position);
      ASSERT_EQ(stack.stepCount() + 1, model.states.size());
      ASSERT_EQ(stack.inGesture(), model.gesture);
      ASSERT_EQ(stack.modified(), model.shown != saved);
      ASSERT_EQ(stack.canUndo(), model.gesture || model.position > 0);
      ASSERT_EQ(stack.canRedo(), !model.gesture && model.position + 1 < model.states.size());
    }
  }
}

TEST(CommandStack, RevisionGrowsExactlyWhenTheRigChanges) {
  CommandStack stack(rigNumbered(0));
  std::size_t revision = stack.revision();
  const auto grew = [&] {
    const bool more = stack.revision() > revision;
    revision = stack.revision();
    return more;
  };
  stack.apply("same", rigNumbered(0));
  EXPECT_FALSE(grew());
  stack.apply("other", rigNumbered(1));
  EXPECT_TRUE(grew());
  stack.undo();
  EXPECT_TRUE(grew());
  stack.undo();
  EXPECT_FALSE(grew());
  stack.redo();
  EXPECT_TRUE(grew());
  stack.beginGesture("drag");
  EXPECT_FALSE(grew());
  stack.updateGesture(rigNumbered(2));
  EXPECT_TRUE(grew());
  stack.endGesture();
  EXPECT_FALSE(grew());
  stack.markSaved();
  EXPECT_FALSE(grew());
}

TEST(CommandStack, DragIsOneStepWithItsLabel) {
  CommandStack stack(rigNumbered(0));
  stack.beginGesture("Move thigh");
  for (int i = 1; i < 20; ++i) stack.updateGesture(rigNumbered(i));
  stack.endGesture();
  ASSERT_EQ(stack.stepCount(), 1u);
  EXPECT_EQ(stack.label(1), "Move thigh");
  EXPECT_EQ(stack.label(0), "Open");
  stack.undo();
  EXPECT_EQ(numberOf(stack.rig()), 0);
}

TEST(CommandStack, EditAfterUndoForgetsTheAbandonedBranch) {
  CommandStack stack(rigNumbered(0));
  stack.apply("a", rigNumbered(1));
  stack.apply("b", rigNumbered(2));
  stack.undo();
  stack.apply("c", rigNumbered(3));
  stack.redo();
  EXPECT_EQ(numberOf(stack.rig()), 3);
  EXPECT_EQ(stack.stepCount(), 2u);
  EXPECT_EQ(stack.label(2), "c");
}

TEST(CommandStack, CanceledDragKeepsTheRedoSteps) {
  CommandStack stack(rigNumbered(0));
  stack.apply("a", rigNumbered(1));
  stack.undo();
  stack.beginGesture("drag");
  stack.updateGesture(rigNumbered(5));
  stack.cancelGesture();
  ASSERT_TRUE(stack.canRedo());
  stack.redo();
  EXPECT_EQ(numberOf(stack.rig()), 1);
}

TEST(CommandStack, UndoingBackToTheSavedStateIsNotModified) {
  CommandStack stack(rigNumbered(0));
  stack.apply("a", rigNumbered(1));
  EXPECT_TRUE(stack.modified());
  stack.undo();
  EXPECT_FALSE(stack.modified());
  stack.apply("b", rigNumbered(2));
  stack.apply("back by hand", rigNumbered(0));
  EXPECT_FALSE(stack.modified());
}

TEST(CommandStack, RangesAreStepsWithoutChangingTheRig) {
  CommandStack stack(rigNumbered(0));
  stack.startFrom({}, {{{"", 0}, {1.0, 2.0}}});
  const KeptPlayRanges first = stack.ranges();
  stack.applyRanges("Play frames 30 to 45", {{{"", 0}, {1.0, 1.5}}});
  stack.apply("Depth", rigNumbered(1));
  EXPECT_EQ(stack.ranges().at({"", 0}).to, 1.5) << "an edit keeps them";
  const std::size_t revision = stack.revision();
  stack.applyRanges("Play the whole clip", {});
  stack.applyRanges("nothing changes", {});
  EXPECT_EQ(stack.stepCount(), 3u);
  EXPECT_EQ(stack.revision(), revision) << "the rig is as it was";
  stack.undo();
  EXPECT_EQ(stack.ranges().at({"", 0}).to, 1.5);
  stack.undo();
  stack.undo();
  EXPECT_EQ(stack.ranges(), first);
  EXPECT_FALSE(stack.modified());
}

TEST(CommandStack, DragCanBeNamedAtItsEnd) {
  CommandStack stack(rigNumbered(0));
  stack.beginGesture("Depth");
  stack.updateGesture(rigNumbered(4));
  EXPECT_EQ(numberOf(stack.rigOfStep()), 0);
  stack.endGesture("Depth 1 to 5");
  EXPECT_EQ(stack.label(1), "Depth 1 to 5");
  EXPECT_EQ(numberOf(stack.rigOfStep()), 4);
}

}  // namespace
}  // namespace sinew::app
