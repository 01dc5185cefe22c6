// core/export/out_files.h: what an export may write, and writing it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/export/gltf_rewrite.h"
#include "core/export/source.h"
#include "sinew/base/result.h"
#include "sinew/character/character.h"

namespace sinew::exporting {

/// ".glb" of "OUT.GLB".
[[nodiscard]] std::string lowerEnding(const std::filesystem::path& file);

/// Error: a clip that the character does not have, and those that it has.
[[nodiscard]] Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                                      const std::vector<std::string>& asked);

/// Files that an export consists of, the one named last; of a .usda not its textures: how many is not known before.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const std::filesystem::path& file);

/// Before the work. Error: no such folder, a place that is a folder, or one that the character is read from.
/// @param files  the one that was asked for last
[[nodiscard]] Result<void> checkPlaces(const Source& source, const std::vector<std::filesystem::path>& files);

/// Bytes of all files written.
[[nodiscard]] Result<std::uint64_t> writeGltf(const PackedGltf& packed, const std::filesystem::path& file);

}  // namespace sinew::exporting
