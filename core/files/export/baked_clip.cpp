// core/files/export/baked_clip.cpp: a clip's times.
#include "core/files/export/baked_clip.h"

#include <algorithm>
#include <cmath>

#include "core/files/fit/poses.h"
#include "core/files/gltf/file.h"

namespace sinew::exporting {
namespace {

const AnimationClip& clipOf(const Character& character, const BakedExportSettings& settings) {
  return *std::ranges::find(character.clips, settings.clip, &AnimationClip::name);
}

}  // namespace

BakedClip::BakedClip(const Character& character, const BakedExportSettings& settings)
    : clip(clipOf(character, settings)), times(clipTimes(clip, momentsPerSecond(settings))) {
  for (std::size_t frame = 0; frame < times.size(); ++frame) frames.push_back(static_cast<double>(frame));
  const double end = static_cast<double>(clip.duration) * momentsPerSecond(settings);
  if (std::abs(end - frames.back()) > kSameTime) frames.back() = end;
}

double momentsPerSecond(const BakedExportSettings& settings) { return settings.framesPerSecond * settings.substeps; }

void refuseClip(const BakedExportSettings& settings, const std::string& what) {
  throw gltf::Refusal{
      errorAt("clip \"" + settings.clip + '"', what + "; expected fewer frames a second, or a smaller depth")};
}

void requireFrames(const Character& character, const BakedExportSettings& settings, int most) {
  const AnimationClip& clip = clipOf(character, settings);
  if (static_cast<double>(clip.duration) * momentsPerSecond(settings) >= most) {
    refuseClip(settings, "has more than " + std::to_string(most) + " frames");
  }
}

}  // namespace sinew::exporting
