// app/command/retarget.cpp: `sinew retarget`: the muscles of a rig on another character.
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/verbs.h"
#include "app/document/document.h"
#include "core/bodies/retarget.h"
#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"
#include "core/geometry/stopwatch.h"
#include "sinew/files/rig_json.h"

namespace sinew::app {
namespace {

struct RetargetOptions {
  std::filesystem::path rig;
  std::filesystem::path character;
  std::filesystem::path output;
  std::filesystem::path report;  ///< Empty: none.
};

void addRetargetOptions(CLI::App& verb, RetargetOptions& options) {
  addPath(verb, "RIG", options.rig, "Rig whose muscles are wanted (.rig.json)")->required();
  addPath(verb, "CHARACTER", options.character, "Character that gets them (.glb, .gltf, .vrm)")->required();
  addPath(verb, "-o,--output", options.output, "Rig to write (.rig.json)")->type_name("OUT.rig.json")->required();
  addPath(verb, "--report", options.report, "What was left out and why, as JSON")->type_name("FILE.json");
}

std::string reportText(const Retargeted& done, double seconds) {
  Json json = Json::object();
  json.set("primitives", static_cast<int>(done.rig.primitives.size()));
  json.set("left_out", jsonList(done.leftOut, [](const auto& left) {
             const auto& [name, why] = left;
             return Json::object().set("muscle", name).set("why", why);
           }));
  json.set("mended", jsonList(done.mended)).set("seconds", seconds);
  return json.dump(true) + '\n';
}

int runRetarget(const RetargetOptions& options) {
  if (!options.output.string().ends_with(".rig.json")) {
    return badCommandLine("--output: expected a name that ends in .rig.json, got \"" + options.output.string() + '"');
  }
  const auto from = openDocument(options.rig);
  if (!from) return badInput(from.error());
  const auto to = openDocument(options.character);
  if (!to) return badInput(to.error());
  Stopwatch watch;
  const auto done = retarget(from->rig(), *from->character, *from->mirror, Motions(to->character), *to->mirror);
  if (!done) return badInput({options.character.string(), {}, done.error().reason});
  const double seconds = watch.lap();
  for (const auto& [name, why] : done->leftOut) message(name + " is left out: " + why);
  for (const std::string& line : done->mended) message("mended " + line);
  Rig rig = done->rig;
  rig.character = relativeCharacterPath(to->characterFile, options.output);
  if (!options.report.empty()) {
    const auto written = writeFileAtomically(options.report, reportText(done.value(), seconds));
    if (!written) return badInput(written.error());
  }
  if (const auto saved = saveRig(rig, options.output); !saved) return badInput(saved.error());
  return kDone;
}

}  // namespace

Verb retargetVerb() {
  return makeVerb<RetargetOptions>("retarget", "Put the muscles of a rig on another character", addRetargetOptions,
                                   runRetarget);
}

}  // namespace sinew::app
