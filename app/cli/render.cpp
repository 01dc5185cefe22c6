// app/cli/render.cpp: open, frame all moments at once, then pose, smooth, draw and write each.
#include <cstdio>
#include <future>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/cli/anchor_segments.h"
#include "app/cli/console.h"
#include "app/cli/render_plan.h"
#include "app/cli/surface_options.h"
#include "app/cli/verb.h"
#include "app/document/document.h"
#include "app/platform/offscreen.h"
#include "app/render/framing.h"
#include "app/render/picking.h"
#include "app/render/png.h"
#include "app/render/viewport.h"
#include "core/base/stopwatch.h"
#include "core/character/skinning.h"
#include "core/io/files/atomic_file.h"
#include "core/rig/attachment.h"
#include "core/smoothing/auto_depth.h"
#include "core/symmetry/motion_clip.h"
#include "sinew/smoothing/smoother.h"

namespace sinew::app {
namespace {

/// A rig's muscles as they are drawn, moment after moment.
struct PosedShapes {
  const Rig& rig;
  RigPoser poser;

  [[nodiscard]] std::vector<PrimitiveShape> at(const Pose& pose) const { return shapesOf(rig, poser.pose(pose)); }
};

/// Points that hold all that one moment shows: skin, ellipsoids, and bones where they are drawn.
void addFramedPoints(const Character& character, const PosedShapes& muscles, const Pose& pose,
                     const DisplaySettings& display, std::vector<glm::vec3>& points) {
  SkinnedMesh skinned;
  skin(character, pose, skinned);
  const std::vector<glm::vec3> extremes = extremePoints(skinned.positions);
  points.insert(points.end(), extremes.begin(), extremes.end());
  for (const PrimitiveShape& shape : muscles.at(pose)) {
    if (shape.sign < 0 && !display.primitives && !display.influence && !display.anatomy) continue;
    const std::array<glm::vec3, 6> ends = extremesOf(shape, display.influence ? shape.reach : 1.0f);
    points.insert(points.end(), ends.begin(), ends.end());
  }
  if (!display.skeleton) return;
  for (const BoneSegment& segment : boneSegments(character.skeleton, pose)) {
    points.push_back(segment.head);
    points.push_back(segment.tail);
  }
}

/// One view for all moments, so that a clip's pictures stand still.
View steadyView(const Document& document, const PosedShapes& muscles, const AnimationClip* clip,
                const RenderOptions& options, const RenderPlan& plan) {
  std::vector<glm::vec3> points;
  for (const double time : plan.times) {
    addFramedPoints(*document.character, muscles, poseAt(*document.character, clip, time), plan.display, points);
  }
  return framedView(points, plan.yaw, plan.pitch, plan.size, options.orthographic);
}

/// A depth that follows the size on screen, settled for all pictures.
Rig settled(Rig rig, const Document& document, const AnimationClip* clip, const RenderPlan& plan, const View& view) {
  if (!rig.smoothing.autoDepth) return rig;
  const Character& character = *document.character;
  SkinnedMesh skinned;
  skin(character, poseAt(character, clip, plan.times.front()), skinned);
  const float pixels = character.height / view.unitsPerPixelAt(boundsOf(skinned.positions).center());
  rig.smoothing.depth = autoDepth(meanEdgeFraction(character.mesh, character.height), pixels, 0);
  message("depth " + std::to_string(rig.smoothing.depth) + " for the character's size in the picture");
  return rig;
}

struct RenderSeconds {
  double smooth = 0.0, upload = 0.0, draw = 0.0, write = 0.0;
};

Image drawPicture(double time, const AnimationClip* clip, const View& view, const PosedShapes& muscles,
                  const RenderPlan& plan, Smoother& smoother, Viewport& viewport, RenderSeconds& seconds) {
  const Character& character = smoother.character();
  const Pose pose = poseAt(character, clip, time);
  Stopwatch watch;
  Surface surface;
  smoother.smooth(pose, surface, plan.display.cullBackFaces ? std::optional(view.facingPoint()) : std::nullopt);
  seconds.smooth += watch.lap();
  Scene scene;
  scene.character = &character;
  scene.surface = &surface;
  scene.pose = &pose;
  scene.primitives = muscles.at(pose);
  if (plan.display.controlMesh) {
    SkinnedMesh skinned;
    skin(character, pose, skinned);
    scene.skinnedControlPositions = std::move(skinned.positions);
  }
  if (plan.anchors) scene.segments = anchorSegments(character, pose, surface);
  viewport.draw(scene, view, plan.display);
  watch.lap();
  // Without noise it takes the mean of many pictures.
  const bool occluded = plan.display.look.occlusion || plan.display.anatomy;
  while (occluded && !viewport.isRefined()) viewport.refine(scene, view, plan.display);
  seconds.draw += watch.lap();
  seconds.upload += viewport.seconds().upload;
  seconds.draw += viewport.seconds().draw;
  return viewport.readPixels();
}

/// Pictures are written beside the drawing of the next one; one at a time, in order.
class PictureWriter {
 public:
  /// First finishes the picture before. @return its failure, if it failed.
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
  /// Waits for the last picture, and names its file among the verb's results.
  Result<void> finish() {
    if (!writing_.valid()) return {};
    Written written = writing_.get();
    seconds_ += written.seconds;
    if (written.result) status_ = putResult(file_.string() + '\n');
    return std::move(written.result);
  }
  [[nodiscard]] double seconds() const { return seconds_; }
  /// kDone, or what became of the standard output.
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
                  "anchors, classes")
      ->type_name("WHAT,...")
      ->delimiter(',')
      ->expected(1)
      ->take_all();
  verb.add_option("--glass", options.glass, "With --show muscles: how clear the skin is, 0 to 1 (0.8)")->type_name("X");
  verb.add_flag("--surface,!--no-surface", options.surface, "The smoothed surface (on)");
  verb.add_flag("--ground,!--no-ground", options.ground, "Grid and shadow (on)");
  verb.add_flag("--cull", options.cull, "Neither compute nor draw faces that point away from the camera: faster");
  verb.add_flag("--transparent", options.transparent, "No background: an alpha channel instead");
  verb.add_option("--light", options.light, "studio, outdoor or rim (studio)")->type_name("L");
  verb.add_option("--background", options.background, "studio, dark, mid, light, gradient or checker (studio)")
      ->type_name("B");
  verb.add_flag("--ao", options.occlusion, "Ambient occlusion: crevices and folds are darker");
  verb.add_option("--size", options.size, "Pixels, each 16 to 8192 (1280x800)")->type_name("WxH");
  verb.add_option("--samples", options.samples, "Samples per pixel, at most what the driver offers (4)")
      ->type_name("N")
      ->check(CLI::Range(1, 64));
}

void addRenderOptions(CLI::App& verb, RenderOptions& options) {
  const auto to = [](std::filesystem::path& path) { return [&path](const std::string& text) { path = text; }; };
  verb.add_option_function<std::string>("FILE", to(options.input), "Rig (.rig.json) or character (.glb, .gltf)");
  verb.add_option("--clip", options.clip,
                  "Pose from this clip, or \"Range of motion\", made from the joints; "
                  "without any of these, the bind pose")
      ->type_name("NAME");
  verb.add_option("--time", options.time, "Seconds into the clip (of the first, if none is named)")->type_name("S");
  addFrameOptions(verb, options.batch);
  addLook(verb, options);
  addSurfaceOptions(verb, options.surfaceOptions);
  verb.add_option_function<std::string>("-o,--output", to(options.output),
                                        "Picture to write: OUT.png, or OUT_%04d.png with --frames")
      ->type_name("OUT")
      ->required();
  addBatchOptions(verb, options.batch);
}

/// What is wanted of one input.
int renderInput(const RenderOptions& options, const RenderPlan& plan, const BatchInput& input) {
  progress("reading " + input.file.string());
  auto document = openDocument(input.file);
  if (!document) return badInput(document.error());
  document.value().character = withClipNamed(document->character, options.clip);
  Rig rig = overridden(document->rig(), options.surfaceOptions);
  if (const auto missing = missingBones(rig, document->character->skeleton); !missing.empty()) {
    return badInput({input.file.string(), missing.front().place, missing.front().reason});
  }
  Result<const AnimationClip*> clip(nullptr);
  if (plan.animated) {
    const auto named = options.clip.empty() ? std::nullopt : std::optional(options.clip);
    clip = clipOf(document.value(), named, plan.times.back());
  }
  if (!clip) return badInput(clip.error());
  const PosedShapes muscles{rig, RigPoser(rig, *document->character)};
  const View view = steadyView(document.value(), muscles, clip.value(), options, plan);
  rig = settled(std::move(rig), document.value(), clip.value(), plan, view);
  Smoother smoother(document->character);
  if (const auto prepared = smoother.prepare(rig); !prepared) {
    return badInput({input.file.string(), prepared.error().place, prepared.error().reason});
  }

  const auto context = OffscreenContext::create();
  if (!context) return badInput(context.error());
  const auto viewport = Viewport::create(options.samples);
  if (!viewport) return badInput(viewport.error());
  viewport.value()->setCharacter(*document->character);
  viewport.value()->setFinishFrames(true);
  RenderSeconds seconds;
  PictureWriter writer;
  for (const std::size_t moment : input.wanted) {
    const std::filesystem::path& file = input.outputs[moment];
    progress("drawing " + file.string());
    Image image =
        drawPicture(plan.times[moment], clip.value(), view, muscles, plan, smoother, *viewport.value(), seconds);
    if (const auto written = writer.write(file, std::move(image)); !written) return badInput(written.error());
    if (writer.status() != kDone) return writer.status();
  }
  if (const auto written = writer.finish(); !written) return badInput(written.error());
  if (writer.status() != kDone) return writer.status();
  seconds.write = writer.seconds();
  tellTimes(seconds, input.wanted.size());
  return kDone;
}

int runRender(const RenderOptions& options) {
  const auto plan = planRender(options);
  if (!plan) return refused(plan.error());
  return runBatch(plan->batch, options.batch.dryRun,
                  [&](const BatchInput& input) { return renderInput(options, plan.value(), input); });
}

}  // namespace

Verb renderVerb() {
  return makeVerb<RenderOptions>("render", "Make pictures, off screen", addRenderOptions, runRender);
}

}  // namespace sinew::app
