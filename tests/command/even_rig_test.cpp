// tests/command/even_rig_test.cpp: evenly spread muscles: valid, repeatable, and with the same overlap for any number.
#include "app/command/costs.h"

#include <gtest/gtest.h>

#include "core/rig/attachment.h"
#include "core/rig/validation.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::app {
namespace {

/// Mean number of influences on a vertex of the bound skin.
double meanOverlap(const Character& character, const Rig& rig) {
  std::vector<UnitBallMap> influences;
  for (const Primitive& primitive : rig.primitives) {
    const auto bone = static_cast<std::size_t>(character.skeleton.findBone(primitive.bone).value());
    influences.push_back(unitBallMap(primitive.placement, primitive.reach, character.skeleton.bones[bone].bindInWorld));
  }
  double held = 0.0;
  for (const glm::vec3& position : character.mesh.positions) {
    for (const UnitBallMap& influence : influences) held += influence.rSquared(position) < 1.0f ? 1.0 : 0.0;
  }
  return held / static_cast<double>(character.mesh.positions.size());
}

TEST(EvenRig, IsValidRepeatableAndAttached) {
  for (const auto& character : {test::makeLimb(), test::makeTwoLegged(), test::makeTube(), test::makeStrip()}) {
    for (const int muscles : {1, 41, 400}) {
      const Rig rig = evenRig(*character, muscles);
      EXPECT_TRUE(validate(rig).ok());
      EXPECT_EQ(rig.primitives.size(), static_cast<std::size_t>(muscles));
      EXPECT_TRUE(rig == evenRig(*character, muscles));
      const auto attachment = attach(rig, *character);
      ASSERT_TRUE(attachment.ok());
      EXPECT_TRUE(attachment.value().unattached.empty());
    }
  }
}

TEST(EvenRig, OverlapIsIndependentOfTheMuscleCount) {
  for (const auto& character : {test::makeTwoLegged(), test::makeTube()}) {
    for (const int muscles : {400, 4000}) {
      const double overlap = meanOverlap(*character, evenRig(*character, muscles));
      EXPECT_GT(overlap, 0.6 * static_cast<double>(kEvenOverlap)) << muscles;
      EXPECT_LT(overlap, 1.4 * static_cast<double>(kEvenOverlap)) << muscles;
    }
  }
}

}  // namespace
}  // namespace sinew::app
