// tests/cli/inspect_test.cpp: `sinew inspect` as a program sees it.
#include <algorithm>

#include "core/io/json/json.h"
#include "tests/cli/program.h"
#include "tests/support/characters/characters.h"

namespace sinew {
namespace {

using test::Program;

TEST_F(Program, InspectJsonHasEveryKeyAndNothingElseOnStdout) {
  const auto result = run({"inspect", demo("demo.glb"), "--json"});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.error, "");
  const auto json = Json::parse(result.out);
  ASSERT_TRUE(json.ok()) << json.error().text();
  EXPECT_EQ(json->keys(),
            (std::vector<std::string>{"triangles", "triangles_dropped", "vertices", "wedges", "colored_wedges",
                                      "closed", "border_edges", "non_manifold_edges", "height", "joints", "joint_names",
                                      "helper_joints", "clips", "materials", "textures", "ignored"}));
  EXPECT_TRUE(json->at("closed").boolean(false));
  EXPECT_EQ(json->at("border_edges").number(-1), 0);
  EXPECT_EQ(json->at("colored_wedges").number(-1), 0);
  // Euler: a closed mesh of one piece and no handles has V = T / 2 + 2; of more pieces, 2 more for each.
  const double euler = json->at("vertices").number(0) - json->at("triangles").number(0) / 2;
  EXPECT_EQ(euler, 2);
  EXPECT_EQ(json->at("joint_names").items().size(), static_cast<std::size_t>(json->at("joints").number(0)));
  EXPECT_TRUE(json->at("helper_joints").items().empty()) << "skin follows every joint of the bundled character";
  ASSERT_GE(json->at("clips").items().size(), 1u);
  EXPECT_EQ(json->at("clips").items()[0].at("name").text(""), "Walk");
  EXPECT_GT(json->at("clips").items()[0].at("duration").number(0), 0);
}

TEST_F(Program, InspectOfARigTellsOfItsPrimitivesToo) {
  const auto result = run({"inspect", demo("demo.rig.json"), "--json"});
  ASSERT_EQ(result.status, 0) << result.error;
  const auto json = Json::parse(result.out);
  ASSERT_TRUE(json.ok());
  EXPECT_GT(json->at("primitives").number(0), 0);
  EXPECT_FALSE(json->at("groups").items().empty());
  EXPECT_TRUE(json->at("unattached").items().empty());
}

TEST_F(Program, InspectCountsTheWedgesACreaseAngleMakes) {
  const std::string head = R"({"format": "sinew-rig", "version": 1, "character": ")" + demo("demo.glb") + "\"";
  ASSERT_TRUE(writeFileAtomically(folder_ / "sharp.rig.json", head + R"(, "smoothing": {"crease_angle": 12}})").ok());
  ASSERT_TRUE(writeFileAtomically(folder_ / "smooth.rig.json", head + "}").ok());
  const auto sharp = Json::parse(run({"inspect", "sharp.rig.json", "--json"}).out);
  const auto smooth = Json::parse(run({"inspect", "smooth.rig.json", "--json"}).out);
  ASSERT_TRUE(sharp.ok() && smooth.ok());
  EXPECT_EQ(sharp->at("crease_angle").number(0), 12);
  EXPECT_EQ(sharp->at("wedges").number(0), smooth->at("wedges").number(-1));
  EXPECT_GT(sharp->at("creased_wedges").number(0), 0);
  EXPECT_GT(sharp->at("shaded_wedges").number(0), sharp->at("wedges").number(0));
  EXPECT_EQ(smooth->at("crease_angle").number(0), 180);
  EXPECT_EQ(smooth->at("creased_wedges").number(-1), 0);
  EXPECT_EQ(smooth->at("shaded_wedges").number(0), smooth->at("wedges").number(-1));
  EXPECT_NE(run({"inspect", "sharp.rig.json"}).out.find("creases     over 12 degrees: "), std::string::npos);
}

TEST_F(Program, InspectNamesUnattachedPrimitives) {
  const std::string rig = R"({"format": "sinew-rig", "version": 1, "character": ")" + demo("demo.glb") +
                          R"(", "groups": [{"name": "g"}], "primitives": [{"name": "wing", "bone": "no such bone",
                          "group": "g", "center": [0, 0, 0], "radii": [1, 1, 1]}]})";
  ASSERT_TRUE(writeFileAtomically(folder_ / "lost.rig.json", rig).ok());
  const auto result = run({"inspect", "lost.rig.json"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_NE(result.out.find("unattached  1: wing"), std::string::npos) << result.out;
}

TEST_F(Program, InspectNamesTheJointsThatNoSkinFollows) {
  const std::string character = std::string(SINEW_CHARACTERS_DIR) + "/robot.glb";
  if (!std::filesystem::exists(character)) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto json = Json::parse(run({"inspect", character, "--json"}).out);
  ASSERT_TRUE(json.ok());
  std::vector<std::string> helpers;
  for (const Json& name : json->at("helper_joints").items()) helpers.push_back(name.text(""));
  EXPECT_NE(std::ranges::find(helpers, "PoleTarget.L"), helpers.end());
  EXPECT_EQ(std::ranges::find(helpers, "Head"), helpers.end());
  EXPECT_NE(run({"inspect", character}).out.find("PoleTarget.L, PoleTarget.R\n  clips "), std::string::npos);
}

TEST_F(Program, InspectForPeopleNamesWhatIsOpen) {
  const std::string character = std::string(SINEW_CHARACTERS_DIR) + "/SimpleSkin.gltf";
  if (!std::filesystem::exists(character)) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto result = run({"inspect", character});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("surface     open: 10 border edges\n"), std::string::npos) << result.out;
}

TEST_F(Program, InspectOfBadFilesIsStatus1AndOneLine) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "empty.glb", "").ok());
  ASSERT_TRUE(writeFileAtomically(folder_ / "text.gltf", "hello").ok());
  ASSERT_TRUE(writeFileAtomically(folder_ / "bad.rig.json", "{\"format\": \"sinew-rig\",\n \"version\": 9}").ok());
  ASSERT_TRUE(writeFileAtomically(folder_ / "lone.rig.json",
                                  R"({"format": "sinew-rig", "version": 1, "character": "gone.glb"})")
                  .ok());
  std::filesystem::create_directory(folder_ / "folder.glb");
  for (const char* file :
       {"absent.glb", "empty.glb", "text.gltf", "bad.rig.json", "lone.rig.json", "folder.glb", "two\nlines.glb", ""}) {
    const auto result = run({"inspect", file});
    EXPECT_EQ(result.status, 1) << file << '\n' << result.error;
    EXPECT_TRUE(result.oneErrorLine()) << file << '\n' << result.error;
    EXPECT_EQ(result.out, "") << file;
  }
  EXPECT_NE(run({"inspect", "bad.rig.json"}).error.find("bad.rig.json: version: "), std::string::npos);
}

}  // namespace
}  // namespace sinew
