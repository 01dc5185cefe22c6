// tests/support/long_run.h: whether the long tests run (./test.sh -C long).
#pragma once

#include <cstdlib>

namespace sinew::test {

/// MORE is set in the environment: more seeds, more clips, more characters.
[[nodiscard]] inline bool longRun() { return std::getenv("MORE") != nullptr; }

}  // namespace sinew::test
