// core/files/disk/atomic_file.h: whole files in, whole files out.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/disk/descriptor.h"
#include "sinew/geometry/result.h"

namespace sinew {

// Names of files that are to replace others, and what killed programs left of them.
//
// A file is `.sinew-NUMBER-NUMBER.part` until it is renamed to its place. Whoever writes one holds a lock on it (flock)
// from before it has that name until after it has lost it; the system releases the lock however the program ends. So a
// part that nobody has locked belongs to nobody. On network folders without locks age is the second sign.

/// Parts that are younger are left alone: no write lasts so long, and locks may be missing.
inline constexpr std::chrono::hours kStrayAge{1};

/// A name that this process has not used yet.
[[nodiscard]] std::filesystem::path freshPart(const std::filesystem::path& folder);

/// Tells other programs that the open file is in use, for as long as it or a copy is open. Does nothing where the file
/// system has no locks.
void lockPart(const Descriptor& file);

/// For a second name of a file that is there: the same, while others may do so too.
[[nodiscard]] Descriptor lockShared(const std::filesystem::path& file);

/// Removes parts that nobody holds and that are older than kStrayAge; what cannot be removed stays.
/// @param now  seconds since 1970
void clearStrayParts(const std::filesystem::path& folder, std::time_t now);

/// What becomes of the version of a file that is replaced.
enum class Previous {
  kKept,      ///< As NAME~, once in a run of the program: the file as it was before the run. Not where it is the same.
  kReplaced,  ///< Nothing: what the program keeps for itself.
};

/// Writes beside the target, flushes to disk, renames over it: after a crash or a full disk the old file is whole. To
/// pipes, terminals and devices the bytes are written as they are. Error also: a pipe that nobody reads for 5 seconds.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& file, std::string_view bytes,
                                               Previous previous = Previous::kKept);

/// A file to be written.
struct NamedBytes {
  std::filesystem::path file;
  std::string_view bytes;
};

/// The same for several files that belong together: all are on the disk before the first is renamed, so that on an
/// Error none has changed. Their places must be regular files, or free.
[[nodiscard]] Result<void> writeFilesAtomically(const std::vector<NamedBytes>& files,
                                                Previous previous = Previous::kKept);

/// The same for what another program has written.
/// @param made  in the folder of `file`; gone afterwards, also on an Error
[[nodiscard]] Result<void> putFileAtomically(const std::filesystem::path& made, const std::filesystem::path& file);

/// Error: it is absent, a folder, unreadable, or larger than `limit` bytes.
[[nodiscard]] Result<std::string> readWholeFile(const std::filesystem::path& file, std::uintmax_t limit);
[[nodiscard]] Result<std::vector<std::uint8_t>> readWholeBytes(const std::filesystem::path& file, std::uintmax_t limit);

}  // namespace sinew
