// tests/command/export_error_test.cpp: export error, also between keys, and its map.
#include <algorithm>
#include <array>
#include <cstring>

#include "core/files/json/json.h"
#include "tests/command/program.h"

namespace sinew::test {
namespace {

class ExportError : public Program {
 protected:
  [[nodiscard]] Json report(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "export");
    arguments.emplace_back("--json");
    const Outcome done = run(arguments);
    EXPECT_EQ(done.status, 0) << done.error;
    const auto json = Json::parse(done.out);
    EXPECT_TRUE(json.ok()) << done.out;
    return json ? json.value() : Json();
  }

  static void expectPlace(const Json& figures, const std::string& clip, double duration) {
    const Json& place = figures.at("farthest");
    EXPECT_EQ(place.at("clip").text(""), clip) << figures.dump();
    EXPECT_GE(place.at("time").number(-1), 0.0);
    EXPECT_LE(place.at("time").number(99), duration + 1e-6);
    EXPECT_GE(place.at("vertex").number(-1), 0.0);
    EXPECT_NE(place.at("bone").text(""), "");
  }
};

TEST_F(ExportError, IsReportedForEveryClipAtAndBetweenKeys) {
  const Json json = report({demo("demo.rig.json"), "--joints", "4", "--depth", "2", "-o", "x.glb"});
  const Json& error = json.at("error_percent_of_height");
  ASSERT_EQ(error.at("clips").items().size(), 2u);
  int poses = 0;
  for (const Json& clip : error.at("clips").items()) {
    const bool isWalk = clip.at("name").text("") == "Walk";
    const Json& between = clip.at("between_keys");
    EXPECT_GT(between.at("poses").number(0), clip.at("poses").number(0)) << "47 a second beside 30";
    for (const Json* figures : {&clip, &between}) {
      expectPlace(*figures, clip.at("name").text(""), isWalk ? 1.2 : 3.2);
      EXPECT_LE(figures->at("rms").number(1), figures->at("percentile_99_9").number(0));
      EXPECT_LE(figures->at("percentile_99_9").number(1), figures->at("max").number(0));
    }
    poses += static_cast<int>(between.at("poses").number(0));
  }
  EXPECT_EQ(error.at("between_keys").at("poses").number(0), poses);
}

TEST_F(ExportError, IsSimilarBetweenKeysForSkinnedExports) {
  const Json json = report({demo("demo.rig.json"), "--as", "skinned", "--clip", "Walk", "--depth", "1", "-o", "x.glb"});
  const Json& clip = json.at("error_percent_of_height").at("clips").items().at(0);
  EXPECT_NEAR(clip.at("between_keys").at("rms").number(0), clip.at("rms").number(9), 0.05 * clip.at("rms").number(9));
}

TEST_F(ExportError, BetweenBakedFramesDecreasesWithSubsteps) {
  const std::vector<std::string> baked{
      demo("demo.rig.json"), "--as", "baked", "--clip", "Walk", "--fps", "3", "--depth", "1", "-o", "x.glb"};
  const Json coarse = report(baked);
  std::vector<std::string> more = baked;
  more.insert(more.end(), {"--substeps", "8"});
  const Json fine = report(more);
  const auto figures = [](const Json& json, const char* which) {
    return json.at("error_percent_of_height").at(which).at("max").number(-1);
  };
  EXPECT_LE(figures(coarse, "baked"), 0.1);
  EXPECT_GT(figures(coarse, "between_frames"), 0.1) << "three frames a second are too few";
  expectPlace(coarse.at("error_percent_of_height").at("between_frames"), "Walk", 1.2);
  EXPECT_LE(figures(fine, "baked"), 0.1);
  EXPECT_LT(figures(fine, "between_frames"), 0.5 * figures(coarse, "between_frames"));
  EXPECT_EQ(fine.at("substeps").number(0), 8);
  EXPECT_GT(fine.at("frames").number(0), 5 * coarse.at("frames").number(0));
}

TEST_F(ExportError, IsInTheTableWithAHintForSparseFrames) {
  const Outcome table = run({"export", demo("demo.rig.json"), "--as", "baked", "--clip", "Walk", "--fps", "3",
                             "--depth", "1", "-o", "x.glb"});
  EXPECT_EQ(table.status, 0) << table.error;
  EXPECT_NE(table.out.find("\n    between frames "), std::string::npos) << table.out;
  EXPECT_NE(table.out.find(" s, vertex "), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("--substeps 2 bakes"), std::string::npos) << table.out;
}

/// The map, parsed independently of the writer.
struct Map {
  std::vector<float> errors;
  std::vector<std::array<unsigned char, 3>> colors;
  std::size_t faces = 0;
};

Map mapOf(const std::string& bytes) {
  Map map;
  const auto count = [&](const std::string& word) {
    return static_cast<std::size_t>(std::atoll(bytes.c_str() + bytes.find(word) + word.size()));
  };
  const std::size_t vertices = count("element vertex ");
  map.faces = count("element face ");
  const std::string end = "end_header\n";
  const char* at = bytes.data() + bytes.find(end) + end.size();
  for (std::size_t v = 0; v < vertices; ++v, at += 19) {
    float error = 0.0f;
    std::memcpy(&error, at + 15, sizeof error);
    map.errors.push_back(error);
    std::array<unsigned char, 3> color{};
    std::memcpy(color.data(), at + 12, 3);
    map.colors.push_back(color);
  }
  EXPECT_EQ(at + 13 * map.faces, bytes.data() + bytes.size()) << "nothing but vertices and triangles";
  return map;
}

TEST_F(ExportError, MapHoldsTheLargestDistanceOfEveryVertex) {
  for (const bool baked : {false, true}) {
    std::vector<std::string> job{
        demo("demo.rig.json"), "--as",   baked ? "baked" : "skinned", "--clip", "Walk", "--depth", "1", "-o", "x.glb",
        "--error-map",         "map.ply"};
    const Json error = report(job).at("error_percent_of_height");
    const Json& keys = baked ? error.at("baked") : error.at("all_clips");
    const Json& between = baked ? error.at("between_frames") : error.at("between_keys");
    const Map map = mapOf(readWholeFile(folder_ / "map.ply", 1 << 26).value());
    ASSERT_FALSE(map.errors.empty());
    EXPECT_GT(map.faces, map.errors.size()) << "a closed mesh has twice as many triangles as vertices";
    const Json& farthest = between.at("max").number(0) > keys.at("max").number(0) || baked ? between : keys;
    const auto vertex = static_cast<std::size_t>(farthest.at("farthest").at("vertex").number(0));
    const auto most = std::ranges::max_element(map.errors);
    EXPECT_NEAR(*most, farthest.at("max").number(0), 1e-4 * *most);
    EXPECT_EQ(static_cast<std::size_t>(most - map.errors.begin()), vertex);
    const auto least = static_cast<std::size_t>(std::ranges::min_element(map.errors) - map.errors.begin());
    EXPECT_GT(map.colors[least][1], map.colors[vertex][1]) << "light where it is near, dark red where it is far";
  }
}

TEST_F(ExportError, InvalidMapOptionsAreRefused) {
  const std::string rig = demo("demo.rig.json");
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"export", rig, "-o", "x.glb", "--error-map", "map.obj"},
        {"export", rig, "--as", "baked", "--clip", "Walk", "-o", "x.pc2", "--error-map", "map.ply"},
        {"export", rig, "--as", "skinned", "-o", "x.glb", "--substeps", "2"},
        {"export", rig, "--as", "baked", "--clip", "Walk", "-o", "x.pc2", "--substeps", "2"},
        {"export", rig, "--as", "baked", "--clip", "Walk", "-o", "x.glb", "--substeps", "0"}}) {
    const Outcome refused = run(wrong);
    EXPECT_EQ(refused.status, 2) << refused.error;
    EXPECT_TRUE(refused.oneErrorLine()) << refused.error;
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
  }
}

}  // namespace
}  // namespace sinew::test
