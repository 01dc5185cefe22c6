// tests/rig/validation_test.cpp: invalid rigs that only code can produce. For files see tests/files/rig_json_test.cpp.

#include "core/rig/validation.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/support/rigs/random_documents.h"

namespace sinew {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Validation, ErrorsNameNanAndInfinity) {
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

TEST(Validation, ShapeRangesAreChecked) {
  Primitive primitive;
  primitive.name = "calf";
  primitive.bone = "leg";
  Shape& shape = primitive.placement.shape;
  const auto ok = [&] { return validatePrimitive(primitive, "p").ok(); };
  shape = {kMostCore, 0.0f, {kMostBend, -kMostBend}};
  EXPECT_TRUE(ok());
  shape.core = std::nextafter(kMostCore, 1.0f);
  EXPECT_FALSE(ok());
  shape = {0.0f, std::numeric_limits<float>::quiet_NaN(), {}};
  EXPECT_FALSE(ok());
  shape = {0.0f, 0.0f, {0.0f, kInfinity}};
  EXPECT_EQ(validatePrimitive(primitive, "p").error().place, "p.bend[1]");
  for (const float reach : {1.001f, 1.4142135f, 2.0f, 8.0f}) {
    for (const float core : {0.0f, 0.5f, kMostCore}) {
      primitive.reach = reach;
      shape = {core, mostBelly(core, reach), {}};
      EXPECT_TRUE(ok()) << reach;
      shape.belly *= -1.01f;
      EXPECT_FALSE(ok()) << reach;
    }
  }
}

/// The interface shows no JSON paths: a muscle is referred to by name.
TEST(Validation, ErrorsNameTheirSubjectInPlainLanguage) {
  Rig rig;
  rig.groups = {{"arms", {}}, {"legs", {}}};
  Primitive& muscle = rig.primitives.emplace_back();
  muscle.name = "biceps L";
  muscle.bone = "upper_arm.L";
  muscle.group = "arms";
  const auto saidOf = [&](auto change) {
    Rig broken = rig;
    change(broken);
    return validate(broken).error().plainText();
  };
  EXPECT_TRUE(validate(rig).ok());
  EXPECT_EQ(saidOf([](Rig& r) { r.primitives[0].placement.radii.z = 0.0f; }),
            "Muscle \"biceps L\", radius Z: expected a number > 0, got 0");
  EXPECT_EQ(saidOf([](Rig& r) { r.primitives[0].reach = 1.0f; }),
            "Muscle \"biceps L\", reach: expected a number > 1, got 1");
  EXPECT_EQ(saidOf([](Rig& r) { r.primitives[0].bone = ""; }),
            "Muscle \"biceps L\", bone: expected a name, got nothing");
  EXPECT_EQ(saidOf([](Rig& r) { r.primitives[0].group = "hands"; }),
            "Muscle \"biceps L\", group: expected the name of a group, but there is no \"hands\"");
  EXPECT_EQ(saidOf([](Rig& r) {
              r.links = {{"arms", "hands"}};
            }),
            "Link 1: expected the name of a group, but there is no \"hands\"");
  EXPECT_EQ(saidOf([](Rig& r) {
              r.links = {{"arms", "arms"}};
            }),
            "Link 1: expected two different groups, got \"arms\" twice");
  EXPECT_EQ(saidOf([](Rig& r) {
              r.links = {{{"arms", "legs"}, 1.5f}};
            }),
            "Link 1: expected an amount above 0, at most 1, got 1.5");
  EXPECT_EQ(saidOf([](Rig& r) { r.surface.iso = 2.0f; }), "Tightness: expected a number from 0.001 to 0.999, got 2");
  EXPECT_EQ(saidOf([](Rig& r) { r.smoothing.depth = 0; }).substr(0, 6), "Depth:");
}

TEST(Validation, RotationsNearUnitLengthAreAccepted) {
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

TEST(Validation, CreaseAnglesMustLieBetween0And180) {
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
  // Lone and missing continuation bytes, overlong forms, a surrogate, beyond the last code point.
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

TEST(Validation, EachPartOfTheBodyIsNamedOnce) {
  Rig rig;
  rig.slots = {{"upperArm.L", "arm"}, {"lowerArm.L", "arm"}};
  EXPECT_TRUE(validate(rig).ok()) << validate(rig).error().text();
  rig.slots[1].slot = "upperArm.L";
  const auto twice = validate(rig);
  ASSERT_FALSE(twice.ok());
  EXPECT_NE(twice.error().text().find("named twice"), std::string::npos);
}

}  // namespace
}  // namespace sinew
