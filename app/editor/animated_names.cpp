// app/editor/animated_names.cpp: how the interface and the history call numbers that are keyed or driven, and inputs.

#include "app/editor/animated_names.h"

#include <cmath>
#include <cstdio>

#include "app/document/shown_names.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

std::string ownerName(const Rig& rig, const NumberRef& ref) {
  const auto index = static_cast<std::size_t>(ref.owner);
  const ParameterOwner owner = ownerOf(ref.parameter);
  if (owner == ParameterOwner::kMorph) return rig.morphs[index].name;
  return owner == ParameterOwner::kLine ? rig.lines[index].name : rig.primitives[index].name;
}

/// "turn about X of ", where it is one of the frame's axes.
std::string turnWords(const glm::vec3& axis) {
  constexpr const char* kWords[][2] = {{"turn about X of ", "turn about -X of "},
                                       {"turn about Y of ", "turn about -Y of "},
                                       {"turn about Z of ", "turn about -Z of "}};
  for (int i = 0; i < 3; ++i) {
    if (std::abs(axis[i]) == 1.0f) return kWords[i][axis[i] < 0.0f ? 1 : 0];
  }
  return "turn of ";
}

}  // namespace

std::string wordsFor(const Rig& rig, std::span<const NumberRef> refs) {
  const Parameter parameter = refs.front().parameter;
  std::string words = sinew::wordsFor(parameter);
  words[0] = toLower(words[0]);
  if (ownerOf(parameter) == ParameterOwner::kSurface) return words;
  const char* several = ownerOf(parameter) == ParameterOwner::kMorph ? " shapes" : " muscles";
  return words + " of " + (refs.size() == 1 ? ownerName(rig, refs.front()) : std::to_string(refs.size()) + several);
}

std::string wordsFor(const DriverInput& input, const Skeleton& skeleton) {
  const std::string bone = shownBoneName(skeleton, input.bone);
  switch (input.kind) {
    case DriverInputKind::kBend:
      return "bend of " + bone;
    case DriverInputKind::kTwist:
      return "twist of " + bone;
    case DriverInputKind::kAxis:
      return turnWords(input.axis) + bone;
    case DriverInputKind::kPose:
      return "pose of " + bone;
    case DriverInputKind::kLength:
      return "length of " + input.line;
    case DriverInputKind::kDistance:
      return "distance from " + shownBoneName(skeleton, input.from.bone) + " to " +
             shownBoneName(skeleton, input.to.bone);
    case DriverInputKind::kChannel:
      break;
  }
  return "channel " + input.channel;
}

std::string inputText(DriverInputKind kind, float value) {
  char text[32];
  const auto number = static_cast<double>(value);
  switch (kind) {
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
    case DriverInputKind::kAxis:
      std::snprintf(text, sizeof text, "%.1f\xc2\xb0", number);
      break;
    case DriverInputKind::kLength:
    case DriverInputKind::kDistance:
      std::snprintf(text, sizeof text, "%.0f %%", 100.0 * number);
      break;
    default:
      std::snprintf(text, sizeof text, "%.2f", number);
  }
  return text;
}

const char* wordFor(CurveKind kind) {
  constexpr const char* kWords[] = {"Smooth", "Linear", "Step"};
  return kWords[static_cast<int>(kind)];
}

std::string timeText(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f s", seconds);
  return text;
}

}  // namespace sinew::app
