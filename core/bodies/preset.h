// core/bodies/preset.h: a set of muscles that fits any body: marks instead of coordinates. docs/muscles.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/geometry/shape.h"
#include "sinew/rig/muscle_line.h"

namespace sinew {

// Ranges of what a preset says.
inline constexpr float kMostU = 3.0f;  ///< Either way.
inline constexpr float kLeastHalfLength = 0.005f;
inline constexpr float kMostHalfLength = 4.0f;
inline constexpr float kLeastPresetHeight = 0.01f;
inline constexpr float kMostPresetHeight = 4.0f;
inline constexpr float kLeastPresetWidth = 0.1f;
inline constexpr float kMostPresetWidth = 10.0f;
inline constexpr float kMostDefinition = 4.0f;  ///< Of a muscle, as a factor.
inline constexpr float kLeastPresetReach = 1.01f;
inline constexpr float kMostPresetReach = 10.0f;
inline constexpr float kMostThickest = 0.9f;  ///< Either way.

/// A place in a body. `slot` is of the left side; kSpine stands for the whole trunk.
struct Mark {
  Slot slot = Slot::kSpine;
  float u = 0.0f;      ///< Along the part: 0 where it begins, 1 where the next one does; may lie beyond.
  float angle = 0.0f;  ///< Degrees round it: 0 front, 90 outer side, 180 back, -90 inner side.
  float depth = 0.0f;  ///< Under the skin, of the local flesh: 0 on the skin, 1 on the axis.
};

/// One muscle of the left side, or one of a pair at the midline.
struct PresetMuscle {
  std::string name;         ///< Without a side.
  std::string group;        ///< Likewise: each side has its own.
  Mark belly;               ///< On the skin over the middle of the belly, or under that by its depth.
  float halfLength = 0.0f;  ///< Of the part's length. 0 with a line: what its tendons leave.
  float height = 0.5f;      ///< Of the local flesh.
  float width = 1.0f;       ///< Of the height.
  float turn = 0.0f;  ///< Degrees that the fibres are turned in the skin, towards the outer side at the upper end.
  float tilt = 0.0f;  ///< Degrees that the end which `turn` turns rises out of the skin.
  float roll = 0.0f;  ///< Degrees that it is turned about its fibres, right-handed along them.
  float definition = 1.0f;  ///< Factor on the set's.
  float reach = 0.0f;       ///< 0: the set's.
  float amount = 1.0f;      ///< As Primitive::amount.
  bool carves = false;
  bool midline = false;  ///< Beside its twin: it does not cross the mirror plane.
  bool single = false;   ///< Without a twin: its center lies in the mirror plane.
  bool asLaid = false;   ///< A designer's: neither flattened nor widened nor shortened.
  Shape shape;
  std::optional<Mark> origin;  ///< Both or none: then it is on a muscle line.
  std::optional<Mark> insertion;
  LineSettings line;
};

struct Preset {
  std::string name;
  std::string title;  ///< What people read.
  BodyKind body = BodyKind::kHumanoid;
  float definition = 0.35f;  ///< How far bellies stand out, of their height, 0..1.
  float reach = 1.35f;
  float skinBlend = 0.015f;
  std::vector<PresetMuscle> muscles;
};

}  // namespace sinew
