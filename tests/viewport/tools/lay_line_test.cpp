// tests/viewport/tools/lay_line_test.cpp: a line between two places on the skin, and its muscle.

#include "app/viewport/tools/line_tool.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "tests/support/characters/real_characters.h"
#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

/// The control triangle nearest to a point of the bind pose among those that mostly follow a bone.
SkinAnchor skinNear(const Character& character, const glm::vec3& point, int bone) {
  SkinAnchor best;
  float nearest = 1e30f;
  for (std::size_t t = 0; t < character.mesh.triangles.size(); ++t) {
    const SkinAnchor anchor{static_cast<int>(t), glm::vec3(1.0f / 3.0f), 0.0f};
    if (boneAt(character, anchor) != bone) continue;
    const glm::vec3 there = skinPointAt(character, bindPose(character.skeleton), anchor).point;
    if (glm::distance(there, point) >= nearest) continue;
    nearest = glm::distance(there, point);
    best = anchor;
  }
  return best;
}

int boneNamed(const Character& character, const char* name) { return character.skeleton.findBone(name).value(); }

struct LineLaying : testing::Test {
  std::shared_ptr<const Character> limb = test::makeLimb();
  Surface skin = bindSkin(*limb);

  [[nodiscard]] SkinAnchor on(const char* bone, const glm::vec3& near) const {
    return skinNear(*limb, near, boneNamed(*limb, bone));
  }
};

TEST_F(LineLaying, AnchorsLieBetweenSkinAndBonesAndTheBellyRises) {
  const auto laid = layLine(*limb, skin, on("root", {0.0f, 0.4f, 0.5f}), on("end", {0.0f, 1.6f, 0.5f}));
  ASSERT_TRUE(laid.ok()) << laid.error().text();
  EXPECT_EQ(laid->line.origin.bone, "root");
  EXPECT_EQ(laid->line.insertion.bone, "end");
  EXPECT_EQ(laid->belly.line, laid->line.name);
  // The limb's bones run along its middle: half the skin's distance from there.
  for (const LineAnchor* anchor : {&laid->line.origin, &laid->line.insertion}) {
    const glm::vec2 off(anchor->point.x, anchor->point.z);
    EXPECT_GT(glm::length(off), 0.05f);
    EXPECT_LT(glm::length(off), 0.25f);
  }
  const glm::mat4& bone = limb->skeleton.bones[static_cast<std::size_t>(boneNamed(*limb, "root"))].bindInWorld;
  const glm::mat4 shape = shapeInWorld(laid->belly.placement, 1.0f, bone);
  const float front = boundsOf(limb->mesh.positions).high.z;
  EXPECT_GT(shape[3].z + glm::length(glm::vec3(shape[2])), front) << "out of the skin";
  EXPECT_LT(shape[3].z + glm::length(glm::vec3(shape[2])), front + 0.1f);
  // Its long axis is y, along the line, from tendon to tendon.
  EXPECT_GT(glm::length(glm::vec3(shape[1])), glm::length(glm::vec3(shape[2])));
  const LineRest rest = lineRest(laid->line, *limb).value();
  EXPECT_GT(glm::dot(glm::normalize(glm::dvec3(shape[1])), rest.direction), 0.9999);
  const auto belly = static_cast<float>(rest.length) * (1.0f - 0.13f - 0.15f);
  EXPECT_NEAR(2.0f * glm::length(glm::vec3(shape[1])), belly, 1e-4f);
}

TEST_F(LineLaying, CoincidentEndsAreRefused) {
  const SkinAnchor from = on("root", {0.0f, 0.4f, 0.5f});
  EXPECT_FALSE(layLine(*limb, skin, from, from).ok());
}

TEST(LaidPairs, SymmetryLaysBothSides) {
  const std::shared_ptr<const Character> legs = test::makeTwoLegged();
  const MirrorPlan plan = makeMirrorPlan(*legs);
  const SkinAnchor from = skinNear(*legs, {0.4f, 0.6f, 0.5f}, boneNamed(*legs, "leg L"));
  const SkinAnchor to = skinNear(*legs, {0.4f, 0.1f, 0.5f}, boneNamed(*legs, "shin L"));
  const auto laid = layLine(*legs, bindSkin(*legs), from, to);
  ASSERT_TRUE(laid.ok()) << laid.error().text();
  const Result<Rig> rig = withLaidLine({}, laid.value(), &plan);
  ASSERT_TRUE(rig.ok()) << rig.error().text();
  EXPECT_TRUE(validate(rig.value()));
  ASSERT_EQ(rig->lines.size(), 2u);
  EXPECT_EQ(rig->lines[1].origin.bone, "leg R");
  EXPECT_EQ(twinOf(rig.value(), 0), 1);
  const Result<Rig> alone = withLaidLine({}, laid.value(), nullptr);
  ASSERT_TRUE(alone.ok());
  EXPECT_EQ(alone->lines.size(), 1u);
}

/// Across every joint of third-party characters: never an empty or huge belly.
TEST(LaidPairs, WorkAcrossEveryJointOfRealCharacters) {
  int joints = 0;
  for (const char* file : {"Fox.glb", "greenman.glb", "cesium_man.gltf", "robot.glb"}) {
    const std::shared_ptr<const Character> character = test::realCharacter(file);
    if (!character) continue;
    const Surface skin = bindSkin(*character);
    for (std::size_t b = 0; b < character->skeleton.bones.size(); ++b) {
      const Bone& bone = character->skeleton.bones[b];
      if (bone.parent < 0) continue;
      const auto middle = [&](const Bone& of) { return glm::vec3(of.bindInWorld * glm::vec4(0.5f * of.tip, 1.0f)); };
      const Bone& parent = character->skeleton.bones[static_cast<std::size_t>(bone.parent)];
      const SkinAnchor from = skinNear(*character, middle(parent), bone.parent);
      const SkinAnchor to = skinNear(*character, middle(bone), static_cast<int>(b));
      if (from.triangle < 0 || to.triangle < 0) continue;
      const auto laid = layLine(*character, skin, from, to);
      if (!laid) continue;
      ++joints;
      const glm::mat4 shape = shapeInWorld(laid->belly.placement, 1.0f, parent.bindInWorld);
      for (int axis = 0; axis < 3; ++axis) {
        const float half = glm::length(glm::vec3(shape[axis]));
        EXPECT_GT(half, 0.0005f * character->height) << file << ' ' << bone.name;
        EXPECT_LT(half, 0.5f * character->height) << file << ' ' << bone.name;
      }
      const Result<Rig> rig = withLaidLine({}, laid.value(), nullptr);
      EXPECT_TRUE(rig.ok() && validate(rig.value())) << file << ' ' << bone.name;
    }
  }
  if (joints == 0) GTEST_SKIP() << "left out: real characters are not at hand";
  EXPECT_GT(joints, 40);
}

// Their handles
// --------------------------------------------------------------------------------------------------------

struct LineHandleDrag : testing::Test {
  test::LimbScene scene;

  LineHandleDrag() {
    const Character& limb = *scene.document.character;
    const auto laid = layLine(limb, bindSkin(limb), skinNear(limb, {0.0f, 0.4f, 0.5f}, boneNamed(limb, "root")),
                              skinNear(limb, {0.0f, 1.6f, 0.5f}, boneNamed(limb, "end")));
    scene.document.commands.apply("Add", withLaidLine({}, laid.value(), nullptr).value());
    scene.document.selection.set(scene.document.idAt(0));
  }

  [[nodiscard]] glm::vec2 place(LineEnd end) {
    const auto line = activeLine(scene.document, scene.pose);
    const View view = viewOf(scene.tools.camera, test::LimbScene::kSize);
    return glm::vec2(view.toPixel(endPoint(*line, end).value()));
  }
};

TEST_F(LineHandleDrag, EndFollowsThePointerInAnyPose) {
  const Character& limb = *scene.document.character;
  scene.pose = samplePose(limb.skeleton, limb.clips.front(), 0.5f);
  scene.smooth();
  const glm::vec2 start = glm::round(place(LineEnd::kInsertion));
  scene.move(start);
  EXPECT_EQ(scene.tools.lineHandles.hovered, LineEnd::kInsertion);
  scene.press(start);
  scene.drag(start + glm::vec2(20.0f, 6.0f));
  scene.release(start + glm::vec2(20.0f, 6.0f));
  EXPECT_LT(glm::distance(place(LineEnd::kInsertion), start + glm::vec2(20.0f, 6.0f)), 1.5f);
  EXPECT_EQ(scene.document.commands.stepCount(), 2u);
  EXPECT_EQ(scene.document.rig().lines[0].insertion.bone, "end");
}

TEST_F(LineHandleDrag, EscapeRestoresTheRig) {
  const Rig before = scene.document.rig();
  const glm::vec2 start = glm::round(place(LineEnd::kOrigin));
  scene.move(start);
  scene.press(start);
  scene.drag(start + glm::vec2(20.0f, 0.0f));
  EXPECT_NE(scene.document.rig(), before);
  ViewportInput esc = test::LimbScene::at(start + glm::vec2(20.0f, 0.0f));
  esc.buttons[0].down = true;
  esc.keysPressed.push_back(Key::kEscape);
  scene.frame(esc);
  EXPECT_EQ(scene.document.rig(), before);
  EXPECT_FALSE(scene.tools.lineHandles.drag);
}

}  // namespace
}  // namespace sinew::app
