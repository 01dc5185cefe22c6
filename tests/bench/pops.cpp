// tests/bench/pops.cpp: how often the skin steps far within a frame, and how often at once, by who laid the muscles.
#include <cstdio>

#include "tests/bench/parts.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/pops.h"
#include "tests/tools/laid_muscles.h"

namespace sinew::app {
namespace {

/// One way to lay muscles on one character.
struct PopsRow {
  std::string scene;
  const char* laid = "";
  int rigs = 0;
  test::Pops pops;
};

Result<std::vector<PopsRow>> measurePops(const BenchScene& scene, bool isRig, const Effort& effort) {
  std::vector<PopsRow> rows;
  if (isRig)
    return std::vector{PopsRow{scene.name, "own", 1, test::countPops(scene.character, scene.rig, effort.frames)}};
  progress("muscles by the tool's defaults");
  const Rig laid = test::layMuscles(scene.character);
  rows.push_back({scene.name, "tool", 1, test::countPops(scene.character, laid, effort.frames)});
  PopsRow random{scene.name, "random", effort.rounds, {}};
  for (int i = 1; i <= effort.rounds; ++i) {
    progress("random muscles " + std::to_string(i) + " of " + std::to_string(effort.rounds));
    const Rig rig = test::randomRig(*scene.character, test::kShortReach, static_cast<std::uint64_t>(i));
    random.pops.add(test::countPops(scene.character, rig, effort.frames));
  }
  rows.push_back(random);
  return rows;
}

std::string tableOf(const std::vector<PopsRow>& rows) {
  std::string table =
      "Every clip at 60 frames a second. A step: a vertex moves by more than 0.5 % H from one frame to the next "
      "against\n"
      "the patch under it. A pop: more than 0.15 % H of that within its fastest 26 microseconds. Largest in % H a "
      "frame.\n"
      "Definition: degrees that muscles turn normals, mean. Backs: pixels, every 15th frame from 14 sides, beyond the "
      "bare\n"
      "skin's. Muscles: the file's own, 16 by the tool's defaults, 24 of short reach at random.\n"
      "\n"
      "scene             muscles  rigs  frames     steps  largest      pops  largest  definition  backs\n";
  char line[160];
  for (const PopsRow& row : rows) {
    std::snprintf(line, sizeof line, "%-16.40s  %-7s  %4d  %6d  %8lld  %7.2f  %8lld  %7.2f  %10.2f  %5lld\n",
                  row.scene.c_str(), row.laid, row.rigs, row.pops.frames, row.pops.steps,
                  100.0 * static_cast<double>(row.pops.largestStep), row.pops.pops,
                  100.0 * static_cast<double>(row.pops.largestPop), row.pops.definition(), row.pops.backs);
    table += line;
  }
  return table;
}

Json jsonOf(const std::vector<PopsRow>& rows) {
  Json list = Json::array();
  for (const PopsRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("laid", row.laid).set("rigs", row.rigs).set("frames", row.pops.frames);
    item.set("steps", static_cast<double>(row.pops.steps))
        .set("largest_step", static_cast<double>(row.pops.largestStep));
    item.set("pops", static_cast<double>(row.pops.pops)).set("largest_pop", static_cast<double>(row.pops.largestPop));
    item.set("definition", row.pops.definition()).set("backs", static_cast<double>(row.pops.backs));
    list.push(item);
  }
  return list;
}

}  // namespace

Result<Report> reportPops(Files files, const Effort& effort) {
  std::vector<PopsRow> rows;
  for (const std::filesystem::path& file : files) {
    const bool isRig = file.extension() == ".json";
    const auto measured = rowsOf<PopsRow>(std::span(&file, 1),
                                          [&](const BenchScene& scene) { return measurePops(scene, isRig, effort); });
    if (!measured) return measured.error();
    rows.insert(rows.end(), measured->begin(), measured->end());
  }
  return Report{tableOf(rows), jsonOf(rows)};
}

}  // namespace sinew::app
