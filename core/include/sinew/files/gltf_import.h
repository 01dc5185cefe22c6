// core/include/sinew/files/gltf_import.h: glTF 2.0 (.glb, .gltf) -> Character.
#pragma once

#include <filesystem>
#include <memory>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"

namespace sinew {

// Limits (docs/formats.md), checked before allocation.
inline constexpr int kMaxControlTriangles = 2'000'000;
inline constexpr int kMaxJoints = 4096;
inline constexpr int kMaxClips = 1000;

/// Reads a character. Untrusted input: every accessor, index and size is checked; buffers and images may only be data:
/// URIs or files inside the file's own folder. Contents that Sinew cannot use are listed in Character::ignored. Error:
/// file, place (JSON path, accessor, byte), reason. Never throws.
[[nodiscard]] Result<std::shared_ptr<const Character>> importGltf(const std::filesystem::path& file);

/// Reads a file for its clips, by the same rules; needs no mesh and reads no images. If no mesh of the scene has a
/// skin, all nodes are the skeleton, bound at rest or by a skin that no mesh uses. Error: also a file without clips.
[[nodiscard]] Result<std::shared_ptr<const Character>> importClips(const std::filesystem::path& file);

}  // namespace sinew
