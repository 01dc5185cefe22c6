// tests/rig/renamed_twins_test.cpp: between two states of a rig, items are matched by identity, not by name.

#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "core/rig/line_edit.h"
#include "core/rig/references.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew {
namespace {

struct RenamedScene {
  std::shared_ptr<const Character> character = test::makeTwoLegged();
  MirrorPlan plan = makeMirrorPlan(*character);
  Rig rig;

  RenamedScene() {
    rig.groups = {{"legs", {}}, {"torso", {}}};
    Primitive thigh;
    thigh.name = "thigh L";
    thigh.bone = "leg L";
    thigh.group = "legs";
    thigh.placement.center = {0.1f, 0.2f, 0.05f};
    rig = addPair(rig, thigh, plan).value();
  }

  void edit(const Result<Rig>& edited) {
    ASSERT_TRUE(edited) << edited.error().text();
    rig = keepTwins(rig, rig, edited.value(), plan);
    ASSERT_TRUE(validate(rig));
  }
};

TEST(RenamedTwins, RenameDoesNotSyncOtherFields) {
  RenamedScene scene;
  scene.rig.primitives[1].group = "torso";  // They were never in one group.
  MuscleLine line;
  line.name = "calf";
  line.origin = {"leg L", {0.0f, -0.1f, 0.1f}, {}};
  line.insertion = {"shin L", {0.0f, -0.1f, 0.1f}, {}};
  scene.rig = addLine(scene.rig, line).value();
  Driver driver;
  driver.input.kind = DriverInputKind::kLength;
  driver.input.line = "calf";
  driver.curve.points = {{0.0f, 0.0f}, {1.0f, 0.1f}};
  scene.rig = setDriver(scene.rig, {Parameter::kReach, 0}, driver).value();  // Nor driven equally.
  IdentitySource().identify(scene.rig, Rig{});

  scene.edit(renameGroup(scene.rig, 0, "thighs"));
  EXPECT_EQ(scene.rig.primitives[0].group, "thighs");
  EXPECT_EQ(scene.rig.primitives[1].group, "torso");
  scene.edit(renameLine(scene.rig, 0, "soleus"));
  EXPECT_EQ(scene.rig.primitives[0].animated[0].drivers[0].input.line, "soleus");
  EXPECT_TRUE(scene.rig.primitives[1].animated.empty());
}

TEST(RenamedTwins, RenameWithAMoveIsFollowed) {
  RenamedScene scene;
  IdentitySource().identify(scene.rig, Rig{});
  Rig renamed = renamePrimitive(scene.rig, 0, "quad").value();
  renamed.primitives[1].name = "thigh L";  // The other one's former name.
  renamed.primitives[0].mirror = "thigh L";
  renamed.primitives[0].placement.center.y += 0.1f;
  scene.edit(renamed);
  EXPECT_EQ(scene.rig.primitives[0].name, "quad");
  const Result<Primitive> image = mirroredPrimitive(scene.plan, scene.rig.primitives[0]);
  EXPECT_LT(glm::length(image->placement.center - scene.rig.primitives[1].placement.center), 1e-5f);
}

}  // namespace
}  // namespace sinew
