// core/bodies/preset.h: a set of muscles that fits any body: marks instead of coordinates. docs/muscles.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/geometry/shape.h"
#include "sinew/rig/muscle_line.h"
#include "sinew/rig/muscle_sheet.h"

namespace sinew {

// Ranges of the numbers in a preset.
inline constexpr float kMostU = 3.0f;  ///< Positive or negative.
inline constexpr float kLeastHalfLength = 0.005f;
inline constexpr float kMostHalfLength = 4.0f;
inline constexpr float kLeastPresetHeight = 0.01f;
inline constexpr float kMostPresetHeight = 4.0f;
inline constexpr float kLeastPresetWidth = 0.1f;
inline constexpr float kMostPresetWidth = 10.0f;
inline constexpr float kMostDefinition = 4.0f;  ///< A muscle's factor.
inline constexpr float kLeastPresetReach = 1.01f;
inline constexpr float kMostPresetReach = 10.0f;
inline constexpr float kMostThickest = 0.9f;  ///< Positive or negative.

/// A place in a body. `slot` is of the left side; kSpine stands for the whole trunk.
struct Mark {
  Slot slot = Slot::kSpine;
  float u = 0.0f;      ///< Along the part: 0 at its start, 1 at the start of the next; may lie beyond.
  float angle = 0.0f;  ///< Degrees around it: 0 front, 90 outer side, 180 back, -90 inner side.
  float depth = 0.0f;  ///< Fraction of the local flesh: 0 on the skin, 1 on the axis.
};

/// One muscle of the left side, or one of a pair at the midline.
struct PresetMuscle {
  std::string name;         ///< Without a side.
  std::string group;        ///< Without a side: left and right get groups of their own.
  Mark belly;               ///< On the skin over the middle of the belly, or below it by the mark's depth.
  float halfLength = 0.0f;  ///< Fraction of the part's length. 0 on a line: what its tendons leave.
  float height = 0.5f;      ///< Fraction of the local flesh.
  float width = 1.0f;       ///< Multiple of the height.
  float turn = 0.0f;        ///< Rotation of the fibres in the skin, degrees; positive: upper end outwards.
  float tilt = 0.0f;        ///< Rise of that end out of the skin, degrees.
  float roll = 0.0f;        ///< Rotation about the fibres, degrees, right-handed along them.
  float definition = 1.0f;  ///< Factor on the set's.
  float reach = 0.0f;       ///< 0: the set's.
  float amount = 1.0f;      ///< As Primitive::amount.
  bool carves = false;
  bool midline = false;  ///< Next to its twin: must not cross the mirror plane.
  bool single = false;   ///< Without a twin: its center lies in the mirror plane.
  bool asLaid = false;   ///< Laid by a designer: never flattened, widened or shortened.
  Shape shape;
  std::optional<Mark> origin;  ///< With `insertion`, or neither: ends of its muscle line.
  std::optional<Mark> insertion;
  LineSettings line;
};

/// One sheet of the left side, or one of a pair at the midline.
struct PresetSheet {
  MuscleSheet sheet;                     ///< Name and group without a side; without edges and twin.
  std::vector<std::vector<Mark>> edges;  ///< On the skin. As MuscleSheet::edges.
  bool single = false;                   ///< Without a twin: its points lie in the mirror plane.
};

struct Preset {
  std::string name;
  std::string title;  ///< Shown to people.
  BodyKind body = BodyKind::kHumanoid;
  float definition = 0.35f;  ///< Fraction of their height by which bellies stand out, 0..1.
  float reach = 1.35f;
  float skinBlend = 0.015f;
  float grooves = kNewGrooves;
  std::vector<PresetMuscle> muscles;
  std::vector<PresetSheet> sheets;
};

}  // namespace sinew
