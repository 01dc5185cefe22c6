// app/command/surface_options.cpp: the options, and what they make of a document.
#include "app/command/surface_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "core/character/clip_names.h"
#include "core/character/range_of_motion.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/attachment.h"
#include "core/rig/rig_edit.h"
#include "sinew/character/character_pose.h"

namespace sinew::app {
namespace {

constexpr std::size_t kNamesListed = 12;
constexpr double kPastEnd = 1e-4;  ///< Seconds; less is rounding.

/// @param expected  the range in words
std::string isWithin(const std::string& text, float least, float most, const char* expected) {
  float number = least - 1.0f;
  const char* const end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, number);
  if (failed == std::errc{} && stop == end && number >= least && number <= most) return {};
  return std::string("expected ") + expected + ", got \"" + text + '"';
}

std::string isAngle(const std::string& text) { return isWithin(text, 0.0f, 180.0f, "degrees from 0 to 180"); }

std::string isTolerance(const std::string& text) {
  return isWithin(text, kLeastTolerance, kMostTolerance, "a number from 0.0001 to 0.01");
}

/// A name may contain "=": the last one counts.
std::string isShape(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) return "expected NAME=WEIGHT, got \"" + text + '"';
  return isWithin(text.substr(equals + 1), kLeastMorphWeight, kMostMorphWeight, "a weight from -10 to 10");
}

std::string noSuchShape(const std::string& name, const std::vector<std::string>& names) {
  if (names.empty()) return "the character has no shapes";
  std::string known;
  for (std::size_t i = 0; i < std::min(names.size(), kNamesListed); ++i) {
    known += (known.empty() ? "\"" : ", \"") + names[i] + '"';
  }
  if (names.size() > kNamesListed) known += " and " + std::to_string(names.size() - kNamesListed) + " more";
  return "expected " + (names.size() > 1 ? "one of " + known : known) + didYouMean(name, names);
}

/// @param shape  as isShape lets it pass
Result<Rig> withShape(Rig rig, const std::string& shape, const Document& document) {
  const std::size_t equals = shape.rfind('=');
  const std::string name = shape.substr(0, equals);
  const std::vector<std::string> names = morphNames(*document.character);
  if (std::ranges::find(names, name) == names.end()) {
    return Error{document.characterFile.string(), "shape \"" + name + '"', noSuchShape(name, names)};
  }
  float weight = 0.0f;
  std::from_chars(shape.data() + equals + 1, shape.data() + shape.size(), weight);
  return setMorphWeight(std::move(rig), name, weight);
}

constexpr double kSameFrame = 1e-3;  ///< Fraction of a frame; less is rounding.

std::string numberText(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

std::string endText(const AnimationClip& clip, double framesPerSecond, int last) {
  return "ends at frame " + std::to_string(last) + " (" + numberText(static_cast<double>(clip.duration)) + " s at " +
         numberText(framesPerSecond) + " a second)";
}

}  // namespace

void addDetailOptions(CLI::App& verb, DetailOverride& detail) {
  verb.add_option(
          "--depth", detail.depth,
          "Every triangle becomes N x N, in place of the rig's detail, even detail that follows the size on screen")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxDepth));
  verb.add_option_function<std::string>(
          "--detail", [&detail](const std::string& word) { detail.kind = detailKindNamed(word); },
          "adaptive (as fine as the tolerance asks for) or uniform (the depth everywhere)")
      ->type_name("D")
      ->check(CLI::IsMember({"adaptive", "uniform"}));
  verb.add_option("--tolerance", detail.tolerance,
                  "Adaptive: how far triangles may lie off the surface, fraction of the height (0.001)")
      ->type_name("T")
      ->check(isTolerance);
}

void addClipsOption(CLI::App& verb, std::vector<std::string>& files) {
  verb.add_option("--clips", files,
                  "Add the clips of this file (.glb, .gltf, .vrm), with a mesh or without; once for each")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

Result<Document> openWithClips(const std::filesystem::path& file, const std::vector<std::string>& clips) {
  Result<Document> opened = openDocument(file, {clips.begin(), clips.end()});
  if (!opened) return opened;
  for (const Error& missing : missingOf(opened->clipFiles.files)) {
    message(file.string() + ": its clips are left out: " + missing.text());
  }
  for (const std::string& note : notesOf(opened->clipFiles.files)) message(note);
  return opened;
}

void addSurfaceOptions(CLI::App& verb, SurfaceOptions& options) {
  addDetailOptions(verb, options.detail);
  verb.add_option("--mode", options.mode, "swell (the skin rises over the muscles) or replace (the paper's method)")
      ->type_name("M")
      ->check(CLI::IsMember({"swell", "replace"}));
  verb.add_option("--patch", options.patch, "Curved patch over each triangle: pn, phong, spherigon or flat")
      ->type_name("P")
      ->check(CLI::IsMember({"pn", "phong", "spherigon", "flat"}));
  verb.add_option("--crease", options.crease,
                  "Shade faces that meet at more than this angle apart; 180: smooth everywhere")
      ->type_name("DEGREES")
      ->check(isAngle);
  verb.add_option("--shape", options.shapes,
                  "Weight of a shape (morph target) in place of the rig's, -10 to 10; once for each")
      ->type_name("NAME=W")
      ->allow_extra_args(false)
      ->check(isShape);
}

Result<Rig> overridden(const Document& document, const SurfaceOptions& options) {
  Rig rig = document.rig();
  options.detail.apply(rig.smoothing);
  if (options.crease) rig.smoothing.creaseAngle = *options.crease;
  rig.surface.mode = surfaceModeNamed(options.mode).value_or(rig.surface.mode);
  rig.smoothing.patch = patchKindNamed(options.patch).value_or(rig.smoothing.patch);
  for (const std::string& shape : options.shapes) {
    Result<Rig> with = withShape(std::move(rig), shape, document);
    if (!with) return with;
    rig = std::move(with).value();
  }
  return rig;
}

Result<void> checkBones(const Rig& rig, const Skeleton& skeleton, const std::filesystem::path& file) {
  const auto missing = missingBones(rig, skeleton);
  if (missing.empty()) return {};
  const Error refusal = refusalOf(missing.front(), skeleton);
  return Error{file.string(), refusal.place, refusal.reason};
}

Result<const AnimationClip*> clipOf(const Document& document, const std::optional<std::string>& name, double lastTime) {
  const Character& character = *document.character;
  const std::string file = document.characterFile.string();
  auto clip = character.clips.begin();
  if (name) clip = std::ranges::find(character.clips, *name, &AnimationClip::name);
  if (clip == character.clips.end()) {
    if (!name) return Error{file, "clip", kNoClips};
    return Error{file, "clip \"" + *name + '"', noSuchClip(*name, character.clips, {std::string(kRangeOfMotionName)})};
  }
  if (lastTime > static_cast<double>(clip->duration) + kPastEnd) {
    message(file + ": clip \"" + clip->name + "\": the time is past its end; its end is used");
  }
  return &*clip;
}

Pose poseAt(const Character& character, const AnimationClip* clip, double seconds) {
  return clip == nullptr ? bindPose(character.skeleton) : samplePose(character, *clip, static_cast<float>(seconds));
}

Result<ClipFrames> framesInClip(const std::vector<int>& frames, const BatchOptions& options,
                                const std::vector<std::size_t>& wanted, const AnimationClip* clip,
                                const std::filesystem::path& file) {
  ClipFrames inside{std::max<std::size_t>(frames.size(), 1), wanted, {}};
  if (clip == nullptr || frames.empty()) return inside;
  const double end = static_cast<double>(clip->duration) * options.framesPerSecond + kSameFrame;
  const auto past = std::ranges::upper_bound(frames, end);
  if (past == frames.end()) return inside;
  const std::string place = "clip \"" + clip->name + '"';
  const std::string ends = endText(*clip, options.framesPerSecond, static_cast<int>(std::floor(end)));
  if (past == frames.begin()) {
    return Error{file.string(), place, ends + ", before the first of --frames " + options.frames};
  }
  inside.count = static_cast<std::size_t>(past - frames.begin());
  std::erase_if(inside.wanted, [&](std::size_t moment) { return moment >= inside.count; });
  const std::size_t left = frames.size() - inside.count;
  inside.left = file.string() + ": " + place + ": " + ends + "; " + std::to_string(left) +
                (left == 1 ? " frame past it is" : " frames past it are") + " left out";
  return inside;
}

}  // namespace sinew::app
