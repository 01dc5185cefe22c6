// tests/files/gltf_morph_test.cpp: morph targets of files: the resulting mesh, and clips that animate them.

#include <limits>

#include <gtest/gtest.h>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/characters/morphing_post.h"
#include "tests/support/characters/moved_base.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

std::vector<float> randomWeights(std::size_t count, Random& random) {
  std::vector<float> weights;
  for (std::size_t k = 0; k < count; ++k) weights.push_back(random.chance(0.4f) ? 0.0f : random.uniform(-0.6f, 1.6f));
  return weights;
}

/// Positions and normals of all corners match an import of the file with moved base positions.
void expectAsMovedBase(const std::filesystem::path& file, std::uint64_t seed) {
  const auto character = importGltf(file).value();
  ASSERT_FALSE(character->morphTargets.empty());
  Random random(seed);
  const std::vector<float> weights = randomWeights(character->morphTargets.size(), random);
  const TemporaryFolder folder;
  const auto moved = importGltf(folder.write("moved.glb", movedBase(file, weights)));
  ASSERT_TRUE(moved.ok()) << moved.error().text();
  MorphedMesh morphed;
  morph(*character, weights, morphed);
  const ControlMesh& expected = moved.value()->mesh;
  ASSERT_EQ(expected.triangles.size(), character->mesh.triangles.size());
  const std::vector<glm::vec3>& positions = morphed.isMorphed ? morphed.positions : character->mesh.positions;
  const std::vector<glm::vec3>& normals = morphed.isMorphed ? morphed.normals : character->mesh.normals;
  const float tolerance = 1e-6f * character->height;
  for (std::size_t t = 0; t < expected.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int was = expected.triangles[t].vertices[i];
      const int is = character->mesh.triangles[t].vertices[i];
      ASSERT_LE(glm::distance(at(positions, is), at(expected.positions, was)), tolerance);
      ASSERT_LE(glm::distance(at(normals, is), at(expected.normals, was)), 1e-4f);
    }
  }
}

class MorphForms : public ::testing::TestWithParam<DeltaForm> {};

TEST_P(MorphForms, MatchAMeshWithMovedBasePositions) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    expectAsMovedBase(folder.write("post.glb", makeMorphingPost(4, seed, GetParam()).file.glb()), seed + 100);
  }
}

TEST_P(MorphForms, PlayAsInTheFile) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    expectSkinsLikeTheFile(folder.write("post.glb", makeMorphingPost(3, seed, GetParam()).file.glb()));
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, MorphForms,
                         ::testing::Values(DeltaForm::kFloats, DeltaForm::kSparse, DeltaForm::kShorts));

TEST(GltfMorphs, RealFaceMatchesMovedBasePositions) {
  const auto file = characterFile("RobotExpressive.glb");
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  for (std::uint64_t seed = 0; seed < 5; ++seed) expectAsMovedBase(*file, seed);
}

TEST(GltfMorphs, StepAndCubicWeightsPlayAsInTheFile) {
  const TemporaryFolder folder;
  for (const bool cubic : {false, true}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Post post = makeMorphingPost(2, seed);
      Random random(seed + 50);
      std::vector<float> values;
      for (int i = 0; i < 4 * 2 * (cubic ? 3 : 1); ++i) values.push_back(random.uniform(-1.0f, 1.0f));
      setWeightKeys(post, {0.0f, 0.2f, 0.7f, 1.0f}, values, cubic ? "CUBICSPLINE" : "STEP");
      expectSkinsLikeTheFile(folder.write("post.glb", post.file.glb()));
    }
  }
}

TEST(GltfMorphs, NodeWeightsOverrideMeshWeights) {
  const TemporaryFolder folder;
  Post post = makeMorphingPost(2, 3);
  post.file.json["animations"][0]["channels"].erase(1);
  post.file.json["meshes"][0]["weights"] = {0.25, 0.5};
  const auto ofMesh = importGltf(folder.write("mesh.glb", post.file.glb())).value();
  EXPECT_EQ(ofMesh->morphTargets[1].weight, 0.5f);
  expectSkinsLikeTheFile(folder.path() / "mesh.glb");
  post.file.json["nodes"][0]["weights"] = {1.0, -0.75};
  const auto ofNode = importGltf(folder.write("node.glb", post.file.glb())).value();
  EXPECT_EQ(ofNode->morphTargets[1].weight, -0.75f);
  expectSkinsLikeTheFile(folder.path() / "node.glb");
}

TEST(GltfMorphs, NamesComeFromTheFileOrTheNode) {
  const TemporaryFolder folder;
  Post post = makeMorphingPost(3, 1);
  post.file.json["meshes"][0]["extras"]["targetNames"] = {"smile", 7};
  const auto character = importGltf(folder.write("post.glb", post.file.glb())).value();
  ASSERT_EQ(character->morphTargets.size(), 3U);
  EXPECT_EQ(character->morphTargets[0].name, "smile");
  EXPECT_EQ(character->morphTargets[1].name, "post.2");
  EXPECT_EQ(character->morphTargets[2].name, "post.3");
}

/// Normals keep their bits except next to moved vertices; positions everywhere.
TEST(GltfMorphs, UnmovedVerticesKeepTheirBits) {
  const TemporaryFolder folder;
  Post post = makeMorphingPost(0, 0);
  std::vector<float> deltas(post.positions.size(), 0.0f);
  for (std::size_t v = 0; v < deltas.size() / 3; ++v) {
    if (post.positions[3 * v + 1] > 1.5f) deltas[3 * v] = 0.3f;
  }
  post.primitive()["targets"].push_back({{"POSITION", post.file.accessor(deltas, "VEC3")}});
  const auto character = importGltf(folder.write("post.glb", post.file.glb())).value();
  const ControlMesh& mesh = character->mesh;
  MorphedMesh morphed;
  morph(*character, std::vector{1.0f}, morphed);
  std::vector<bool> beside(mesh.positions.size(), false);
  for (const ControlTriangle& triangle : mesh.triangles) {
    bool moved = false;
    for (const int v : triangle.vertices) moved = moved || at(mesh.positions, v).y > 1.5f;
    for (const int v : triangle.vertices) beside[toIndex(v)] = beside[toIndex(v)] || moved;
  }
  int still = 0;
  int turned = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    turned += morphed.normals[v] == mesh.normals[v] ? 0 : 1;
    if (mesh.positions[v].y < 1.5f) {
      EXPECT_TRUE(sameBits(morphed.positions[v], mesh.positions[v]));
    }
    if (beside[v]) continue;
    ++still;
    EXPECT_TRUE(sameBits(morphed.normals[v], mesh.normals[v]));
  }
  EXPECT_GT(still, 0);
  EXPECT_GT(turned, 0);
}

/// The result depends on the current weights only, whatever the memory held before.
TEST(GltfMorphs, ResultDoesNotDependOnPreviousWeights) {
  const TemporaryFolder folder;
  const auto character = importGltf(folder.write("post.glb", makeMorphingPost(3, 5).file.glb())).value();
  Random random(9);
  MorphedMesh kept;
  for (int i = 0; i < 40; ++i) {
    std::vector<float> weights = randomWeights(3, random);
    if (i % 5 == 0) weights.assign(3, 0.0f);
    MorphedMesh fresh;
    morph(*character, weights, kept);
    morph(*character, weights, fresh);
    ASSERT_EQ(kept.isMorphed, fresh.isMorphed);
    if (!kept.isMorphed) continue;
    EXPECT_TRUE(sameBytes(kept.positions, fresh.positions));
    EXPECT_TRUE(sameBytes(kept.normals, fresh.normals));
  }
}

/// Normals of a fan from its faces, weighted by angle, in double precision.
std::vector<glm::dvec3> fanNormals(const ControlMesh& sharp, const std::vector<glm::vec3>& positions) {
  std::vector<glm::dvec3> sums(3 * sharp.triangles.size(), glm::dvec3(0.0));
  for (const ControlTriangle& triangle : sharp.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int fan = at(sharp.wedges, triangle.wedges[i]).fan;
      const auto p = [&](std::size_t k) { return glm::dvec3(at(positions, triangle.vertices[(i + k) % 3])); };
      const glm::dvec3 a = glm::normalize(p(1) - p(0));
      const glm::dvec3 b = glm::normalize(p(2) - p(0));
      if (fan >= 0) at(sums, fan) += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(a, b));
    }
  }
  return sums;
}

TEST(GltfMorphs, CreasesRotateWithTheirFaces) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto character = importGltf(folder.write("post.glb", makeMorphingPost(3, seed).file.glb())).value();
    const ControlMesh sharp = creased(character->mesh, 20.0f);
    Pose pose = bindPose(character->skeleton);
    pose.morphWeights = {0.7f, -0.4f, 1.1f};
    SkinnedMesh skinned;
    skin(*character, pose, skinned);
    morphFans(sharp, skinned.morphed);
    std::vector<glm::vec3> normals;
    skinWedgeNormals(*character, sharp.wedges, skinned, normals);
    const std::vector<glm::dvec3> expected = fanNormals(sharp, skinned.positions);
    int compared = 0;
    for (std::size_t w = 0; w < sharp.wedges.size(); ++w) {
      if (!sharp.wedges[w].creased) continue;
      const glm::dvec3 own = glm::normalize(at(expected, sharp.wedges[w].fan));
      EXPECT_LT(glm::distance(glm::dvec3(normals[w]), own), 1e-5) << w;
      compared += glm::distance(normals[w], sharp.wedges[w].normal) > 0.01f ? 1 : 0;
    }
    EXPECT_GT(compared, 10) << "none has turned";
  }
}

class BadMorphs : public ::testing::Test {
 protected:
  Result<std::shared_ptr<const Character>> import() { return importGltf(folder_.write("post.glb", post_.file.glb())); }

  TemporaryFolder folder_;
  Post post_ = makeMorphingPost(2, 1);
};

TEST_F(BadMorphs, MismatchedCountsAreRefused) {
  post_.primitive()["targets"][0]["POSITION"] = post_.file.accessor(std::vector<float>(9, 0.5f), "VEC3");
  const auto imported = import();
  ASSERT_FALSE(imported.ok());
  EXPECT_NE(imported.error().reason.find("3 deltas for 12 positions"), std::string::npos) << imported.error().text();
}

TEST_F(BadMorphs, NonFiniteDeltasAreReported) {
  std::vector<float> deltas(36, 0.125f);
  deltas[4] = std::numeric_limits<float>::quiet_NaN();
  deltas[9] = 1e30f;
  post_.primitive()["targets"][0]["POSITION"] = post_.file.accessor(deltas, "VEC3");
  const auto imported = import();
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  EXPECT_EQ(imported.value()->morphTargets[0].vertices.size(), 10U);
  const std::string notes = imported.value()->ignored.at(0);
  EXPECT_NE(notes.find("not finite or too large: 0 is used there (2 times)"), std::string::npos) << notes;
}

/// Whatever the file contains, positions stay finite.
TEST_F(BadMorphs, HugeWeightsAreClamped) {
  post_.file.json["meshes"][0]["weights"] = {1e30, -1e30};
  setWeightKeys(post_, {0.0f, 1e-6f, 1.0f}, std::vector<float>(18, 1e15f), "CUBICSPLINE");
  const auto imported = import();
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& character = *imported.value();
  EXPECT_EQ(character.morphTargets[1].weight, -1000.0f);
  for (const float time : {0.0f, 5e-7f, 0.4f, 1.0f}) {
    const Pose pose = samplePose(character, character.clips.front(), time);
    for (const float weight : pose.morphWeights) EXPECT_LE(std::abs(weight), 1000.0f);
    SkinnedMesh skinned;
    skin(character, pose, skinned);
    EXPECT_TRUE(allFinite(skinned.positions));
    EXPECT_TRUE(allUnit(skinned.normals));
  }
}

TEST_F(BadMorphs, TooManyTargetsAreRefused) {
  for (int i = 0; i < 1023; ++i) post_.primitive()["targets"].push_back(ordered_json::object());
  const auto imported = import();
  ASSERT_FALSE(imported.ok());
  EXPECT_NE(imported.error().text().find("1,024 morph targets"), std::string::npos) << imported.error().text();
}

TEST_F(BadMorphs, MismatchedWeightKeysAreRefused) {
  setWeightKeys(post_, {0.0f, 1.0f}, {0.0f, 1.0f, 0.5f}, "LINEAR");
  const auto imported = import();
  ASSERT_FALSE(imported.ok());
  EXPECT_NE(imported.error().text().find("values for 2 keys"), std::string::npos) << imported.error().text();
}

TEST_F(BadMorphs, TargetsWithoutPositionsAndOddExtrasAreHarmless) {
  for (const ordered_json& extras : {ordered_json(5), ordered_json{{"targetNames", "a"}}, ordered_json{{"x", 1}}}) {
    post_.primitive()["targets"][0] = {{"NORMAL", post_.attributes()["POSITION"]}};
    post_.file.json["meshes"][0]["extras"] = extras;
    const auto imported = import();
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    EXPECT_TRUE(imported.value()->morphTargets.at(0).vertices.empty());
    EXPECT_FALSE(imported.value()->morphTargets.at(1).vertices.empty());
  }
  post_.primitive()["targets"][0] = {{"POSITION", 999}};
  EXPECT_FALSE(import().ok());
  post_.primitive()["targets"] = 7;
  EXPECT_FALSE(import().ok());
}

}  // namespace
}  // namespace sinew::test
