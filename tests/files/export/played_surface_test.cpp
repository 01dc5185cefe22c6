// tests/files/export/played_surface_test.cpp: interpolation between two keys as in glTF.
#include "core/files/fit/played_surface.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/characters/synthetic_characters.h"

namespace sinew::exporting {
namespace {

class PlayedBetweenKeys : public ::testing::Test {
 protected:
  /// One vertex on a joint that the clip "Move" moves from rest by (2, 0, 0) within a second.
  void SetUp() override {
    const Skeleton& skeleton = character->skeleton;
    const HelperJoint joint = makeHelper("helper", 0, Trs{}, skeleton);
    HelperClip clip{"Move", {0.0f, 1.0f}, {{Trs{}, Trs{}}}};
    clip.locals[0][1].translation.x = 2.0;
    FourWeights weights;
    weights.binding[0] = static_cast<int>(skeleton.bindings.size());
    weights.weight[0] = 1.0f;
    surface.emplace(character, std::vector{kRest}, std::vector{weights}, std::vector{joint}, std::vector{clip});
  }
  [[nodiscard]] glm::vec3 at(const std::string& clip, float time) const {
    std::vector<glm::vec3> placed;
    surface->place(bindPose(character->skeleton), clip, time, placed);
    return placed.at(0);
  }
  /// Transforms a displacement by the first bone's axes.
  [[nodiscard]] glm::vec3 moved(float x) const {
    return kRest + glm::mat3(character->skeleton.bones[0].bindInWorld) * glm::vec3(x, 0.0f, 0.0f);
  }

  static constexpr glm::vec3 kRest{0.25f, 0.5f, 0.0f};
  const std::shared_ptr<const Character> character = test::makeLimb();
  std::optional<PlayedSurface> surface;
};

void expectNear(const glm::vec3& a, const glm::vec3& b) { EXPECT_LT(glm::distance(a, b), 1e-5f); }

TEST_F(PlayedBetweenKeys, JointsAreInterpolated) {
  expectNear(at("Move", 0.0f), kRest);
  expectNear(at("Move", 0.25f), moved(0.5f));
  expectNear(at("Move", 1.0f), moved(2.0f));
  expectNear(at("Move", 5.0f), moved(2.0f));
  expectNear(at("another", 0.5f), kRest);
}

TEST_F(PlayedBetweenKeys, TargetsAreBlendedBeforeSkinning) {
  surface->targets = {"Move", {0.0f, 0.5f, 1.0f}, {0.0f, 1.0f, 1.0f}, {{glm::vec3(0.0f, 0.0f, 1.0f)}}};
  expectNear(at("Move", 0.25f), moved(0.5f) + glm::vec3(0.0f, 0.0f, 0.5f));
  expectNear(at("Move", 0.75f), moved(1.5f) + glm::vec3(0.0f, 0.0f, 1.0f));
  expectNear(at("another", 0.75f), kRest);
}

TEST_F(PlayedBetweenKeys, AddedJointsReportTheirParentBone) {
  EXPECT_EQ(surface->boneOf(0), character->skeleton.bones[0].name);
}

TEST(TimesBetween, LieBetweenTheKeys) {
  AnimationClip clip;
  clip.duration = 1.0f;
  const std::vector<float> times = timesBetween(clip, 30.0);
  EXPECT_EQ(times.size(), 48u);
  int between = 0;
  for (const float time : times) {
    const float frames = 30.0f * time;
    if (std::abs(frames - std::round(frames)) > 0.01f) ++between;
  }
  EXPECT_EQ(between, 46) << "all but the ends";
}

}  // namespace
}  // namespace sinew::exporting
