// tests/bench/pops.cpp: how often the skin steps far within a frame, and how often at once, by who laid the muscles.
#include <cstdio>

#include "tests/bench/parts.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/pops.h"
#include "tests/viewport/tools/laid_muscles.h"

namespace sinew::app {
namespace {

/// One way to lay muscles on one character.
struct PopsRow {
  std::string scene;
  const char* laid = "";
  const char* detail = "";
  int rigs = 0;
  test::Pops pops;
};

constexpr DetailKind kDetails[] = {DetailKind::kUniform, DetailKind::kAdaptive};

test::Pops popsOf(const BenchScene& scene, Rig rig, DetailKind detail, const Effort& effort) {
  rig.smoothing.detail = detail;
  return test::countPops(scene.character, rig, effort.frames);
}

Result<std::vector<PopsRow>> measurePops(const BenchScene& scene, bool isRig, const Effort& effort) {
  std::vector<PopsRow> rows;
  const Rig laid = isRig ? scene.rig : test::layMuscles(scene.character);
  for (const DetailKind detail : kDetails) {
    const char* name = detail == DetailKind::kUniform ? "uniform" : "adaptive";
    progress("muscles by the tool's defaults, or the rig's own");
    rows.push_back({scene.name, isRig ? "own" : "tool", name, 1, popsOf(scene, laid, detail, effort)});
    if (isRig) continue;
    PopsRow random{scene.name, "random", name, effort.rounds, {}};
    for (int i = 1; i <= effort.rounds; ++i) {
      progress("random muscles " + std::to_string(i) + " of " + std::to_string(effort.rounds));
      const Rig rig = test::randomRig(*scene.character, test::kShortReach, static_cast<std::uint64_t>(i));
      random.pops.add(popsOf(scene, rig, detail, effort));
    }
    rows.push_back(random);
  }
  return rows;
}

std::string tableOf(const std::vector<PopsRow>& rows) {
  std::string table =
      "Every clip at 60 frames a second. A step: a vertex moves by more than 0.5 % H from one frame to the next "
      "against\n"
      "the patch under it. A pop: more than 0.15 % H of that within its fastest 26 microseconds. Largest in % H a "
      "frame.\n"
      "Definition: degrees that muscles turn normals, mean. More: pixels of backs, every 15th frame from 14 sides, "
      "that\n"
      "a frame shows beyond those of the bare skin. Muscles: the file's own, 16 by the tool's defaults, 24 of short\n"
      "reach at random.\n"
      "\n"
      "scene             muscles  detail    rigs  frames     steps  largest      pops  largest  definition   more\n";
  char line[160];
  for (const PopsRow& row : rows) {
    std::snprintf(line, sizeof line, "%-16.40s  %-7s  %-8s  %4d  %6d  %8lld  %7.2f  %8lld  %7.2f  %10.2f  %5lld\n",
                  row.scene.c_str(), row.laid, row.detail, row.rigs, row.pops.frames, row.pops.steps,
                  100.0 * static_cast<double>(row.pops.largestStep), row.pops.pops,
                  100.0 * static_cast<double>(row.pops.largestPop), row.pops.definition(), row.pops.moreBacks);
    table += line;
  }
  return table;
}

Json placesOf(const test::Pops& pops) {
  Json list = Json::array();
  for (const test::PopPlace& place : pops.places) {
    Json item = Json::object();
    item.set("clip", place.clip).set("time", place.time);
    item.set("vertex", static_cast<double>(place.vertex));
    item.set("control_triangle", static_cast<double>(place.controlTriangle));
    item.set("step", static_cast<double>(place.step)).set("kept", static_cast<double>(place.kept));
    item.set("of_root", static_cast<double>(place.ofRoot));
    list.push(item);
  }
  return list;
}

Json jsonOf(const std::vector<PopsRow>& rows) {
  Json list = Json::array();
  for (const PopsRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene)
        .set("laid", row.laid)
        .set("detail", row.detail)
        .set("rigs", row.rigs)
        .set("frames", row.pops.frames);
    item.set("steps", static_cast<double>(row.pops.steps))
        .set("largest_step", static_cast<double>(row.pops.largestStep));
    item.set("pops", static_cast<double>(row.pops.pops)).set("largest_pop", static_cast<double>(row.pops.largestPop));
    item.set("definition", row.pops.definition()).set("backs", static_cast<double>(row.pops.backs));
    item.set("bare_backs", static_cast<double>(row.pops.bareBacks))
        .set("more_backs", static_cast<double>(row.pops.moreBacks));
    item.set("places", placesOf(row.pops));
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
