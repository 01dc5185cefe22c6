// tests/runtime/c_interface_test.cpp: the C interface: the same bits, error codes with a reason, invalid calls are
// harmless.

#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "sinew/c/sinew_runtime.h"
#include "sinew/character/character_pose.h"
#include "sinew/runtime/game_file.h"
#include "sinew/runtime/vertex_buffer.h"
#include "sinew/surface/smoother.h"
#include "tests/support/allocations.h"
#include "tests/support/rigs/trial_scenes.h"

extern "C" {
int play_in_c(const void* file, size_t size, int clip, float seconds, void* vertices, size_t vertexBytes,
              uint16_t* indices, size_t indexBytes);
void use_tasks_of_c(int* count);
}

namespace sinew::test {
namespace {

/// A smoother created through the interface, and its inputs.
class CInterface : public testing::Test {
 protected:
  void SetUp() override {
    const std::vector<std::byte> file = gameFile(*scene_.character, scene_.rig);
    ASSERT_EQ(sinew_character_create(file.data(), file.size(), &character_), SINEW_OK) << sinew_error();
    ASSERT_EQ(sinew_smoother_create(character_, nullptr, &smoother_), SINEW_OK) << sinew_error();
    bones_.resize(16 * static_cast<std::size_t>(sinew_bone_count(character_)));
    ASSERT_EQ(sinew_clip_sample(character_, 0, 0.3f, bones_.data(), bones_.size()), SINEW_OK) << sinew_error();
    pose_.bones = bones_.data();
    pose_.bone_count = bones_.size() / 16;
    vertices_.resize(24 * sinew_vertex_count(smoother_, SINEW_DRAWN));
  }
  void TearDown() override {
    sinew_smoother_destroy(smoother_);
    sinew_character_destroy(character_);
  }
  sinew_code write() { return sinew_write_vertices(smoother_, &layout_, vertices_.data(), vertices_.size()); }

  TrialScene scene_ = bundledTrialScene("demo");
  sinew_character* character_ = nullptr;
  sinew_smoother* smoother_ = nullptr;
  std::vector<float> bones_;
  sinew_pose pose_{};
  sinew_layout layout_{24, 0, 12, SINEW_FLOAT3, SINEW_FLOAT3, SINEW_DRAWN, {}};
  std::vector<std::byte> vertices_;
};

TEST_F(CInterface, CProgramGetsTheSmoothersBits) {
  const std::vector<std::byte> file = gameFile(*scene_.character, scene_.rig);
  Smoother smoother(scene_.character);
  ASSERT_TRUE(smoother.prepare(scene_.rig).ok());
  Surface surface;
  smoother.smooth(samplePose(scene_.character->skeleton, scene_.character->clips[0], 0.5f), surface);
  std::vector<std::byte> expected(vertices_.size());
  ASSERT_TRUE(writeVertices(surface, {}, expected).ok());
  std::vector<std::uint16_t> indices(sinew_index_count(smoother_));
  std::vector<std::uint16_t> sameIndices(indices.size());
  ASSERT_TRUE(
      writeIndices(*surface.refinement, scene_.character->mesh, BufferVertices::kDrawn, std::span(sameIndices)).ok());
  int tasks = 0;
  for (const bool own : {false, true}) {
    use_tasks_of_c(own ? &tasks : nullptr);
    std::ranges::fill(vertices_, std::byte{0});
    const int line = play_in_c(file.data(), file.size(), 0, 0.5f, vertices_.data(), vertices_.size(), indices.data(),
                               2 * indices.size());
    use_tasks_of_c(nullptr);
    EXPECT_EQ(line, 0) << sinew_error();
    EXPECT_TRUE(vertices_ == expected);
    EXPECT_TRUE(indices == sameIndices);
  }
  EXPECT_GT(tasks, 0);
}

TEST_F(CInterface, FrameAllocatesNothing) {
  for (int warm = 0; warm < 2; ++warm) ASSERT_EQ(sinew_smooth(smoother_, &pose_), SINEW_OK) << sinew_error();
  const std::int64_t before = allocations();
  const sinew_code smoothed = sinew_smooth(smoother_, &pose_);
  const sinew_code written = write();
  EXPECT_EQ(allocations(), before);
  EXPECT_EQ(smoothed, SINEW_OK);
  EXPECT_EQ(written, SINEW_OK);
}

TEST_F(CInterface, RefusedPoseGivesAMessageAndKeepsTheLastSurface) {
  ASSERT_EQ(sinew_smooth(smoother_, &pose_), SINEW_OK);
  ASSERT_EQ(write(), SINEW_OK);
  const std::vector<std::byte> last = vertices_;
  const auto refused = [&](const sinew_pose& pose, const char* words) {
    EXPECT_EQ(sinew_smooth(smoother_, &pose), SINEW_BAD_POSE) << words;
    EXPECT_NE(std::strstr(sinew_error(), words), nullptr) << sinew_error();
    EXPECT_EQ(write(), SINEW_OK);
    EXPECT_TRUE(vertices_ == last) << words;
  };
  sinew_pose pose = pose_;
  pose.bone_count -= 1;
  refused(pose, "expected matrices of");
  pose.bone_count = 0;
  refused(pose, "got 0");
  pose = pose_;
  pose.bones = nullptr;
  refused(pose, "bones: null");
  pose = pose_;
  pose.has_clip = 1;
  pose.clip = 1000;
  refused(pose, "clip: out of range");
  const float weight = 0.0f;
  pose = pose_;
  pose.morph_weights = &weight;
  pose.morph_count = 99;
  refused(pose, "morph targets");
  bones_[37] = std::numeric_limits<float>::quiet_NaN();
  refused(pose_, "not finite");
  bones_[37] = 0.0f;
  EXPECT_EQ(sinew_smooth(smoother_, &pose_), SINEW_OK);
}

TEST_F(CInterface, BadArgumentsHaveCodesAndReasons) {
  sinew_character* none = character_;
  EXPECT_EQ(sinew_character_create("no game file, but longer than its head is", 40, &none), SINEW_BAD_FILE);
  EXPECT_EQ(none, nullptr);
  EXPECT_NE(std::strstr(sinew_error(), "not a Sinew game file"), nullptr) << sinew_error();
  EXPECT_EQ(sinew_character_create(nullptr, 0, &none), SINEW_BAD_ARGUMENT);
  EXPECT_EQ(sinew_character_create("", 0, nullptr), SINEW_BAD_ARGUMENT);
  sinew_smoother* other = smoother_;
  EXPECT_EQ(sinew_smoother_create(nullptr, nullptr, &other), SINEW_BAD_ARGUMENT);
  EXPECT_EQ(other, nullptr);
  const sinew_detail deep{99, 0.0f, nullptr, 0};
  EXPECT_EQ(sinew_smoother_create(character_, &deep, &other), SINEW_BAD_RIG);
  EXPECT_NE(std::strstr(sinew_error(), "depth"), nullptr) << sinew_error();
  const sinew_detail both{2, 0.001f, nullptr, 0};
  EXPECT_EQ(sinew_smoother_share(smoother_, &both, &other), SINEW_BAD_ARGUMENT);
  const int bones[] = {0, sinew_bone_count(character_)};
  const sinew_detail beyond{0, 0.0f, bones, 2}, unknown{0, 0.0f, nullptr, 2};
  EXPECT_EQ(sinew_smoother_share(smoother_, &beyond, &other), SINEW_BAD_ARGUMENT);
  EXPECT_NE(std::strstr(sinew_error(), "there is no bone"), nullptr) << sinew_error();
  EXPECT_EQ(sinew_smoother_share(smoother_, &unknown, &other), SINEW_BAD_ARGUMENT);
  EXPECT_EQ(sinew_smooth(smoother_, nullptr), SINEW_BAD_ARGUMENT);
  EXPECT_EQ(sinew_smooth(nullptr, &pose_), SINEW_BAD_ARGUMENT);
  EXPECT_EQ(sinew_write_vertices(smoother_, &layout_, vertices_.data(), vertices_.size() - 1), SINEW_BAD_ARGUMENT);
  layout_.normal_format = SINEW_HALF4;
  EXPECT_EQ(write(), SINEW_BAD_ARGUMENT);
  std::uint16_t index = 0;
  EXPECT_EQ(sinew_write_indices(smoother_, SINEW_DRAWN, 3, &index, 2), SINEW_BAD_ARGUMENT);
  EXPECT_EQ(sinew_write_indices(smoother_, SINEW_DRAWN, 2, &index, 2), SINEW_BAD_ARGUMENT);
  EXPECT_EQ(sinew_clip_sample(character_, -1, 0.0f, bones_.data(), bones_.size()), SINEW_BAD_ARGUMENT);
  EXPECT_EQ(sinew_clip_sample(character_, 0, 0.0f, bones_.data(), 3), SINEW_BAD_ARGUMENT);
  EXPECT_STREQ(sinew_bone_name(character_, -1), "");
  EXPECT_EQ(sinew_bone_parent(character_, 9999), -1);
  EXPECT_EQ(sinew_bone_find(character_, "nobody"), -1);
  sinew_smoother_destroy(nullptr);
  sinew_character_destroy(nullptr);
}

TEST_F(CInterface, ListsBonesClipsAndMaterials) {
  const Character& character = *scene_.character;
  ASSERT_EQ(sinew_bone_count(character_), static_cast<int>(character.skeleton.bones.size()));
  for (int b = 0; b < sinew_bone_count(character_); ++b) {
    const Bone& bone = character.skeleton.bones[static_cast<std::size_t>(b)];
    EXPECT_EQ(sinew_bone_name(character_, b), bone.name);
    EXPECT_EQ(sinew_bone_parent(character_, b), bone.parent);
    EXPECT_EQ(sinew_bone_find(character_, bone.path.c_str()), b);
    glm::mat4 bind(0.0f);
    EXPECT_EQ(sinew_bone_bind(character_, b, &bind[0][0]), SINEW_OK);
    EXPECT_EQ(bind, bone.bindInWorld);
  }
  ASSERT_EQ(sinew_clip_count(character_), static_cast<int>(character.clips.size()));
  EXPECT_EQ(sinew_clip_name(character_, 0), character.clips[0].name);
  EXPECT_EQ(sinew_clip_seconds(character_, 0), character.clips[0].duration);
  std::size_t total = 0;
  for (int m = 0; m < sinew_material_count(character_); ++m) {
    std::size_t first = 0;
    std::size_t count = 0;
    EXPECT_EQ(sinew_material_indices(smoother_, m, &first, &count), SINEW_OK);
    EXPECT_EQ(first, total);
    total += count;
  }
  EXPECT_EQ(total, sinew_index_count(smoother_));
  ASSERT_EQ(sinew_pose_from_locals(character_, nullptr, nullptr, nullptr, bones_.data(), bones_.size()), SINEW_OK);
  EXPECT_EQ(std::memcmp(bones_.data(), restPose(character.skeleton).boneInWorld.data(), 4 * bones_.size()), 0);
}

TEST_F(CInterface, RegionMatchesTheCppInterface) {
  const int bone = sinew_bone_count(character_) - 1;
  const sinew_detail part{3, 0.0f, &bone, 1};
  sinew_smoother* other = nullptr;
  ASSERT_EQ(sinew_smoother_share(smoother_, &part, &other), SINEW_OK) << sinew_error();
  Rig rig = scene_.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = 3;
  Smoother smoother(scene_.character);
  ASSERT_TRUE(smoother.prepare(rig, {}, regionOfBones(*scene_.character, {&bone, 1})).ok());
  Surface surface;
  ASSERT_TRUE(smoother.smooth(bindPose(scene_.character->skeleton), surface));
  ASSERT_EQ(sinew_vertex_count(other, SINEW_REFINED), surface.positions.size());
  const sinew_layout layout{12, 0, -1, SINEW_FLOAT3, SINEW_FLOAT3, SINEW_REFINED, {}};
  std::vector<glm::vec3> positions(surface.positions.size());
  const std::size_t bytes = positions.size() * sizeof(glm::vec3);
  ASSERT_EQ(sinew_write_vertices(other, &layout, positions.data(), bytes), SINEW_OK) << sinew_error();
  EXPECT_EQ(positions, surface.positions);
  sinew_smoother_destroy(other);
}

TEST_F(CInterface, SharedSmootherOutlivesItsSource) {
  const sinew_detail coarse{1, 0.0f, nullptr, 0};
  sinew_smoother* other = nullptr;
  ASSERT_EQ(sinew_smoother_share(smoother_, &coarse, &other), SINEW_OK) << sinew_error();
  sinew_smoother_destroy(smoother_);
  sinew_character_destroy(character_);
  smoother_ = nullptr;
  character_ = nullptr;
  EXPECT_EQ(sinew_vertex_count(other, SINEW_REFINED), scene_.character->mesh.positions.size());
  EXPECT_EQ(sinew_smooth(other, &pose_), SINEW_OK) << sinew_error();
  sinew_smoother_destroy(other);
}

TEST_F(CInterface, PoseWithoutAClipForgetsTheOneBefore) {
  const AnimationClip& clip = scene_.character->clips.front();
  Rig rig = setKey(scene_.rig, {Parameter::kRadiusX, 0}, clip.name, 0.0f, 0.3f * scene_.character->height).value();
  const std::vector<std::byte> file = gameFile(*scene_.character, rig);
  TearDown();
  ASSERT_EQ(sinew_character_create(file.data(), file.size(), &character_), SINEW_OK) << sinew_error();
  ASSERT_EQ(sinew_smoother_create(character_, nullptr, &smoother_), SINEW_OK) << sinew_error();
  ASSERT_EQ(sinew_smooth(smoother_, &pose_), SINEW_OK) << sinew_error();
  ASSERT_EQ(write(), SINEW_OK);
  const std::vector<std::byte> without = vertices_;
  sinew_pose inClip = pose_;
  inClip.has_clip = 1;
  inClip.clip_seconds = 0.3f;
  ASSERT_EQ(sinew_smooth(smoother_, &inClip), SINEW_OK) << sinew_error();
  ASSERT_EQ(write(), SINEW_OK);
  EXPECT_FALSE(vertices_ == without);
  ASSERT_EQ(sinew_smooth(smoother_, &pose_), SINEW_OK) << sinew_error();
  ASSERT_EQ(write(), SINEW_OK);
  EXPECT_TRUE(vertices_ == without);
}

}  // namespace
}  // namespace sinew::test
