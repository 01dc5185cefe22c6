// core/files/export/usd_files.h: the finished glTF as the files of a USD stage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/source.h"
#include "core/files/usd/stage.h"

namespace sinew::exporting {

/// Writes the .usda and its textures, all or none. Bytes of all of them. Throws gltf::Refusal.
/// @param file     .usda; the place was free before the work
/// @param left     what .usda does not hold is added
/// @param moments  points over time in place of a skeleton; null: skinned
[[nodiscard]] Result<std::uint64_t> writeStage(const Source& source, const PackedGltf& packed,
                                               const std::filesystem::path& file, std::vector<std::string>& left,
                                               const usd::PointMoments* moments);

}  // namespace sinew::exporting
