// core/rig/validation.h: what makes a rig a rig, in one place for files and editor alike.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/rig/blending_graph.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// The words of what is refused.

[[nodiscard]] std::string numberText(float value);
/// "expected ..., got ..."
[[nodiscard]] Error outOfRange(std::string place, const std::string& expected, float value, std::string subject);
/// "radius Y"
[[nodiscard]] std::string ofAxis(const std::string& what, int axis);
/// muscle "biceps L"
[[nodiscard]] std::string quoted(const char* what, const std::string& name);
/// The same about something else.
[[nodiscard]] Error named(const char* subject, Error error);
/// primitives[3]
[[nodiscard]] std::string indexed(const char* list, std::size_t index);

inline constexpr int kMaxPrimitives = 65536;

/// Checks ranges, finiteness, unique names, that groups and lines exist, that twins name each other, and the blending
/// graph's size. Bones are not checked: a rig may meet another character. The Error's place is a JSON path such as
/// "primitives[2].radii[1]"; its reason says what was expected.
[[nodiscard]] Result<void> validate(const Rig& rig);
/// The same for whoever validates again and again: cliques are enumerated only where groups or links have changed.
[[nodiscard]] Result<void> validate(const Rig& rig, BlendingGraphMemo& graphs);

// Its parts, for edits that can break no more than one of them. The Error's place begins with `place`.

/// Center and rotation finite, rotation within 1e-3 of unit length, radii finite and > 0, core and bend in range.
[[nodiscard]] Result<void> validatePlacement(const Placement& placement, const std::string& place);
/// All of a primitive that needs no look at the rest of the rig.
[[nodiscard]] Result<void> validatePrimitive(const Primitive& primitive, const std::string& place);
/// All of a line that needs no look at the rest of the rig.
[[nodiscard]] Result<void> validateLine(const MuscleLine& line, const std::string& place);
[[nodiscard]] Result<void> validateSurface(const SurfaceSettings& surface);
[[nodiscard]] Result<void> validateSmoothing(const SmoothingSettings& smoothing);
/// Links name two different groups that exist, and the blending graph has few enough cliques.
[[nodiscard]] Result<void> validateLinks(const Rig& rig);
/// Parameters of the owner's kind, each once; curves with rising x and finite numbers; ranges of inputs.
[[nodiscard]] Result<void> validateAnimated(const std::vector<AnimatedNumber>& animated, ParameterOwner owner,
                                            const std::string& place);
/// Channels have names and sound tracks, one of a name for a clip.
[[nodiscard]] Result<void> validateChannels(const Rig& rig);
/// The lines and channels that inputs name exist.
[[nodiscard]] Result<void> validateInputs(const Rig& rig);
/// A name is not empty and UTF-8. Whether it is unique is validate()'s affair.
[[nodiscard]] Result<void> validateName(const std::string& name, const std::string& place);

}  // namespace sinew
