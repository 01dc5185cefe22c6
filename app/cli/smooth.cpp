// app/cli/smooth.cpp: open, override, pose, smooth, export, report.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>

#include "app/cli/batch.h"
#include "app/cli/console.h"
#include "app/cli/crease_option.h"
#include "app/cli/verb.h"
#include "app/document/document.h"
#include "app/document/motion_clip.h"
#include "core/io/files/atomic_file.h"
#include "core/io/json/json.h"
#include "core/rig/attachment.h"
#include "sinew/io/surface_export.h"
#include "sinew/smoothing/smoother.h"

namespace sinew::app {
namespace {

struct SmoothOptions {
  std::filesystem::path file;       ///< Rig or character.
  std::filesystem::path output;     ///< isExportName().
  std::filesystem::path report;     ///< JSON; empty: none.
  std::optional<std::string> clip;  ///< Absent: the bind pose.
  std::optional<double> time;       ///< Seconds into the clip.
  BatchOptions batch;
  std::optional<int> depth;
  std::optional<float> crease;  ///< Degrees.
  std::optional<std::string> mode;
  std::optional<std::string> patch;
  std::optional<std::string> projection;
};

/// The rig with what the command line overrides. The words have passed the parser.
Rig overridden(Rig rig, const SmoothOptions& options) {
  if (options.depth) rig.smoothing.depth = *options.depth;
  if (options.crease) rig.smoothing.creaseAngle = *options.crease;
  if (options.mode) rig.surface.mode = surfaceModeNamed(*options.mode).value_or(rig.surface.mode);
  if (options.patch) rig.smoothing.patch = patchKindNamed(*options.patch).value_or(rig.smoothing.patch);
  if (options.projection) {
    rig.smoothing.projection = projectionKindNamed(*options.projection).value_or(rig.smoothing.projection);
  }
  return rig;
}

std::string clipNames(const Character& character) {
  if (character.clips.empty()) return "none: it has no clips";
  std::string names;
  for (const AnimationClip& clip : character.clips) names += (names.empty() ? "\"" : ", \"") + clip.name + '"';
  return character.clips.size() == 1 ? names : "one of " + names;
}

/// The clip asked for; null: the bind pose.
Result<const AnimationClip*> clipOf(const Document& document, const SmoothOptions& options, double lastTime) {
  const AnimationClip* none = nullptr;
  const Character& character = *document.character;
  if (!options.clip) return none;
  const auto clip = std::ranges::find(character.clips, *options.clip, &AnimationClip::name);
  if (clip == character.clips.end()) {
    return Error{document.characterFile.string(), "clip \"" + *options.clip + '"', "expected " + clipNames(character)};
  }
  if (lastTime > static_cast<double>(clip->duration)) {
    message(document.characterFile.string() + ": clip \"" + clip->name +
            "\": the time is past its end; its end is used");
  }
  return &*clip;
}

std::string reportText(const SmoothingReport& report) {
  Json seconds = Json::object();
  seconds.set("skin", report.seconds.skin).set("patch", report.seconds.patch).set("project", report.seconds.project);
  seconds.set("folds", report.seconds.folds).set("normals", report.seconds.normals);
  seconds.set("total", report.seconds.total());
  Json json = Json::object();
  json.set("mode", nameOf(report.mode)).set("depth", report.depth);
  json.set("patch", nameOf(report.patch)).set("projection", nameOf(report.projection));
  json.set("control_triangles", report.controlTriangles);
  json.set("refined_triangles", report.refinedTriangles).set("refined_vertices", report.refinedVertices);
  json.set("implicit", report.implicitTriangles).set("straddling", report.straddlingTriangles);
  json.set("normal", report.normalTriangles);
  json.set("primitives", report.primitives).set("cliques", report.cliques);
  json.set("guarded", report.guarded).set("unwrapped", report.unwrapped);
  json.set("unresolved", report.unresolved).set("residual_max", report.residualMax);
  json.set("seconds", seconds);
  return json.dump(true) + '\n';
}

std::string isTime(const std::string& text) {
  try {
    std::size_t used = 0;
    const double seconds = std::stod(text, &used);
    if (used == text.size() && std::isfinite(seconds) && seconds >= 0.0) return {};
  } catch (const std::exception&) {
    // Falls through: what is no number is no time.
  }
  return "expected seconds >= 0, got \"" + text + '"';
}

std::string isOutput(const std::string& text) {
  if (isExportName(text)) return {};
  return "expected a name that ends in " + exportNameEndings() + ", got \"" + text + '"';
}

void addSettings(CLI::App& verb, SmoothOptions& options) {
  verb.add_option("--depth", options.depth,
                  "Every triangle becomes N x N, in place of the rig's depth (a file has no size on screen to follow)")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxDepth));
  verb.add_option("--mode", options.mode, "swell (the skin rises over the muscles) or replace (the paper's method)")
      ->type_name("M")
      ->check(CLI::IsMember({"swell", "replace"}));
  verb.add_option("--patch", options.patch, "Curved patch over each triangle: pn, phong, spherigon or flat")
      ->type_name("P")
      ->check(CLI::IsMember({"pn", "phong", "spherigon", "flat"}));
  verb.add_option("--projection", options.projection, "How roots are found: newton, bisection or analytic")
      ->type_name("P")
      ->check(CLI::IsMember({"newton", "bisection", "analytic"}));
  addCreaseOption(verb, options.crease);
}

void addSmoothOptions(CLI::App& verb, SmoothOptions& options) {
  const auto to = [](std::filesystem::path& path) { return [&path](const std::string& text) { path = text; }; };
  verb.add_option_function<std::string>("FILE", to(options.file), "Rig (.rig.json) or character (.glb, .gltf)");
  CLI::Option* clip =
      verb.add_option("--clip", options.clip,
                      "Pose from this clip, or \"Range of motion\", made from the joints; without it, the bind pose");
  clip->type_name("NAME");
  verb.add_option("--time", options.time, "Seconds into the clip (0)")->type_name("S")->check(isTime)->needs(clip);
  addFrameOptions(verb, options.batch);
  addSettings(verb, options);
  verb.add_option_function<std::string>("-o,--output", to(options.output), "Surface to write: " + exportNameEndings())
      ->type_name("OUT")
      ->required()
      ->check(isOutput);
  verb.add_option_function<std::string>("--report", to(options.report),
                                        "Counts, class sizes, residuals and seconds as JSON")
      ->type_name("FILE.json");
  addBatchOptions(verb, options.batch);
}

/// The report first: a surface that is there has its report.
Result<void> writeSurface(const Surface& surface, const Character& character, const std::filesystem::path& output,
                          const std::filesystem::path& report) {
  if (!report.empty()) {
    if (const auto written = writeFileAtomically(report, reportText(surface.report)); !written) return written.error();
  }
  return exportSurface(surface, character, output);
}

struct SmoothJob {
  Batch batch;
  std::vector<double> times;  ///< [moments] seconds into the clip.
};

Result<SmoothJob> planSmooth(const SmoothOptions& options) {
  if (!options.batch.frames.empty() && !options.clip) return errorAt("--frames", "expected --clip too");
  if (!options.batch.frames.empty() && options.time) {
    return errorAt("--time", "cannot be combined with --frames: a frame's number is its time");
  }
  auto batch = planBatch(options.batch, options.file, options.output);
  if (!batch) return batch.error();
  SmoothJob job{std::move(batch.value()), {}};
  for (std::size_t i = 0; i < job.batch.frames.size(); ++i) {
    job.times.push_back(secondsAt(job.batch, options.batch, i));
  }
  if (job.times.empty()) job.times.push_back(options.time.value_or(0.0));
  return job;
}

/// What is wanted of one input.
int smoothInput(const SmoothOptions& options, const SmoothJob& job, const BatchInput& input) {
  std::vector<std::filesystem::path> reports(input.outputs.size());
  if (!options.report.empty()) {
    auto named = filesBeside(job.batch, input, options.report, "--report");
    if (!named) return badCommandLine(named.error().text());
    reports = std::move(named.value());
  }
  progress("reading " + input.file.string());
  auto document = openDocument(input.file);
  if (!document) return badInput(document.error());
  if (options.clip) document.value().character = withClipNamed(document->character, options.clip.value());
  const Character& character = *document->character;
  const Rig rig = overridden(document->rig(), options);
  if (const auto missing = missingBones(rig, character.skeleton); !missing.empty()) {
    return badInput({input.file.string(), missing.front().place, missing.front().reason});
  }
  const auto clip = clipOf(document.value(), options, job.times[input.wanted.back()]);
  if (!clip) return badInput(clip.error());

  progress("smoothing");
  Smoother smoother(document->character);
  if (const auto prepared = smoother.prepare(rig); !prepared) {
    return badInput({input.file.string(), prepared.error().place, prepared.error().reason});
  }
  for (const std::size_t moment : input.wanted) {
    const std::filesystem::path& output = input.outputs[moment];
    const Pose pose = clip.value() == nullptr
                          ? bindPose(character.skeleton)
                          : samplePose(character.skeleton, *clip.value(), static_cast<float>(job.times[moment]));
    Surface surface;
    smoother.smooth(pose, surface);
    progress("writing " + output.string());
    if (const auto written = writeSurface(surface, character, output, reports[moment]); !written) {
      return badInput(written.error());
    }
    if (const int status = putResult(output.string() + '\n'); status != kDone) return status;
  }
  return kDone;
}

int runSmooth(const SmoothOptions& options) {
  const auto job = planSmooth(options);
  if (!job) return refused(job.error());
  return runBatch(job->batch, options.batch.dryRun,
                  [&](const BatchInput& input) { return smoothInput(options, job.value(), input); });
}

}  // namespace

Verb smoothVerb() {
  return makeVerb<SmoothOptions>("smooth", "Write the smoothed surface of one moment, or of each frame",
                                 addSmoothOptions, runSmooth);
}

}  // namespace sinew::app
