// app/command/muscle.cpp: `sinew muscle`: gives a character a set of muscles.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/verbs.h"
#include "app/document/document.h"
#include "app/document/muscle_sets.h"
#include "core/bodies/body_map.h"
#include "core/bodies/muscle_set.h"
#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/preset_json.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/geometry/stopwatch.h"
#include "core/rig/motion_clip.h"
#include "sinew/files/rig_json.h"

namespace sinew::app {
namespace {

struct MuscleOptions {
  std::filesystem::path file;
  std::filesystem::path output;
  std::filesystem::path report;  ///< Empty: none.
  std::string set;               ///< Empty: the one for the body's kind.
  float mass = 1.0f;
  std::optional<float> definition;
};

void addMuscleOptions(CLI::App& verb, MuscleOptions& options) {
  addPath(verb, "FILE", options.file, "Character (.glb, .gltf, .vrm) or rig (.rig.json)")->required();
  addPath(verb, "-o,--output", options.output, "Rig to write (.rig.json)")->type_name("OUT.rig.json")->required();
  verb.add_option(
          "--set", options.set,
          "Set of muscles: athlete, sculpted, animal, one of your own, or a file (.json); without it, the one for this "
          "kind of body")
      ->type_name("NAME");
  verb.add_option("--mass", options.mass, "Girth of all muscles, 0.5 to 2 (1)")
      ->type_name("M")
      ->check(CLI::Range(kLeastMass, kMostMass));
  verb.add_option("--definition", options.definition, "How far muscles stand out, 0 to 1 (the set's)")
      ->type_name("D")
      ->check(CLI::Range(0.0f, 1.0f));
  addPath(verb, "--report", options.report, "Muscles, and what was left out and why, as JSON")->type_name("FILE.json");
}

Result<Preset> presetOf(const MuscleOptions& options, BodyKind kind) {
  if (options.set.ends_with(".json")) return loadPreset(options.set);
  const MuscleSets all = muscleSets();
  const int chosen = options.set.empty() ? all.firstFor(kind == BodyKind::kUnknown ? BodyKind::kHumanoid : kind)
                                         : all.named(options.set);
  if (chosen >= 0) return at(all.sets, chosen);
  std::vector<std::string> names;
  for (const Preset& set : all.sets) names.push_back(set.name);
  return errorAt("--set", "there is no set \"" + options.set + "\"; there are " + listed(names, "and"));
}

std::string reportText(const AddedSet& added, const Preset& preset, const BodySlots& slots, double seconds) {
  const FittedPreset& fitted = added.fitted;
  const auto leftOut = jsonList(fitted.leftOut, [](const auto& left) {
    const auto& [name, why] = left;
    return Json::object().set("muscle", name).set("why", why);
  });
  Json missing = Json::array();
  for (const BodySlot slot : allBodySlots()) {
    if (slots[slot].bone < 0) missing.push(nameOf(slot));
  }
  Json json = Json::object();
  json.set("set", preset.name).set("body", nameOf(slots.kind)).set("muscles", jsonList(fitted.muscles));
  json.set("primitives", static_cast<int>(fitted.rig.primitives.size())).set("left_out", leftOut);
  json.set("mended", jsonList(added.mended)).set("missing_parts", std::move(missing)).set("seconds", seconds);
  return json.dump(true) + '\n';
}

int runMuscle(const MuscleOptions& options) {
  if (!options.output.string().ends_with(".rig.json")) {
    return badCommandLine("--output: expected a name that ends in .rig.json, got \"" + options.output.string() + '"');
  }
  auto document = openDocument(options.file);
  if (!document) return badInput(document.error());
  Stopwatch watch;
  const MirrorPlan& plan = *document->mirror;
  const auto character = withRangeOfMotion(document->character, plan);
  const BodySlots slots = bodySlots(*character, plan, document->rig().slots);
  const auto preset = presetOf(options, slots.kind);
  if (!preset) return refused(preset.error());
  const auto added =
      addMuscleSet(document->rig(), preset.value(), {options.mass, options.definition}, Motions(character), plan);
  if (!added) return badInput({options.file.string(), {}, added.error().reason});
  const double seconds = watch.lap();
  for (const auto& [name, why] : added->fitted.leftOut) message(name + " is left out: " + why);
  for (const std::string& line : added->mended) message("mended " + line);
  Rig rig = added->fitted.rig;
  rig.character = relativeCharacterPath(document->characterFile, options.output);
  if (!options.report.empty()) {
    const auto written = writeFileAtomically(options.report, reportText(added.value(), preset.value(), slots, seconds));
    if (!written) return badInput(written.error());
  }
  if (const auto saved = saveRig(rig, options.output); !saved) return badInput(saved.error());
  return kDone;
}

}  // namespace

Verb muscleVerb() {
  return makeVerb<MuscleOptions>("muscle", "Give a character a set of muscles that fits its body", addMuscleOptions,
                                 runMuscle);
}

}  // namespace sinew::app
