// tests/files/rig_animated_json_test.cpp: keys, drivers and channels in rig files: format, errors and their places.

#include <gtest/gtest.h>

#include "sinew/files/rig_json.h"
#include "tests/files/rig_text.h"

namespace sinew {
namespace {

Rig animatedRig() {
  Rig rig;
  rig.character = "arm.glb";
  rig.groups = {{"muscles", {}}};
  rig.channels = {{"effort", {"Lift", {{{0.0f, 0.0f}, {0.5f, 1.0f}}, CurveKind::kSmooth}, {}}}};
  Primitive belly;
  belly.name = "biceps L";
  belly.bone = "upper_arm.L";
  belly.group = "muscles";
  Driver bend;
  bend.input.bone = "forearm.L";
  bend.curve.points = {{0.0f, 0.0f}, {90.0f, 0.25f}};
  Driver effort;
  effort.input.kind = DriverInputKind::kChannel;
  effort.input.channel = "effort";
  effort.curve = {{{0.0f, 1.0f}, {1.0f, 1.5f}}, CurveKind::kLinear};
  effort.mode = DriverMode::kMultiply;
  belly.animated = {{Parameter::kRadiusX, {{"Flex", {{{0.25f, 2.0f}}, CurveKind::kStep}, {}}}, {bend, effort}, {}}};
  rig.primitives = {belly};
  return rig;
}

TEST(RigAnimatedJson, WritesOnlyNonDefaultValues) {
  const std::string text = squeezed(rigToJson(animatedRig()));
  EXPECT_TRUE(has(text, R"("version":2)")) << text;
  EXPECT_TRUE(has(text, R"("channels":[{"name":"effort","clip":"Lift","times":[0,0.5],"values":[0,1]}])")) << text;
  EXPECT_TRUE(has(text, R"("animated":[{"parameter":"radii.x",)"
                        R"("keys":[{"clip":"Flex","times":[0.25],"values":[2],"interpolation":"step"}],)"
                        R"("drivers":[{"input":{"kind":"bend","bone":"forearm.L"},"curve":[[0,0],[90,0.25]]},)"
                        R"({"input":{"kind":"channel","channel":"effort"},"curve":[[0,1],[1,1.5]],)"
                        R"("interpolation":"linear","mode":"multiply"}]}])"))
      << text;
  Rig plain = animatedRig();
  plain.channels.clear();
  plain.primitives[0].animated.clear();
  EXPECT_TRUE(has(squeezed(rigToJson(plain)), R"("version":1)"));
  plain.primitives[0].amount = 0.5f;
  EXPECT_TRUE(has(squeezed(rigToJson(plain)), R"("version":2)"));
}

TEST(RigAnimatedJson, RoundTrips) {
  const Rig rig = animatedRig();
  const Result<Rig> read = rigFromJson(rigToJson(rig));
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read.value(), rig);
}

TEST(RigAnimatedJson, KeepsUnknownKeys) {
  std::string text = squeezed(rigToJson(animatedRig()));
  for (const char* before :
       {R"("kind":"bend")", R"("parameter":"radii.x")", R"("times":[0.25])", R"("times":[0,0.5])", R"("input":)"}) {
    const std::size_t at = text.find(before);
    ASSERT_NE(at, std::string::npos) << before;
    text.insert(at, R"("later":[1],)");
  }
  const Result<Rig> read = rigFromJson(text);
  ASSERT_TRUE(read) << read.error().text();
  const std::string again = squeezed(rigToJson(read.value()));
  std::size_t count = 0;
  for (std::size_t at = again.find("later"); at != std::string::npos; at = again.find("later", at + 1)) ++count;
  EXPECT_EQ(count, 5u) << again;
}

struct BadPart {
  const char* from;
  const char* to;
  const char* place;
  const char* reason;
};

class BadAnimation : public testing::TestWithParam<BadPart> {};

TEST_P(BadAnimation, IsRefusedWithPlaceAndReason) {
  std::string text = squeezed(rigToJson(animatedRig()));
  const std::size_t at = text.find(GetParam().from);
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, std::string(GetParam().from).size(), GetParam().to);
  const Result<Rig> read = rigFromJson(text);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().place, GetParam().place);
  EXPECT_TRUE(has(read.error().reason, GetParam().reason)) << read.error().text();
}

INSTANTIATE_TEST_SUITE_P(
    RigAnimatedJson, BadAnimation,
    testing::Values(
        BadPart{"radii.x", "volume", "primitives[0].animated[0].parameter", "expected a parameter of a muscle"},
        BadPart{"radii.x", "girth", "primitives[0].animated[0].parameter", "there is no parameter \"girth\""},
        BadPart{"\"bend\"", "\"bent\"", "primitives[0].animated[0].drivers[0].input.kind", "got \"bent\""},
        BadPart{"\"bone\":\"forearm.L\"", "\"bone\":7", "primitives[0].animated[0].drivers[0].input.bone", "got 7"},
        BadPart{"[[0,0],[90,0.25]]", "[[0,0],[0,0.25]]", "primitives[0].animated[0].drivers[0].curve[1][0]", "> 0"},
        BadPart{"[[0,0],[90,0.25]]", "[]", "primitives[0].animated[0].drivers[0].curve", "at least one point"},
        BadPart{"[[0,0],[90,0.25]]", "[[0,0,0]]", "primitives[0].animated[0].drivers[0].curve[0]", "array of 2"},
        BadPart{"\"multiply\"", "\"times\"", "primitives[0].animated[0].drivers[1].mode", "got \"times\""},
        BadPart{"\"channel\":\"effort\"", "\"channel\":\"rage\"", "primitives[0].animated[0].drivers[1].input.channel",
                "there is no \"rage\""},
        BadPart{"\"kind\":\"bend\",\"bone\":\"forearm.L\"", "\"kind\":\"length\",\"line\":\"x\"",
                "primitives[0].animated[0].drivers[0].input.line", "there is no \"x\""},
        BadPart{"\"kind\":\"bend\"", "\"kind\":\"pose\",\"rotation\":[0,0,0,2]",
                "primitives[0].animated[0].drivers[0].input.rotation", "length 1"},
        BadPart{"\"kind\":\"bend\"", "\"kind\":\"axis\",\"axis\":[0,0,0]",
                "primitives[0].animated[0].drivers[0].input.axis", "length 1"},
        BadPart{"\"values\":[2]", "\"values\":[2,3]", "primitives[0].animated[0].keys[0].values", "expected 1 values"},
        BadPart{"\"times\":[0.25]", "\"times\":[-0.25]", "primitives[0].animated[0].keys[0].times[0]", ">= 0"},
        BadPart{"\"times\":[0,0.5]", "\"times\":[0,0]", "channels[0].times[1]", "> 0"},
        BadPart{"\"clip\":\"Lift\"", "\"clip\":\"\"", "channels[0].clip", "the name of a clip"},
        BadPart{"\"name\":\"effort\"", "\"name\":\"\"", "channels[0].name", "expected a name"}));

TEST(RigAnimatedJson, DuplicateParameterIsRefused) {
  Rig rig = animatedRig();
  rig.primitives[0].animated.push_back(rig.primitives[0].animated[0]);
  const Result<Rig> read = rigFromJson(rigToJson(rig));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().place, "primitives[0].animated[1].parameter");
}

}  // namespace
}  // namespace sinew
