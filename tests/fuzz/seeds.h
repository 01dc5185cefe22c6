// tests/fuzz/seeds.h: small files to begin with, which between them hold what an import can meet.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sinew::fuzz {

struct Seed {
  std::string name;
  std::string bytes;
};

/// Those of a target: rig files for "rig", sets of muscles for "set", else characters.
[[nodiscard]] std::vector<Seed> seedsOf(std::string_view target);

}  // namespace sinew::fuzz
