// tests/surface/cloth_test.cpp: muscles push the skin, cloth follows without sinking in, eyes stay.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/bodies/cloth_check.h"
#include "core/geometry/at.h"
#include "core/rig/mesh_layers.h"
#include "core/surface/preparation.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/smoother.h"
#include "tests/support/allocations.h"
#include "tests/support/characters/character_parts.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/sheets.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

const fs::path kClothAssets = fs::path(SINEW_SOURCE_DIR) / "assets";

/// The same mesh with and without muscles.
Rig flexRig() {
  Rig rig = loadRig(kClothAssets / "humanoid-flex.rig.json").value();
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = 3;
  return rig;
}

struct DressedSurface {
  std::shared_ptr<const Character> character = test::dressedHumanoid();
  MeshLayers layers = meshLayers(*character, guessLayers(*character));

  Surface smooth(const Rig& rig, const Pose& pose, bool bare = false) const {
    Smoother smoother(character);
    std::vector<int> all;
    for (std::size_t i = 0; bare && i < rig.primitives.size(); ++i) all.push_back(static_cast<int>(i));
    EXPECT_TRUE(smoother.prepare(rig, all).ok());
    Surface surface;
    smoother.smooth(pose, surface);
    return surface;
  }

  ClothMeter meter(const Rig& rig) const {
    return {character->mesh, layers, smooth(rig, bindPose(character->skeleton), true), character->height};
  }

  /// Calls visit(refined vertex) for the vertices of refined triangles of a part.
  template <class Visit>
  void forEachOf(const std::string& part, const Refinement& refinement, Visit visit) const {
    for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
      const int own = at(character->mesh.triangles, refinement.controlOf[i]).part;
      if (at(character->parts, own).name != part) continue;
      for (const int v : refinement.triangles[i]) visit(toIndex(v));
    }
  }
};

class ClothBySurfaceMode : public ::testing::TestWithParam<SurfaceMode> {};

TEST_P(ClothBySurfaceMode, ClothStaysAboveTheSkin) {
  const DressedSurface dressed;
  Rig rig = flexRig();
  rig.surface.mode = GetParam();
  const std::vector<Pose> poses = test::posesOfClips(*dressed.character, 8);
  const ClothCount count = countClothBelow(dressed.character, rig, poses).value();
  EXPECT_GT(count.vertices, 3000);
  EXPECT_LE(count.below, count.bare) << "deepest " << count.deepest << " H in pose " << count.worst;
  // Where two walls of a fold penetrate each other there may be no free position.
  EXPECT_LT(static_cast<double>(count.more), 2e-4 * count.vertices * static_cast<double>(poses.size()));
  // The measure detects penetration: clothes that follow no skin.
  for (const char* part : {"Shirt", "Trousers", "Hair"}) rig = setLayer(rig, part, SkinLayer::kRigid).value();
  const ClothMeter meter = dressed.meter(rig);
  const std::vector<ClothSunk> sunk = meter.below(dressed.smooth(rig, poses[2]));
  const std::vector<ClothSunk> bare = meter.below(dressed.smooth(rig, poses[2], true));
  int more = 0;
  for (std::size_t v = 0; v < sunk.size(); ++v) more += sunk[v].depth > 0.0f && bare[v].depth == 0.0f ? 1 : 0;
  EXPECT_GT(more, 5);
}

INSTANTIATE_TEST_SUITE_P(Modes, ClothBySurfaceMode, ::testing::Values(SurfaceMode::kSwell, SurfaceMode::kReplace),
                         [](const auto& mode) { return std::string(nameOf(mode.param)); });

TEST(Cloth, MovesWithTheSkinAndRigidPartsAreUnchanged) {
  const DressedSurface dressed;
  const Rig rig = flexRig();
  for (const Pose& pose : test::posesOfClips(*dressed.character, 2)) {
    const Surface bare = dressed.smooth(rig, pose, true);
    const Surface lifted = dressed.smooth(rig, pose);
    dressed.forEachOf("Eyes", *lifted.refinement, [&](std::size_t v) {
      EXPECT_EQ(lifted.positions[v], bare.positions[v]);
      EXPECT_EQ(lifted.normals[v], bare.normals[v]);
      EXPECT_EQ(lifted.displacement[v], 0.0f);
    });
    int moved = 0;
    dressed.forEachOf("Shirt", *lifted.refinement, [&](std::size_t v) {
      moved += lifted.positions[v] != bare.positions[v] ? 1 : 0;
      EXPECT_NEAR(glm::length(lifted.normals[v]), 1.0f, 1e-4f);
    });
    EXPECT_GT(moved, 500);
  }
}

/// A square of skin that faces +z, over a muscle, and the same of cloth `deep` below it.
Character skinOverCloth(float deep) {
  test::Sheet sheets = test::sheetOf(8, [](float, float) { return 0.0f; });
  const std::size_t half = sheets.triangles.size();
  const auto first = static_cast<int>(sheets.positions.size());
  for (const glm::vec3& p : std::vector(sheets.positions)) sheets.positions.emplace_back(p.x, p.y, -deep);
  for (const auto& [a, b, c] : std::vector(sheets.triangles)) {
    sheets.triangles.push_back({first + a, first + b, first + c});
  }
  Character character;
  character.mesh = test::meshOf(sheets.positions, sheets.triangles);
  for (std::size_t t = half; t < 2 * half; ++t) character.mesh.triangles[t].part = 1;
  character.parts = {{"Body", 0}, {"Lining", 0}};
  character.materials.emplace_back();
  test::addBone(character.skeleton, "bone", -1, glm::vec3(0.0f));
  finishBones(character.skeleton);
  character.height = 2.0f;
  return character;
}

TEST(Cloth, BelowTheSkinInTheFileKeepsItsDepth) {
  for (const float deep : {0.005f, 0.02f}) {
    const auto character = std::make_shared<const Character>(skinOverCloth(deep));
    Rig rig;
    rig.smoothing.depth = 2;
    rig.groups.push_back({"a", {}});
    rig.primitives.push_back(
        test::ellipsoidAt(*character, "muscle", "bone", "a", {0.0f, 0.0f, -0.2f}, {0.5f, 0.5f, 0.3f}));
    rig.layers = {{"Body", SkinLayer::kSkin}, {"Lining", SkinLayer::kCloth}};
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    Surface surface;
    smoother.smooth(bindPose(character->skeleton), surface);
    const auto& triangles = surface.refinement->triangles;
    const std::size_t half = triangles.size() / 2;
    float risen = 0.0f;
    for (std::size_t t = 0; t < half; ++t) {
      for (std::size_t c = 0; c < 3; ++c) {
        const glm::vec3& skin = at(surface.positions, triangles[t][c]);
        const glm::vec3& cloth = at(surface.positions, triangles[half + t][c]);
        EXPECT_LT(glm::distance(cloth, skin - glm::vec3(0.0f, 0.0f, deep)), 1e-5f) << skin.x << ' ' << skin.y;
        risen = std::max(risen, skin.z);
      }
    }
    EXPECT_GT(risen, 0.05f) << deep;
  }
}

TEST(Cloth, DoesNotChangeTheSkin) {
  const DressedSurface dressed;
  const auto naked = importGltf(kClothAssets / "humanoid.glb").value();
  const Rig rig = flexRig();
  Smoother smoother(naked);
  ASSERT_TRUE(smoother.prepare(rig).ok());
  for (const Pose& pose : test::posesOfClips(*dressed.character, 2)) {
    Surface expected;
    smoother.smooth(pose, expected);
    const Surface lifted = dressed.smooth(rig, pose);
    // The body comes first in the file; edges and triangles keep their order. The hair makes H, and with it the blend
    // width, 1 % larger.
    double sum = 0.0;
    ASSERT_EQ(dressed.character->mesh.triangles[0].part, 0);
    for (std::size_t t = 0; t < expected.refinement->triangles.size(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) {
        const glm::vec3& body = at(lifted.positions, lifted.refinement->triangles[t][c]);
        const float apart = glm::distance(body, at(expected.positions, expected.refinement->triangles[t][c]));
        ASSERT_LT(apart, 1e-4f * naked->height);
        sum += static_cast<double>(apart);
      }
    }
    EXPECT_LT(sum / (3.0 * static_cast<double>(expected.refinement->triangles.size())),
              5e-6 * static_cast<double>(naked->height));
  }
}

TEST(Cloth, AllSkinLayersMatchACharacterWithoutParts) {
  const auto dressed = test::dressedHumanoid();
  auto plain = std::make_shared<Character>(*dressed);
  plain->parts.clear();
  for (ControlTriangle& triangle : plain->mesh.triangles) triangle.part = 0;
  Rig rig = flexRig();
  Smoother one(plain);
  ASSERT_TRUE(one.prepare(rig).ok());
  for (const MeshPart& part : dressed->parts) rig = setLayer(rig, part.name, SkinLayer::kSkin).value();
  Smoother other(dressed);
  ASSERT_TRUE(other.prepare(rig).ok());
  Surface a;
  Surface b;
  const Pose pose = test::posesOfClips(*dressed, 3).back();
  one.smooth(pose, a);
  other.smooth(pose, b);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
}

TEST(Cloth, BundledRigsHaveNoLayers) {
  for (const char* name : {"humanoid", "humanoid-flex", "humanoid-wrapped", "horse", "horse-flex", "horse-wrapped",
                           "demo", "tangle", "wrapped"}) {
    const fs::path file = kClothAssets / (std::string(name) + ".rig.json");
    const Rig rig = loadRig(file).value();
    BlendingGraphMemo graphs;
    const auto tables = characterTables(importGltf(characterPath(rig, file)).value());
    const auto prepared = prepare(tables, rig, {}, nullptr, graphs);
    ASSERT_TRUE(prepared.ok()) << name;
    EXPECT_EQ(prepared.value()->layered, nullptr) << name << ": every stage is as before parts were known";
    EXPECT_EQ(prepared.value()->cloth, nullptr) << name;
  }
}

TEST(Cloth, LayerEditMatchesAFreshSmoother) {
  const auto dressed = test::dressedHumanoid();
  const Pose pose = test::posesOfClips(*dressed, 3).back();
  for (const DetailKind detail : {DetailKind::kUniform, DetailKind::kAdaptive}) {
    Rig rig = flexRig();
    rig.smoothing.detail = detail;
    rig.smoothing.tolerance = 0.003f;
    Smoother edited(dressed);
    Surface a;
    Surface b;
    for (const SkinLayer layer : {SkinLayer::kCloth, SkinLayer::kRigid, SkinLayer::kSkin, SkinLayer::kCloth}) {
      rig = setLayer(rig, "Shirt", layer).value();
      ASSERT_TRUE(edited.prepare(rig).ok());
      edited.smooth(pose, a);
      Smoother fresh(dressed);
      ASSERT_TRUE(fresh.prepare(rig).ok());
      fresh.smooth(pose, b);
      ASSERT_EQ(a.positions, b.positions) << nameOf(detail) << ", " << nameOf(layer);
      ASSERT_EQ(a.normals, b.normals);
    }
  }
}

TEST(Cloth, DoesNotDependOnThreadsAndAFrameAllocatesNothing) {
  const auto dressed = test::dressedHumanoid();
  const std::vector<Pose> poses = test::posesOfClips(*dressed, 2);
  Smoother smoother(dressed);
  ASSERT_TRUE(smoother.prepare(flexRig()).ok());
  Surface many;
  Surface one;
  for (const Pose& pose : poses) {
    smoother.smooth(pose, many);
    const ThreadLimit limit(1);
    smoother.smooth(pose, one);
    EXPECT_EQ(many.positions, one.positions);
    EXPECT_EQ(many.normals, one.normals);
  }
  const ThreadLimit limit(1);
  const std::int64_t before = test::allocations();
  for (const Pose& pose : poses) smoother.smooth(pose, one);
  EXPECT_EQ(test::allocations(), before);
}

TEST(Cloth, AdaptiveDetailSplitsClothAsFinelyAsTheSkinUnderIt) {
  const DressedSurface dressed;
  Rig rig = flexRig();
  rig.smoothing.detail = DetailKind::kAdaptive;
  Rig stiff = rig;
  for (const char* part : {"Shirt", "Trousers", "Hair"}) stiff = setLayer(stiff, part, SkinLayer::kRigid).value();
  const Pose pose = test::posesOfClips(*dressed.character, 3)[4];
  const auto triangles = [&](const Rig& of) {
    const Surface surface = dressed.smooth(of, pose);
    int count = 0;
    dressed.forEachOf("Shirt", *surface.refinement, [&](std::size_t) { ++count; });
    return count / 3;
  };
  EXPECT_GT(triangles(rig), triangles(stiff));
}

}  // namespace
}  // namespace sinew
