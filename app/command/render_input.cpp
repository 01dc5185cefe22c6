// app/command/render_input.cpp: opening, moments, framing.

#include "app/command/render_input.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <span>

#include <glm/gtc/matrix_transform.hpp>

#include "app/command/clip_frames.h"
#include "app/command/console.h"
#include "app/command/contact_sheet.h"
#include "app/document/document.h"
#include "app/document/playback.h"
#include "app/viewport/render/picking.h"
#include "app/viewport/render/view.h"
#include "core/character/bone_segments.h"
#include "core/character/skinning.h"
#include "core/rig/attachment.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {
namespace {

constexpr int kFramedTurns = 24;  ///< A turntable is framed from so many sides.

/// Points that hold all that one moment shows: skin, ellipsoids, and bones where they are drawn.
void addFramedPoints(const OpenedInput& input, const PosedRig& posed, const Pose& pose, const DisplaySettings& display,
                     std::vector<glm::vec3>& points) {
  SkinnedMesh skinned;
  skin(*input.character, pose, posed.morphWeights, skinned);
  const std::vector<glm::vec3> extremes = extremePoints(skinned.positions);
  points.insert(points.end(), extremes.begin(), extremes.end());
  for (const PrimitiveShape& shape : shapesOf(input.rig, posed)) {
    if (shape.sign < 0 && !display.primitives && !display.influence && !display.anatomy) continue;
    const std::array<glm::vec3, 6> ends = extremesOf(shape, display.influence ? shape.reach : 1.0f);
    points.insert(points.end(), ends.begin(), ends.end());
  }
  if (!display.skeleton) return;
  for (const BoneSegment& segment : boneSegments(input.character->skeleton, pose)) {
    points.push_back(segment.head);
    points.push_back(segment.tail);
  }
}

/// Without frames: one moment, as many as there are pictures in a turn, or as many as a sheet has room for.
std::vector<Moment> momentsOf(const RenderPlan& plan, const AnimationClip* clip) {
  std::vector<Moment> moments;
  for (const double time : plan.times) moments.push_back({time, 0.0f});
  if (plan.spreads && clip != nullptr) {
    const int cells = plan.sheet.x * plan.sheet.y;
    moments.clear();
    for (int i = 0; i < cells; ++i) {
      moments.push_back({static_cast<double>(clip->duration) * i / std::max(cells - 1, 1), 0.0f});
    }
  }
  for (std::size_t i = 0; plan.turntable > 0 && i < moments.size(); ++i) {
    const double turns = static_cast<double>(i) / plan.turntable;
    moments[i].turn = static_cast<float>(2.0 * std::numbers::pi * (turns - std::floor(turns)));
  }
  return moments;
}

}  // namespace

Result<OpenedInput> openToRender(const RenderOptions& options, const RenderPlan& plan, const BatchInput& input) {
  auto document = openWithClips(input.file, options.clips);
  if (!document) return document.error();
  document.value().character = withClipNamed(document->character, options.clip);
  auto rig = overridden(document.value(), options.surfaceOptions);
  if (!rig) return rig.error();
  OpenedInput opened{document->character, std::move(rig).value(), nullptr, {}, {}, {}};
  const Skeleton& skeleton = opened.character->skeleton;
  if (const auto missing = missingBones(opened.rig, skeleton); !missing.empty()) {
    const Error refusal = refusalOf(missing.front(), skeleton);
    return Error{input.file.string(), refusal.place, refusal.reason};
  }
  if (plan.animated) {
    const auto named = options.clip.empty() ? std::nullopt : std::optional(options.clip);
    const auto clip = clipOf(document.value(), named, options.time.value_or(0.0));
    if (!clip) return clip.error();
    opened.clip = clip.value();
  }
  const auto frames = framesInClip(plan.frames, options.batch, input.wanted, opened.clip, document->characterFile);
  if (!frames) return frames.error();
  opened.moments = momentsOf(plan, opened.clip);
  if (!plan.frames.empty()) opened.moments.resize(frames->count);
  opened.wanted = plan.isOneFile() ? input.wanted : frames->wanted;
  opened.left = frames->left;
  if (plan.sheet.x > 0) {
    std::vector<Moment> shown;
    const auto room = static_cast<std::size_t>(plan.sheet.x * plan.sheet.y);
    for (const std::size_t i : evenly(opened.moments.size(), room)) shown.push_back(opened.moments[i]);
    opened.moments = std::move(shown);
  }
  return opened;
}

View SteadyView::at(const Moment& moment) const {
  if (moment.turn == 0.0f) return view;
  const glm::vec3 up(0.0f, 1.0f, 0.0f);
  const auto turned = [&](float angle) {
    const glm::mat4 there = glm::translate(glm::mat4(1.0f), center);
    return there * glm::rotate(glm::mat4(1.0f), angle, up) * glm::translate(glm::mat4(1.0f), -center);
  };
  View result = view;
  result.viewFromWorld = view.viewFromWorld * turned(-moment.turn);
  result.eyeInWorld = glm::vec3(turned(moment.turn) * glm::vec4(view.eyeInWorld, 1.0f));
  return result;
}

SteadyView steadyView(const OpenedInput& input, const RenderOptions& options, const RenderPlan& plan) {
  const RigPoser poser(input.rig, *input.character);
  std::vector<glm::vec3> points;
  std::optional<double> last;
  for (const Moment& moment : input.moments) {
    if (last == moment.time) continue;
    last = moment.time;
    const Pose pose = poseAt(*input.character, input.clip, moment.time);
    addFramedPoints(input, poser.pose(pose), pose, plan.display, points);
  }
  SteadyView steady;
  steady.center = boundsOf(points).center();
  if (plan.turntable > 0) {
    // As the character looks from all sides.
    std::vector<glm::vec3> around;
    for (int i = 0; i < kFramedTurns; ++i) {
      const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kFramedTurns;
      const glm::mat3 turn(glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0.0f, 1.0f, 0.0f)));
      for (const glm::vec3& point : points) around.push_back(steady.center + turn * (point - steady.center));
    }
    points = std::move(around);
  }
  steady.view = framedView(points, plan.yaw, plan.pitch, plan.size, options.orthographic);
  return steady;
}

/// Detail that follows the size on screen, settled for all pictures.
Rig settled(const OpenedInput& input, const View& view) {
  Rig rig = input.rig;
  if (!rig.smoothing.autoDepth) return rig;
  const Character& character = *input.character;
  SkinnedMesh skinned;
  const Pose pose = poseAt(character, input.clip, input.moments.front().time);
  skin(character, pose, RigPoser(rig, character).pose(pose).morphWeights, skinned);
  const float pixels = character.height / view.unitsPerPixelAt(boundsOf(skinned.positions).center());
  if (rig.smoothing.detail == DetailKind::kAdaptive) {
    rig.smoothing.tolerance = autoTolerance(pixels, 0.0f);
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "%.2g", static_cast<double>(rig.smoothing.tolerance));
    message("tolerance " + std::string(number.data()) + " for the character's size in the picture");
    return rig;
  }
  rig.smoothing.depth = autoDepth(meanEdgeFraction(character.mesh, character.height), pixels, 0);
  message("depth " + std::to_string(rig.smoothing.depth) + " for the character's size in the picture");
  return rig;
}

}  // namespace sinew::app
