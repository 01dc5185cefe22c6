// core/files/export/baked_clip.h: the moments of a clip that are baked, and how many may be.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/files/baked_export.h"

namespace sinew::exporting {

struct BakedClip {
  /// @param settings  of a clip that the character has
  BakedClip(const Character& character, const BakedExportSettings& settings);

  const AnimationClip& clip;
  std::vector<float> times;    ///< [frames] seconds.
  std::vector<double> frames;  ///< [frames] 0, 1 ...; the last is no whole number where the clip ends between two.
};

[[nodiscard]] double momentsPerSecond(const BakedExportSettings& settings);

/// Before the times are made. Throws gltf::Refusal where the clip has more frames than that.
void requireFrames(const Character& character, const BakedExportSettings& settings, int most);

/// Throws gltf::Refusal: of the clip, which fewer frames or vertices would do for.
[[noreturn]] void refuseClip(const BakedExportSettings& settings, const std::string& what);

}  // namespace sinew::exporting
