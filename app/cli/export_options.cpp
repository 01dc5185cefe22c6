// app/cli/export_options.cpp: options of `sinew export`, and which kind takes which.
#include "app/cli/export_verb.h"

#include <cmath>

#include <CLI/CLI.hpp>

namespace sinew::app {
namespace {

constexpr int kMostThreads = 1024;

std::string isFrameRate(const std::string& text) {
  double number = 0.0;
  if (CLI::detail::lexical_cast(text, number) && number > 0.0 && std::isfinite(number)) return {};
  return "expected a number > 0, got \"" + text + '"';
}

std::string isBound(const std::string& text) {
  double number = 0.0;
  if (CLI::detail::lexical_cast(text, number) && number >= kLeastBound && number <= kMostBound) return {};
  return "expected percent of the height from 0.001 to 100, got \"" + text + '"';
}

}  // namespace

void addExportOptions(CLI::App& verb, ExportOptions& options) {
  const auto to = [](std::filesystem::path& path) { return [&path](const std::string& text) { path = text; }; };
  verb.add_option_function<std::string>("FILE", to(options.file), "Rig (.rig.json) or character (.glb, .gltf)");
  verb.add_option(
          "--as", options.kind,
          "helpers: with joints that move as the muscles do, keyed in every clip (default); skinned: the file's "
          "joints alone, muscles at rest; baked: one clip as it is, in morph targets (.glb, .gltf) or points "
          "(.usda; .pc2 or .mdd, a cache beside an .obj)")
      ->type_name("KIND")
      ->check(CLI::IsMember({"skinned", "helpers", "baked"}));
  verb.add_option("--mesh", options.mesh, "refined, or original: the file's own vertices, in its order")
      ->type_name("M")
      ->check(CLI::IsMember({"refined", "original"}));
  verb.add_option("--depth", options.depth, "Every triangle becomes N x N, in place of the rig's depth")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxDepth));
  verb.add_option(
          "--weights", options.weights,
          "refitted to the muscles' surface over the clips and the range of motion, or transferred from the file")
      ->type_name("W")
      ->check(CLI::IsMember({"refitted", "transferred"}));
  verb.add_option("--clip", options.clips, "Keep this clip; may be given several times; without it, all are kept")
      ->type_name("NAME")
      ->allow_extra_args(false);
  verb.add_option(
          "--joints", options.helpers,
          "helpers: how many joints may be added (24), whatever serves best: those of muscle lines, or rigid ones")
      ->type_name("N")
      ->check(CLI::Range(0, kMostHelpers));
  verb.add_option("--joint-scale", options.jointScale,
                  "helpers: how joints of muscle lines may scale: full, uniform, or none (two joints a line)")
      ->type_name("S")
      ->check(CLI::IsMember({"full", "uniform", "none"}));
  verb.add_option("--fps", options.framesPerSecond, "baked: frames a second (30); the clip's end is one, too")
      ->type_name("N")
      ->check(isFrameRate);
  verb.add_option("--bound", options.bound,
                  "baked: how far any vertex may be off in any frame, percent of the height (0.1)")
      ->type_name("PERCENT")
      ->check(isBound);
  verb.add_option("--threads", options.threads, "Work on N cores at most; without it, on all; the file is the same")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
  verb.add_flag("--json", options.json, "Report as JSON");
  verb.add_option_function<std::string>("-o,--output", to(options.output),
                                        "File to write: .glb, .gltf or .usda; baked: .glb, .gltf, .usda, .pc2 or .mdd")
      ->type_name("OUT")
      ->required();
  addBatchOptions(verb, options.batch);
}

Result<void> checkExportOptions(const ExportOptions& options) {
  const bool isBaked = options.kind == "baked";
  const bool arePoints = isBaked && isBakedPointsName(options.output);
  const auto only = [](const char* option, bool isGiven, bool isFor, const char* what) -> Result<void> {
    if (!isGiven || isFor) return {};
    return errorAt(option, std::string("is for ") + what + " alone");
  };
  const bool isNamed = isBaked ? isBakedExportName(options.output) : isSkinnedExportName(options.output);
  if (!isNamed) {
    return errorAt("--output", std::string("expected a name that ends in ") +
                                   (isBaked ? ".glb, .gltf, .usda, .pc2 or .mdd" : ".glb, .gltf or .usda") +
                                   ", got \"" + options.output.string() + '"');
  }
  const bool isHelpers = options.kind == "helpers";
  for (const Result<void>& fits :
       {only("--joints", options.helpers.has_value(), isHelpers, "--as helpers"),
        only("--joint-scale", options.jointScale.has_value(), isHelpers, "--as helpers"),
        only("--weights transferred", options.weights == "transferred", !isHelpers, "--as skinned and --as baked"),
        only("--fps", options.framesPerSecond.has_value(), isBaked, "--as baked"),
        only("--bound", options.bound.has_value(), isBaked, "--as baked"),
        only("--bound", options.bound.has_value(), !arePoints, ".glb and .gltf"),
        only("--weights", options.weights.has_value(), !arePoints, ".glb and .gltf"),
        only("--mesh original", options.mesh == "original", !isBaked, "--as skinned and --as helpers")}) {
    if (!fits) return fits;
  }
  if (isBaked && options.clips.size() != 1) return errorAt("--clip", "expected one clip to bake");
  return {};
}

SkinnedExportSettings skinnedSettings(const ExportOptions& options) {
  SkinnedExportSettings settings;
  settings.mesh = options.mesh == "original" ? ExportMesh::kOriginal : ExportMesh::kRefined;
  settings.weights = options.weights == "transferred" ? ExportWeights::kTransferred : ExportWeights::kRefitted;
  settings.clips = options.clips;
  settings.joints = options.kind == "helpers" ? ExportJoints::kHelpers : ExportJoints::kOwn;
  settings.helpers = options.helpers.value_or(settings.helpers);
  if (options.jointScale) settings.jointScale = jointScaleNamed(*options.jointScale).value_or(JointScale::kFull);
  return settings;
}

BakedExportSettings bakedSettings(const ExportOptions& options) {
  BakedExportSettings settings;
  settings.clip = options.clips.front();
  settings.framesPerSecond = options.framesPerSecond.value_or(settings.framesPerSecond);
  settings.bound = options.bound.value_or(settings.bound);
  settings.weights = skinnedSettings(options).weights;
  return settings;
}

}  // namespace sinew::app
