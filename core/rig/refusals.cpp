// core/rig/refusals.cpp: numbers and names as refusals say them.
#include "core/rig/refusals.h"

#include <array>
#include <charconv>
#include <cmath>

namespace sinew {

std::string numberText(float value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0.0f ? "infinity" : "-infinity";
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

Error outOfRange(std::string place, const std::string& expected, float value, std::string subject) {
  return errorAt(std::move(place), "expected " + expected + ", got " + numberText(value), std::move(subject));
}

std::string ofAxis(const std::string& what, int axis) { return what + ' ' + "XYZ"[axis]; }

std::string quoted(const char* what, const std::string& name) { return what + (" \"" + name + '"'); }

Error named(const char* subject, Error error) {
  error.subject = subject;
  return error;
}

std::string indexed(const char* list, std::size_t index) { return list + ('[' + std::to_string(index) + ']'); }

}  // namespace sinew
