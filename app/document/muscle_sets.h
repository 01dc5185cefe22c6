// app/document/muscle_sets.h: sets of muscles: those that ship with the program, and the user's own.
#pragma once

#include <filesystem>
#include <vector>

#include "core/bodies/preset.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

struct MuscleSets {
  std::vector<Preset> sets;    ///< By file name, shipped sets first. Names are unique.
  std::vector<Error> refused;  ///< Unreadable files.

  [[nodiscard]] int named(std::string_view name) const;  ///< Index by name, or -1.
  [[nodiscard]] int firstFor(BodyKind body) const;       ///< Index of the first set for that kind of body, or -1.
};

[[nodiscard]] bool isShippedSet(std::string_view name);
/// File name for a title: characters that file systems refuse become "-".
[[nodiscard]] std::string setNameFor(std::string_view title);
[[nodiscard]] bool isOwnSet(std::string_view name);
[[nodiscard]] Result<void> saveOwnSet(const Preset& set);  ///< Replaces an own set of the same name. Makes the folder.
[[nodiscard]] Result<void> removeOwnSet(std::string_view name);  ///< The file is kept as name.json~.

[[nodiscard]] std::filesystem::path ownSetsFolder();  ///< sets/ beside the preferences. Need not exist.

[[nodiscard]] MuscleSets muscleSets();

}  // namespace sinew::app
