// tests/rig/morphs_test.cpp: weights that a rig adds to morph targets: entries, edits, the file.
#include "core/rig/rig_edit.h"

#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "core/rig/validation.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::test {
namespace {

Character withTargets(const std::vector<std::string>& names) {
  Character character = *makeLimb();
  for (const std::string& name : names) {
    character.morphTargets.emplace_back();
    character.morphTargets.back().name = name;
  }
  return character;
}

std::vector<std::string> namesIn(const Rig& rig) {
  std::vector<std::string> names;
  for (const MorphWeight& morph : rig.morphs) names.push_back(morph.name);
  return names;
}

Rig emptyRig() {
  Rig rig;
  rig.character = "face.glb";
  return rig;
}

Driver bendDriver() {
  DriverInput input;
  input.bone = "end";
  return {input, {{{0.0f, 0.0f}, {90.0f, 1.0f}}, CurveKind::kLinear}, DriverMode::kAdd, {}};
}

TEST(Morphs, NamesAreUniqueInFileOrder) {
  const Character character = withTargets({"smile", "blink.L", "smile", "jaw"});
  EXPECT_EQ(morphNames(character), (std::vector<std::string>{"smile", "blink.L", "jaw"}));
}

TEST(Morphs, EntriesFollowTheCharacterAndNonIdleOnesStay) {
  Rig rig = setMorphWeight(emptyRig(), "gone", 0.5f).value();
  rig = setMorphWeight(std::move(rig), "jaw", 0.25f).value();
  rig.morphs.push_back({.name = "idle", .weight = 0.0f, .animated = {}, .unknownKeys = {}});
  rig = withMorphsOf(std::move(rig), withTargets({"smile", "jaw"}));
  EXPECT_EQ(namesIn(rig), (std::vector<std::string>{"smile", "jaw", "gone"}));
  EXPECT_EQ(rig.morphs[1].weight, 0.25f);
  EXPECT_EQ(rig.morphs[2].weight, 0.5f);
  EXPECT_EQ(withMorphsOf(rig, withTargets({"smile", "jaw"})), rig);
}

TEST(Morphs, KeepIdleKeepsEveryEntry) {
  Rig rig = emptyRig();
  rig.morphs.push_back({.name = "idle", .weight = 0.0f, .animated = {}, .unknownKeys = {}});
  rig = withMorphsOf(std::move(rig), withTargets({"smile"}), KeepIdle::kYes);
  EXPECT_EQ(namesIn(rig), (std::vector<std::string>{"smile", "idle"}));
}

/// Idle entries come from the character, which may have more names than a rig may use.
TEST(Morphs, IdleEntriesAreNotCounted) {
  Rig rig = emptyRig();
  for (int i = 0; i < 1024; ++i) rig = setMorphWeight(std::move(rig), "shape " + std::to_string(i), 1.0f).value();
  rig.morphs.push_back({.name = "idle", .weight = 0.0f, .animated = {}, .unknownKeys = {}});
  EXPECT_TRUE(validate(rig).ok());
  rig.morphs.back().weight = 0.5f;
  EXPECT_FALSE(validate(rig).ok());
}

TEST(Morphs, WeightsOutOfRangeAreRefused) {
  const Rig rig = emptyRig();
  EXPECT_TRUE(setMorphWeight(rig, "smile", kMostMorphWeight).ok());
  EXPECT_TRUE(setMorphWeight(rig, "smile", kLeastMorphWeight).ok());
  for (const float bad : {10.5f, -11.0f, std::numeric_limits<float>::quiet_NaN()}) {
    const auto set = setMorphWeight(rig, "smile", bad);
    ASSERT_FALSE(set.ok());
    EXPECT_EQ(set.error().place, "shapes[0].weight");
  }
}

TEST(Morphs, ResettingKeepsDrivers) {
  Rig rig = setMorphWeight(emptyRig(), "smile", 0.5f).value();
  rig = setDriver(std::move(rig), {Parameter::kMorphWeight, 0}, bendDriver(), -1).value();
  rig = withoutMorphWeights(std::move(rig));
  EXPECT_EQ(rig.morphs[0].weight, 0.0f);
  EXPECT_EQ(rig.morphs[0].animated.size(), 1U);
}

TEST(MorphsJson, RoundTrip) {
  Rig rig = withMorphsOf(emptyRig(), withTargets({"smile", "jaw", "blink.L"}));
  rig = setMorphWeight(std::move(rig), "smile", -0.75f).value();
  rig = setDriver(std::move(rig), {Parameter::kMorphWeight, 1}, bendDriver(), -1).value();
  rig = setKey(std::move(rig), {Parameter::kMorphWeight, 1}, "bend", 0.5f, 0.25f).value();
  rig.morphs[0].unknownKeys = R"({"later":3})";
  const std::string text = rigToJson(rig);
  const auto back = rigFromJson(text);
  ASSERT_TRUE(back.ok()) << back.error().text();
  EXPECT_EQ(namesIn(back.value()), (std::vector<std::string>{"smile", "jaw"})) << "idle ones are not written";
  EXPECT_EQ(back->morphs[0], rig.morphs[0]);
  EXPECT_EQ(back->morphs[1], rig.morphs[1]);
  EXPECT_EQ(rigToJson(back.value()), text);
  EXPECT_NE(text.find("\"version\": 2"), std::string::npos);
}

TEST(MorphsJson, IdleEntriesAreNotWritten) {
  const Rig rig = emptyRig();
  EXPECT_EQ(rigToJson(withMorphsOf(rig, withTargets({"smile"}))), rigToJson(rig));
}

TEST(MorphsJson, FaultsAreRefusedAtTheirPath) {
  const auto refusal = [](const std::string& shapes) {
    const auto rig = rigFromJson(R"({"format":"sinew-rig","version":2,"character":"a.glb","shapes":)" + shapes + "}");
    return rig.ok() ? std::string("accepted") : rig.error().place;
  };
  EXPECT_EQ(refusal("3"), "shapes");
  EXPECT_EQ(refusal("[4]"), "shapes[0]");
  EXPECT_EQ(refusal(R"([{"weight":1}])"), "shapes[0].name");
  EXPECT_EQ(refusal(R"([{"name":"a","weight":"x"}])"), "shapes[0].weight");
  EXPECT_EQ(refusal(R"([{"name":"a","weight":40}])"), "shapes[0].weight");
  EXPECT_EQ(refusal(R"([{"name":"a"},{"name":"a"}])"), "shapes[1].name");
  EXPECT_EQ(refusal(R"([{"name":"a","animated":[{"parameter":"reach"}]}])"), "shapes[0].animated[0].parameter");
  const std::string driver = R"({"input":{"kind":"channel","channel":"none"},"curve":[[0,1]]})";
  EXPECT_EQ(refusal(R"([{"name":"a","animated":[{"parameter":"weight","drivers":[)" + driver + "]}]}]"),
            "shapes[0].animated[0].drivers[0].input.channel");
  EXPECT_EQ(refusal(R"([{"name":"a","weight":0.5}])"), "accepted");
}

}  // namespace
}  // namespace sinew::test
