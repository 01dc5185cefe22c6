// core/files/buffer_files.h: the files that a .gltf has its numbers in.
#pragma once

#include <filesystem>
#include <vector>

namespace sinew {

/// The buffers that a .gltf names in its own folder, in its order, there or not; no link that leads out
/// of it. None of other files, nor where it cannot be read. Never throws.
[[nodiscard]] std::vector<std::filesystem::path> bufferFilesOf(const std::filesystem::path& file);

}  // namespace sinew
