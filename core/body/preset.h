// core/body/preset.h: a set of muscles that fits any body: marks instead of coordinates. docs/presets.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/skeleton/body_slots.h"
#include "sinew/primitives/shape.h"
#include "sinew/rig/muscle_line.h"

namespace sinew {

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
  Mark belly;               ///< On the skin over the middle of the belly.
  float halfLength = 0.0f;  ///< Of the part's length; only without a line.
  float height = 0.5f;      ///< Of the local flesh.
  float width = 1.0f;       ///< Of the height.
  float turn = 0.0f;  ///< Degrees that the fibres are turned in the skin, towards the outer side at the upper end.
  float definition = 1.0f;  ///< Factor on the set's.
  float reach = 0.0f;       ///< 0: the set's.
  bool midline = false;     ///< Beside its twin: it is never widened.
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
