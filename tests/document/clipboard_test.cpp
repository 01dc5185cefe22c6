// tests/document/clipboard_test.cpp: copying muscles as text within a document and between documents.

#include "app/editor/symmetry_commands.h"

#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "core/rig/line_edit.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::app {
namespace {

struct Clipboard : testing::Test {
  std::shared_ptr<const Character> legs = test::makeTwoLegged();
  MirrorPlan plan = makeMirrorPlan(*legs);
  Rig rig;

  Clipboard() {
    rig.groups = {{"legs", {}}, {"torso", {}}, {"other", {}}};
    rig.links = {{"legs", "torso"}, {"torso", "other"}};
    Primitive thigh;
    thigh.name = "thigh L";
    thigh.bone = "leg L";
    thigh.group = "legs";
    thigh.placement.center = {0.1f, 0.2f, 0.3f};
    thigh.reach = 1.7f;
    rig = addPair(rig, thigh, plan).value();
    Primitive belly;
    belly.name = "belly";
    belly.bone = "spine";
    belly.group = "torso";
    rig = addPrimitive(rig, belly).value();
  }
};

TEST_F(Clipboard, PairIsPastedAsAPairUnderFreeNames) {
  const std::string text = musclesAsText(rig, std::vector<int>{0, 1});
  const Result<Pasted> pasted = pasteText(rig, text, legs->skeleton, nullptr);
  ASSERT_TRUE(pasted);
  EXPECT_EQ(pasted->names, (std::vector<std::string>{"thigh L 2", "thigh R 2"}));
  EXPECT_EQ(twinOf(pasted->rig, 3), 4);
  EXPECT_EQ(twinOf(pasted->rig, 0), 1);
  EXPECT_EQ(pasted->rig.primitives[3].placement.center, rig.primitives[0].placement.center);
  EXPECT_EQ(pasted->rig.primitives[3].reach, 1.7f);
  EXPECT_EQ(pasted->rig.groups.size(), 3u);
  EXPECT_TRUE(validate(pasted->rig));
}

TEST_F(Clipboard, DriversComeWithTheChannelsAndLinesTheyRead) {
  MuscleLine line;
  line.name = "calf";
  line.origin = {"leg L", {0.0f, -0.1f, 0.1f}, {}};
  line.insertion = {"shin L", {0.0f, -0.1f, 0.1f}, {}};
  rig = addLine(rig, line).value();
  rig = setChannelKey(rig, "effort", "cross", 0.0f, 1.0f).value();
  const NumberRef radius{Parameter::kRadiusX, 2};
  Driver driver;
  driver.curve.points = {{0.0f, 0.0f}, {1.0f, 0.1f}};
  driver.input.kind = DriverInputKind::kChannel;
  driver.input.channel = "effort";
  rig = setDriver(rig, radius, driver).value();
  driver.input = {};
  driver.input.kind = DriverInputKind::kLength;
  driver.input.line = "calf";
  rig = setDriver(rig, radius, driver).value();
  const std::string text = musclesAsText(rig, std::vector<int>{2});

  const Result<Pasted> here = pasteText(rig, text, legs->skeleton, nullptr);
  ASSERT_TRUE(here);
  EXPECT_TRUE(here->leftOut.empty());
  EXPECT_EQ(here->rig.primitives.back().animated, rig.primitives[2].animated);
  EXPECT_EQ(here->rig.channels.size(), 1u) << "the channel was there";
  EXPECT_EQ(here->rig.lines.size(), 1u);

  Rig other;
  other.character = "other.glb";
  const Result<Pasted> there = pasteText(other, text, legs->skeleton, nullptr);
  ASSERT_TRUE(there);
  ASSERT_EQ(there->leftOut.size(), 1u) << "the line is not there";
  ASSERT_EQ(there->rig.primitives.back().animated.size(), 1u);
  EXPECT_EQ(there->rig.primitives.back().animated[0].drivers.size(), 1u);
  EXPECT_EQ(there->rig.channels, rig.channels);
  EXPECT_TRUE(validate(there->rig)) << validate(there->rig).error().text();
}

TEST_F(Clipboard, OneOfAPairIsCopiedWithoutItsTwin) {
  const Result<Rig> copied = rigFromJson(musclesAsText(rig, std::vector<int>{1}));
  ASSERT_TRUE(copied);
  EXPECT_EQ(copied->primitives[0].mirror, "");
  EXPECT_EQ(copied->groups.size(), 1u);
  EXPECT_TRUE(copied->links.empty());
}

TEST_F(Clipboard, PasteIntoAnotherDocumentAddsGroupsAndReportsOmissions) {
  const std::string text = musclesAsText(rig, std::vector<int>{0, 1, 2});
  Skeleton other = legs->skeleton;
  other.bones[static_cast<std::size_t>(*other.findBone("leg R"))].name = "elsewhere";
  other.bones[static_cast<std::size_t>(*other.findBone("elsewhere"))].path = "elsewhere";
  const Result<Pasted> pasted = pasteText(Rig{}, text, other, nullptr);
  ASSERT_TRUE(pasted);
  EXPECT_EQ(pasted->names, (std::vector<std::string>{"thigh L", "belly"}));
  ASSERT_EQ(pasted->leftOut.size(), 1u);
  EXPECT_NE(pasted->leftOut[0].find("leg R"), std::string::npos);
  EXPECT_EQ(pasted->rig.links.size(), 1u);
  EXPECT_EQ(pasted->rig.primitives[0].mirror, "");
  EXPECT_TRUE(validate(pasted->rig));
}

TEST_F(Clipboard, MirroredPasteGoesToTheOtherSide) {
  const Rig single = removePrimitives(rig, std::vector<int>{1});
  const std::string text = musclesAsText(single, std::vector<int>{0});
  const Result<Pasted> pasted = pasteText(single, text, legs->skeleton, &plan);
  ASSERT_TRUE(pasted);
  EXPECT_EQ(pasted->names, std::vector<std::string>{"thigh R"});
  EXPECT_EQ(pasted->rig.primitives.back().bone, "leg R");
  EXPECT_EQ(pasted->rig.primitives.back().placement.center, rig.primitives[1].placement.center);
}

TEST_F(Clipboard, PasteOnAnotherBoneKeepsTheRelativePositionAndTheTwin) {
  const Skeleton& skeleton = legs->skeleton;
  const int target = *skeleton.findBone("shin R");
  const std::string text = musclesAsText(rig, std::vector<int>{0, 1});
  const Result<Pasted> pasted = pasteTextOnBone(rig, text, skeleton, target, &plan);
  ASSERT_TRUE(pasted);
  ASSERT_EQ(pasted->names.size(), 2u);
  const Primitive& right = pasted->rig.primitives[3];
  const Primitive& left = pasted->rig.primitives[4];
  EXPECT_EQ(right.bone, "shin R");
  EXPECT_EQ(left.bone, "shin L");
  EXPECT_EQ(twinOf(pasted->rig, 3), 4);
  const auto lengthOf = [&](const char* bone) {
    return glm::length(skeleton.bones[static_cast<std::size_t>(*skeleton.findBone(bone))].tip);
  };
  const float factor = lengthOf("shin R") / lengthOf("leg R");
  EXPECT_LT(glm::length(right.placement.center - factor * rig.primitives[1].placement.center), 1e-5f);
  EXPECT_TRUE(validate(pasted->rig));
}

TEST_F(Clipboard, PasteOnTheSameBoneOrFromSeveralBonesKeepsThePosition) {
  const Skeleton& skeleton = legs->skeleton;
  for (const std::vector<int>& copied : {std::vector<int>{2}, std::vector<int>{0, 2}}) {
    const std::string text = musclesAsText(rig, copied);
    const Result<Pasted> there = pasteTextOnBone(rig, text, skeleton, *skeleton.findBone("spine"), &plan);
    const Result<Pasted> plain = pasteText(rig, text, skeleton, nullptr);
    ASSERT_TRUE(there && plain);
    EXPECT_EQ(there->rig, plain->rig);
  }
  // A muscle on a bone that this character lacks is pasted on another bone.
  Primitive lost = rig.primitives[2];
  lost.bone = "elsewhere";
  Rig other;
  other.character = "other.glb";
  other.groups = {{"torso", {}}};
  other.primitives = {lost};
  const int spine = *skeleton.findBone("spine");
  const Result<Pasted> pasted = pasteTextOnBone(rig, musclesAsText(other, std::vector<int>{0}), skeleton, spine, &plan);
  ASSERT_TRUE(pasted);
  EXPECT_EQ(pasted->rig.primitives.back().bone, "spine");
  EXPECT_EQ(pasted->rig.primitives.back().placement, lost.placement);
}

TEST_F(Clipboard, PasteStopsAtThePrimitiveLimitWithoutUnusedLines) {
  MuscleLine line;
  line.name = "calf";
  line.origin = {"leg L", {0.0f, -0.1f, 0.1f}, {}};
  line.insertion = {"shin L", {0.0f, -0.1f, 0.1f}, {}};
  Rig source = addLine(rig, line).value();
  source.primitives[1].line = "calf";
  const std::string text = musclesAsText(source, std::vector<int>{2, 1});
  Rig full;
  full.groups = {{"torso", {}}};
  full.primitives.resize(kMaxPrimitives - 1, rig.primitives[2]);
  for (std::size_t i = 0; i < full.primitives.size(); ++i) full.primitives[i].name = std::to_string(i);
  const Result<Pasted> pasted = pasteText(full, text, legs->skeleton, nullptr);
  ASSERT_TRUE(pasted);
  EXPECT_EQ(pasted->names, std::vector<std::string>{"belly"});
  EXPECT_EQ(pasted->rig.primitives.size(), static_cast<std::size_t>(kMaxPrimitives));
  EXPECT_TRUE(pasted->rig.lines.empty());
  ASSERT_EQ(pasted->leftOut.size(), 1u);
  EXPECT_NE(pasted->leftOut[0].find("65536"), std::string::npos) << pasted->leftOut[0];
}

TEST_F(Clipboard, InvalidTextIsRefused) {
  for (const char* text : {"", "hello", "{}", "[1, 2]", R"({"format": "sinew-rig", "version": 1})"}) {
    const Result<Pasted> pasted = pasteText(rig, text, legs->skeleton, nullptr);
    ASSERT_FALSE(pasted) << text;
    EXPECT_FALSE(pasted.error().text().empty());
  }
}

}  // namespace
}  // namespace sinew::app
