// app/cli/crease_option.cpp: an angle, checked as it is read.
#include "app/cli/crease_option.h"

#include <charconv>
#include <string>

#include <CLI/CLI.hpp>

namespace sinew::app {
namespace {

std::string isAngle(const std::string& text) {
  float degrees = -1.0f;
  const char* const end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, degrees);
  if (failed == std::errc{} && stop == end && degrees >= 0.0f && degrees <= 180.0f) return {};
  return "expected degrees from 0 to 180, got \"" + text + '"';
}

}  // namespace

void addCreaseOption(CLI::App& verb, std::optional<float>& degrees) {
  verb.add_option("--crease", degrees, "Shade faces that meet at more than this angle apart; 180: smooth everywhere")
      ->type_name("DEGREES")
      ->check(isAngle);
}

}  // namespace sinew::app
