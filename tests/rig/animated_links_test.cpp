// tests/rig/animated_links_test.cpp: keys and drivers of links' amounts: edits, references, merges, validation.

#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "core/rig/attachment.h"
#include "core/rig/merge.h"
#include "core/rig/mirror.h"
#include "core/rig/posed_rig.h"
#include "core/rig/references.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew {
namespace {

constexpr NumberRef kAmount{Parameter::kLinkAmount, 0};

struct AnimatedLinks : testing::Test {
  std::shared_ptr<const Character> character = test::makeLimb();
  std::string clip = character->clips.front().name;
  Rig rig;

  AnimatedLinks() {
    for (const char* name : {"legs", "torso", "arms"}) {
      rig.groups.push_back({name, {}});
      Primitive primitive;
      primitive.name = std::string(name) + " muscle";
      primitive.bone = "middle";
      primitive.group = name;
      rig.primitives.push_back(primitive);
    }
    rig.links = {{{"legs", "torso"}, 0.4f}, {{"torso", "arms"}}};
  }

  static Driver byBend(const std::string& bone) {
    Driver driver;
    driver.input.bone = bone;
    driver.curve = {{{0.0f, 0.0f}, {90.0f, 0.5f}}, CurveKind::kLinear};
    return driver;
  }
  static Driver byChannel(const std::string& name) {
    Driver driver;
    driver.input.kind = DriverInputKind::kChannel;
    driver.input.channel = name;
    driver.curve = {{{0.0f, 0.0f}, {1.0f, 1.0f}}, CurveKind::kLinear};
    return driver;
  }
  void key(float time, float value) { rig = setKey(rig, kAmount, clip, time, value).value(); }
  [[nodiscard]] std::vector<float> at(float time) const {
    return RigPoser(rig, *character)
        .pose(samplePose(character->skeleton, character->clips.front(), time))
        .numbers.links;
  }
};

TEST_F(AnimatedLinks, KeysAndDriversGiveTheAmountOfTheMoment) {
  key(0.0f, 0.2f);
  key(1.0f, 0.8f);
  rig = setKeyKind(rig, kAmount, clip, CurveKind::kLinear).value();
  EXPECT_EQ(at(0.5f), (std::vector<float>{0.5f, 1.0f}));
  EXPECT_EQ(RigPoser(rig, *character).pose(bindPose(character->skeleton)).numbers.links,
            (std::vector<float>{0.4f, 1.0f}));
  rig = setChannelKey(rig, "effort", "", 0.0f, 0.3f).value();
  rig = setDriver(rig, kAmount, byChannel("effort")).value();
  EXPECT_NEAR(at(0.5f)[0], 0.8f, 1e-6f);
  EXPECT_EQ(at(1.0f)[0], 1.0f) << "brought into range";
  rig = setChannelKey(rig, "effort", "", 0.0f, -3.0f).value();
  rig = setDriver(
            rig, kAmount,
            [] {
              Driver driver = byChannel("effort");
              driver.curve.points = {{-3.0f, -2.0f}, {0.0f, 0.0f}};
              return driver;
            }(),
            0)
            .value();
  EXPECT_EQ(at(1.0f)[0], 0.0f) << "at 0 they are not linked";
  EXPECT_TRUE(RigPoser(rig, *character).drivesLinks());
  EXPECT_FALSE(RigPoser(rig, *character).drivesMuscles());
}

TEST_F(AnimatedLinks, FollowTheirGroups) {
  key(0.0f, 0.2f);
  const std::vector<AnimatedNumber> animated = rig.links[0].animated;
  rig = renameGroup(rig, 0, "hind legs").value();
  EXPECT_EQ(rig.links[0].groups[0], "hind legs");
  EXPECT_EQ(rig.links[0].animated, animated);
  rig = setLink(rig, 0, 1, 0.7f).value();
  EXPECT_EQ(rig.links[0].animated, animated) << "another amount";
  EXPECT_EQ(rig.links[0].amount, 0.7f);
  rig = dissolveGroup(rig, 0, 1).value();
  ASSERT_EQ(rig.links.size(), 1u);
  EXPECT_TRUE(rig.links[0].animated.empty());
  EXPECT_TRUE(validate(rig));
}

TEST_F(AnimatedLinks, UnlinkingTakesKeysAndDrivers) {
  key(0.0f, 0.2f);
  rig = setLink(rig, 1, 0, 0.0f).value();
  EXPECT_EQ(findLink(rig, "legs", "torso"), -1);
  rig = setLink(rig, 0, 1, 1.0f).value();
  EXPECT_TRUE(rig.links.back().animated.empty());
}

TEST_F(AnimatedLinks, FollowClipsChannelsAndLines) {
  MuscleLine line;
  line.name = "biceps";
  line.origin = {"root", {0.0f, 0.1f, 0.0f}, {}};
  line.insertion = {"end", {0.0f, 0.1f, 0.0f}, {}};
  rig.lines.push_back(line);
  rig = setChannelKey(rig, "effort", "", 0.0f, 0.3f).value();
  key(0.0f, 0.2f);
  rig = setDriver(rig, kAmount, byChannel("effort")).value();
  Driver length = byBend("");
  length.input = {};
  length.input.kind = DriverInputKind::kLength;
  length.input.line = "biceps";
  rig = setDriver(rig, kAmount, length).value();
  EXPECT_EQ(countKeyTracks(rig, clip), 1u);
  rig = withClipsRenamed(rig, {{clip, "other"}});
  EXPECT_EQ(rig.links[0].animated[0].keys[0].clip, "other");
  rig = renameChannel(rig, "effort", "breath").value();
  EXPECT_EQ(rig.links[0].animated[0].drivers[0].input.channel, "breath");
  renameReferences(rig, Named::kLine, "biceps", "biceps L");
  EXPECT_EQ(rig.links[0].animated[0].drivers[1].input.line, "biceps L");
  dropLineInputs(rig, {"biceps L"});
  EXPECT_EQ(rig.links[0].animated[0].drivers.size(), 1u);
  rig = removeChannel(rig, "breath");
  EXPECT_TRUE(rig.links[0].animated[0].drivers.empty());
}

TEST_F(AnimatedLinks, AreValidated) {
  const auto refusal = [&](const std::function<void(Link&)>& change) {
    Rig bad = rig;
    change(bad.links[0]);
    const Result<void> valid = validate(bad);
    return valid ? std::string() : valid.error().plainText();
  };
  EXPECT_EQ(refusal([](Link& link) {
              link.animated = {{Parameter::kReach, {}, {byBend("middle")}, {}}};
            }),
            "Link 1, animated number: expected a parameter of a link, got \"reach\"");
  EXPECT_EQ(refusal([](Link& link) {
              link.animated = {{Parameter::kLinkAmount, {}, {byChannel("none")}, {}}};
            }),
            "Link 1, driver: expected the name of a channel, but there is no \"none\"");
  EXPECT_EQ(refusal([](Link& link) {
              link.animated = {{Parameter::kLinkAmount, {}, {byBend("middle")}, {}}};
              link.amount = 0.0f;
            }),
            "Link 1: expected an amount above 0, at most 1, got 0");
  EXPECT_EQ(refusal([](Link& link) {
              link.animated.assign(2, {Parameter::kLinkAmount, {}, {byBend("middle")}, {}});
            }),
            "Link 1, animated number: expected each parameter once, but \"link_amount\" is there twice");
}

TEST_F(AnimatedLinks, MissingBonesOfDriversAreNamed) {
  rig = setDriver(rig, kAmount, byBend("tail")).value();
  const std::vector<MissingBone> missing = missingBones(rig, character->skeleton);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].place, "links[0].animated[0].drivers[0].input.bone");
  EXPECT_EQ(missing[0].plainText(), "Link 1, driver of Link amount: this character has no bone \"tail\"");
  EXPECT_EQ(at(0.3f)[0], 0.4f) << "the driver is left out";
}

TEST_F(AnimatedLinks, OnlyTheLinksThemselvesMakeOtherCandidates) {
  const Rig before = rig;
  key(0.0f, 0.2f);
  EXPECT_FALSE(sameCandidates(before, rig)) << "now its cliques change";
  EXPECT_TRUE(samePlaces(before, rig));
  const Rig keyed = rig;
  key(0.5f, 0.9f);
  EXPECT_TRUE(sameCandidates(keyed, rig));
}

TEST_F(AnimatedLinks, CopiesTakeWhatTheirDriversRead) {
  rig = setChannelKey(rig, "effort", "", 0.0f, 0.3f).value();
  rig = setDriver(rig, kAmount, byChannel("effort")).value();
  const Rig part = excerpt(rig, std::vector{0, 1});
  ASSERT_EQ(part.links.size(), 1u);
  EXPECT_EQ(part.links[0], rig.links[0]);
  ASSERT_EQ(part.channels.size(), 1u);
  EXPECT_TRUE(validate(part));
  EXPECT_TRUE(excerpt(rig, std::vector{1, 2}).channels.empty());
  Rig other;
  const Merged merged = mergeRigs(other, part, character->skeleton, nullptr).value();
  EXPECT_EQ(merged.rig.links, part.links);
  EXPECT_EQ(merged.rig.channels, part.channels);
  EXPECT_TRUE(validate(merged.rig));
}

TEST_F(AnimatedLinks, MergedImagesAreDrivenByTheOtherSide) {
  const auto body = test::makeTwoLegged();
  const MirrorPlan plan = makeMirrorPlan(*body);
  std::string left;
  for (std::size_t bone = 0; bone < plan.twinOf.size() && left.empty(); ++bone) {
    const int twin = plan.twinOf[bone];
    if (twin >= 0 && static_cast<std::size_t>(twin) != bone) left = body->skeleton.fileName(static_cast<int>(bone));
  }
  ASSERT_FALSE(left.empty());
  for (Primitive& primitive : rig.primitives) primitive.bone = left;
  rig = setDriver(rig, kAmount, byBend(left)).value();
  const Merged merged = mergeRigs({}, rig, body->skeleton, &plan).value();
  ASSERT_EQ(merged.rig.links.size(), 2u);
  ASSERT_EQ(merged.rig.links[0].animated.size(), 1u);
  EXPECT_EQ(merged.rig.links[0].animated[0].drivers[0].input.bone, twinBone(plan, left).value());
  EXPECT_EQ(merged.rig.links[0].amount, 0.4f);
}

TEST_F(AnimatedLinks, DriversOfLinesThatDoNotComeAreReported) {
  MuscleLine line;
  line.name = "biceps";
  line.origin = {"root", {0.0f, 0.1f, 0.0f}, {}};
  line.insertion = {"end", {0.0f, 0.1f, 0.0f}, {}};
  rig.lines.push_back(line);
  Driver length;
  length.input.kind = DriverInputKind::kLength;
  length.input.line = "biceps";
  length.curve.points = {{0.5f, 0.0f}, {1.0f, 1.0f}};
  rig = setDriver(rig, kAmount, length).value();
  const Merged merged = mergeRigs({}, rig, character->skeleton, nullptr).value();
  ASSERT_EQ(merged.lostDrivers.size(), 1u);
  EXPECT_EQ(merged.lostDrivers[0].owner, "legs and torso");
  EXPECT_TRUE(merged.rig.links[0].animated.empty());
  EXPECT_TRUE(validate(merged.rig));
}

}  // namespace
}  // namespace sinew
