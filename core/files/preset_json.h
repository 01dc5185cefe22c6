// core/files/preset_json.h: preset files: sets of muscles by marks on the body. docs/muscles.md.
#pragma once

#include <filesystem>
#include <string>

#include "core/bodies/preset.h"
#include "sinew/geometry/result.h"

namespace sinew {

[[nodiscard]] Result<Preset> presetFromJson(const std::string& text);        ///< Error: place is the JSON path.
[[nodiscard]] Result<Preset> loadPreset(const std::filesystem::path& file);  ///< Refuses files over 4 MiB.

[[nodiscard]] std::string presetToJson(const Preset& preset);  ///< Numbers are the shortest that read back bit-equal.
[[nodiscard]] Result<void> savePreset(const Preset& preset, const std::filesystem::path& file);

}  // namespace sinew
