// app/cli/surface_options.cpp: how the surface is made, and the clip it moves by.
#include "app/cli/surface_options.h"

#include <algorithm>
#include <charconv>

#include <CLI/CLI.hpp>

#include "app/cli/console.h"

namespace sinew::app {
namespace {

constexpr double kPastEnd = 1e-4;  ///< Seconds: less is rounding.

std::string isAngle(const std::string& text) {
  float degrees = -1.0f;
  const char* const end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, degrees);
  if (failed == std::errc{} && stop == end && degrees >= 0.0f && degrees <= 180.0f) return {};
  return "expected degrees from 0 to 180, got \"" + text + '"';
}

std::string clipNames(const Character& character) {
  if (character.clips.empty()) return "none: it has no clips";
  std::string names;
  for (const AnimationClip& clip : character.clips) names += (names.empty() ? "\"" : ", \"") + clip.name + '"';
  return character.clips.size() == 1 ? names : "one of " + names;
}

}  // namespace

void addSurfaceOptions(CLI::App& verb, SurfaceOptions& options) {
  verb.add_option(
          "--depth", options.depth,
          "Every triangle becomes N x N, in place of the rig's depth, also of one that follows the size on screen")
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
  verb.add_option("--crease", options.crease,
                  "Shade faces that meet at more than this angle apart; 180: smooth everywhere")
      ->type_name("DEGREES")
      ->check(isAngle);
}

Rig overridden(Rig rig, const SurfaceOptions& options) {
  if (options.depth) {
    rig.smoothing.depth = *options.depth;
    rig.smoothing.autoDepth = false;
  }
  if (options.crease) rig.smoothing.creaseAngle = *options.crease;
  rig.surface.mode = surfaceModeNamed(options.mode).value_or(rig.surface.mode);
  rig.smoothing.patch = patchKindNamed(options.patch).value_or(rig.smoothing.patch);
  rig.smoothing.projection = projectionKindNamed(options.projection).value_or(rig.smoothing.projection);
  return rig;
}

Result<const AnimationClip*> clipOf(const Document& document, const std::optional<std::string>& name, double lastTime) {
  const Character& character = *document.character;
  const std::string file = document.characterFile.string();
  auto clip = character.clips.begin();
  if (name) clip = std::ranges::find(character.clips, *name, &AnimationClip::name);
  if (clip == character.clips.end()) {
    return Error{file, name ? "clip \"" + *name + '"' : "clip", "expected " + clipNames(character)};
  }
  if (lastTime > static_cast<double>(clip->duration) + kPastEnd) {
    message(file + ": clip \"" + clip->name + "\": the time is past its end; its end is used");
  }
  return &*clip;
}

Pose poseAt(const Character& character, const AnimationClip* clip, double seconds) {
  return clip == nullptr ? bindPose(character.skeleton)
                         : samplePose(character.skeleton, *clip, static_cast<float>(seconds));
}

}  // namespace sinew::app
