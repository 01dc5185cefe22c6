// app/command/smooth.cpp: `sinew smooth`: opens, overrides, poses, smooths, exports and reports.
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command/batch.h"
#include "app/command/console.h"
#include "app/command/surface_options.h"
#include "app/command/verbs.h"
#include "app/document/document.h"
#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"
#include "core/rig/motion_clip.h"
#include "sinew/character/pose_check.h"
#include "sinew/files/surface_export.h"
#include "sinew/surface/smoother.h"

namespace sinew::app {
namespace {

struct SmoothOptions {
  std::filesystem::path file;       ///< Rig or character.
  std::filesystem::path output;     ///< isExportName().
  std::filesystem::path report;     ///< JSON; empty: none.
  std::optional<std::string> clip;  ///< Absent: the bind pose.
  std::optional<double> time;       ///< Seconds into the clip.
  BatchOptions batch;
  SurfaceOptions surface;
  ProjectionKind projection = ProjectionKind::kNewton;
  std::vector<std::string> clips;  ///< Files whose clips are added.
};

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
    // Not a number.
  }
  return "expected seconds >= 0, got \"" + text + '"';
}

std::string isOutput(const std::string& text) {
  if (isExportName(text)) return {};
  return "expected a name that ends in " + exportNameEndings() + ", got \"" + text + '"';
}

void addSmoothOptions(CLI::App& verb, SmoothOptions& options) {
  addPath(verb, "FILE", options.file, "Rig (.rig.json) or character (.glb, .gltf, .vrm)");
  CLI::Option* clip =
      verb.add_option("--clip", options.clip,
                      "Pose from this clip, or \"Range of motion\", made from the joints; without it, the bind pose");
  clip->type_name("NAME");
  addClipsOption(verb, options.clips);
  verb.add_option("--time", options.time, "Seconds into the clip (0)")->type_name("S")->check(isTime)->needs(clip);
  addFrameOptions(verb, options.batch);
  addSurfaceOptions(verb, options.surface);
  verb.add_option_function<std::string>(
          "--projection", [&options](const std::string& word) { options.projection = *projectionKindNamed(word); },
          "How roots are found: newton, or to compare, by the slow reference, the paper's bisection or analytic")
      ->type_name("P")
      ->check(CLI::IsMember({"newton", "bisection", "analytic"}));
  addPath(verb, "-o,--output", options.output, "Surface to write: " + exportNameEndings())
      ->type_name("OUT")
      ->required()
      ->check(isOutput);
  addPath(verb, "--report", options.report, "Counts, class sizes, residuals and seconds as JSON")
      ->type_name("FILE.json");
  addBatchOptions(verb, options.batch);
}

/// Writes the report first, so that every surface has one.
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

/// An input, ready to smooth.
struct OpenedInput {
  std::shared_ptr<const Character> character;
  Rig rig;
  const AnimationClip* clip = nullptr;  ///< Null: the bind pose.
  ClipFrames frames;
};

Result<OpenedInput> open(const SmoothOptions& options, const SmoothJob& job, const BatchInput& input) {
  auto document = openWithClips(input.file, options.clips);
  if (!document) return document.error();
  if (options.clip) document.value().character = withClipNamed(document->character, options.clip.value());
  auto rig = overridden(document.value(), options.surface);
  if (!rig) return rig.error();
  OpenedInput opened{document->character, std::move(rig).value(), nullptr, {}};
  if (auto attached = checkBones(opened.rig, opened.character->skeleton, input.file); !attached) {
    return attached.error();
  }
  if (options.clip) {
    const auto clip = clipOf(document.value(), options.clip, options.time.value_or(0.0));
    if (!clip) return clip.error();
    opened.clip = clip.value();
  }
  auto frames = framesInClip(job.batch.frames, options.batch, input.wanted, opened.clip, document->characterFile);
  if (!frames) return frames.error();
  opened.frames = std::move(frames.value());
  return opened;
}

/// Makes the wanted moments of one input.
int smoothInput(const SmoothOptions& options, const SmoothJob& job, const BatchInput& input, BatchProgress& progress) {
  std::vector<std::filesystem::path> reports(input.outputs.size());
  if (!options.report.empty()) {
    auto named = filesBeside(job.batch, input, options.report, "--report");
    if (!named) return badCommandLine(named.error().text());
    reports = std::move(named.value());
  }
  const auto opened = open(options, job, input);
  if (!opened) return badInput(opened.error());
  if (!opened->frames.left.empty()) message(opened->frames.left);
  if (options.batch.dryRun) return putNames(input, opened->frames.wanted);
  Smoother smoother(opened->character, options.projection);
  if (const auto prepared = smoother.prepare(opened->rig); !prepared) {
    return badInput({input.file.string(), prepared.error().place, prepared.error().reason});
  }
  std::size_t made = 0;
  for (const std::size_t moment : opened->frames.wanted) {
    const std::filesystem::path& output = input.outputs[moment];
    Surface surface;
    const Pose pose = poseAt(*opened->character, opened->clip, job.times[moment]);
    if (const auto sound = checkPose(*opened->character, pose); !sound) {
      return badInput({output.string(), sound.error().place, "cannot be written: " + sound.error().reason});
    }
    smoother.smooth(pose, surface);
    if (const auto written = writeSurface(surface, *opened->character, output, reports[moment]); !written) {
      return badInput(written.error());
    }
    if (const int status = putResult(output.string() + '\n'); status != kDone) return status;
    progress.show(++made);
  }
  return kDone;
}

int runSmooth(const SmoothOptions& options) {
  const auto job = planSmooth(options);
  if (!job) return refused(job.error());
  BatchProgress progress("smoothing " + options.output.string(), job->batch, options.batch);
  return runBatch(job->batch, options.batch, [&](const BatchInput& input) {
    const int status = smoothInput(options, job.value(), input, progress);
    if (status == kDone) progress.leave(input);
    return status;
  });
}

Result<FarmCheck> checkSmooth(const SmoothOptions& options) {
  const auto job = planSmooth(options);
  if (!job) return job.error();
  return checkForFarm("smooth", job->batch, options.batch, [&](const BatchInput& input) -> Result<InputCheck> {
    const auto opened = open(options, job.value(), input);
    if (!opened) return opened.error();
    return InputCheck{opened->character, opened->rig, opened->frames};
  });
}

}  // namespace

Verb smoothVerb() {
  return makeVerb<SmoothOptions>("smooth", "Write the smoothed surface of one moment, or of each frame",
                                 addSmoothOptions, runSmooth, checkSmooth);
}

}  // namespace sinew::app
