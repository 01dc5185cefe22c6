// app/command/machine.h: which machine and which build the figures of a benchmark are of.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "core/files/json/json.h"

namespace sinew::app {

struct Machine {
  std::string processor;                     ///< "unknown" where the system does not tell.
  std::vector<std::string> instructionSets;  ///< Those that run here, narrowest first.
  int threads = 1;                           ///< That this process may run on at once.
  double load = 0.0;  ///< What wanted to run in the last minute, mean; above `threads`, times wander.
  std::string compiler;
  std::string buildType;  ///< With the flags that were added; "none" if neither was given.
  bool assertions = false;
  std::string version;  ///< The program's.
};

[[nodiscard]] Machine machineHere();

/// The first "model name" of a /proc/cpuinfo; "unknown" if it has none.
[[nodiscard]] std::string processorName(std::istream& cpuinfo);

[[nodiscard]] Json jsonOf(const Machine& machine);
/// A few lines.
[[nodiscard]] std::string textOf(const Machine& machine);

}  // namespace sinew::app
