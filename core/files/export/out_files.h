// core/files/export/out_files.h: what an export may write, and writing it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/disk/atomic_file.h"
#include "core/files/export/source.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"

namespace sinew::exporting {

/// Error: a clip that the character does not have, and those that it has.
[[nodiscard]] Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                                      const std::vector<std::string>& asked);

/// Error: clips of more than an hour together. Each second is 30 poses that are smoothed, fitted and measured.
/// @param asked  names; empty: all
[[nodiscard]] Result<void> checkSeconds(const std::filesystem::path& file, const Character& character,
                                        const std::vector<std::string>& asked);

/// Before the work. Error: no such folder, a place that is a folder, or one that the character is read from.
/// @param files  the one that was asked for last
[[nodiscard]] Result<void> checkPlaces(const Source& source, const std::vector<std::filesystem::path>& files);

/// Checks the places and writes all files or none. Returns the bytes of all of them. @param files  as checkPlaces()
[[nodiscard]] Result<std::uint64_t> writeFiles(const Source& source, const std::vector<NamedBytes>& files);

}  // namespace sinew::exporting
