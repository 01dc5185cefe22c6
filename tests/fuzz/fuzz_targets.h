// tests/fuzz/fuzz_targets.h: what must hold whatever a file contains. libFuzzer calls these with bytes it makes up,
// fuzz_tests with the inputs that once broke one.
#pragma once

#include <span>
#include <string_view>

namespace sinew::fuzz {

/// Each returns, or ends the process with a line that says which promise was broken.

/// A character file: refused in one line, or a finite character. Another one plays its clips.
void importAny(std::string_view bytes);

/// A rig file: refused in one line, or a rig that is the same when it has been written and read. It goes on a small
/// character without a number that is not finite.
void rigAny(std::string_view bytes);

/// A set of muscles: refused in one line, or written as it was read.
void setAny(std::string_view bytes);

/// A character file with muscles on its bones: the surface of the bind pose and of its clips is finite.
void smoothAny(std::string_view bytes);

/// A character file with a muscle, exported: refused in one line, or a file that opens again. Or its surface, in any
/// form.
void exportAny(std::string_view bytes);

struct Target {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

/// "import", "rig", "set", "smooth", "export".
[[nodiscard]] std::span<const Target> allTargets();

}  // namespace sinew::fuzz
