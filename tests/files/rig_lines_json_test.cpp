// tests/files/rig_lines_json_test.cpp: muscle lines in rig files: format, errors and their places.

#include <gtest/gtest.h>

#include "sinew/files/rig_json.h"
#include "tests/files/rig_text.h"

namespace sinew {
namespace {

Rig withLine() {
  Rig rig;
  rig.character = "arm.glb";
  rig.groups = {{"muscles", {}}};
  MuscleLine line;
  line.name = "biceps L";
  line.origin = {"upper_arm.L", {0.0f, 1.0f, 2.0f}, {}};
  line.insertion = {"forearm.L", {0.5f, 0.0f, 0.0f}, {}};
  rig.lines = {line};
  Primitive belly;
  belly.name = "biceps L";
  belly.bone = "upper_arm.L";
  belly.group = "muscles";
  belly.line = "biceps L";
  rig.primitives = {belly};
  return rig;
}

TEST(RigLinesJson, DefaultsAreOmitted) {
  const std::string text = squeezed(rigToJson(withLine()));
  EXPECT_TRUE(has(text, R"("version":2)")) << text;
  EXPECT_TRUE(has(text, R"("lines":[{"name":"bicepsL","origin":{"bone":"upper_arm.L","point":[0,1,2]},)"
                        R"("insertion":{"bone":"forearm.L","point":[0.5,0,0]}}],)"))
      << text;
  EXPECT_TRUE(has(text, R"("line":"bicepsL")")) << text;
  Rig full = withLine();
  full.lines[0].via = LineAnchor{"upper_arm.L", {0.0f, 3.0f, 1.0f}, {}};
  full.lines[0].settings.flex = {0.5f, 0.25f};
  full.lines[0].settings.gain = 0.5f;
  const std::string more = squeezed(rigToJson(full));
  EXPECT_TRUE(has(more, R"("via":{"bone":"upper_arm.L","point":[0,3,1]},)")) << more;
  EXPECT_TRUE(has(more, R"("flex":[0.5,0.25],"activation":{"gain":0.5}})")) << more;
}

TEST(RigLinesJson, RigWithoutLinesIsVersion1) {
  Rig rig = withLine();
  rig.lines.clear();
  rig.primitives[0].line.clear();
  const std::string text = rigToJson(rig);
  EXPECT_TRUE(has(text, R"("version": 1)")) << text;
  EXPECT_FALSE(has(text, "line"));
}

struct BadLine {
  const char* from;
  const char* to;
  const char* place;
  const char* reason;
};

class BadLines : public testing::TestWithParam<BadLine> {};

TEST_P(BadLines, IsRefusedWithPlaceAndReason) {
  Rig rig = withLine();
  rig.lines[0].via = rig.lines[0].origin;
  rig.lines[0].settings.tendons = {0.25f, 0.5f};
  rig.lines[0].settings.limits = {0.5f, 3.0f};
  rig.lines[0].settings.full = 0.5f;
  std::string text = rigToJson(rig);
  ASSERT_TRUE(rigFromJson(text).ok());
  const std::size_t at = text.find(GetParam().from);
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, std::string(GetParam().from).size(), GetParam().to);
  const Result<Rig> read = rigFromJson(text);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().place, GetParam().place);
  EXPECT_TRUE(has(read.error().reason, GetParam().reason)) << read.error().text();
  EXPECT_FALSE(has(read.error().plainText(), "lines[")) << read.error().plainText();
}

INSTANTIATE_TEST_SUITE_P(
    RigLinesJson, BadLines,
    testing::Values(
        BadLine{"[0.25, 0.5]", "[-0.25, 0.5]", "lines[0].tendons[0]", "from 0 to 0.8, got -0.25"},
        BadLine{"[0.25, 0.5]", "[0.5, 0.5]", "lines[0].tendons", "from 0 to 0.8, got 1"},
        BadLine{"[0.25, 0.5]", "[0.25]", "lines[0].tendons", "expected an array of 2 numbers"},
        BadLine{"[0.5, 3]", "[1, 3]", "lines[0].limits[0]", "> 0 and < 1, got 1"},
        BadLine{"[0.5, 3]", "[0.5, 1]", "lines[0].limits[1]", "> 1, got 1"},
        BadLine{"\"full\": 0.5", "\"full\": 1", "lines[0].activation.full", "from 0.1 to 0.99, got 1"},
        BadLine{"\"full\": 0.5", "\"base\": 2", "lines[0].activation.base", "from 0 to 1, got 2"},
        BadLine{"[0.5, 0, 0]", "[0.5, 0]", "lines[0].insertion.point", "expected an array of 3 numbers"},
        BadLine{"\"forearm.L\"", "7", "lines[0].insertion.bone", "expected a text, got 7"},
        BadLine{"\"line\": \"biceps L\"", "\"line\": \"calf\"", "primitives[0].line", "there is no \"calf\""},
        BadLine{"\"line\": \"biceps L\"", "\"line\": \"\"", "primitives[0].line", "expected the name of a line"},
        BadLine{"\"tendons\"", "\"mirror\": \"biceps R\", \"tendons\"", "lines[0].mirror",
                "there is no \"biceps R\""}));

TEST(RigLinesJson, DuplicateNameIsRefused) {
  Rig rig = withLine();
  rig.lines.push_back(rig.lines[0]);
  const Result<Rig> read = rigFromJson(rigToJson(rig));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().place, "lines[1].name");
}

}  // namespace
}  // namespace sinew
