// core/export/usd_files.h: the finished glTF as the files of a USD stage.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/export/gltf_rewrite.h"
#include "core/export/usd/stage.h"

namespace sinew::exporting {

struct OutFile {
  std::filesystem::path file;
  std::string bytes;
};

/// The textures and, last, the .usda itself. Throws gltf::Refusal.
/// @param folder   of the source, which images that could not be read name from
/// @param moments  points over time in place of a skeleton; null: skinned
/// @param left     what .usda does not hold is added
[[nodiscard]] Result<std::vector<OutFile>> usdFiles(const PackedGltf& packed, const std::filesystem::path& folder,
                                                    const std::filesystem::path& file, std::vector<std::string>& left,
                                                    const usd::PointMoments* moments = nullptr);

}  // namespace sinew::exporting
