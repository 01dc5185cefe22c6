// tests/command/smooth_test.cpp: `sinew smooth` run as a process.
#include <algorithm>
#include <sstream>

#include "core/files/json/json.h"
#include "tests/command/program.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew {
namespace {

using test::Program;

std::vector<std::array<int, 3>> facesOf(const std::string& obj) {
  std::vector<std::array<int, 3>> faces;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("f ")) continue;
    std::istringstream words(line.substr(2));
    std::array<int, 3> face{};
    for (int& vertex : face) {
      std::string corner;
      words >> corner;
      vertex = std::stoi(corner);
    }
    faces.push_back(face);
  }
  return faces;
}

/// A clip in which nested scaled joints exceed the range of floats after its beginning.
std::string farPost() {
  test::Post post = test::makePost();
  post.file.json["nodes"].push_back({{"name", "top"}, {"children", {1}}});
  post.file.json["scenes"][0]["nodes"] = {0, 3};
  auto& clip = post.file.json["animations"][0];
  for (const int node : {1, 2, 3}) {
    clip["channels"].push_back({{"sampler", clip["samplers"].size()}, {"target", {{"node", node}, {"path", "scale"}}}});
    clip["samplers"].push_back(
        {{"input", post.file.accessor(std::vector<float>{0, 1}, "SCALAR")},
         {"output", post.file.accessor(std::vector<float>{1, 1, 1, 1e15f, 1e15f, 1e15f}, "VEC3")}});
  }
  return post.file.glb();
}

TEST_F(Program, SmoothReportsANonFinitePose) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "far.glb", farPost()).ok());
  const auto smoothed = run({"smooth", "far.glb", "--clip", "bend", "--time", "0.5", "-o", "out.obj"});
  EXPECT_EQ(smoothed.status, 1);
  EXPECT_TRUE(smoothed.oneErrorLine()) << smoothed.error;
  EXPECT_NE(smoothed.error.find("\"knee\": cannot be written: its matrix has a number that is not finite"),
            std::string::npos)
      << smoothed.error;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.obj"));
  EXPECT_EQ(run({"smooth", "far.glb", "--clip", "bend", "--time", "0", "-o", "out.obj"}).status, 0);
  const auto drawn = run({"render", "far.glb", "--clip", "bend", "--time", "0.5", "--size", "64x64", "-o", "out.png"});
  EXPECT_EQ(drawn.status, 0) << drawn.error;
  EXPECT_NE(drawn.error.find("the bind pose is shown"), std::string::npos) << drawn.error;
}

TEST_F(Program, SmoothRefusesARigWithUnknownBones) {
  const auto rigWith = [&](const std::string& bone, const std::string& territory) {
    return R"({"format": "sinew-rig", "version": 1, "character": ")" + demo("demo.glb") +
           R"(", "groups": [{"name": "g"}], "primitives": [{"name": "wing", "bone": ")" + bone +
           R"(", "group": "g", "center": [0, 0, 0], "radii": [1, 1, 1])" + territory + "}]}";
  };
  ASSERT_TRUE(writeFileAtomically(folder_ / "bone.rig.json", rigWith("wing bone", "")).ok());
  ASSERT_TRUE(writeFileAtomically(folder_ / "land.rig.json", rigWith("head", R"(, "territory": ["sea"])")).ok());
  for (const auto& [file, place] : {std::pair{"bone.rig.json", "primitives[0].bone: "},
                                    std::pair{"land.rig.json", "primitives[0].territory[0]: "}}) {
    const auto result = run({"smooth", file, "-o", "out.obj"});
    EXPECT_EQ(result.status, 1) << file;
    EXPECT_TRUE(result.oneErrorLine()) << result.error;
    EXPECT_NE(result.error.find(place), std::string::npos) << result.error;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.obj"));
  }
}

TEST_F(Program, SmoothWritesAClosedSurfaceAndAReport) {
  const auto result = run({"smooth", demo("demo.rig.json"), "--clip", "Walk", "--time", "0.4", "--depth", "4", "-o",
                           "out.obj", "--report", "report.json"});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.out, "out.obj\n");
  EXPECT_EQ(result.error, "");
  const std::string obj = readWholeFile(folder_ / "out.obj", 1 << 26).value();
  const auto faces = facesOf(obj);
  EXPECT_TRUE(test::isClosed(faces));

  const auto report = Json::parse(readWholeFile(folder_ / "report.json", 1 << 20).value());
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->keys(),
            (std::vector<std::string>{"mode", "depth", "patch", "projection", "control_triangles", "refined_triangles",
                                      "refined_vertices", "implicit", "straddling", "normal", "primitives", "cliques",
                                      "guarded", "unwrapped", "unresolved", "residual_max", "seconds"}));
  EXPECT_EQ(report->at("depth").number(0), 4);
  EXPECT_EQ(report->at("refined_triangles").number(0), static_cast<double>(faces.size()));
  EXPECT_EQ(report->at("refined_triangles").number(0), 16 * report->at("control_triangles").number(0));
  EXPECT_EQ(report->at("implicit").number(0) + report->at("straddling").number(0) + report->at("normal").number(0),
            report->at("control_triangles").number(0));
  EXPECT_EQ(report->at("seconds").keys(),
            (std::vector<std::string>{"skin", "patch", "project", "folds", "normals", "total"}));
}

TEST_F(Program, SmoothAcceptsEveryModeAndPatch) {
  for (const char* mode : {"swell", "replace"}) {
    for (const char* patch : {"pn", "phong", "spherigon", "flat"}) {
      const auto result = run({"smooth", demo("demo.rig.json"), "--mode", mode, "--patch", patch, "--depth", "2", "-o",
                               "out.ply", "--report", "r.json"});
      ASSERT_EQ(result.status, 0) << result.error;
      const auto report = Json::parse(readWholeFile(folder_ / "r.json", 1 << 20).value());
      ASSERT_TRUE(report.ok());
      EXPECT_EQ(report->at("mode").text(""), mode);
      EXPECT_EQ(report->at("patch").text(""), patch);
      EXPECT_EQ(report->at("projection").text(""), "newton");
    }
  }
}

// The paper's searches are for comparison only; the setting in old rigs is ignored.
TEST_F(Program, SmoothSelectsTheProjectionMethod) {
  const std::string rig = demo("demo.rig.json");
  const auto surfaceBy = [&](const std::string& file, const char* projection) {
    const auto result =
        run({"smooth", file, "--projection", projection, "--depth", "2", "-o", "out.ply", "--report", "r.json"});
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_EQ(Json::parse(readWholeFile(folder_ / "r.json", 1 << 20).value())->at("projection").text(""), projection);
    return readWholeFile(folder_ / "out.ply", 1 << 26).value();
  };
  const std::string newton = surfaceBy(rig, "newton");
  ASSERT_EQ(run({"smooth", rig, "--depth", "2", "-o", "plain.ply"}).status, 0);
  EXPECT_EQ(readWholeFile(folder_ / "plain.ply", 1 << 26).value(), newton);
  for (const char* projection : {"bisection", "analytic"}) EXPECT_NE(surfaceBy(rig, projection), newton) << projection;
  std::filesystem::copy_file(demo("demo.glb"), folder_ / "demo.glb");
  std::string old = readWholeFile(rig, 1 << 20).value();
  old.replace(old.find("\"patch\""), 0, "\"projection\": \"bisection\", ");
  std::ofstream(folder_ / "old.rig.json") << old;
  ASSERT_EQ(run({"smooth", "old.rig.json", "--depth", "2", "-o", "old.ply"}).status, 0);
  EXPECT_EQ(readWholeFile(folder_ / "old.ply", 1 << 26).value(), newton);
}

TEST_F(Program, SmoothOfACharacterHasNoPrimitives) {
  const auto result = run({"smooth", demo("demo.glb"), "-o", "out.glb", "--report", "r.json"});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(Json::parse(readWholeFile(folder_ / "r.json", 1 << 20).value())->at("primitives").number(-1), 0);
}

TEST_F(Program, SmoothCreasesSplitOnlyNormals) {
  const auto lines = [&](const char* file, const std::string& word) {
    std::vector<std::string> found;
    std::istringstream text(readWholeFile(folder_ / file, 1 << 26).value());
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with(word + ' ')) found.push_back(line);
    }
    return found;
  };
  ASSERT_EQ(run({"smooth", demo("demo.glb"), "-o", "plain.obj"}).status, 0);
  ASSERT_EQ(run({"smooth", demo("demo.glb"), "--crease", "180", "-o", "smooth.obj"}).status, 0);
  ASSERT_EQ(run({"smooth", demo("demo.glb"), "--crease", "12.5", "-o", "sharp.obj"}).status, 0);
  for (const char* word : {"v", "vt", "vn", "f"}) EXPECT_EQ(lines("plain.obj", word), lines("smooth.obj", word));
  EXPECT_EQ(lines("plain.obj", "v"), lines("sharp.obj", "v"));
  EXPECT_GT(lines("sharp.obj", "vn").size(), lines("plain.obj", "vn").size());
  EXPECT_TRUE(test::isClosed(facesOf(readWholeFile(folder_ / "sharp.obj", 1 << 26).value())));
}

TEST_F(Program, CreaseAngleOutOfRangeIsABadCommandLine) {
  for (const char* verb : {"smooth", "render"}) {
    const std::string out = std::string(verb) == "smooth" ? "out.obj" : "out.png";
    for (const char* angle : {"181", "-1", "nan", "inf", "40deg", ""}) {
      const auto result = run({verb, demo("demo.glb"), "--crease", angle, "-o", out});
      EXPECT_EQ(result.status, 2) << angle;
      EXPECT_TRUE(result.oneErrorLine()) << result.error;
    }
  }
}

TEST_F(Program, SmoothAtTheSameTimeWritesTheSameBytes) {
  ASSERT_EQ(run({"smooth", demo("demo.rig.json"), "--clip", "Walk", "--time", "0.25", "-o", "a.glb"}).status, 0);
  ASSERT_EQ(run({"smooth", demo("demo.rig.json"), "--clip", "Walk", "--time", "0.25", "-o", "b.glb"}).status, 0);
  ASSERT_EQ(run({"smooth", demo("demo.rig.json"), "--clip", "Walk", "--time", "0.5", "-o", "c.glb"}).status, 0);
  const std::string a = readWholeFile(folder_ / "a.glb", 1 << 26).value();
  EXPECT_EQ(a, readWholeFile(folder_ / "b.glb", 1 << 26).value());
  EXPECT_NE(a, readWholeFile(folder_ / "c.glb", 1 << 26).value());
}

TEST_F(Program, SmoothWithAnUnknownClipListsTheKnownOnes) {
  const auto result = run({"smooth", demo("demo.glb"), "--clip", "Wlk", "-o", "out.obj"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(result.oneErrorLine());
  EXPECT_NE(result.error.find("\"Walk\", \"Idle\""), std::string::npos) << result.error;
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Program, SmoothPastTheEndWarns) {
  const auto result = run({"smooth", demo("demo.glb"), "--clip", "Walk", "--time", "99", "-o", "out.obj"});
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(result.oneErrorLine()) << result.error;
}

TEST_F(Program, SmoothNeverOverwritesItsInput) {
  std::filesystem::copy_file(demo("demo.glb"), folder_ / "demo.glb");
  const std::string before = readWholeFile(folder_ / "demo.glb", 1 << 26).value();
  const auto result = run({"smooth", "demo.glb", "-o", "./demo.glb"});
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(result.oneErrorLine()) << result.error;
  EXPECT_EQ(run({"smooth", "demo.glb", "-o", "out.obj", "--report", "demo.glb"}).status, 2);
  EXPECT_EQ(readWholeFile(folder_ / "demo.glb", 1 << 26).value(), before);
}

TEST_F(Program, SmoothIntoAMissingFolderIsStatus1) {
  const auto result = run({"smooth", demo("demo.glb"), "-o", "absent/out.ply"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(result.oneErrorLine()) << result.error;
  EXPECT_NE(result.error.find("absent/out.ply: cannot be written"), std::string::npos) << result.error;
}

}  // namespace
}  // namespace sinew
