// core/bodies/muscle_at.h: a muscle of a set where a hand points, in place of where the set has it.
#pragma once

#include <optional>

#include "core/bodies/body_map.h"
#include "core/bodies/preset.h"

namespace sinew {

/// A place on the skin, as a mark: of the left side, or of the middle.
struct MarkOnSkin {
  Mark mark;
  BodySide side = BodySide::kLeft;
};
/// nullopt: the bone is no part of the body, or a part without length.
/// @param inBind  on the skin that follows the bone; world of the bind pose
[[nodiscard]] std::optional<MarkOnSkin> markOnSkin(const MeasuredBody& body, int bone, const glm::vec3& inBind);

/// Near its own place the muscle is laid there. Elsewhere on its part it goes round the part and along it, and its line
/// with it; on another part it is a belly alone, along that part and as long as it was.
[[nodiscard]] PresetMuscle muscleAt(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body);

/// Near enough its own place to be laid there.
[[nodiscard]] bool isOwnPlace(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body);

}  // namespace sinew
