// app/cli/export.cpp: open, fit, write for other programs, report.
#include <filesystem>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/batch.h"
#include "app/cli/console.h"
#include "app/cli/verb.h"
#include "app/document/document.h"
#include "app/document/motion_clip.h"
#include "core/io/json/json.h"
#include "core/rig/attachment.h"
#include "sinew/export/skinned_export.h"

namespace sinew::app {
namespace {

struct ExportOptions {
  std::filesystem::path file;    ///< Rig or character.
  std::filesystem::path output;  ///< .glb or .gltf.
  std::string kind = "helpers";
  std::string mesh = "refined";
  std::string weights = "refitted";
  std::optional<int> depth;
  std::vector<std::string> clips;
  std::optional<int> helpers;
  std::optional<std::string> jointScale;
  bool json = false;
  BatchOptions batch;
};

Json jsonOf(const ErrorFigures& error) {
  Json json = Json::object();
  json.set("poses", error.poses).set("rms", error.rms).set("percentile_99_9", error.percentile999);
  json.set("max", error.largest);
  return json;
}

Json clipsOf(const std::vector<ClipError>& clips) {
  Json list = Json::array();
  for (const ClipError& clip : clips) {
    Json item = Json::object();
    item.set("name", clip.clip);
    for (const Json& member : jsonOf(clip.error).children) item.set(member.key, member);
    list.push(std::move(item));
  }
  return list;
}

std::string jsonText(const ExportOptions& options, const std::filesystem::path& output,
                     const SkinnedExportReport& report) {
  Json error = Json::object();
  error.set("fitted", jsonOf(report.fitted)).set("held_out", jsonOf(report.heldOut));
  error.set("all_clips", jsonOf(report.allClips)).set("clips", clipsOf(report.clips));
  error.set("further", clipsOf(report.further));
  Json left = Json::array();
  for (const std::string& line : report.left) left.push(line);
  Json json = Json::object();
  json.set("file", output.string()).set("as", options.kind).set("mesh", options.mesh);
  json.set("weights", options.weights).set("joints", report.joints);
  json.set("line_joints", report.lineJoints).set("rigid_helpers", report.rigidHelpers);
  json.set("vertices", static_cast<long long>(report.vertices));
  json.set("triangles", static_cast<long long>(report.triangles));
  json.set("bytes", static_cast<long long>(report.bytes));
  json.set("error_percent_of_height", std::move(error)).set("left_out", std::move(left));
  return json.dump(true) + '\n';
}

void writeRow(std::ostream& out, const std::string& name, const ErrorFigures& error) {
  out << "  " << std::left << std::setw(24) << name << std::right << std::setw(6) << error.poses << std::fixed
      << std::setprecision(3) << std::setw(10) << error.rms << std::setw(10) << error.percentile999 << std::setw(10)
      << error.largest << '\n';
}

std::string addedText(const SkinnedExportReport& report) {
  const int added = report.lineJoints + report.rigidHelpers;
  if (added == 0) return {};
  return " (" + std::to_string(added) + " added: " + std::to_string(report.lineJoints) + " of muscle lines, " +
         std::to_string(report.rigidHelpers) + " rigid)";
}

std::string plainText(const ExportOptions& options, const std::filesystem::path& output,
                      const SkinnedExportReport& report) {
  std::ostringstream out;
  out << output.string() << '\n';
  out << "  " << options.mesh << " mesh, " << options.weights << " weights: " << report.joints << " joints"
      << addedText(report) << ", " << report.vertices << " vertices, " << report.triangles << " triangles, "
      << report.bytes << " bytes\n";
  out << "  % of the height            poses       rms    99.9 %       max\n";
  for (const ClipError& clip : report.clips) writeRow(out, '"' + clip.clip + '"', clip.error);
  if (report.clips.size() > 1) writeRow(out, "all clips", report.allClips);
  for (const ClipError& clip : report.further) writeRow(out, '(' + clip.clip + ')', clip.error);
  writeRow(out, "fitted poses", report.fitted);
  writeRow(out, "held-out poses", report.heldOut);
  for (const std::string& line : report.left) out << "  left out: " << line << '\n';
  return out.str();
}

std::string isOutput(const std::string& text) {
  return isSkinnedExportName(text) ? std::string() : "expected a name that ends in .glb or .gltf, got \"" + text + '"';
}

void addExportOptions(CLI::App& verb, ExportOptions& options) {
  const auto to = [](std::filesystem::path& path) { return [&path](const std::string& text) { path = text; }; };
  verb.add_option_function<std::string>("FILE", to(options.file), "Rig (.rig.json) or character (.glb, .gltf)");
  verb.add_option(
          "--as", options.kind,
          "helpers: with joints that move as the muscles do, keyed in every clip (default); skinned: the file's "
          "joints alone, muscles at rest")
      ->type_name("KIND")
      ->check(CLI::IsMember({"skinned", "helpers"}));
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
  verb.add_option("--joints", options.helpers,
                  "helpers: how many joints may be added (24), whatever serves best: those of "
                  "muscle lines, or others")
      ->type_name("N")
      ->check(CLI::Range(0, kMostHelpers));
  verb.add_option("--joint-scale", options.jointScale,
                  "helpers: how joints of muscle lines may scale: full, uniform, or none (two joints a line)")
      ->type_name("S")
      ->check(CLI::IsMember({"full", "uniform", "none"}));
  verb.add_flag("--json", options.json, "Report as JSON");
  verb.add_option_function<std::string>("-o,--output", to(options.output), "Character to write: .glb or .gltf")
      ->type_name("OUT")
      ->required()
      ->check(isOutput);
  addBatchOptions(verb, options.batch);
}

int exportInput(const ExportOptions& options, const BatchInput& input) {
  const std::filesystem::path& output = input.outputs.front();
  progress("reading " + input.file.string());
  const auto document = openDocument(input.file);
  if (!document) return badInput(document.error());
  Rig rig = document->rig();
  if (options.depth) rig.smoothing.depth = *options.depth;
  if (const auto missing = missingBones(rig, document->character->skeleton); !missing.empty()) {
    return badInput({input.file.string(), missing.front().place, missing.front().reason});
  }
  SkinnedExportSettings settings;
  settings.mesh = options.mesh == "original" ? ExportMesh::kOriginal : ExportMesh::kRefined;
  settings.weights = options.weights == "transferred" ? ExportWeights::kTransferred : ExportWeights::kRefitted;
  settings.clips = options.clips;
  settings.joints = options.kind == "helpers" ? ExportJoints::kHelpers : ExportJoints::kOwn;
  settings.helpers = options.helpers.value_or(kDefaultHelpers);
  if (options.jointScale) settings.jointScale = jointScaleNamed(*options.jointScale).value_or(JointScale::kFull);
  progress("exporting " + output.string());
  const auto moving = withRangeOfMotion(document->character);
  const auto report = exportSkinned(document->characterFile, document->character, *moving, rig, settings, output);
  if (!report) return badInput(report.error());
  return putResult(options.json ? jsonText(options, output, report.value())
                                : plainText(options, output, report.value()));
}

/// Why the options do not go together; they name no file, so the status is 2.
std::optional<Error> misfit(const ExportOptions& options) {
  const bool helpers = options.kind == "helpers";
  if (!helpers && options.helpers) return errorAt({}, "--joints goes with --as helpers");
  if (!helpers && options.jointScale) return errorAt({}, "--joint-scale goes with --as helpers");
  if (helpers && options.weights == "transferred") return errorAt({}, "--weights transferred goes with --as skinned");
  return std::nullopt;
}

int runExport(const ExportOptions& options) {
  if (const auto error = misfit(options)) return refused(*error);
  const auto batch = planBatch(options.batch, options.file, options.output);
  if (!batch) return refused(batch.error());
  return runBatch(batch.value(), options.batch.dryRun,
                  [&](const BatchInput& input) { return exportInput(options, input); });
}

}  // namespace

Verb exportVerb() {
  return makeVerb<ExportOptions>("export", "Write the character for games", addExportOptions, runExport);
}

}  // namespace sinew::app
