// core/rig/line_validation.cpp: the checks of a muscle line, each naming the JSON path of what it refuses.
#include <array>
#include <cmath>

#include "core/rig/animated_validation.h"
#include "core/rig/refusals.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

/// A number of a line and the range it must lie in.
struct LineNumber {
  const char* key;
  const char* words;
  float value;
  float least;
  float most;
};

Result<void> validateSettings(const LineSettings& line, const std::string& place) {
  const std::array numbers = {
      LineNumber{".rest", "rest length", line.rest, kLeastRest, kMostRest},
      LineNumber{".tendons[0]", "origin tendon", line.tendons.x, 0.0f, kMostTendons},
      LineNumber{".tendons[1]", "insertion tendon", line.tendons.y, 0.0f, kMostTendons},
      LineNumber{".tendons", "both tendons together", line.tendons.x + line.tendons.y, 0.0f, kMostTendons},
      LineNumber{".volume", "volume", line.volume, 0.0f, kMostVolume},
      LineNumber{".pivot", "pivot", line.pivot, 0.0f, 1.0f},
      LineNumber{".twist", "twist", line.twist, 0.0f, 1.0f},
      LineNumber{".flex[0]", "flex height", line.flex.x, kLeastFlex, kMostFlex},
      LineNumber{".flex[1]", "flex width", line.flex.y, kLeastFlex, kMostFlex},
      LineNumber{".activation.base", "activation", line.base, 0.0f, 1.0f},
      LineNumber{".activation.gain", "activation gain", line.gain, 0.0f, kMostGain},
      LineNumber{".activation.full", "full contraction", line.full, kLeastFull, kMostFull},
  };
  for (const auto& [key, words, value, least, most] : numbers) {
    if (value >= least && value <= most) continue;
    return outOfRange(place + key, "a number from " + numberText(least) + " to " + numberText(most), value, words);
  }
  if (!(line.limits.x > 0.0f && line.limits.x < 1.0f)) {
    return outOfRange(place + ".limits[0]", "a number > 0 and < 1", line.limits.x, "least stretch");
  }
  if (!(line.limits.y > 1.0f && std::isfinite(line.limits.y))) {
    return outOfRange(place + ".limits[1]", "a number > 1", line.limits.y, "most stretch");
  }
  return {};
}

Result<void> validateAnchor(const LineAnchor& anchor, const std::string& place, const char* words) {
  if (auto bone = validateName(anchor.bone, place + ".bone"); !bone) return named(words, bone.error());
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(anchor.point[i])) continue;
    return outOfRange(place + indexed(".point", static_cast<std::size_t>(i)), "a finite number", anchor.point[i],
                      words);
  }
  return {};
}

Result<void> validateLineParts(const MuscleLine& line, const std::string& place) {
  if (auto name = validateName(line.name, place + ".name"); !name) return name;
  if (auto origin = validateAnchor(line.origin, place + ".origin", "origin"); !origin) return origin;
  if (auto insertion = validateAnchor(line.insertion, place + ".insertion", "insertion"); !insertion) return insertion;
  if (line.via) {
    if (auto via = validateAnchor(*line.via, place + ".via", "via point"); !via) return via;
  }
  if (auto settings = validateSettings(line.settings, place); !settings) return settings;
  return validateAnimated(line.animated, ParameterOwner::kLine, place);
}

}  // namespace

Result<void> validateLine(const MuscleLine& line, const std::string& place) {
  if (auto parts = validateLineParts(line, place); !parts) {
    return about(line.name.empty() ? "a muscle line" : quoted("muscle line", line.name), parts.error());
  }
  return {};
}

}  // namespace sinew
