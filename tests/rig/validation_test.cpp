// tests/rig/validation_test.cpp: what no file can hold but code can. Files' cases: tests/io/rig_json_test.cpp.
#include "core/rig/validation.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/support/rigs/random_documents.h"

namespace sinew {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Validation, NamesNotANumberAndInfinity) {
  Placement placement;
  placement.radii.y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(validatePlacement(placement, "primitives[2]").error().text(),
            "primitives[2].radii[1]: expected a number > 0, got NaN");
  placement = {};
  placement.radii.x = kInfinity;
  EXPECT_EQ(validatePlacement(placement, "p").error().reason, "expected a number > 0, got infinity");
  placement = {};
  placement.center.z = -kInfinity;
  EXPECT_EQ(validatePlacement(placement, "p").error().text(), "p.center[2]: expected a finite number, got -infinity");
  placement = {};
  placement.rotation.w = kInfinity;
  EXPECT_EQ(validatePlacement(placement, "p").error().place, "p.rotation[3]");
}

TEST(Validation, RotationsNearUnitLengthAreTakenAsTheyAre) {
  Placement placement;
  for (const float w : {0.9991f, 1.0009f}) {
    placement.rotation = glm::quat(w, 0, 0, 0);
    EXPECT_TRUE(validatePlacement(placement, "").ok()) << w;
  }
  for (const float w : {0.0f, 0.998f, 1.002f, 3e38f}) {
    placement.rotation = glm::quat(w, 0, 0, 0);
    EXPECT_FALSE(validatePlacement(placement, "").ok()) << w;
  }
}

TEST(Validation, CreaseAnglesLieBetween0And180) {
  SmoothingSettings smoothing;
  for (const float angle : {0.0f, 40.0f, 180.0f}) {
    smoothing.creaseAngle = angle;
    EXPECT_TRUE(validateSmoothing(smoothing).ok()) << angle;
  }
  for (const float angle : {-0.1f, 180.1f, kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
    smoothing.creaseAngle = angle;
    ASSERT_FALSE(validateSmoothing(smoothing).ok()) << angle;
    EXPECT_EQ(validateSmoothing(smoothing).error().place, "smoothing.crease_angle");
  }
}

TEST(Validation, NamesMustBeUtf8) {
  for (const char* good : {"a", "é", "大腿", "\U0001F4AA", "\x01", "\x7f"})
    EXPECT_TRUE(validateName(good, "").ok()) << good;
  // Lone and missing continuations, overlong forms, a surrogate, past the last code point.
  for (const char* bad : {"", "\x80", "a\xff", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf0\x80\x80\x80",
                          "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xe5\xa4"}) {
    EXPECT_FALSE(validateName(bad, "").ok()) << bad;
  }
}

TEST(Validation, MorePrimitivesThanTheLimitAreRefused) {
  Rig rig;
  rig.groups.push_back({"g", {}});
  for (int i = 0; i <= kMaxPrimitives; ++i) {
    Primitive& primitive = rig.primitives.emplace_back();
    primitive.name = std::to_string(i);
    primitive.bone = "b";
    primitive.group = "g";
  }
  EXPECT_EQ(validate(rig).error().place, "primitives");
  rig.primitives.pop_back();
  EXPECT_TRUE(validate(rig).ok());
}

}  // namespace
}  // namespace sinew
