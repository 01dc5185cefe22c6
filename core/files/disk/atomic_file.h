// core/files/disk/atomic_file.h: reading and writing whole files.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "sinew/geometry/result.h"

namespace sinew {

/// An open file of the system, closed at the end of its scope.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}  ///< @param number  from the system; -1: not open
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool isOpen() const { return number_ >= 0; }
  /// A duplicate: locks last until both are closed.
  [[nodiscard]] Descriptor copy() const { return Descriptor(::fcntl(number_, F_DUPFD_CLOEXEC, 0)); }
  /// False if the system reports a late failure, in errno.
  bool close() {
    if (number_ < 0) return true;
    return ::close(std::exchange(number_, -1)) == 0;
  }

 private:
  int number_ = -1;
};

// A file is named `.sinew-NUMBER-NUMBER.part` until it is renamed to its place. Its writer holds a lock on it (flock)
// for as long as it has that name; the system releases the lock however the program ends. So an unlocked part is stray.
// On network folders without locks its age decides.

/// Younger parts are kept: no write takes so long, and locks may be missing.
inline constexpr std::chrono::hours kStrayAge{1};

[[nodiscard]] std::filesystem::path freshPart(const std::filesystem::path& folder);  ///< A new name in this process.

/// Marks an open file as in use until it and its copies are closed. Does nothing without locks.
void lockPart(const Descriptor& file);

/// The same with a shared lock, for a second name of an existing file.
[[nodiscard]] Descriptor lockShared(const std::filesystem::path& file);

/// Removes unlocked parts older than kStrayAge, as far as possible. @param now  seconds since 1970
void clearStrayParts(const std::filesystem::path& folder, std::time_t now);

/// What happens to the previous version of a file.
enum class Previous {
  kKept,      ///< Kept as NAME~, once in a run of the program: as it was before the run. Not if it is the same.
  kReplaced,  ///< Replaced: for the program's own files.
};

/// Writes beside the target, flushes to disk, renames over it: after a crash or a full disk the old file is whole.
/// Pipes, terminals and devices are written directly. Error also: a pipe that nobody reads for 5 seconds.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& file, std::string_view bytes,
                                               Previous previous = Previous::kKept);

struct NamedBytes {
  std::filesystem::path file;
  std::string_view bytes;
};

/// The same for several files that belong together: all are on the disk before the first is renamed, so that an Error
/// changes none. Each target must be a regular file or free.
[[nodiscard]] Result<void> writeFilesAtomically(const std::vector<NamedBytes>& files,
                                                Previous previous = Previous::kKept);

/// The same for a file written by another program. @param made  in the folder of `file`; removed, even on an Error
[[nodiscard]] Result<void> putFileAtomically(const std::filesystem::path& made, const std::filesystem::path& file);

/// Error: it is absent, a folder, unreadable, or larger than `limit` bytes.
[[nodiscard]] Result<std::string> readWholeFile(const std::filesystem::path& file, std::uintmax_t limit);
[[nodiscard]] Result<std::vector<std::uint8_t>> readWholeBytes(const std::filesystem::path& file, std::uintmax_t limit);

}  // namespace sinew
