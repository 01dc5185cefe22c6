// core/rig/validation.h: validates rigs, for files and editor alike.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/rig/field.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Texts of errors.

[[nodiscard]] std::string numberText(float value);
/// "expected ..., got ..."
[[nodiscard]] Error outOfRange(std::string place, const std::string& expected, float value, std::string subject);
[[nodiscard]] std::string quoted(const char* what, const std::string& name);  ///< muscle "biceps L"
[[nodiscard]] Error named(const char* subject, Error error);                  ///< The error with another subject.
[[nodiscard]] std::string indexed(const char* list, std::size_t index);       ///< primitives[3]

inline constexpr int kMaxPrimitives = 65536;

/// Checks ranges, finiteness, unique names, references to groups and lines, twins, and the size of the blending graph.
/// Bones are not checked, since a rig may be used with another character. The Error's place is a JSON path such as
/// "primitives[2].radii[1]"; its reason names what was expected.
[[nodiscard]] Result<void> validate(const Rig& rig);
/// For repeated validation: cliques are enumerated only if groups or links have changed.
[[nodiscard]] Result<void> validate(const Rig& rig, BlendingGraphMemo& graphs);

// Parts of validate(), for edits. The Error's place begins with `place`.

/// At most so many items in a list of the rig. @param items  "primitives"
[[nodiscard]] Result<void> validateCount(const char* list, const char* items, std::size_t count, std::size_t most);
/// Center and rotation finite, rotation within 1e-3 of unit length, radii finite and > 0, core and bend in range.
[[nodiscard]] Result<void> validatePlacement(const Placement& placement, const std::string& place);
/// Everything that does not depend on the rest of the rig.
[[nodiscard]] Result<void> validatePrimitive(const Primitive& primitive, const std::string& place);
/// Everything that does not depend on the rest of the rig.
[[nodiscard]] Result<void> validateLine(const MuscleLine& line, const std::string& place);
[[nodiscard]] Result<void> validateSettings(const LineSettings& line, const std::string& place);
[[nodiscard]] Result<void> validateAnchor(const LineAnchor& anchor, const std::string& place, const char* words);
[[nodiscard]] Result<void> validateSurface(const SurfaceSettings& surface);
[[nodiscard]] Result<void> validateSmoothing(const SmoothingSettings& smoothing);
[[nodiscard]] inline bool isList(const Link& link) {  ///< In files; else an object.
  return link.animated.empty() && link.unknownKeys.empty();
}
/// Links name two different groups that exist and have an amount, and the blending graph has few enough cliques.
[[nodiscard]] Result<void> validateLinks(const Rig& rig);
/// Parameters of this owner, each once; curves with ascending x and finite numbers; inputs in range.
[[nodiscard]] Result<void> validateAnimated(const std::vector<AnimatedNumber>& animated, ParameterOwner owner,
                                            const std::string& place);
/// Channels have names and valid tracks, one for each name and clip.
[[nodiscard]] Result<void> validateChannels(const Rig& rig);
[[nodiscard]] Result<void> validateInputs(const Rig& rig);  ///< The lines and channels that inputs name exist.
/// A name is not empty and in UTF-8.
[[nodiscard]] Result<void> validateName(const std::string& name, const std::string& place);

}  // namespace sinew
