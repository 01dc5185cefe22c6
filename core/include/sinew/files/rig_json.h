// core/include/sinew/files/rig_json.h: the rig file, *.rig.json (docs/formats.md).
#pragma once

#include <filesystem>
#include <string>

#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Keys in the order of docs/formats.md, shortest decimals that read back bit-equal, unknown keys after the known ones.
[[nodiscard]] std::string rigToJson(const Rig& rig);

/// A validated rig. Error: place is the JSON path (or the byte if it is no JSON), reason what was expected.
[[nodiscard]] Result<Rig> rigFromJson(const std::string& text);

[[nodiscard]] Result<Rig> loadRig(const std::filesystem::path& file);  ///< A validated rig; refuses files over 64 MiB.

/// Writes atomically: after an Error the old file is unchanged.
[[nodiscard]] Result<void> saveRig(const Rig& rig, const std::filesystem::path& file);

/// Path of the rig's character.
[[nodiscard]] std::filesystem::path characterPath(const Rig& rig, const std::filesystem::path& rigFile);
/// For Rig::character: the path relative to the rig file's folder if possible.
[[nodiscard]] std::string relativeCharacterPath(const std::filesystem::path& character,
                                                const std::filesystem::path& rigFile);

}  // namespace sinew
