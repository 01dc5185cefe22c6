// core/rig/refusals.h: the words of what is refused.
#pragma once

#include <cstddef>
#include <string>

#include "sinew/geometry/result.h"

namespace sinew {

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

}  // namespace sinew
