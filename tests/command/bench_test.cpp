// tests/command/bench_test.cpp: `sinew bench` measures every figure. Times are not checked.
#include "core/files/json/json.h"
#include "tests/command/program.h"

namespace sinew::test {
namespace {

class Bench : public Program {};

/// Fractions and ratios of one mode exist and are in range.
void expectFigures(const Json& figures) {
  const std::string what = figures.dump();
  EXPECT_EQ(figures.at("scene").text(""), "humanoid");
  for (const char* speedups : {"reference_over_optimised", "reference_over_optimised_projection"}) {
    EXPECT_TRUE(figures.at(speedups).find("sse4")) << what;
    EXPECT_FALSE(figures.at(speedups).find("scalar")) << what;
    for (const Json& set : figures.at(speedups).children) {
      EXPECT_EQ(set.keys(), (std::vector<std::string>{"cold", "warm_60hz", "warm_20hz", "cut"}));
      for (const Json& ratio : set.children) EXPECT_GT(ratio.number(0), 0.0) << what;
    }
  }
  for (const char* positive : {"with_over_without", "ns_per_vertex_floor", "frame_seconds"}) {
    EXPECT_GT(figures.at(positive).number(0), 0.0) << positive;
  }
  for (const char* number : {"ns_per_projected_vertex", "exponent_vertices", "exponent_primitives"}) {
    EXPECT_EQ(figures.at(number).kind, Json::Kind::kNumber) << number;
  }
  EXPECT_EQ(figures.at("nan").number(1), 0.0);
  EXPECT_GE(figures.at("within_1e-4H").number(0), 0.99);
  EXPECT_LE(figures.at("within_1e-4H").number(2), 1.0);
  EXPECT_LE(figures.at("uncertified_share").number(2), 1.0);
  EXPECT_TRUE(figures.find("draw_seconds") && figures.find("upload_seconds")) << "null where there is no display";
}

TEST_F(Bench, OneRunMeasuresEverything) {
  const auto file = folder_ / "whole.json";
  const Outcome outcome = run({"bench", demo("humanoid.rig.json"), "--rounds", "1", "--json", file.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "") << "progress is for terminals";
  for (const char* part :
       {"\nswell: humanoid", "\nreplace: humanoid", "\nTable 1", "\nTable 2", "exponent of muscles"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
  const auto parsed = Json::parse(readWholeFile(file, 1 << 20).value());
  ASSERT_TRUE(parsed.ok());
  const Json& json = parsed.value();
  EXPECT_EQ(json.at("rounds").number(0), 1.0);
  EXPECT_GE(json.at("machine").at("threads").number(0), 1.0);
  expectFigures(json.at("swell"));
  expectFigures(json.at("replace"));
  for (const char* mode : {"swell", "replace"}) {
    EXPECT_LE(json.at(mode).at("uncertified_share").number(1), 0.05) << mode;
  }
  ASSERT_EQ(json.at("table1").items().size(), 2u * 6u * 3u * 2u) << "modes x depths x projections x culling";
  for (const Json& row : json.at("table1").items()) {
    EXPECT_GT(row.at("fps").number(0), 0.0) << row.dump();
    EXPECT_EQ(row.at("paper_fps").isNull(), row.at("projection").text("") == "newton") << row.dump();
  }
  const std::vector<Json> table2 = json.at("table2").items();
  ASSERT_EQ(table2.size(), 2u * 4u) << "modes x depths";
  const double triangles = table2[0].at("n").number(0) / 4.0;
  for (const Json& row : table2) {
    const double depth = row.at("depth").number(0);
    EXPECT_EQ(row.at("n").number(0), triangles * depth * depth);
    EXPECT_EQ(row.at("n").number(0), row.at("paper_n").number(1)) << "the paper's humanoid has as many";
    EXPECT_GT(row.at("paper_fps").number(0), 0.0);
  }
}

TEST_F(Bench, RigAfterJsonIsMeasuredAndNotOverwritten) {
  // The word after --json may be meant as the input: an existing rig is never overwritten.
  std::filesystem::copy_file(demo("demo.rig.json"), folder_ / "mine.rig.json");
  std::filesystem::copy_file(demo("demo.glb"), folder_ / "demo.glb");
  const std::string before = readWholeFile(folder_ / "mine.rig.json", 1 << 20).value();
  const Outcome outcome = run({"bench", "--rounds", "1", "--json", "mine.rig.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(readWholeFile(folder_ / "mine.rig.json", 1 << 20).value(), before);
  const auto json = Json::parse(outcome.out);
  ASSERT_TRUE(json.ok()) << "JSON alone on stdout";
  EXPECT_EQ(json.value().at("swell").at("scene").text(""), "mine");
  for (const char* table : {"table1", "table2"}) {
    for (const Json& row : json.value().at(table).items()) {
      EXPECT_TRUE(row.at("paper_fps").isNull()) << "the paper has no such character: " << row.dump();
    }
  }
}

TEST_F(Bench, UnreadableInputAndUnwritableOutputAreRefusedImmediately) {
  const auto json = folder_ / "whole.json";
  for (const char* file : {"no such file.glb", "nonsense", "stages"}) {
    const Outcome outcome = run({"bench", demo("demo.rig.json"), file, "--json", json.string()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.oneErrorLine()) << outcome.error;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(json));
  }
  const Outcome outcome = run({"bench", "--json", (folder_ / "no such folder" / "whole.json").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.oneErrorLine()) << outcome.error;
  EXPECT_EQ(outcome.out, "");
}

TEST_F(Bench, BadCommandLineIsStatus2) {
  for (const auto& arguments : {std::vector<std::string>{"bench", "--rounds", "0"}, {"bench", "--frames", "3"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.oneErrorLine()) << outcome.error;
  }
}

}  // namespace
}  // namespace sinew::test
