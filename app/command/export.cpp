// app/command/export.cpp: `sinew export`: options for the kinds and settings of app/document; exports and reports.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>

#include <CLI/CLI.hpp>

#include "app/command/batch.h"
#include "app/command/console.h"
#include "app/command/surface_options.h"
#include "app/command/verbs.h"
#include "app/document/document.h"
#include "app/document/export_report.h"
#include "app/viewport/render/color_scales.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/nearest_name.h"
#include "sinew/files/exported_surface.h"
#include "sinew/geometry/result.h"

namespace sinew::app {
namespace {

void put(std::string& out, std::uint32_t bits) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((bits >> shift) & 0xffU);
}

void put(std::string& out, float value) { put(out, std::bit_cast<std::uint32_t>(value)); }
char byteOf(float share) { return static_cast<char>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f))); }

/// A little endian .ply of the exported mesh in the bind pose. Each vertex has x, y, z, red, green, blue and "error",
/// its largest distance to the live surface in percent of the height. White is 0, the darkest red the largest.
Result<void> writeErrorMap(const ExportedSurface& exported, const std::filesystem::path& file) {
  const float largest =
      exported.largest.empty() ? 0.0f : *std::max_element(exported.largest.begin(), exported.largest.end());
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment error: percent of the height\nelement vertex " +
                    std::to_string(exported.rest.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
                    "property uchar blue\nproperty float error\nelement face " +
                    std::to_string(exported.triangles.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < exported.rest.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) put(out, exported.rest[v][axis]);
    const float error = exported.largest[v];
    const glm::vec3 color = heatColor(largest > 0.0f ? error / largest : 0.0f);
    for (int channel = 0; channel < 3; ++channel) out += byteOf(color[channel]);
    put(out, error);
  }
  for (const auto& triangle : exported.triangles) {
    out += '\3';
    for (const int corner : triangle) put(out, static_cast<std::uint32_t>(corner));
  }
  return writeFileAtomically(file, out);
}

struct ExportOptions {
  std::filesystem::path file;  ///< Rig or character.
  std::filesystem::path output;
  std::string word = exportKinds().front().word;  ///< After --as.
  ExportSettings settings;
  CLI::App* parser = nullptr;      ///< To ask which options are given.
  std::vector<std::string> clips;  ///< Files whose clips are added.
  std::filesystem::path errorMap;  ///< .ply; empty: none.
  bool json = false;
  BatchOptions batch;
};

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

/// An option whose words are the names of the values.
template <class Value>
void addNamed(CLI::App& verb, const char* option, const char* type, Value& setting, std::initializer_list<Value> values,
              const char* help) {
  std::vector<std::string> words;
  for (const Value value : values) words.emplace_back(nameOf(value));
  verb.add_option_function<std::string>(
          option,
          [&setting, all = std::vector<Value>(values)](const std::string& word) {
            setting = *std::ranges::find_if(all, [&](Value value) { return word == nameOf(value); });
          },
          help)
      ->type_name(type)
      ->check(CLI::IsMember(words));
}

void addSettings(CLI::App& verb, ExportSettings& settings) {
  addNamed(verb, "--mesh", "M", settings.mesh, {ExportMesh::kRefined, ExportMesh::kOriginal},
           "refined, or original: the file's own vertices, in its order");
  addDetailOptions(verb, settings.detail);
  addNamed(verb, "--weights", "W", settings.weights, {ExportWeights::kRefitted, ExportWeights::kTransferred},
           "refitted to the muscles' surface over the clips and the range of motion, or transferred from the file");
  verb.add_option("--clip", settings.clips, "Keep this clip; may be given several times; without it, all are kept")
      ->type_name("NAME")
      ->allow_extra_args(false);
  verb.add_option("--joints", settings.helpers,
                  "helpers: how many joints may be added (24), for muscle lines or rigid, whichever serve best")
      ->type_name("N")
      ->check(CLI::Range(0, kMostHelpers));
  addNamed(verb, "--joint-scale", "S", settings.jointScale,
           {JointScale::kFull, JointScale::kUniform, JointScale::kNone},
           "helpers: how joints of muscle lines may scale: full, uniform, or none (two joints a line)");
  verb.add_option("--fps", settings.framesPerSecond, "baked: frames per second (30), and one at the clip's end")
      ->type_name("N")
      ->check(isFrameRate);
  verb.add_option("--substeps", settings.substeps,
                  "baked: samples per frame (1); more hold the bound between frames, too")
      ->type_name("N")
      ->check(CLI::Range(1, kMostSubsteps));
  verb.add_option("--bound", settings.bound,
                  "baked: how far any vertex may be off in any frame, percent of the height (0.1)")
      ->type_name("PERCENT")
      ->check(isBound);
}

/// The usual endings, and those of kinds with others.
std::string endingsText() {
  const std::string usual = exportEndingsOf(exportKinds().front().word);
  std::string text = usual;
  for (const std::string& word : exportWords()) {
    if (exportEndingsOf(word) != usual) text += "; " + word + ": " + exportEndingsOf(word);
  }
  return text;
}

void addOptions(CLI::App& verb, ExportOptions& options) {
  options.parser = &verb;
  addPath(verb, "FILE", options.file, "Rig (.rig.json) or character (.glb, .gltf, .vrm)");
  verb.add_option(
          "--as", options.word,
          "helpers: with joints that move as the muscles do, keyed in every clip (default); skinned: the file's "
          "joints alone, muscles at rest; baked: one clip as it is, in morph targets (.glb, .gltf) or points "
          "(.usda; .pc2 or .mdd, a cache beside an .obj)")
      ->type_name("KIND")
      ->check(CLI::IsMember(exportWords()));
  addClipsOption(verb, options.clips);
  addSettings(verb, options.settings);
  verb.add_flag("--json", options.json, "Report as JSON");
  addPath(verb, "--error-map", options.errorMap,
          "The exported mesh at rest, each vertex with its largest distance to the live surface as color and number")
      ->type_name("OUT.ply");
  addPath(verb, "-o,--output", options.output, "File to write: " + endingsText())->type_name("OUT")->required();
  addBatchOptions(verb, options.batch);
}

struct ExportJob {
  const ExportKind* kind = nullptr;
  Batch batch;
};

int exportInput(const ExportOptions& options, const ExportJob& job, const BatchInput& input) {
  const ExportKind& kind = *job.kind;
  const std::filesystem::path& output = input.outputs.front();
  const auto document = openWithClips(input.file, options.clips);
  if (!document) return badInput(document.error());
  ProgressLine line("exporting " + output.string(), options.batch.progress);
  const auto show = [&line](double share) {
    line.show(share);
    return true;
  };
  line.show(0.0);
  const ExportSource source{document->characterFile, document->character, document->rig(), input.file};
  const auto report =
      runExport(kind, source, options.settings, output, line.isShown() ? ExportProgress(show) : ExportProgress());
  if (report) line.show(1.0);
  line.end();
  if (!report) return badInput(report.error());
  if (!options.errorMap.empty()) {
    const auto maps = filesBeside(job.batch, input, options.errorMap, "--error-map");
    if (!maps) return badCommandLine(maps.error().text());
    if (const auto written = writeErrorMap(*playedBy(report.value()), maps->front()); !written) {
      return badInput(written.error());
    }
  }
  const ExportResult result{kind, options.settings, output, report.value()};
  return putResult(options.json ? exportJson(result) : exportText(result));
}

Result<ExportJob> planExport(const ExportOptions& options) {
  const auto kind = findExportKind(options.word, options.output);
  if (!kind) return kind.error();
  const auto isGiven = [&](const char* option) { return options.parser->count(option) > 0; };
  if (const auto fits = checkExportSettings(*kind.value(), options.settings, isGiven); !fits) return fits.error();
  if (!options.errorMap.empty()) {
    if (lowerEnding(options.errorMap) != ".ply") {
      return errorAt("--error-map", "expected a name that ends in .ply, got \"" + options.errorMap.string() + '"');
    }
    if (kind.value()->form == ExportForm::kCache || kind.value()->form == ExportForm::kStage) {
      return errorAt("--error-map", "baked points are the live surface: there is no distance to show");
    }
  }
  auto batch = planBatch(options.batch, options.file, options.output);
  if (!batch) return batch.error();
  return ExportJob{kind.value(), std::move(batch.value())};
}

int runVerb(const ExportOptions& options) {
  const auto job = planExport(options);
  if (!job) return refused(job.error());
  return runBatch(job->batch, options.batch,
                  [&](const BatchInput& input) { return exportInput(options, job.value(), input); });
}

Result<FarmCheck> checkVerb(const ExportOptions& options) {
  const auto job = planExport(options);
  if (!job) return job.error();
  return checkForFarm("export", job->batch, options.batch, [&](const BatchInput& input) -> Result<InputCheck> {
    const auto document = openWithClips(input.file, options.clips);
    if (!document) return document.error();
    ExportSource source{document->characterFile, document->character, document->rig(), input.file};
    if (const auto able = checkExportSource(*job->kind, source, options.settings); !able) return able.error();
    options.settings.detail.apply(source.rig.smoothing);
    return InputCheck{source.character, source.rig, {}, heldFrames(*job->kind, source.character, options.settings)};
  });
}

}  // namespace

Verb exportVerb() {
  return makeVerb<ExportOptions>("export", "Write the character for games", addOptions, runVerb, checkVerb);
}

}  // namespace sinew::app
