// app/command/render.cpp: `sinew render`: frames all moments together, then poses, smooths, draws and writes each.

#include <cstdio>
#include <filesystem>
#include <future>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/render_plan.h"
#include "app/command/surface_options.h"
#include "app/command/verbs.h"
#include "app/ui/offscreen.h"
#include "app/viewport/gpu/drawn_on_card.h"
#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/picture_files.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/viewport.h"
#include "core/character/skinning.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/stopwatch.h"
#include "core/rig/mesh_layers.h"
#include "core/surface/projection/replace.h"
#include "sinew/character/pose_check.h"
#include "sinew/geometry/result.h"
#include "sinew/surface/smoother.h"

namespace sinew::app {
namespace {

/// Writes .png files on a thread while the next picture is drawn: one at a time, in order.
class PictureWriter {
 public:
  /// First finishes the previous picture. Error: that of the previous picture.
  Result<void> write(const std::filesystem::path& file, Image image) {
    if (const Result<void> before = finish(); !before) return before;
    file_ = file;
    writing_ = std::async(std::launch::async, [file, image = std::move(image)]() -> Written {
      Stopwatch watch;
      const Result<std::string> bytes = pngBytes(image);
      if (!bytes) return {Error{file.string(), bytes.error().place, bytes.error().reason}, 0.0};
      Result<void> done = writeFileAtomically(file, bytes.value());
      return {std::move(done), watch.lap()};
    });
    return {};
  }

  /// Waits for the last picture and prints its name.
  Result<void> finish() {
    if (!writing_.valid()) return {};
    Written written = writing_.get();
    seconds_ += written.seconds;
    if (written.result) status_ = putResult(file_.string() + '\n');
    return std::move(written.result);
  }

  [[nodiscard]] double seconds() const { return seconds_; }
  /// kDone, or the status of printing.
  [[nodiscard]] int status() const { return status_; }

 private:
  struct Written {
    Result<void> result;
    double seconds = 0.0;
  };
  std::filesystem::path file_;
  std::future<Written> writing_;
  double seconds_ = 0.0;
  int status_ = kDone;
};

std::vector<bool> cornersOfImplicitTriangles(const ControlMesh& mesh, const Surface& surface) {
  std::vector<bool> held(mesh.positions.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (surface.classes[t] != TriangleClass::kImplicit) continue;
    for (const int v : mesh.triangles[t].vertices) held[static_cast<std::size_t>(v)] = true;
  }
  return held;
}

/// The segments that `replace` searches (Fig. 5 of the paper), in world space: from each corner of an implicit triangle
/// to its anchor, both in the pose; kFound if the smoothed surface lies off the control vertex, else kLost.
std::vector<SceneSegment> anchorSegments(const Character& character, const Pose& pose,
                                         std::span<const float> morphWeights, const Surface& surface) {
  SkinnedMesh skinned;
  skin(character, pose, morphWeights, skinned);
  std::vector<glm::vec3> anchors;
  poseAnchors(findAnchors(character.skeleton, character.mesh.positions), pose, anchors);
  const std::vector<bool> held = cornersOfImplicitTriangles(character.mesh, surface);
  std::vector<SceneSegment> segments;
  for (std::size_t v = 0; v < anchors.size(); ++v) {
    if (!held[v]) continue;
    const bool moved = surface.positions[v] != skinned.positions[v];
    segments.push_back({skinned.positions[v], anchors[v], moved ? SegmentClass::kFound : SegmentClass::kLost});
  }
  return segments;
}

struct RenderSeconds {
  double smooth = 0.0, upload = 0.0, draw = 0.0, write = 0.0;
};

/// Draws the pictures of one input.
class Drawing {
 public:
  Drawing(const OpenedInput& input, const RenderPlan& plan, SteadyView view, Smoother& smoother, Viewport& viewport)
      : input_(input),
        plan_(plan),
        view_(std::move(view)),
        poser_(input.rig, *input.character),
        smoother_(smoother),
        viewport_(viewport) {
    if (plan.display.shading != Shading::kClasses) return;
    layers_ = layersOf(input.rig, *input.character, guessLayers(*input.character));
  }

  Image draw(const Moment& moment);
  /// Computes the surface on the graphics card as long as it can.
  void drawFromCard(std::unique_ptr<DrawnOnCard> card) { card_ = std::move(card); }

  RenderSeconds seconds;

 private:
  const Surface& makeSurface(const Pose& pose);

  const OpenedInput& input_;
  const RenderPlan& plan_;
  SteadyView view_;
  RigPoser poser_;
  Smoother& smoother_;
  Viewport& viewport_;
  std::vector<SkinLayer> layers_;  ///< Scene::layers.
  std::unique_ptr<DrawnOnCard> card_;
  Surface surface_;  ///< From the processor.
};

void tellLeft(const std::string& reason) { message("the surface is computed by the processor: " + reason); }

const Surface& Drawing::makeSurface(const Pose& pose) {
  if (card_) {
    if (const auto reason = card_->make(pose); !reason) {
      viewport_.setCardVertices(card_->vertices());
      return card_->surface();
    } else {
      tellLeft(*reason);
      card_.reset();
      viewport_.setCardVertices(std::nullopt);
    }
  }
  smoother_.smooth(pose, surface_);
  return surface_;
}

Image Drawing::draw(const Moment& moment) {
  const View view = view_.at(moment);
  const Character& character = smoother_.character();
  Pose pose = poseAt(character, input_.clip, moment.time);
  if (const auto sound = checkPose(character, pose); !sound) {
    message(sound.error().text() + " at " + std::to_string(moment.time) + " s: the bind pose is shown");
    pose = bindPose(character.skeleton);
  }
  Stopwatch watch;
  const Surface& surface = makeSurface(pose);
  seconds.smooth += watch.lap();
  Scene scene;
  scene.character = &character;
  scene.surface = &surface;
  scene.pose = &pose;
  const PosedRig posed = poser_.pose(pose);
  scene.primitives = shapesOf(input_.rig, posed);
  if (plan_.display.controlMesh) {
    SkinnedMesh skinned;
    skin(character, pose, posed.morphWeights, skinned);
    scene.skinnedControlPositions = std::move(skinned.positions);
  }
  scene.layers = layers_;
  if (plan_.anchors) scene.segments = anchorSegments(character, pose, posed.morphWeights, surface);
  if (plan_.isMean()) viewport_.drawMean(scene, view, plan_.display, meanSamples(plan_.samples));
  else viewport_.draw(scene, view, plan_.display);
  seconds.upload += viewport_.seconds().upload;
  seconds.draw += viewport_.seconds().draw;
  return viewport_.readPixels();
}

void tellTimes(const RenderSeconds& seconds, std::size_t pictures) {
  char line[160];
  const double each = 1000.0 / static_cast<double>(pictures);
  std::snprintf(line, sizeof line, "%zu picture%s, each: smooth %.1f ms, upload %.1f ms, draw %.1f ms, write %.1f ms",
                pictures, pictures == 1 ? "" : "s", seconds.smooth * each, seconds.upload * each, seconds.draw * each,
                seconds.write * each);
  message(line);
}

void addLook(CLI::App& verb, RenderOptions& options) {
  verb.add_option("--view", options.view,
                  "front, back, left, right, top, bottom, three-quarter, or YAW,PITCH in degrees")
      ->type_name("VIEW");
  verb.add_flag("--orthographic", options.orthographic, "Orthographic: no perspective");
  verb.add_option("--shading", options.shading,
                  "textured, clay, classes (implicit, straddling, normal) or heat (displacement)")
      ->type_name("S");
  verb.add_option("--show", options.show,
                  "Any of muscles (flesh under glass), skeleton, primitives, influence, wire, control, "
                  "anchors, classes, relief (normal maps on clay)")
      ->type_name("WHAT,...")
      ->delimiter(',')
      ->expected(1)
      ->take_all();
  verb.add_option("--glass", options.glass, "With --show muscles: how clear the skin is, 0 to 1 (0.8)")->type_name("X");
  verb.add_flag("--surface,!--no-surface", options.surface, "The smoothed surface (on)");
  verb.add_flag("--ground,!--no-ground", options.ground, "Grid and shadow (on)");
  verb.add_option("--on", options.on,
                  "Compute the surface on the processor or, with gpu, on the graphics card (processor)")
      ->type_name("WHERE")
      ->check(CLI::IsMember({"processor", "gpu"}));
  verb.add_flag("--transparent", options.transparent, "No background: an alpha channel instead");
  verb.add_option("--light", options.light, "studio, outdoor, rim or white (studio)")->type_name("L");
  verb.add_option("--background", options.background, "studio, dark, mid, light, gradient or checker (studio)")
      ->type_name("B");
  verb.add_flag("--ao", options.occlusion, "Ambient occlusion: crevices and folds are darker");
  verb.add_option("--size", options.size, "Pixels, each 16 to 8192 (1280x800)")->type_name("WxH");
  verb.add_option(
          "--samples", options.samples,
          "Samples per pixel, at most what the driver offers; 4 or 16 with --ao; above 4, 16 with --show muscles (4)")
      ->type_name("N")
      ->check(CLI::Range(1, 64));
}

void addRenderOptions(CLI::App& verb, RenderOptions& options) {
  addPath(verb, "FILE", options.input, "Rig (.rig.json) or character (.glb, .gltf, .vrm)");
  addClipsOption(verb, options.clips);
  verb.add_option("--clip", options.clip,
                  "Pose from this clip, or \"Range of motion\", made from the joints; "
                  "without any of these, the bind pose")
      ->type_name("NAME");
  verb.add_option("--time", options.time, "Seconds into the clip (of the first, if none is named)")->type_name("S");
  addFrameOptions(verb, options.batch);
  verb.add_option("--turntable", options.turntable,
                  "Go around the character in N pictures, of one moment or with --frames as the clip plays")
      ->type_name("N")
      ->check(CLI::Range(2, kMostTurns));
  verb.add_option(
          "--sheet", options.sheet,
          "One picture of C columns and R rows, each as large as --size: of the frames, the turntable, the whole "
          "clip, or from all sides")
      ->type_name("CxR");
  addLook(verb, options);
  addSurfaceOptions(verb, options.surfaceOptions);
  addPath(verb, "-o,--output", options.output,
          "Picture to write: OUT.png, OUT_%04d.png with --frames or --turntable, or all of them as one moving "
          "picture, OUT.webp, or OUT.gif or OUT.mp4 where ffmpeg is installed")
      ->type_name("OUT")
      ->required();
  addBatchOptions(verb, options.batch);
}

/// One file per picture.
int writePictures(const OpenedInput& opened, const BatchInput& input, Drawing& drawing, BatchProgress& progress) {
  PictureWriter writer;
  std::size_t made = 0;
  for (const std::size_t moment : opened.wanted) {
    Image image = drawing.draw(opened.moments[moment]);
    if (const auto written = writer.write(input.outputs[moment], std::move(image)); !written) {
      return badInput(written.error());
    }
    if (writer.status() != kDone) return writer.status();
    progress.show(++made);
  }
  if (const auto written = writer.finish(); !written) return badInput(written.error());
  drawing.seconds.write = writer.seconds();
  return writer.status();
}

int writeMovie(const OpenedInput& opened, const RenderPlan& plan, const std::filesystem::path& file, Drawing& drawing,
               BatchProgress& progress) {
  const auto movie = makeMovie(file, plan.picturesPerSecond);
  Stopwatch watch;
  for (std::size_t i = 0; i < opened.moments.size(); ++i) {
    const Image image = drawing.draw(opened.moments[i]);
    watch.lap();
    if (const auto added = movie->add(image); !added) return badInput(added.error());
    drawing.seconds.write += watch.lap();
    progress.showPart(static_cast<double>(i + 1) / static_cast<double>(opened.moments.size()));
  }
  watch.lap();
  if (const auto written = movie->finish(); !written) return badInput(written.error());
  drawing.seconds.write += watch.lap();
  return putResult(file.string() + '\n');
}

int writeSheet(const OpenedInput& opened, const RenderPlan& plan, const std::filesystem::path& file, Drawing& drawing,
               BatchProgress& progress) {
  std::vector<Image> pictures;
  for (const Moment& moment : opened.moments) {
    pictures.push_back(drawing.draw(moment));
    progress.showPart(static_cast<double>(pictures.size()) / static_cast<double>(opened.moments.size()));
  }
  PictureWriter writer;
  if (const auto begun = writer.write(file, contactSheet(pictures, plan.sheet)); !begun) return badInput(begun.error());
  if (const auto written = writer.finish(); !written) return badInput(written.error());
  drawing.seconds.write = writer.seconds();
  return writer.status();
}

/// Makes the wanted pictures of one input.
int renderInput(const RenderOptions& options, const RenderPlan& plan, const BatchInput& input,
                BatchProgress& progress) {
  const auto opened = openToRender(options, plan, input);
  if (!opened) return badInput(opened.error());
  if (!opened->left.empty()) message(opened->left);
  if (options.batch.dryRun) return putNames(input, opened->wanted);
  SteadyView view = steadyView(opened.value(), options, plan);
  const Rig rig = settled(opened.value(), view.view);
  Smoother smoother(opened->character);
  if (const auto prepared = smoother.prepare(rig); !prepared) {
    return badInput({input.file.string(), prepared.error().place, prepared.error().reason});
  }

  const auto context = OffscreenContext::create();
  if (!context) return badInput(context.error());
  const auto viewport = Viewport::create(plan.isMean() ? 1 : plan.samples);
  if (!viewport) return badInput(viewport.error());
  viewport.value()->setCharacter(*opened->character);
  viewport.value()->setFinishFrames(true);
  viewport.value()->setOccludesOnce(true);
  Drawing drawing(opened.value(), plan, std::move(view), smoother, *viewport.value());
  if (plan.onCard) {
    auto card = DrawnOnCard::create(opened->character, rig);
    if (card) drawing.drawFromCard(std::move(card).value());
    else tellLeft(card.error().text());
  }
  int status = kDone;
  if (plan.sheet.x > 0) status = writeSheet(opened.value(), plan, input.outputs.front(), drawing, progress);
  else if (plan.isMovie) status = writeMovie(opened.value(), plan, input.outputs.front(), drawing, progress);
  else status = writePictures(opened.value(), input, drawing, progress);
  const std::size_t drawn = plan.isOneFile() ? opened->moments.size() : opened->wanted.size();
  if (status == kDone && drawn > 0) tellTimes(drawing.seconds, drawn);
  return status;
}

int runRender(const RenderOptions& options) {
  const auto plan = planRender(options);
  if (!plan) return refused(plan.error());
  BatchProgress progress("rendering " + options.output.string(), plan->batch, options.batch);
  return runBatch(plan->batch, options.batch, [&](const BatchInput& input) {
    const int status = renderInput(options, plan.value(), input, progress);
    if (status == kDone) progress.leave(input);
    return status;
  });
}

Result<FarmCheck> checkRender(const RenderOptions& options) {
  const auto plan = planRender(options);
  if (!plan) return plan.error();
  return checkForFarm("render", plan->batch, options.batch, [&](const BatchInput& input) -> Result<InputCheck> {
    const auto opened = openToRender(options, plan.value(), input);
    if (!opened) return opened.error();
    ClipFrames frames;
    frames.count = plan->isOneFile() ? 1 : opened->moments.size();
    frames.left = opened->left;
    return InputCheck{opened->character, opened->rig, std::move(frames)};
  });
}

}  // namespace

Verb renderVerb() {
  return makeVerb<RenderOptions>("render", "Make pictures, off screen", addRenderOptions, runRender, checkRender);
}

}  // namespace sinew::app
