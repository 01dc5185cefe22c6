// tests/rig/mirror_test.cpp: mirror plane, bone pairs, and mirrored placements on real and pathological skeletons.

#include "core/rig/mirror.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>

#include <glm/gtc/matrix_transform.hpp>

#include "sinew/files/gltf_import.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

using test::Random;

/// Extent of an ellipsoid along a unit direction, from the world's origin. Two convex bodies whose support functions
/// differ by at most e lie within e of each other.
double support(const Placement& inBone, const glm::mat4& boneInWorld, const glm::dvec3& direction) {
  const glm::dmat4 bone(boneInWorld);
  const glm::dmat3 axes = glm::dmat3(bone) * glm::mat3_cast(glm::normalize(glm::dquat(inBone.rotation)));
  const glm::dvec3 center(bone * glm::dvec4(glm::dvec3(inBone.center), 1.0));
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double part = glm::dot(axes[i], direction) * static_cast<double>(inBone.radii[i]);
    sum += part * part;
  }
  return glm::dot(center, direction) + std::sqrt(sum);
}

glm::dvec3 randomDirection(Random& random) {
  while (true) {
    const glm::dvec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (const double length = glm::length(v); length > 0.1 && length < 1.0) return v / length;
  }
}

/// A placement of world size radii around the bone; `height` is H.
Placement randomPlacement(Random& random, const glm::mat4& boneInWorld, float height) {
  const float scale = std::cbrt(std::abs(glm::determinant(glm::mat3(boneInWorld))));
  Placement placement;
  placement.center =
      0.2f * height / scale * glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  placement.rotation = random.rotation();
  placement.radii =
      height / scale * glm::vec3(random.uniform(0.02f, 0.2f), random.uniform(0.02f, 0.2f), random.uniform(0.02f, 0.2f));
  return placement;
}

/// @param canonical  the placement itself is reproduced, not only the ellipsoid
void expectMirrored(const MirrorPlan& plan, Random& random, int bone, bool canonical = true) {
  const auto from = static_cast<std::size_t>(bone);
  const auto to = static_cast<std::size_t>(plan.twinOf[from]);
  const glm::mat4& bind = plan.skeleton.bones[from].bindInWorld;
  const Placement original = randomPlacement(random, bind, plan.characterHeight);
  const Placement image = imageOf(original, *plan.mirrors[from]);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 d = randomDirection(random);
    // Reflecting a body reflects its support: h'(d) = h(S d) + a term for the plane's offset.
    const glm::dvec3 turned = d - 2.0 * glm::dot(d, plan.plane.normal) * plan.plane.normal;
    const double expected = support(original, bind, turned) + 2.0 * plan.plane.offset * glm::dot(d, plan.plane.normal);
    EXPECT_NEAR(support(image, plan.skeleton.bones[to].bindInWorld, d), expected,
                1e-6 * static_cast<double>(plan.characterHeight))
        << plan.skeleton.bones[from].name;
  }
  // And back.
  const Placement back = imageOf(image, *plan.mirrors[to]);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 d = randomDirection(random);
    EXPECT_NEAR(support(back, bind, d), support(original, bind, d), 1e-6 * static_cast<double>(plan.characterHeight));
  }
  if (!canonical) return;
  for (int i = 0; i < 3; ++i) {
    const float reach = std::max(1.0f, glm::length(original.center) / glm::length(original.radii));
    EXPECT_NEAR(back.center[i], original.center[i], 2e-6f * reach * glm::length(original.radii));
    EXPECT_NEAR(back.radii[i], original.radii[i], 2e-6f * original.radii[i]);
    EXPECT_NEAR(back.rotation[i], original.rotation[i], 2e-5f) << plan.skeleton.bones[from].name;
  }
  EXPECT_NEAR(back.rotation.w, original.rotation.w, 2e-5f);
}

void expectSoundPlan(const MirrorPlan& plan) {
  for (std::size_t i = 0; i < plan.twinOf.size(); ++i) {
    const int twin = plan.twinOf[i];
    EXPECT_EQ(twin >= 0, plan.mirrors[i].has_value());
    EXPECT_EQ(twin >= 0, plan.pairedBy[i] != PairedBy::kNothing);
    if (twin < 0) continue;
    EXPECT_EQ(plan.twinOf[static_cast<std::size_t>(twin)], static_cast<int>(i));
  }
  Random random(7);
  for (int bone = 0; bone < static_cast<int>(plan.twinOf.size()); ++bone) {
    if (plan.twinOf[static_cast<std::size_t>(bone)] < 0) continue;
    for (int turn = 0; turn < 5; ++turn) expectMirrored(plan, random, bone);
  }
}

void print(const std::string& name, const MirrorPlan& plan) {
  const auto by = [&](PairedBy how) { return std::ranges::count(plan.pairedBy, how); };
  std::cout << name << ": plane (" << plan.plane.normal.x << ", " << plan.plane.normal.y << ", " << plan.plane.normal.z
            << ") " << plan.plane.offset << ", " << plan.twinOf.size() << " bones, " << plan.pairCount() << " pairs ("
            << by(PairedBy::kName) / 2 << " by name, " << by(PairedBy::kPlace) / 2 << " by place), "
            << plan.centerCount() << " center, " << by(PairedBy::kNothing) << " alone\n";
  for (std::size_t i = 0; i < plan.twinOf.size(); ++i) {
    if (plan.twinOf[i] < 0) std::cout << "  alone: " << plan.skeleton.bones[i].name << '\n';
  }
}

struct Expected {
  const char* file;
  glm::dvec3 normal;
  int pairs;
  int centers;
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.file; }

class MirrorOnCharacters : public testing::TestWithParam<Expected> {};

TEST_P(MirrorOnCharacters, ArePairedAndMirrored) {
  const auto character = test::realCharacter(GetParam().file);
  if (!character) SINEW_SKIP_WITHOUT_CHARACTERS();
  const MirrorPlan plan = makeMirrorPlan(*character);
  print(GetParam().file, plan);
  EXPECT_NEAR(std::abs(glm::dot(plan.plane.normal, GetParam().normal)), 1.0, 0.01);
  EXPECT_EQ(plan.pairCount(), GetParam().pairs);
  EXPECT_EQ(plan.centerCount(), GetParam().centers);
  expectSoundPlan(plan);
}

INSTANTIATE_TEST_SUITE_P(Mirror, MirrorOnCharacters,
                         testing::Values(Expected{"Fox.glb", {1, 0, 0}, 7, 10},
                                         Expected{"greenman.glb", {1, 0, 0}, 4, 4},
                                         Expected{"cesium_man.gltf", {0, 0, 1}, 7, 5},
                                         Expected{"robot.glb", {1, 0, 0}, 18, 7}));

TEST(Mirror, BundledLizardIsFullyPaired) {
  const auto lizard = importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets/demo.glb");
  ASSERT_TRUE(lizard);
  const MirrorPlan plan = makeMirrorPlan(*lizard.value());
  print("demo.glb", plan);
  EXPECT_EQ(static_cast<int>(plan.twinOf.size()), 2 * plan.pairCount() + plan.centerCount());
  expectSoundPlan(plan);
}

// Pathological skeletons -------------------------------------------------------------------------------------------

struct Joint {
  const char* name;
  int parent;
  glm::vec3 at;
};

/// Bones with randomly rotated frames, as exporters write them.
Skeleton skeletonOf(const std::vector<Joint>& joints, bool turned = true) {
  Random random(3);
  Skeleton skeleton;
  for (const Joint& joint : joints) {
    Bone bone;
    bone.name = joint.name;
    bone.parent = joint.parent;
    bone.bindInWorld = glm::translate(glm::mat4(1.0f), joint.at);
    if (turned) bone.bindInWorld *= glm::mat4_cast(random.rotation());
    skeleton.bones.push_back(bone);
  }
  finishBones(skeleton);
  return skeleton;
}

std::string twinNameOf(const MirrorPlan& plan, int bone) {
  const int twin = plan.twinOf[static_cast<std::size_t>(bone)];
  return twin < 0 ? "" : plan.skeleton.bones[static_cast<std::size_t>(twin)].path;
}

TEST(Mirror, PairsIrregularNames) {
  const std::vector<Joint> joints = {{"Root", -1, {0, 0, 0}},
                                     {"b_LeftLeg01_015", 0, {1, 0, 0}},
                                     {"b_RightLeg01_019", 0, {-1, 0, 0}},
                                     {"ARM.L", 0, {2, 3, 0}},
                                     {"arm.r", 0, {-2, 3, 0}},
                                     {"Bright", 0, {0, 4, 0}},
                                     {"L", 3, {3, 3, 0}},
                                     {"R", 4, {-3, 3, 0}},
                                     {"finger_L_1", 6, {4, 3, 1}},
                                     {"finger_L_2", 6, {4, 3, 0}},
                                     {"finger_R_2", 7, {-4, 3, 0}},
                                     {"finger_R_1", 7, {-4, 3, 1}},
                                     {"LeftHand_R", 8, {5, 3, 1}},
                                     {"RightHand_R", 11, {-5, 3, 1}},
                                     {"claw", 12, {6, 3, 1}},
                                     {"claw", 13, {-6, 3, 1}},
                                     {"only_left", 0, {1, -3, 2}}};
  const MirrorPlan plan = pairBones(skeletonOf(joints), {}, 8.0f);
  expectSoundPlan(plan);
  const std::vector<int> expected = {0, 2, 1, 4, 3, 5, 7, 6, 11, 10, 9, 8, 13, 12, 15, 14, -1};
  EXPECT_EQ(plan.twinOf, expected);
  EXPECT_EQ(plan.pairedBy[1], PairedBy::kName);
  EXPECT_EQ(plan.pairedBy[0], PairedBy::kCenter);
}

TEST(Mirror, PairsUnnamedBonesByPositionAndHierarchy) {
  // Two bones in the same place on each side: only the tree distinguishes them.
  const std::vector<Joint> joints = {
      {"joint 0", -1, {0, 0, 0}}, {"joint 1", 0, {1, 0, 0}}, {"joint 2", 0, {-1, 0, 0}},
      {"joint 3", 2, {-2, 0, 0}}, {"joint 4", 1, {2, 0, 0}}, {"joint 5", 4, {2, 0, 0}},
      {"joint 6", 3, {-2, 0, 0}}, {"joint 7", 0, {0, 1, 0}}, {"joint 8", 7, {0.6f, 2, 0}}};
  const MirrorPlan plan = pairBones(skeletonOf(joints), {}, 4.0f);
  expectSoundPlan(plan);
  const std::vector<int> expected = {0, 2, 1, 4, 3, 6, 5, 7, -1};
  EXPECT_EQ(plan.twinOf, expected);
}

TEST(Mirror, NamedPairsMustBeOpposite) {
  const std::vector<Joint> joints = {{"root", -1, {0, 0, 0}},
                                     {"wing L", 0, {1, 0, 0}},
                                     {"wing R", 0, {-1, 9, 0}},
                                     {"foot L", 0, {1, 0, 3}},
                                     {"foot R", 0, {-1, 0, 3}}};
  const MirrorPlan plan = pairBones(skeletonOf(joints), {}, 10.0f);
  EXPECT_EQ(twinNameOf(plan, 1), "");
  EXPECT_EQ(twinNameOf(plan, 3), "root/foot R");
}

TEST(Mirror, NonuniformScaleAndShearAreExact) {
  Random random(11);
  std::vector<Joint> joints = {{"root", -1, {0, 0, 0}}, {"arm L", 0, {1, 1, 0}}, {"arm R", 0, {-1, 1, 0}}};
  Skeleton skeleton = skeletonOf(joints);
  for (Bone& bone : skeleton.bones) {
    bone.bindInWorld =
        bone.bindInWorld *
        glm::scale(glm::mat4(1.0f), {random.uniform(0.3f, 2), random.uniform(0.3f, 2), random.uniform(0.3f, 2)}) *
        glm::mat4_cast(random.rotation());
  }
  finishBones(skeleton);
  const MirrorPlan plan = pairBones(skeleton, {{1, 0, 0}, 0.0}, 2.0f);
  ASSERT_EQ(plan.pairCount(), 1);
  for (int i = 0; i < 200; ++i) expectMirrored(plan, random, 1 + i % 2, false);
}

TEST(Mirror, FlattenedBoneHasNoCounterpart) {
  Skeleton skeleton = skeletonOf({{"root", -1, {0, 0, 0}}, {"arm L", 0, {1, 1, 0}}, {"arm R", 0, {-1, 1, 0}}});
  skeleton.bones[2].bindInWorld[1] = glm::vec4(0.0f);
  const MirrorPlan plan = pairBones(skeleton, {}, 2.0f);
  EXPECT_EQ(plan.twinOf, (std::vector<int>{0, -1, -1}));
  EXPECT_FALSE(twinBone(plan, "arm L"));
  EXPECT_FALSE(twinBone(plan, "tail"));
}

/// Bitwise equal placements.
bool sameBits(const Placement& a, const Placement& b) { return std::memcmp(&a, &b, sizeof(Placement)) == 0; }

Placement mirroredPlacement(const Placement& inBone, const glm::mat4& bone, const glm::mat4& twin,
                            const MirrorPlane& plane) {
  return imageOf(inBone, boneMirror(bone, twin, plane).value());
}

TEST(Mirror, AxisMirroredFramesRoundTripBitForBit) {
  Random random(5);
  // Frames of twins as tools create them: both upright, or the twin's flipped along some or all of its axes.
  for (const glm::vec3 signs : {glm::vec3(1, 1, 1), glm::vec3(-1, 1, -1), glm::vec3(1, -1, -1), glm::vec3(-1, -1, 1)}) {
    const glm::mat4 bone = glm::translate(glm::mat4(1.0f), {0.25f, 1.0f, 0.125f});
    glm::mat4 twin = glm::translate(glm::mat4(1.0f), {-0.25f, 1.0f, 0.125f});
    for (int i = 0; i < 3; ++i) twin[i] *= signs[i];
    const MirrorPlane plane;
    for (int i = 0; i < 100; ++i) {
      Placement original = randomPlacement(random, bone, 1.0f);
      if (i % 3 == 0) original.radii = glm::vec3(0.1f);
      const Placement image = mirroredPlacement(original, bone, twin, plane);
      EXPECT_EQ(image.radii, original.radii);
      EXPECT_TRUE(sameBits(mirroredPlacement(image, twin, bone, plane), original));
    }
    // An unrotated placement comes back unrotated.
    const Placement straight{{0.1f, 0.2f, 0.3f}, glm::quat(1, 0, 0, 0), {0.1f, 0.2f, 0.3f}};
    EXPECT_GT(mirroredPlacement(straight, bone, twin, plane).rotation.w, 0.99f);
  }
}

TEST(Mirror, AsymmetricCharacterWithoutNamesHasNoPlane) {
  const auto limb = test::makeLimb();
  Character lopsided = *limb;
  Random random(2);
  for (glm::vec3& position : lopsided.mesh.positions) {
    position += 0.3f * limb->height * glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  }
  EXPECT_FALSE(makeMirrorPlan(lopsided).usable());
  EXPECT_TRUE(makeMirrorPlan(*limb).usable());
}

TEST(Mirror, SnapsToThePlaneAndDetectsWhatLiesInIt) {
  const auto legs = test::makeTwoLegged();
  const MirrorPlan plan = makeMirrorPlan(*legs);
  ASSERT_EQ(plan.pairCount(), 2);
  Primitive belly;
  belly.bone = "spine";
  belly.placement.radii = glm::vec3(0.1f, 0.2f, 0.15f) * legs->height;
  belly.placement.center.x = 0.008f * legs->height;
  belly.placement.rotation = glm::angleAxis(0.2f, glm::normalize(glm::vec3(0.3f, 1.0f, 0.2f)));
  EXPECT_FALSE(liesInPlane(plan, belly, 1e-4f));
  const std::optional<Placement> snapped = snappedToPlane(plan, belly, 0.01f);
  ASSERT_TRUE(snapped);
  belly.placement = *snapped;
  EXPECT_TRUE(liesInPlane(plan, belly, 1e-5f));
  // An asymmetric shape is not its own image until it is snapped.
  for (const Shape& shape : {Shape{0.3f, 0.2f, {}}, Shape{0.0f, 0.0f, {0.5f, 0.0f}}, Shape{0.4f, 0.1f, {0.2f, 0.5f}}}) {
    Primitive shaped = belly;
    shaped.placement.shape = shape;
    shaped.placement = *snappedToPlane(plan, shaped, 0.01f);
    EXPECT_TRUE(liesInPlane(plan, shaped, 1e-5f));
    shaped.placement.shape.bend.x = 0.4f;
    EXPECT_FALSE(liesInPlane(plan, shaped, 1e-4f));
  }
  belly.placement.center.x += 0.02f * legs->height;
  EXPECT_FALSE(snappedToPlane(plan, belly, 0.01f));
  belly.placement.center.x = 0.0f;
  belly.bone = "leg L";
  EXPECT_FALSE(snappedToPlane(plan, belly, 1.0f));
}

}  // namespace
}  // namespace sinew
