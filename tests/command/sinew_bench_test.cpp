// tests/command/sinew_bench_test.cpp: each part of sinew_bench measures every figure. Times are not checked.
#include "core/files/json/json.h"
#include "tests/command/program.h"

namespace sinew::test {
namespace {

class SinewBench : public Program {
 protected:
  Outcome run(const std::vector<std::string>& arguments) const { return Program::run(arguments, SINEW_BENCH); }
};

TEST_F(SinewBench, FieldMeasuresSpheresAndEllipsoids) {
  const Outcome outcome = run({"field", "--rounds", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("value and gradient"), std::string::npos) << outcome.out;
}

TEST_F(SinewBench, DragMeasuresHistoryLengthAndMuscleCount) {
  const auto file = folder_ / "drag.json";
  const Outcome outcome = run({"drag", demo("demo.glb"), "--frames", "3", "--rounds", "1", "--json", file.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("x first"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\ndemo "), std::string::npos) << outcome.out;
  const auto json = Json::parse(readWholeFile(file, 1 << 20).value());
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json.value().at("frames").number(0), 3.0);
  const std::vector<Json> rows = json.value().at("rows").items();
  ASSERT_EQ(rows.size(), 3u);
  const auto number = [&](std::size_t row, const char* key) { return rows[row].at(key).number(-1.0); };
  const double expected[3][2] = {{5, 10}, {200, 10}, {5, 60}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    EXPECT_EQ(number(row, "undo_steps"), expected[row][0]);
    EXPECT_EQ(number(row, "untouched"), expected[row][1]);
    EXPECT_GT(number(row, "prepare_seconds"), 0.0);
    EXPECT_GT(number(row, "frame_seconds"), number(row, "prepare_seconds"));
    EXPECT_GT(number(row, "frame_ratio"), 0.0);
  }
  EXPECT_EQ(number(0, "frame_ratio"), 1.0);
  EXPECT_GT(number(0, "vertices"), 100.0);
  EXPECT_EQ(number(1, "vertices"), number(0, "vertices")) << "history moves no skin";
  EXPECT_GT(number(2, "vertices"), number(0, "vertices")) << "more muscles move more";
}

TEST_F(SinewBench, SettleMeasuresLevelsAfterADrag) {
  const auto file = folder_ / "settle.json";
  const Outcome outcome =
      run({"settle", demo("demo.rig.json"), "--frames", "2", "--rounds", "1", "--json", file.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("\ndemo "), std::string::npos) << outcome.out;
  const auto json = Json::parse(readWholeFile(file, 1 << 20).value());
  ASSERT_TRUE(json.ok());
  const std::vector<Json> rows = json.value().at("rows").items();
  ASSERT_EQ(rows.size(), 2u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].at("threads").number(0), static_cast<double>(i + 1));
    EXPECT_EQ(rows[i].at("muscles").number(0), 2.0);
    EXPECT_GT(rows[i].at("vertices").number(0), 100.0);
    for (const char* key : {"drag_seconds", "drag_prepare_seconds", "settled_seconds", "settled_cpu_seconds"}) {
      EXPECT_GT(rows[i].at(key).number(0), 0.0) << key;
    }
  }
}

TEST_F(SinewBench, StagesAreFractionsOfTheFrame) {
  const auto file = folder_ / "stages.json";
  const Outcome outcome =
      run({"stages", demo("demo.rig.json"), "--frames", "2", "--rounds", "3", "--json", file.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("\ndemo "), std::string::npos) << outcome.out;
  const auto json = Json::parse(readWholeFile(file, 1 << 20).value());
  ASSERT_TRUE(json.ok());
  const std::vector<Json> rows = json.value().at("rows").items();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].at("depth").number(0), 3.0);
  EXPECT_EQ(rows[1].at("depth").number(0), 5.0);
  EXPECT_EQ(rows[2].at("depth").number(-1.0), 0.0) << "adaptive";
  EXPECT_GT(rows[1].at("vertices").number(0), rows[0].at("vertices").number(0));
  for (const Json& row : rows) {
    EXPECT_GT(row.at("frame_seconds").number(0), 0.0);
    for (const char* stage : {"skin", "patch", "project", "folds", "normals"}) {
      const double share = row.at("shares").at(stage).number(-1.0);
      EXPECT_GT(share, 0.0) << stage;
      EXPECT_LT(share, 1.0) << stage;
    }
  }
}

TEST_F(SinewBench, ExportsMeasuresEveryKind) {
  const auto file = folder_ / "exports.json";
  const Outcome outcome =
      run({"exports", demo("tangle.rig.json"), "--frames", "2", "--rounds", "1", "--json", file.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("\ntangle "), std::string::npos) << outcome.out;
  const auto json = Json::parse(readWholeFile(file, 1 << 20).value());
  ASSERT_TRUE(json.ok());
  const std::vector<Json> rows = json.value().at("rows").items();
  ASSERT_EQ(rows.size(), 6u);
  for (const Json& row : rows) {
    EXPECT_GT(row.at("vertices").number(0), 8000.0) << row.dump() << ": some stand for all";
    EXPECT_GT(row.at("seconds").number(0), 0.0) << row.dump();
    EXPECT_GT(row.at("smoothings").number(0), 0.0) << row.dump();
  }
  const auto error = [&](std::size_t row) { return rows[row].at("error_rms").number(-1.0); };
  EXPECT_LT(error(1), error(0)) << "refitted comes nearer than transferred";
  EXPECT_LT(error(2), error(1)) << "and helpers nearer still";
}

TEST_F(SinewBench, PopsMeasuresOwnLaidAndRandomMuscles) {
  const auto file = folder_ / "pops.json";
  const Outcome outcome = run(
      {"pops", demo("demo.rig.json"), demo("demo.glb"), "--frames", "12", "--rounds", "2", "--json", file.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("definition"), std::string::npos) << outcome.out;
  const auto json = Json::parse(readWholeFile(file, 1 << 20).value());
  ASSERT_TRUE(json.ok());
  const std::vector<Json> rows = json.value().at("rows").items();
  ASSERT_EQ(rows.size(), 6u);
  const char* laid[] = {"own", "own", "tool", "random", "tool", "random"};
  const char* detail[] = {"uniform", "adaptive", "uniform", "uniform", "adaptive", "adaptive"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].at("laid").text(""), laid[i]);
    EXPECT_EQ(rows[i].at("detail").text(""), detail[i]);
    EXPECT_EQ(rows[i].at("rigs").number(0), rows[i].at("laid").text("") == "random" ? 2.0 : 1.0);
    EXPECT_GE(rows[i].at("frames").number(0), 12.0);
    EXPECT_GE(rows[i].at("steps").number(-1.0), rows[i].at("pops").number(-1.0));
    EXPECT_GT(rows[i].at("largest_step").number(0), 0.0);
    EXPECT_GT(rows[i].at("definition").number(0), 0.1);
  }
}

TEST_F(SinewBench, DetailComparesUniformAndAdaptive) {
  const auto file = folder_ / "detail.json";
  const Outcome outcome =
      run({"detail", demo("demo.rig.json"), "--frames", "1", "--rounds", "1", "--json", file.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("rooted"), std::string::npos) << outcome.out;
  const auto json = Json::parse(readWholeFile(file, 1 << 20).value());
  ASSERT_TRUE(json.ok());
  const std::vector<Json> rows = json.value().at("rows").items();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].at("detail").text(""), "depth 3");
  EXPECT_EQ(rows[1].at("detail").text(""), "adaptive");
  for (const char* where : {"bind", "clips"}) {
    const auto figure = [&](std::size_t row, const char* name) { return rows[row].at(where).at(name).number(-1.0); };
    EXPECT_LT(figure(1, "most"), figure(0, "most"));
    EXPECT_LE(figure(1, "of_thousand"), figure(1, "most"));
    EXPECT_GT(figure(1, "within"), figure(0, "within"));
    EXPECT_LE(figure(1, "within"), 1.0);
  }
  EXPECT_GT(rows[1].at("rooted").number(0), rows[0].at("rooted").number(1));
}

TEST_F(SinewBench, AnimationIsMeasuredBesideSkinning) {
  const Outcome outcome = run({"animation", demo("demo.glb"), "--rounds", "2"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  for (const char* what : {"\nskinning, vertices", "\nlines", "\ndrivers"}) {
    EXPECT_NE(outcome.out.find(what), std::string::npos) << outcome.out;
  }
}

TEST_F(SinewBench, BadInputIsStatus1AndBadCommandLineStatus2) {
  for (const char* part : {"animation", "detail", "drag", "pops", "settle", "stages"}) {
    const Outcome absent = run({part, "no such file.glb"});
    EXPECT_EQ(absent.status, 1);
    EXPECT_TRUE(absent.oneErrorLine()) << absent.error;
  }
  for (const auto& arguments : {std::vector<std::string>{},
                                {"no such part"},
                                {"drag", "--json"},
                                {"field", demo("demo.glb")},
                                {"animation", demo("demo.glb"), demo("demo.glb")},
                                {"--rounds", "3", "stages"},
                                {"stages", "--rounds", "0"},
                                {"drag", "--frames", "0"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.oneErrorLine()) << outcome.error;
  }
}

}  // namespace
}  // namespace sinew::test
