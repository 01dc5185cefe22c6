// core/include/sinew/files/gltf_import.h: glTF 2.0 (.glb, .gltf) -> Character.
#pragma once

#include <filesystem>
#include <memory>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"

namespace sinew {

// Limits (docs/formats.md), checked before anything is allocated.
inline constexpr int kMaxControlTriangles = 2'000'000;
inline constexpr int kMaxJoints = 4096;
inline constexpr int kMaxClips = 1000;

/// Reads a character. Untrusted input: every accessor, index and size is checked; buffers and images may be data: uris
/// or files inside the file's own folder, nothing else. What Sinew cannot use is listed in Character::ignored. Error:
/// file, place (JSON path, accessor, byte), reason. Never throws.
[[nodiscard]] Result<std::shared_ptr<const Character>> importGltf(const std::filesystem::path& file);

/// Reads a file for its clips, by the same rules: no mesh is needed, and no pictures are read. Where no mesh of the
/// scene has a skin, all nodes are the skeleton, bound as they stand, or as a skin that no mesh uses binds them. Error:
/// also a file without clips.
[[nodiscard]] Result<std::shared_ptr<const Character>> importClips(const std::filesystem::path& file);

}  // namespace sinew
