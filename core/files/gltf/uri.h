// core/files/gltf/uri.h: what a glTF uri may name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/geometry/result.h"

namespace sinew::gltf {

/// Whether it starts with "data:", in any case of letters.
[[nodiscard]] bool isDataUri(std::string_view uri);

/// The bytes of a data: uri, base64 or percent-encoded. Error: reason only.
[[nodiscard]] Result<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri);

/// The relative path a uri names, percent-decoded once. Error: absolute, with a scheme, with "..", a backslash or a
/// control character, or empty. Says nothing about the disk.
[[nodiscard]] Result<std::filesystem::path> relativePathOf(std::string_view uri);

/// The real place of folder/relative, symbolic links followed; nullopt if that lies outside the folder or is not there.
[[nodiscard]] std::optional<std::filesystem::path> placeInside(const std::filesystem::path& folder,
                                                               const std::filesystem::path& relative);

}  // namespace sinew::gltf
