// app/document/muscle_sets.h: the sets of muscles at hand: those that ship with the program, and the user's own.
#pragma once

#include <filesystem>
#include <vector>

#include "core/bodies/preset.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

struct MuscleSets {
  std::vector<Preset> sets;    ///< By file name, those that ship with the program first. Of one name the first counts.
  std::vector<Error> refused;  ///< Files that are no sets.

  /// Index of the set of that name, or -1.
  [[nodiscard]] int named(std::string_view name) const;
  /// Index of the first set for that kind of body, or -1.
  [[nodiscard]] int firstFor(BodyKind body) const;
};

/// Comes with the program, and cannot be replaced.
[[nodiscard]] bool isShippedSet(std::string_view name);
/// Name of the file for a set that is called so: what no file system takes is a "-".
[[nodiscard]] std::string setNameFor(std::string_view title);
[[nodiscard]] bool isOwnSet(std::string_view name);
/// Among the user's own, by its name; one of that name is replaced. Makes the folder.
[[nodiscard]] Result<void> saveOwnSet(const Preset& set);
/// The file is kept as name.json~.
[[nodiscard]] Result<void> removeOwnSet(std::string_view name);

/// sets/ beside the preferences. Need not exist.
[[nodiscard]] std::filesystem::path ownSetsFolder();

[[nodiscard]] MuscleSets muscleSets();

}  // namespace sinew::app
