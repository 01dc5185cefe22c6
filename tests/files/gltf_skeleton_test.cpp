// tests/files/gltf_skeleton_test.cpp: skeletons, binds and clips with the peculiarities of real files.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/geometry/weld.h"
#include "sinew/character/pose.h"
#include "sinew/files/gltf_import.h"
#include "tests/files/mentions.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

using nlohmann::ordered_json;
using test::makePost;
using test::mentions;
using test::Post;

class GltfSkeleton : public testing::Test {
 protected:
  std::shared_ptr<const Character> import(const Post& post, bool compare = true) {
    const auto file = folder_.write("post.glb", post.file.glb());
    if (compare) test::expectSkinsLikeTheFile(file);
    const auto imported = importGltf(file);
    if (!imported) {
      ADD_FAILURE() << imported.error().text();
      return std::make_shared<Character>();
    }
    return imported.value();
  }

  static void setInverseBinds(Post& post, const std::vector<float>& matrices) {
    post.file.json["skins"][0]["inverseBindMatrices"] = post.file.accessor(matrices, "MAT4");
  }

  test::TemporaryFolder folder_;
};

glm::vec3 extentOf(const Character& character) { return boundsOf(character.mesh.positions).extent(); }

void expectBindPoseIsTheMesh(const Character& character) {
  SkinnedMesh skinned;
  skin(character, bindPose(character.skeleton), skinned);
  for (std::size_t v = 0; v < skinned.positions.size(); ++v) {
    EXPECT_LE(glm::distance(skinned.positions[v], character.mesh.positions[v]), 1e-5f * character.height) << v;
  }
}

/// Two rigid matrices in column order: the identity, and one that moves y = `height` to the origin.
std::vector<float> uprightBinds(float height) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -height, 0, 1};
}

TEST_F(GltfSkeleton, RootMayRotateZUpToYUp) {
  Post post = makePost();
  for (std::size_t v = 0; v < 12; ++v) std::swap(post.positions[3 * v + 1], post.positions[3 * v + 2]);
  post.attributes()["POSITION"] = post.file.accessor(post.positions, "VEC3");
  setInverseBinds(post,
                  {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1});
  post.file.json["nodes"][2]["translation"] = {0, 0, 1};
  const double half = std::sqrt(0.5);
  post.file.json["nodes"].push_back({{"name", "upright"}, {"rotation", {-half, 0, 0, half}}, {"children", {1}}});
  post.file.json["scenes"][0]["nodes"] = {0, 3};
  const auto character = import(post);
  EXPECT_LE(glm::distance(extentOf(*character), glm::vec3(1, 2, 1)), 1e-5f);
  EXPECT_EQ(character->skeleton.nodes.size(), 3u);
  EXPECT_EQ(character->skeleton.bones.size(), 2u);
  expectBindPoseIsTheMesh(*character);
}

TEST_F(GltfSkeleton, RootMayBeScaled) {
  Post post = makePost();
  post.file.json["nodes"].push_back({{"scale", {100, 100, 100}}, {"children", {1}}});
  post.file.json["scenes"][0]["nodes"] = {0, 3};
  const auto character = import(post);
  EXPECT_NEAR(character->height, 200.0f, 1e-3f);
  expectBindPoseIsTheMesh(*character);
}

TEST_F(GltfSkeleton, NodesMayHaveMatrices) {
  Post post = makePost();
  post.file.json["nodes"][1]["matrix"] = {0, 0, -2, 0, 0, 2, 0, 0, 2, 0, 0, 0, 3, 0, 5, 1};
  post.file.json["nodes"][0]["translation"] = {9, 9, 9};  // no effect on a skinned mesh
  const auto character = import(post);
  EXPECT_NEAR(character->height, 4.0f, 1e-4f);
  EXPECT_TRUE(character->skeleton.nodes[0].rest.matrix.has_value());
  expectBindPoseIsTheMesh(*character);
}

TEST_F(GltfSkeleton, MirroredBindReversesTheWinding) {
  Post post = makePost();
  post.file.json["nodes"][1]["scale"] = {-1, 1, 1};
  const auto character = import(post);
  for (std::size_t v = 0; v < character->mesh.positions.size(); ++v) {
    const glm::vec3 outwards = character->mesh.positions[v] - glm::vec3(0, 1, 0);
    EXPECT_GT(glm::dot(character->mesh.normals[v], outwards), 0.0f);
  }
}

TEST_F(GltfSkeleton, MissingInverseBindsAreIdentity) {
  Post post = makePost();
  post.file.json["skins"][0].erase("inverseBindMatrices");
  const auto character = import(post);
  expectBindPoseIsTheMesh(*character);
  EXPECT_EQ(character->skeleton.bones[1].bindInWorld, glm::mat4(1.0f));
}

TEST_F(GltfSkeleton, SingularInverseBindFallsBackToTheRestPose) {
  for (const std::size_t joint : {0U, 1U}) {
    Post post = makePost();
    std::vector<float> binds = uprightBinds(1.0f);
    std::fill_n(binds.begin() + static_cast<long>(16 * joint), 16, 0.0f);
    setInverseBinds(post, binds);
    const auto character = import(post, false);
    EXPECT_TRUE(mentions(*character, "singular"));
    EXPECT_LE(glm::distance(extentOf(*character), glm::vec3(1, 2, 1)), 1e-5f);
    EXPECT_EQ(glm::vec3(character->skeleton.bones[1].bindInWorld[3]), glm::vec3(0, 1, 0));
    expectBindPoseIsTheMesh(*character);
  }
}

TEST_F(GltfSkeleton, JointsMayBeListedChildFirst) {
  Post post = makePost();
  post.file.json["skins"][0]["joints"] = {2, 1};
  for (std::uint8_t& joint : post.joints) joint = static_cast<std::uint8_t>(1 - joint);
  post.attributes()["JOINTS_0"] = post.file.accessor(post.joints, "VEC4");
  std::vector<float> binds = uprightBinds(1.0f);
  std::rotate(binds.begin(), binds.begin() + 16, binds.end());
  setInverseBinds(post, binds);
  const auto character = import(post);
  EXPECT_EQ(character->skeleton.bones[0].name, "hip");
  EXPECT_EQ(character->skeleton.bones[1].parent, 0);
}

TEST_F(GltfSkeleton, TwoSkinsShareJointsAndBindings) {
  Post post = makePost();
  post.file.json["skins"].push_back(post.file.json["skins"][0]);
  post.file.json["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
  post.file.json["scenes"][0]["nodes"].push_back(3);
  const auto character = import(post);
  EXPECT_EQ(character->skeleton.bones.size(), 2u);
  EXPECT_EQ(character->skeleton.bindings.size(), 2u);
  EXPECT_EQ(character->mesh.positions.size(), 12u) << "both meshes lie in the same place and weld";
}

/// The second skin's mesh has another origin, as its inverse binds show; in the bind pose both coincide.
TEST_F(GltfSkeleton, SecondSkinWithItsOwnOriginSharesBindings) {
  Post post = makePost();
  std::vector<float> positions = post.positions;
  for (std::size_t v = 0; v < 12; ++v) positions[3 * v] += 10.0f;
  ordered_json mesh = post.file.json["meshes"][0];
  mesh["primitives"][0]["attributes"]["POSITION"] = post.file.accessor(positions, "VEC3");
  post.file.json["meshes"].push_back(mesh);
  std::vector<float> binds = uprightBinds(1.0f);
  binds[12] = binds[28] = -10.0f;
  post.file.json["skins"].push_back({{"joints", {1, 2}}, {"inverseBindMatrices", post.file.accessor(binds, "MAT4")}});
  post.file.json["nodes"].push_back({{"mesh", 1}, {"skin", 1}});
  post.file.json["scenes"][0]["nodes"].push_back(3);
  const auto character = import(post);
  EXPECT_EQ(character->skeleton.bindings.size(), 2u);
  EXPECT_LE(glm::distance(extentOf(*character), glm::vec3(1, 2, 1)), 1e-5f);
  expectBindPoseIsTheMesh(*character);
}

TEST_F(GltfSkeleton, SecondSkinBoundDifferentlyGetsItsOwnBindings) {
  Post post = makePost();
  post.file.json["skins"].push_back(
      {{"joints", {1, 2}}, {"inverseBindMatrices", post.file.accessor(uprightBinds(1.5f), "MAT4")}});
  post.file.json["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
  post.file.json["scenes"][0]["nodes"].push_back(3);
  const auto character = import(post);
  EXPECT_EQ(character->skeleton.bones.size(), 2u);
  EXPECT_EQ(character->skeleton.bindings.size(), 3u);
  EXPECT_EQ(character->skeleton.bindings[2].bone, 1);
  EXPECT_TRUE(mentions(*character, "bound differently"));
}

TEST_F(GltfSkeleton, MeshBelowAJointFollowsIt) {
  Post post = makePost();
  ordered_json hat{
      {"primitives",
       {{{"attributes", {{"POSITION", post.attributes()["POSITION"]}}}, {"indices", post.primitive()["indices"]}}}}};
  post.file.json["meshes"].push_back(hat);
  post.file.json["nodes"].push_back({{"name", "holder"}, {"translation", {0, 1, 0}}, {"children", {4}}});
  post.file.json["nodes"].push_back({{"name", "hat"}, {"mesh", 1}, {"scale", {0.5, -0.5, 0.5}}});
  post.file.json["nodes"][2]["children"] = {3};
  const auto character = import(post);
  EXPECT_EQ(character->skeleton.bones.size(), 2u);
  EXPECT_EQ(character->mesh.positions.size(), 24u);
  EXPECT_NEAR(boundsOf(character->mesh.positions).high.y, 2.0f, 1e-6f) << "knee at 1, holder at 2, hanging down by 1";
  expectBindPoseIsTheMesh(*character);
}

TEST_F(GltfSkeleton, MeshNodesAreBonesWithoutASkin) {
  Post post = makePost();
  post.file.json.erase("skins");
  post.file.json["nodes"] = {{{"mesh", 0}, {"children", {1}}},
                             {{"name", "middle"}, {"translation", {2, 0, 0}}, {"children", {2}}},
                             {{"name", "top"}, {"mesh", 0}, {"translation", {0, 5, 0}}}};
  post.file.json["scenes"][0]["nodes"] = {0};
  const auto character = import(post);
  ASSERT_EQ(character->skeleton.bones.size(), 2u);
  EXPECT_EQ(character->skeleton.bones[0].name, "joint 0");
  EXPECT_EQ(character->skeleton.bones[1].path, "joint 0/top");
  EXPECT_EQ(character->skeleton.nodes.size(), 3u);
  EXPECT_EQ(character->clips.size(), 1u);
  EXPECT_EQ(character->height, 7.0f);
  expectBindPoseIsTheMesh(*character);
}

TEST_F(GltfSkeleton, UnnamedItemsGetNames) {
  Post post = makePost();
  post.file.json["nodes"][1].erase("name");
  post.file.json["nodes"][2]["name"] = "";
  post.file.json["animations"][0].erase("name");
  const auto character = import(post);
  EXPECT_EQ(character->skeleton.bones[0].name, "joint 0");
  EXPECT_EQ(character->skeleton.bones[1].path, "joint 0/joint 1");
  EXPECT_EQ(character->clips[0].name, "clip 0");
}

void setSampler(Post& post, const std::string& mode, const std::vector<float>& times, int output) {
  const int input = post.file.accessor(times, "SCALAR");
  post.file.json["animations"][0]["samplers"][0] = {{"input", input}, {"output", output}, {"interpolation", mode}};
}

TEST_F(GltfSkeleton, StepCubicAndIntegerKeysAreImported) {
  Post step = makePost();
  setSampler(step, "STEP", {0.0f, 0.5f, 1.0f},
             step.file.accessor(std::vector<float>{0, 0, 0, 1, 0.6f, 0, 0, 0.8f, 1, 0, 0, 0}, "VEC4"));
  EXPECT_EQ(import(step)->clips[0].channels[0].interpolation, Interpolation::kStep);

  Post cubic = makePost();
  const std::vector<float> keys{0,    0, 0, 0,     0,    0, 0, 1,    1, 0, 0, -0.5f,
                                0.3f, 0, 0, -0.2f, 0.6f, 0, 0, 0.8f, 0, 0, 0, 0};
  setSampler(cubic, "CUBICSPLINE", {0.25f, 2.0f}, cubic.file.accessor(keys, "VEC4"));
  EXPECT_EQ(import(cubic)->clips[0].channels[0].values.size(), 6u);

  Post shorts = makePost();
  setSampler(shorts, "LINEAR", {0.0f, 1.0f},
             shorts.file.accessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 19660, 0, 26214}, "VEC4", true));
  EXPECT_NEAR(import(shorts)->clips[0].channels[0].values[1].y, 0.6f, 1e-4f);
}

TEST_F(GltfSkeleton, KeyTimesAreSortedAndTheLastOfEqualTimesWins) {
  Post post = makePost();
  const std::vector<float> values{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  setSampler(post, "LINEAR", {2.0f, 1.0f, 3.0f, 1.0f}, post.file.accessor(values, "VEC4"));
  const auto character = import(post, false);
  const Channel& channel = character->clips.at(0).channels.at(0);
  EXPECT_EQ(channel.times, (std::vector<float>{1.0f, 2.0f, 3.0f}));
  EXPECT_EQ(channel.values[0], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(channel.values[1], glm::vec4(1, 0, 0, 0));
  EXPECT_EQ(channel.values[2], glm::vec4(0, 0, 1, 0));
  EXPECT_EQ(character->clips[0].duration, 3.0f);
  EXPECT_TRUE(mentions(*character, "out of order"));
}

TEST_F(GltfSkeleton, ChannelsThatMoveNoBoneAreListed) {
  Post post = makePost();
  post.file.json["animations"][0]["channels"][0]["target"]["node"] = 0;
  const auto character = import(post, false);
  EXPECT_TRUE(character->clips.empty());
  EXPECT_TRUE(mentions(*character, "move no bone"));
}

/// The joints' rest pose differs from where both skins are bound: the second one goes where the first one put them.
TEST_F(GltfSkeleton, SecondSkinLiesWithTheFirstWhereRestAndBindPoseDiffer) {
  Post post = makePost();
  post.file.json["skins"].push_back(
      {{"joints", {2}},
       {"inverseBindMatrices",
        post.file.accessor(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1}, "MAT4")}});
  post.file.json["nodes"][2]["translation"] = {0.0f, 1.5f, 0.0f};
  ordered_json mesh = post.file.json["meshes"][0];
  std::vector<std::uint8_t> joints(post.joints.size(), 0);
  std::vector<float> weights(post.weights.size(), 0.0f);
  for (std::size_t v = 0; v < weights.size(); v += 4) weights[v] = 1.0f;
  mesh["primitives"][0]["attributes"]["JOINTS_0"] = post.file.accessor(joints, "VEC4");
  mesh["primitives"][0]["attributes"]["WEIGHTS_0"] = post.file.accessor(weights, "VEC4");
  post.file.json["meshes"].push_back(mesh);
  post.file.json["nodes"].push_back({{"mesh", 1}, {"skin", 1}});
  post.file.json["scenes"][0]["nodes"].push_back(3);
  const auto character = import(post, false);
  EXPECT_LE(glm::distance(extentOf(*character), glm::vec3(1, 2, 1)), 1e-5f);
}

}  // namespace
}  // namespace sinew
