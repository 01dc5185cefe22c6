// core/io/files/atomic_file.h: whole files in, whole files out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"

namespace sinew {

/// Writes beside the target, flushes to disk, renames over it: after a crash or a full disk the old file is whole.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

/// A file to be written.
struct NamedBytes {
  std::filesystem::path file;
  std::string_view bytes;
};

/// The same for several files that belong together: all are on the disk before the first is renamed, so that on an
/// Error none has changed. Their places must be regular files, or free.
[[nodiscard]] Result<void> writeFilesAtomically(const std::vector<NamedBytes>& files);

/// Error: it is absent, a folder, unreadable, or larger than `limit` bytes.
[[nodiscard]] Result<std::string> readWholeFile(const std::filesystem::path& file, std::uintmax_t limit);
[[nodiscard]] Result<std::vector<std::uint8_t>> readWholeBytes(const std::filesystem::path& file, std::uintmax_t limit);

}  // namespace sinew
