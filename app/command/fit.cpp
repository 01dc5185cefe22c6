// app/command/fit.cpp: `sinew fit`: muscles that make the skin look like a sculpt.
#include <cstdio>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/verbs.h"
#include "app/document/document.h"
#include "core/bodies/check.h"
#include "core/bodies/fit_to_sculpt.h"
#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/sculpt_file.h"
#include "core/geometry/at.h"
#include "core/geometry/stopwatch.h"
#include "sinew/files/rig_json.h"

namespace sinew::app {
namespace {

struct FitOptions {
  std::filesystem::path rig;
  std::filesystem::path sculpt;
  std::filesystem::path output;
  std::filesystem::path report;  ///< Empty: none.
  float hold = kDefaultHold;
  int carves = 0;
  bool eachSide = false;
};

void addFitOptions(CLI::App& verb, FitOptions& options) {
  addPath(verb, "RIG", options.rig, "Rig whose muscles are changed (.rig.json)")->required();
  addPath(verb, "SCULPT", options.sculpt, "The same body sculpted, in the bind pose (.glb, .gltf, .vrm, .obj, .ply)")
      ->required();
  addPath(verb, "-o,--output", options.output, "Rig to write (.rig.json)")->type_name("OUT.rig.json")->required();
  verb.add_option("--prior", options.hold, "Between keeping the muscles, 1, and matching the sculpt, 0.01 (0.1)")
      ->type_name("P")
      ->check(CLI::Range(kLeastHold, kMostHold));
  verb.add_option("--carves", options.carves, "Add up to N carves where the sculpt is lower (0)")
      ->type_name("N")
      ->check(CLI::Range(0, kMostFitCarves));
  verb.add_flag("--each-side", options.eachSide, "Follow the sculpt on each side: twins are no longer linked");
  addPath(verb, "--report", options.report, "How near the skin has come, as JSON")->type_name("FILE.json");
}

Json jsonOf(const SculptMatch& match) { return Json::object().set("explained", match.explained).set("rms", match.rms); }

std::string textOf(const FitOptions& options, const SculptFit& fit, std::size_t findings) {
  char text[512];
  std::snprintf(text, sizeof text,
                "%s: explained %.3f, before %.3f; %.2f %% of the height is left, before %.2f %%\n"
                "  %d muscles moved by %.2f %% of the height on average; %d carves added; the sculpt lies over %.0f %% "
                "of their skin\n"
                "  check: %s\n",
                options.sculpt.string().c_str(), fit.after.explained, fit.before.explained, 100.0 * fit.after.rms,
                100.0 * fit.before.rms, fit.muscles, 100.0 * fit.moved, fit.carves, 100.0 * fit.covered,
                findings == 0 ? "nothing found" : (std::to_string(findings) + " findings").c_str());
  return text;
}

int runFit(const FitOptions& options) {
  if (!options.output.string().ends_with(".rig.json")) {
    return badCommandLine("--output: expected a name that ends in .rig.json, got \"" + options.output.string() + '"');
  }
  const auto document = openDocument(options.rig);
  if (!document) return badInput(document.error());
  if (document->rigFile.empty()) return badInput({options.rig.string(), "", "expected a rig: this is a character"});
  const auto sculpt = loadSculpt(options.sculpt);
  if (!sculpt) return badInput(sculpt.error());
  Stopwatch watch;
  ProgressLine line("fitting " + options.rig.filename().string(), false);
  SculptFitOptions fitting{options.hold, options.carves, !options.eachSide, {}};
  fitting.progress = [&](double share) {
    line.show(share);
    return true;
  };
  const Motions motions(document->character);
  auto fit = fitToSculpt(document->rig(), document->character, *document->mirror, motions, sculpt.value(), fitting);
  line.end();
  if (!fit) {
    const std::string& file = (fit.error().place.empty() ? options.sculpt : options.rig).string();
    return badInput({file, fit.error().place, fit.error().reason});
  }
  const double seconds = watch.lap();
  for (const std::string& name : fit->heldBack) message("held back, as it would leave the flesh: " + name);
  const std::vector<Finding> findings = check(fit->rig, motions);
  Rig rig = fit->rig;
  rig.character = relativeCharacterPath(document->characterFile, options.output);
  if (!options.report.empty()) {
    Json json = Json::object();
    json.set("before", jsonOf(fit->before)).set("after", jsonOf(fit->after)).set("covered", fit->covered);
    json.set("muscles", fit->muscles).set("moved", fit->moved).set("carves", fit->carves);
    json.set("held_back", jsonList(fit->heldBack)).set("findings", static_cast<int>(findings.size()));
    json.set("seconds", seconds);
    const auto written = writeFileAtomically(options.report, json.dump(true) + '\n');
    if (!written) return badInput(written.error());
  }
  if (const auto saved = saveRig(rig, options.output); !saved) return badInput(saved.error());
  return putResult(textOf(options, fit.value(), findings.size()));
}

}  // namespace

Verb fitVerb() {
  return makeVerb<FitOptions>("fit", "Change muscles until the skin looks like a sculpt", addFitOptions, runFit);
}

}  // namespace sinew::app
