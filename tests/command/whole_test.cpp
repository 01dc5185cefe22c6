// tests/command/whole_test.cpp: report of a `sinew bench` run from made-up figures, and the paper's figures.
#include "app/command/whole.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

namespace sinew::app {
namespace {

Whole madeUp() {
  Whole whole;
  whole.machine = {"Some processor", {"scalar", "avx2"}, 2, 0.5, "GCC 1", "Release", false, "1.2.3"};
  whole.rounds = 4;
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    ModeFigures figures;
    figures.mode = mode;
    figures.scene = "fox";
    figures.speedups.rows = {{"avx2", {11.5, 12.5, 13.5, 14.5}, {21.5, 22.5, 23.5, 24.5}}};
    figures.speedups.agreement = {0.75, 0.125, 3, 1000};
    figures.cost = {3.5, 15.25, 2.25, 0.004};
    figures.exponentVertices = 0.9;
    figures.exponentPrimitives = 0.35;
    figures.threads = {1.25, 1.75};
    whole.modes.push_back(figures);
  }
  whole.modes[0].drawing = DrawCost{0.02, 0.001};
  whole.table1 = {{"fox", SurfaceMode::kSwell, 2, ProjectionKind::kAnalytic, true, 0.01, 100.0, 123.0},
                  {"fox", SurfaceMode::kSwell, 2, ProjectionKind::kNewton, false, 0.005, 200.0, std::nullopt}};
  whole.table2 = {{"fox", SurfaceMode::kReplace, 3, 900, 452, 0.01, 100.0, std::nullopt, std::nullopt}};
  return whole;
}

TEST(WholeBench, JsonHasEveryFigure) {
  const Json json = jsonOf(madeUp());
  EXPECT_EQ(json.keys(), (std::vector<std::string>{"machine", "rounds", "swell", "replace", "table1", "table2"}));
  const Json& swell = json.at("swell");
  EXPECT_EQ(swell.at("reference_over_optimised").at("avx2").at("cold").number(0), 11.5);
  EXPECT_EQ(swell.at("reference_over_optimised").at("avx2").at("warm_60hz").number(0), 12.5);
  EXPECT_EQ(swell.at("reference_over_optimised").at("avx2").at("warm_20hz").number(0), 13.5);
  EXPECT_EQ(swell.at("reference_over_optimised").at("avx2").at("cut").number(0), 14.5);
  EXPECT_EQ(swell.at("reference_over_optimised_projection").at("avx2").at("cut").number(0), 24.5);
  EXPECT_EQ(swell.at("with_over_without").number(0), 3.5);
  EXPECT_EQ(swell.at("ns_per_projected_vertex").number(0), 15.25);
  EXPECT_EQ(swell.at("ns_per_vertex_floor").number(0), 2.25);
  EXPECT_EQ(swell.at("exponent_vertices").number(0), 0.9);
  EXPECT_EQ(swell.at("exponent_primitives").number(0), 0.35);
  EXPECT_EQ(swell.at("threads2_single").number(0), 1.25);
  EXPECT_EQ(swell.at("threads2_crowd").number(0), 1.75);
  EXPECT_EQ(swell.at("within_1e-4H").number(0), 0.75);
  EXPECT_EQ(swell.at("nan").number(0), 3.0);
  EXPECT_EQ(swell.at("uncertified_share").number(0), 0.125);
  EXPECT_EQ(swell.at("draw_seconds").number(0), 0.02);
  EXPECT_EQ(swell.at("upload_seconds").number(0), 0.001);
  EXPECT_EQ(json.at("replace").keys(), swell.keys());
  EXPECT_TRUE(json.at("replace").at("draw_seconds").isNull()) << "no display";
  EXPECT_TRUE(json.at("replace").at("upload_seconds").isNull());
  EXPECT_EQ(json.at("table1").items()[0].at("paper_fps").number(0), 123.0);
  EXPECT_TRUE(json.at("table1").items()[1].at("paper_fps").isNull());
  EXPECT_EQ(json.at("table2").items()[0].at("n").number(0), 900.0);
  EXPECT_TRUE(json.at("table2").items()[0].at("paper_n").isNull());
  EXPECT_EQ(json.at("machine").at("threads").number(0), 2.0);
  EXPECT_EQ(json.at("machine").at("instruction_sets").items().size(), 2u);
}

TEST(WholeBench, TextHasTheFiguresAndNamesMissingOnes) {
  const std::string text = textOf(madeUp());
  for (const char* part : {"Some processor, 2 threads, load 0.5", "swell: fox", "replace: fox", "12.50", "24.50",
                           "75.000 %", "[123]", "20.00", "no display", "12.500 %"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
}

TEST(WholeBench, PaperFiguresAreConsistent) {
  for (const PaperSizes& sizes : kPaperTable2) {
    EXPECT_EQ(sizes.humanoidTriangles, 592 * sizes.depth * sizes.depth);
    EXPECT_EQ(sizes.horseTriangles, 412 * sizes.depth * sizes.depth);
    const auto rates = std::find_if(kPaperTable1.begin(), kPaperTable1.end(),
                                    [&](const PaperRates& each) { return each.depth == sizes.depth; });
    ASSERT_NE(rates, kPaperTable1.end());
    EXPECT_EQ(rates->bisectionCulled, sizes.humanoidFps) << "the second table is by binary search with culling";
  }
  for (const PaperRates& rates : kPaperTable1) {
    EXPECT_LT(rates.analytic, rates.analyticCulled);
    EXPECT_LT(rates.bisection, rates.bisectionCulled);
    EXPECT_LT(rates.analytic, rates.bisection);
  }
}

TEST(WholeBench, ProcessorNameIsReadFromTheSystem) {
  std::istringstream usual("processor\t: 0\nmodel name\t: A fast one @ 3 GHz \nmodel name\t: Another\n");
  EXPECT_EQ(processorName(usual), "A fast one @ 3 GHz");
  std::istringstream none("processor : 0\nmodel name\t:\n");
  EXPECT_EQ(processorName(none), "unknown");
  EXPECT_GE(machineHere().threads, 1);
  EXPECT_EQ(machineHere().instructionSets.front(), "scalar");
}

}  // namespace
}  // namespace sinew::app
