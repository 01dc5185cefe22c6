// tests/viewport/tools/add_muscle_on_bone_test.cpp: a muscle around a bone is never a disc.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/document/document.h"
#include "app/viewport/tools/add_muscle.h"
#include "tests/support/characters/characters.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/viewport/tools/limb_scene.h"

namespace sinew::app {
namespace {

TEST(AddMuscleOnBone, SurroundsTheMiddleOfTheBone) {
  test::LimbScene scene;
  const Result<std::string> name = addMuscleOnBone(scene.document, 1);
  ASSERT_TRUE(name.ok());
  EXPECT_EQ(scene.document.activeName(), name.value());
  EXPECT_EQ(scene.document.commands.stepCount(), 1u);
  const Bone& bone = scene.document.character->skeleton.bones[1];
  const Primitive& muscle = scene.document.rig().primitives[0];
  EXPECT_LT(glm::length(muscle.placement.center - 0.5f * bone.tip), 1e-4f);
  const glm::mat4 shape = shapeInWorld(muscle.placement, 1.0f, bone.bindInWorld);
  const glm::vec3 along = glm::normalize(glm::mat3(bone.bindInWorld) * bone.tip);
  EXPECT_GT(std::abs(glm::dot(glm::normalize(glm::vec3(shape[0])), along)), 0.999f);
}

TEST(AddMuscleOnBone, NamedShapesLieAlongTheBone) {
  for (const ShapePreset preset :
       {ShapePreset::kCapsule, ShapePreset::kCylinder, ShapePreset::kEgg, ShapePreset::kCone, ShapePreset::kSpindle}) {
    test::LimbScene scene;
    ASSERT_TRUE(addMuscleOnBone(scene.document, 1, preset).ok());
    const Bone& bone = scene.document.character->skeleton.bones[1];
    const Primitive& muscle = scene.document.rig().primitives[0];
    EXPECT_FALSE(muscle.placement.shape.isPlain()) << nameOf(preset);
    const glm::mat4 shape = shapeInWorld(muscle.placement, 1.0f, bone.bindInWorld);
    const glm::vec3 along = glm::normalize(glm::mat3(bone.bindInWorld) * bone.tip);
    EXPECT_GT(std::abs(glm::dot(glm::normalize(glm::vec3(shape[1])), along)), 0.999f);
    EXPECT_GT(glm::determinant(shape), 0.0f);
  }
}

/// Adds a muscle on every bone and measures it in the bind pose.
void expectNoDiscs(const std::shared_ptr<const Character>& character, const std::string& file) {
  Document document;
  document.character = character;
  for (std::size_t i = 0; i < character->skeleton.bones.size(); ++i) {
    const Bone& bone = character->skeleton.bones[i];
    const Result<std::string> name = addMuscleOnBone(document, static_cast<int>(i));
    if (!name) continue;  // Scaled to zero.
    const Primitive& muscle = document.rig().primitives.back();
    const glm::mat3 shape(shapeInWorld(muscle.placement, 1.0f, bone.bindInWorld));
    const float along = glm::length(shape[0]);
    const float across = std::max(glm::length(shape[1]), glm::length(shape[2]));
    const glm::vec3 segment = glm::mat3(bone.bindInWorld) * bone.tip;
    if (glm::length(segment) > 0.0f) {
      EXPECT_GT(std::abs(glm::dot(shape[0] / along, glm::normalize(segment))), 0.999f) << file << " " << bone.name;
      EXPECT_GE(along, 1.2f * across) << file << " " << bone.name;
    } else {
      EXPECT_NEAR(along, across, 1e-3f * along) << file << " " << bone.name;
    }
  }
}

TEST(AddMuscleOnBone, IsLongerThanThickOnEveryBoneOfTheBundledCharacters) {
  for (const char* file : {"humanoid.glb", "horse.glb", "demo.glb"}) {
    const Result<Document> document = openDocument(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / file);
    ASSERT_TRUE(document.ok()) << file;
    expectNoDiscs(document->character, file);
  }
}

TEST(AddMuscleOnBone, IsLongerThanThickOnEveryBoneOfRealCharacters) {
  int seen = 0;
  for (const char* file : {"Fox.glb", "cesium_man.gltf", "greenman.glb", "robot.glb", "rigged_simple.gltf"}) {
    const std::optional<std::filesystem::path> path = test::characterFile(file);
    if (!path) continue;
    const Result<Document> document = openDocument(*path);
    ASSERT_TRUE(document.ok()) << file;
    expectNoDiscs(document->character, file);
    ++seen;
  }
  if (seen == 0) SINEW_SKIP_WITHOUT_CHARACTERS();
}

TEST(AddMuscleOnBone, IsABallOnABoneWithoutLength) {
  auto character = std::make_shared<Character>(*test::makeLimb());
  character->skeleton.bones[1].tip = glm::vec3(0.0f);
  expectNoDiscs(character, "limb");
}

}  // namespace
}  // namespace sinew::app
