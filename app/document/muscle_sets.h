// app/document/muscle_sets.h: the sets of muscles at hand: those that ship with the program, and the user's own.
#pragma once

#include <filesystem>
#include <vector>

#include "core/body/preset.h"
#include "sinew/base/result.h"

namespace sinew::app {

struct MuscleSets {
  std::vector<Preset> sets;    ///< By file name, those that ship with the program first. Of one name the first counts.
  std::vector<Error> refused;  ///< Files that are no sets.

  /// Index of the set of that name, or -1.
  [[nodiscard]] int named(std::string_view name) const;
  /// Index of the first set for that kind of body, or -1.
  [[nodiscard]] int firstFor(BodyKind body) const;
};

/// sets/ beside the preferences. Need not exist.
[[nodiscard]] std::filesystem::path ownSetsFolder();

[[nodiscard]] MuscleSets muscleSets();

}  // namespace sinew::app
