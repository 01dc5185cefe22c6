// core/files/disk/part_files.h: names of files that are to replace others, and what killed programs left of them.
//
// A file is `.sinew-NUMBER-NUMBER.part` until it is renamed to its place. Whoever writes one holds a lock on it (flock)
// from before it has that name until after it has lost it; the system releases the lock however the program ends. So a
// part that nobody has locked belongs to nobody. On network folders without locks age is the second sign.
#pragma once

#include <chrono>
#include <ctime>
#include <filesystem>

#include "core/files/disk/descriptor.h"

namespace sinew {

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

}  // namespace sinew
