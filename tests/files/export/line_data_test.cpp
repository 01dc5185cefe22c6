// tests/files/export/line_data_test.cpp: line data for runtimes, next to its bind pose. tests/export/runtime_test.py
// poses with it.

#include "core/files/export/out_skins.h"

#include <algorithm>
#include <fstream>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

/// The JSON of a .gltf.
ordered_json jsonOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  return ordered_json::parse(in);
}

glm::dvec3 vectorOf(const ordered_json& list, std::size_t from = 0) {
  return {list.at(from).get<double>(), list.at(from + 1).get<double>(), list.at(from + 2).get<double>()};
}

/// The post with a muscle between its two bones; its skin has extras.
class LineData : public ::testing::Test {
 protected:
  ordered_json exported(const ordered_json& extras, SkinnedExportSettings settings = {}) {
    Post post = makePost();
    if (!extras.is_null()) post.file.json["skins"][0]["extras"] = extras;
    scene_.characterFile = folder_.path() / "post.glb";
    std::ofstream(scene_.characterFile, std::ios::binary) << post.file.glb();
    scene_.character = importGltf(scene_.characterFile).value();
    MuscleLine line;
    line.name = "long";
    line.origin = {"hip", {0.3f, 0.2f, 0.5f}, {}};
    line.insertion = {"knee", {0.2f, 0.6f, 0.6f}, {}};
    line.via = LineAnchor{"hip", {0.3f, 0.9f, 0.8f}, {}};
    line.settings.rest = 1.1f;
    line.settings.pivot = 0.7f;
    scene_.rig = {};
    scene_.rig.groups.push_back({"all", {}});
    Primitive muscle = ellipsoidAt(*scene_.character, "belly", "hip", "all", {0.25f, 0.8f, 0.5f}, glm::vec3(0.15f));
    muscle.line = line.name;
    scene_.rig.lines.push_back(line);
    scene_.rig.primitives.push_back(muscle);
    const auto file = folder_.path() / "out.gltf";
    const auto report = scene_.writeQuickly(file, settings);
    EXPECT_TRUE(report.ok()) << report.error().text();
    left_ = report->left;
    return jsonOf(file);
  }

  static SkinnedExportSettings helpers(JointScale scale) {
    SkinnedExportSettings settings;
    settings.joints = ExportJoints::kHelpers;
    settings.jointScale = scale;
    return settings;
  }

  TemporaryFolder folder_;
  ExportScene scene_;
  std::vector<std::string> left_;
};

TEST_F(LineData, PlacesTheJointRelativeToTheOrigin) {
  for (const JointScale scale : {JointScale::kFull, JointScale::kUniform, JointScale::kNone}) {
    const ordered_json file = exported({{"mine", 3}}, helpers(scale));
    const ordered_json& extras = file["skins"][0]["extras"];
    EXPECT_EQ(extras["mine"], 3);
    ASSERT_EQ(extras["sinew"]["version"], 1);
    ASSERT_EQ(extras["sinew"]["lines"].size(), 1u);
    const ordered_json& line = extras["sinew"]["lines"][0];
    EXPECT_EQ(line["name"], "long");
    EXPECT_EQ(line["origin"]["node"], 1);
    EXPECT_EQ(line["insertion"]["node"], 2);
    EXPECT_EQ(line["via"]["node"], 1);
    ASSERT_FALSE(line["joints"].empty());
    // The hip's space is the world's in the bind pose.
    const ordered_json& frame = line["origin"]["frame"];
    const glm::dmat3 axes(vectorOf(frame), vectorOf(frame, 3), vectorOf(frame, 6));
    const glm::dvec3 origin = vectorOf(line["origin"]["point"]);
    const glm::dvec3 insertion = glm::dvec3(0.0, 1.0, 0.0) + vectorOf(line["insertion"]["point"]);
    EXPECT_LT(glm::distance(axes[1], glm::normalize(insertion - origin)), 1e-6);
    EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-6);
    const double restLength = line["length"].get<double>() * line["rest"].get<double>();
    const glm::dvec3 start =
        origin + line["tendons"][0].get<double>() * restLength * axes[1] - line["depth"].get<double>() * axes[2];
    for (const ordered_json& joint : line["joints"]) {
      const ordered_json& node = file["nodes"][joint["node"].get<std::size_t>()];
      EXPECT_LT(glm::distance(start + axes * vectorOf(joint["at"]), vectorOf(node["translation"])), 1e-6);
      const auto& bound = file["skins"][0]["joints"];
      EXPECT_NE(std::ranges::find(bound, joint["node"]), bound.end());
    }
  }
}

TEST_F(LineData, ExistsOnlyWithLineJoints) {
  EXPECT_FALSE(exported(nullptr)["skins"][0].contains("extras"));
  SkinnedExportSettings none = helpers(JointScale::kFull);
  none.helpers = 0;
  EXPECT_FALSE(exported(nullptr, none)["skins"][0].contains("extras"));
  EXPECT_TRUE(exported(nullptr, helpers(JointScale::kFull))["skins"][0].contains("extras"));
}

TEST_F(LineData, KeepsExtrasThatAreNotAnObject) {
  const ordered_json file = exported("a text", helpers(JointScale::kFull));
  EXPECT_EQ(file["skins"][0]["extras"], "a text");
  EXPECT_TRUE(std::ranges::any_of(left_, [](const std::string& line) { return line.starts_with("line data"); }));
  exported(nullptr, helpers(JointScale::kFull));
  EXPECT_TRUE(std::ranges::none_of(left_, [](const std::string& line) { return line.starts_with("line data"); }));
}

}  // namespace
}  // namespace sinew::test
