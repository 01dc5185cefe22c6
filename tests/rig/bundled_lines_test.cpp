// tests/rig/bundled_lines_test.cpp: the bundled characters' muscles on lines work, and stay in their anatomical place.

#include <filesystem>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/line_edit.h"
#include "core/rig/posed_rig.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"

namespace sinew::test {
namespace {

struct Bundled {
  Rig rig;
  std::shared_ptr<const Character> character;

  explicit Bundled(const std::string& name) {
    const std::filesystem::path assets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets";
    rig = loadRig(assets / (name + "-flex.rig.json")).value();
    character = importGltf(assets / rig.character).value();
  }

  [[nodiscard]] LineLengths lengths(const MuscleLine& line, std::span<const AnimationClip> clips) const {
    return lengthsOver(lineRest(line, *character).value(), *character, clips);
  }

  [[nodiscard]] const AnimationClip& clip(const std::string& name) const {
    return *std::ranges::find(character->clips, name, &AnimationClip::name);
  }
};

TEST(BundledLines, StayWithinPlausibleLengths) {
  for (const char* name : {"humanoid", "horse"}) {
    const Bundled bundled(name);
    ASSERT_FALSE(bundled.rig.lines.empty());
    for (const MuscleLine& line : bundled.rig.lines) {
      const LineLengths lengths = bundled.lengths(line, bundled.character->clips);
      EXPECT_GT(lengths.least, kPlausibleLeast) << name << ", " << line.name << " in " << lengths.shortestIn;
      EXPECT_LT(lengths.most, kPlausibleMost) << name << ", " << line.name << " in " << lengths.longestIn;
    }
  }
}

// A muscle with constant length in the gallop would not need a line.
TEST(BundledLines, ChangeLengthInTheHorsesGallop) {
  const Bundled horse("horse");
  for (const MuscleLine& line : horse.rig.lines) {
    const LineLengths lengths = horse.lengths(line, {&horse.clip("Gallop"), 1});
    EXPECT_GT(lengths.most - lengths.least, 0.05f) << line.name;
    EXPECT_GT(1.0f - lengths.least, 0.5f * (1.0f - line.settings.full)) << line.name << " never gets half way to full";
  }
}

// The belly's thickest point is the peak.
TEST(BundledLines, BicepsPeaksOverTheMiddleOfTheUpperArm) {
  const Bundled humanoid("humanoid");
  const Skeleton& skeleton = humanoid.character->skeleton;
  const auto biceps = std::ranges::find(humanoid.rig.primitives, "biceps L", &Primitive::name);
  ASSERT_NE(biceps, humanoid.rig.primitives.end());
  const auto joint = [&](const char* bone, const Pose& pose) {
    return glm::vec3(pose.boneInWorld[static_cast<std::size_t>(skeleton.findBone(bone).value())][3]);
  };
  const auto index = static_cast<std::size_t>(biceps - humanoid.rig.primitives.begin());
  const RigPoser poser(humanoid.rig, *humanoid.character);
  const AnimationClip& flex = humanoid.clip("Flex");
  float thickest = 0.0f;
  for (float time = 0.0f; time < flex.duration; time += 0.1f) {
    const Pose pose = samplePose(skeleton, flex, time);
    const glm::mat4 carrier = poser.pose(pose).muscles[index].carrier;
    const glm::vec3 shoulder = joint("upper_arm.L", pose);
    const glm::vec3 arm = joint("forearm.L", pose) - shoulder;
    const glm::vec3 middle = glm::vec3(carrier * glm::vec4(biceps->placement.center, 1.0f)) - shoulder;
    const float along = glm::dot(middle, arm) / glm::dot(arm, arm);
    EXPECT_GT(along, 0.45f) << time;
    EXPECT_LT(along, 0.65f) << time;
    const auto rotation = glm::mat3_cast(biceps->placement.rotation);
    thickest = std::max(thickest, glm::length(glm::mat3(carrier) * rotation[1]));
  }
  EXPECT_GT(thickest, 1.2f);
  EXPECT_LT(thickest, 1.6f);
}

}  // namespace
}  // namespace sinew::test
