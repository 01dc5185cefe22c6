// tests/document/symmetry_test.cpp: the command stack keeps twins in sync, and undo restores every edit byte for byte.

#include <gtest/gtest.h>

#include <vector>

#include "app/document/document.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/rig_edits.h"

namespace sinew::app {
namespace {

using test::Random;

Document legs() {
  Document document;
  document.character = test::makeTwoLegged();
  prepareMirror(document);
  return document;
}

Primitive muscle(Random& random, const Skeleton& skeleton) {
  Primitive primitive;
  primitive.bone = skeleton.fileName(random.below(static_cast<int>(skeleton.bones.size())));
  primitive.name = random.chance(0.5f) ? "muscle L" : "m" + std::to_string(random.below(8));
  primitive.placement = {{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)},
                         random.rotation(),
                         {random.uniform(0.05f, 1), random.uniform(0.05f, 1), random.uniform(0.05f, 1)}};
  return primitive;
}

Result<Rig> randomEdit(Random& random, const Document& document) {
  const Rig& rig = document.rig();
  const MirrorPlan& plan = *document.mirror;
  const auto count = static_cast<int>(rig.primitives.size());
  const Primitive fresh = muscle(random, document.character->skeleton);
  if (count == 0) return addPair(rig, fresh, plan);
  const int index = random.below(count);
  const std::vector<int> some{index, random.below(count)};
  switch (random.below(13)) {
    case 0:
      return addPair(rig, fresh, plan);
    case 1:
      return addPrimitive(rig, fresh);
    case 2:
      return setPlacement(rig, index, fresh.placement);
    case 3:
      return test::setBone(rig, index, fresh.bone, fresh.placement);
    case 4:
      return test::setReach(rig, index, random.uniform(1.1f, 3));
    case 5:
      return test::setSign(rig, index, random.chance(0.5f) ? 1 : -1);
    case 6:
      return removePrimitives(rig, withTwins(rig, std::span(some).first(1)));
    case 7:
      return duplicatePairs(rig, withTwins(rig, some));
    case 8:
      return mirrorToOtherSide(rig, index, plan);
    case 9:
      return clearMirror(rig, index);
    case 10:
      return renameWithTwin(rig, index, fresh.name + " " + std::to_string(random.below(99)));
    case 11:
      return flipPrimitives(rig, some, plan);
    default:
      return test::setTerritory(rig, index, std::vector<std::string>{fresh.bone});
  }
}

TEST(SymmetricEdits, TwoHundredEditsUndoAndRedoByteForByte) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Document document = legs();
    Random random(seed);
    std::vector<std::string> states{rigToJson(document.rig())};
    while (states.size() <= 200) {
      const std::size_t steps = document.commands.position();
      if (random.chance(0.3f)) {
        // A drag: several states, one step.
        document.commands.beginGesture("Drag");
        for (int i = 0; i < 3; ++i) {
          if (Result<Rig> edited = randomEdit(random, document)) document.commands.updateGesture(edited.value());
        }
        document.commands.endGesture();
      } else if (Result<Rig> edited = randomEdit(random, document)) {
        document.commands.apply("Edit", edited.value());
      }
      if (document.commands.position() == steps) continue;
      ASSERT_TRUE(validate(document.rig())) << validate(document.rig()).error().text();
      states.push_back(rigToJson(document.rig()));
    }
    for (std::size_t i = states.size() - 1; i-- > 0;) {
      document.commands.undo();
      ASSERT_EQ(rigToJson(document.rig()), states[i]);
    }
    EXPECT_FALSE(document.commands.canUndo());
    for (std::size_t i = 1; i < states.size(); ++i) {
      document.commands.redo();
      ASSERT_EQ(rigToJson(document.rig()), states[i]);
    }
    EXPECT_FALSE(document.commands.canRedo());
  }
}

TEST(SymmetricEdits, TwinFollowsInTheSameStepUntilUnlinked) {
  Document document = legs();
  Random random(4);
  Primitive thigh = muscle(random, document.character->skeleton);
  thigh.name = "thigh L";
  thigh.bone = "leg L";
  document.commands.apply("Add", addPair(document.rig(), thigh, *document.mirror).value());
  document.commands.apply("Reach", test::setReach(document.rig(), 1, 2.0f).value());
  EXPECT_EQ(document.rig().primitives[0].reach, 2.0f);
  EXPECT_EQ(document.commands.stepCount(), 2u);
  document.commands.apply("Unlink", clearMirror(document.rig(), 0));
  document.commands.apply("Reach", test::setReach(document.rig(), 1, 3.0f).value());
  EXPECT_EQ(document.rig().primitives[0].reach, 2.0f);
}

}  // namespace
}  // namespace sinew::app
