// tests/command/inspect_test.cpp: `sinew inspect` run as a process.
#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/files/json/json.h"
#include "tests/command/program.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/characters/gltf_builder.h"

namespace sinew {
namespace {

using test::Program;

TEST_F(Program, InspectJsonHasEveryKeyAndIsAloneOnStdout) {
  const auto result = run({"inspect", demo("demo.glb"), "--json"});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.error, "");
  const auto json = Json::parse(result.out);
  ASSERT_TRUE(json.ok()) << json.error().text();
  EXPECT_EQ(json->keys(), (std::vector<std::string>{"file",          "triangles",     "triangles_dropped",
                                                    "vertices",      "wedges",        "colored_wedges",
                                                    "closed",        "border_edges",  "non_manifold_edges",
                                                    "height",        "joints",        "joint_names",
                                                    "helper_joints", "body",          "clips",
                                                    "clip_files",    "morph_targets", "range_of_motion",
                                                    "materials",     "parts",         "textures",
                                                    "ignored"}));
  EXPECT_TRUE(json->at("closed").boolean(false));
  EXPECT_EQ(json->at("border_edges").number(-1), 0);
  EXPECT_EQ(json->at("colored_wedges").number(-1), 0);
  // Euler: a closed mesh of one piece without handles has V = T / 2 + 2; each further piece adds 2.
  const double euler = json->at("vertices").number(0) - json->at("triangles").number(0) / 2;
  EXPECT_EQ(euler, 2);
  EXPECT_EQ(json->at("joint_names").items().size(), static_cast<std::size_t>(json->at("joints").number(0)));
  EXPECT_TRUE(json->at("helper_joints").items().empty()) << "skin follows every joint of the bundled character";
  ASSERT_GE(json->at("clips").items().size(), 1u);
  EXPECT_EQ(json->at("clips").items()[0].at("name").text(""), "Walk");
  EXPECT_GT(json->at("clips").items()[0].at("duration").number(0), 0);
  EXPECT_GE(json->at("range_of_motion").number(0), 1.0);
}

TEST_F(Program, InspectListsTheLayersOfParts) {
  test::writeDressedHumanoid(folder_);
  auto json = Json::parse(run({"inspect", "dressed.glb", "--json"}).out);
  ASSERT_TRUE(json.ok()) << json.error().text();
  std::string told;
  for (const Json& part : json->at("parts").items()) {
    told +=
        part.at("name").text("") + ' ' + part.at("layer").text("") + (part.at("guessed").boolean(false) ? "? " : " ");
  }
  EXPECT_EQ(told, "humanoid skin? Shirt cloth? Trousers cloth? Eyes rigid? Hair cloth? ");
  std::ofstream(folder_ / "dressed.rig.json") << R"({"format": "sinew-rig", "version": 1, "character": "dressed.glb",
                                "layers": {"Hair": "rigid", "Cape": "cloth"}})";
  const std::string text = run({"inspect", "dressed.rig.json"}).out;
  EXPECT_NE(text.find("Eyes rigid (guessed), Hair rigid\n"), std::string::npos) << text;
  EXPECT_NE(text.find("no parts    1: Cape"), std::string::npos) << text;
}

TEST_F(Program, InspectOfSeveralFilesIsATableOrAnArray) {
  const auto table = run({"inspect", demo("demo.glb"), demo("humanoid-flex.rig.json"), demo("tangle.glb")});
  ASSERT_EQ(table.status, 0) << table.error;
  EXPECT_EQ(table.error, "");
  ASSERT_EQ(std::ranges::count(table.out, '\n'), 4) << table.out;
  EXPECT_TRUE(table.out.starts_with("file ")) << table.out;
  std::istringstream lines(table.out);
  std::size_t width = 0;
  for (std::string line; std::getline(lines, line); width = line.size()) {
    EXPECT_TRUE(width == 0 || line.size() == width) << "columns stand below each other\n" << table.out;
  }
  const auto array = Json::parse(run({"inspect", demo("demo.glb"), demo("humanoid-flex.rig.json"), "--json"}).out);
  ASSERT_TRUE(array.ok()) << array.error().text();
  ASSERT_EQ(array->items().size(), 2u);
  EXPECT_EQ(array->items()[0].at("file").text(""), demo("demo.glb"));
  const auto alone = Json::parse(run({"inspect", demo("humanoid-flex.rig.json"), "--json"}).out);
  EXPECT_EQ(array->items()[1].dump(), alone->dump()) << "what the file alone says";
}

TEST_F(Program, InspectContinuesAfterAnUnreadableFile) {
  const auto some = run({"inspect", demo("demo.glb"), "absent.glb", demo("tangle.glb")});
  EXPECT_EQ(some.status, 3);
  EXPECT_TRUE(some.oneErrorLine()) << some.error;
  EXPECT_EQ(std::ranges::count(some.out, '\n'), 3) << some.out;
  const auto json = Json::parse(run({"inspect", demo("demo.glb"), "absent.glb", "--json"}).out);
  ASSERT_EQ(json->items().size(), 2u);
  EXPECT_NE(json->items()[1].at("error").text("").find("absent.glb"), std::string::npos);
  const auto none = run({"inspect", "absent.glb", "gone.glb"});
  EXPECT_EQ(none.status, 1);
  EXPECT_EQ(none.out, "");
}

TEST_F(Program, InspectReportsLinesKeysAndDrivers) {
  const auto json = Json::parse(run({"inspect", demo("humanoid-flex.rig.json"), "--json"}).out);
  ASSERT_TRUE(json.ok());
  EXPECT_FALSE(json->at("lines").items().empty());
  const std::string rig = R"({"format": "sinew-rig", "version": 3, "character": ")" + demo("demo.glb") + R"(",
    "channels": [{"name": "effort", "clip": "Walk", "times": [0, 1], "values": [0, 1]},
                 {"name": "effort", "clip": "Idle", "times": [0], "values": [1]}],
    "groups": [{"name": "g"}, {"name": "h"}],
    "links": [{"groups": ["g", "h"], "amount": 0.5,
               "animated": [{"parameter": "link_amount", "keys": [{"times": [0, 1], "values": [0, 1]}]}]}],
    "primitives": [{"name": "wing", "bone": "hand.L", "group": "g", "center": [0, 0, 0],
    "radii": [1, 1, 1], "core": 0.5, "animated": [{"parameter": "radii.x",
      "keys": [{"clip": "Walk", "times": [0, 0.5, 1], "values": [1, 2, 1]}],
      "drivers": [{"input": {"kind": "channel", "channel": "effort"}, "curve": [[0, 0], [1, 1]]}]}]}]})";
  ASSERT_TRUE(writeFileAtomically(folder_ / "moved.rig.json", rig).ok());
  const auto moved = run({"inspect", "moved.rig.json", "--json"});
  ASSERT_EQ(moved.status, 0) << moved.error;
  const auto told = Json::parse(moved.out);
  EXPECT_EQ(told->at("shapes").number(0), 1);
  EXPECT_EQ(told->at("keys").number(0), 5);
  EXPECT_EQ(told->at("keyed_numbers").number(0), 2);
  EXPECT_EQ(told->at("drivers").number(0), 1);
  ASSERT_EQ(told->at("channels").items().size(), 1u);
  EXPECT_EQ(told->at("channels").items()[0].text(""), "effort");
  const std::string words = run({"inspect", "moved.rig.json"}).out;
  for (const char* line :
       {"primitives  1, 1 of them shaped\n", "links       1: g - h (50 %, animated)\n", "keys        5, of 2 numbers\n",
        "channels    1: effort\n", "drivers     1\n", "lines       0\n"}) {
    EXPECT_NE(words.find(line), std::string::npos) << line << words;
  }
}

TEST_F(Program, InspectStrictFailsOnMissingBones) {
  const std::string rig = R"({"format": "sinew-rig", "version": 1, "character": ")" + demo("demo.glb") +
                          R"(", "groups": [{"name": "g"}], "primitives": [{"name": "wing", "bone": "Hand_L",
                          "group": "g", "center": [0, 0, 0], "radii": [1, 1, 1]}]})";
  ASSERT_TRUE(writeFileAtomically(folder_ / "lost.rig.json", rig).ok());
  const auto lenient = run({"inspect", "lost.rig.json"});
  EXPECT_EQ(lenient.status, 0);
  EXPECT_NE(lenient.out.find("no bone \"Hand_L\"; did you mean \"hand.L\"?\n"), std::string::npos) << lenient.out;
  const auto strict = run({"inspect", "lost.rig.json", "--strict"});
  EXPECT_EQ(strict.status, 1);
  EXPECT_TRUE(strict.oneErrorLine()) << strict.error;
  EXPECT_EQ(strict.out, lenient.out) << "what it tells is the same";
  EXPECT_EQ(run({"inspect", demo("demo.rig.json"), "--strict"}).status, 0);
  EXPECT_EQ(run({"inspect", demo("demo.rig.json"), "lost.rig.json", "--strict"}).status, 3);
}

TEST_F(Program, InspectListsEightNonManifoldEdges) {
  // Walls inside the post: where they touch its skin, three or more triangles share an edge.
  test::Post post = test::makePost();
  for (const int corner :
       {4, 5, 6, 6, 7, 4, 0, 4, 6, 0, 6, 2, 1, 5, 7, 1, 7, 3, 4, 8, 10, 4, 10, 6, 5, 9, 11, 5, 11, 7}) {
    post.indices.push_back(static_cast<std::uint16_t>(corner));
  }
  post.primitive()["indices"] = post.file.accessor(post.indices, "SCALAR");
  ASSERT_TRUE(writeFileAtomically(folder_ / "walls.glb", post.file.glb()).ok());
  const auto json = Json::parse(run({"inspect", "walls.glb", "--json"}).out);
  ASSERT_TRUE(json.ok());
  const int edges = static_cast<int>(json->at("non_manifold_edges").number(0));
  ASSERT_GT(edges, 8);
  const std::string told = run({"inspect", "walls.glb"}).out;
  std::size_t listed = 0;
  for (std::size_t at = told.find(" triangles, bone "); at != std::string::npos;
       at = told.find(" triangles, bone ", at + 1)) {
    ++listed;
  }
  EXPECT_EQ(listed, 8u) << told;
  EXPECT_NE(told.find("\n              and " + std::to_string(edges - 8) + " more\n"), std::string::npos) << told;
}

TEST_F(Program, InspectMapsBonesToBodyParts) {
  const auto json = run({"inspect", demo("humanoid.glb"), "--json"});
  ASSERT_EQ(json.status, 0) << json.error;
  const auto parsed = Json::parse(json.out);
  ASSERT_TRUE(parsed.ok());
  EXPECT_EQ(parsed->at("body").at("kind").text(""), "humanoid");
  EXPECT_EQ(parsed->at("body").at("slots").at("upperArm.L").at("bone").text(""), "upper_arm.L");
  EXPECT_EQ(parsed->at("body").at("slots").at("upperArm.L").at("confidence").text(""), "sure");
  const auto text = run({"inspect", demo("horse.glb")});
  ASSERT_EQ(text.status, 0) << text.error;
  EXPECT_NE(text.out.find("  body        quadruped\n"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("frontLower.L  sure     forearm.L\n"), std::string::npos) << text.out;
}

TEST_F(Program, InspectOfARigReportsItsPrimitives) {
  const auto result = run({"inspect", demo("demo.rig.json"), "--json"});
  ASSERT_EQ(result.status, 0) << result.error;
  const auto json = Json::parse(result.out);
  ASSERT_TRUE(json.ok());
  EXPECT_GT(json->at("primitives").number(0), 0);
  EXPECT_FALSE(json->at("groups").items().empty());
  EXPECT_TRUE(json->at("unattached").items().empty());
}

TEST_F(Program, InspectCountsCreasedWedges) {
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

TEST_F(Program, InspectListsHelperJoints) {
  const std::string character = std::string(SINEW_CHARACTERS_DIR) + "/robot.glb";
  if (!std::filesystem::exists(character)) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto json = Json::parse(run({"inspect", character, "--json"}).out);
  ASSERT_TRUE(json.ok());
  std::vector<std::string> helpers;
  for (const Json& name : json->at("helper_joints").items()) helpers.push_back(name.text(""));
  EXPECT_NE(std::ranges::find(helpers, "PoleTarget.L"), helpers.end());
  EXPECT_EQ(std::ranges::find(helpers, "Head"), helpers.end());
  EXPECT_NE(run({"inspect", character}).out.find("PoleTarget.L, PoleTarget.R\n  body "), std::string::npos);
}

TEST_F(Program, InspectTextReportsOpenEdges) {
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
