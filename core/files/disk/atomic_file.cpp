// core/files/disk/atomic_file.cpp: POSIX files, every failure returns a readable message.
#include "core/files/disk/atomic_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/files/disk/descriptor.h"

namespace sinew {

// A part without a lock is nobody's.

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBefore = ".sinew-";
constexpr std::string_view kAfter = ".part";
constexpr std::string_view kDigits = "0123456789";

/// Takes digits off the front. False if there are none.
bool takeNumber(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of(kDigits), text.size());
  text.remove_prefix(end);
  return end > 0;
}

bool isPartName(std::string_view name) {
  if (!name.starts_with(kBefore) || !name.ends_with(kAfter)) return false;
  name.remove_prefix(kBefore.size());
  if (!takeNumber(name) || !name.starts_with('-')) return false;
  name.remove_prefix(1);
  return takeNumber(name) && name == kAfter;
}

/// When it was written last. A second name of an older file was given when the file was changed last in any way.
std::time_t lastUsed(const struct stat& file) { return file.st_nlink > 1 ? file.st_ctim.tv_sec : file.st_mtim.tv_sec; }

bool isSameFile(const struct stat& a, const struct stat& b) { return a.st_ino == b.st_ino && a.st_dev == b.st_dev; }

/// Only a regular file of that very name: links are not followed.
void removeIfStray(const fs::path& part, std::time_t before) {
  struct stat named {};
  struct stat opened {};
  if (::lstat(part.c_str(), &named) != 0 || !S_ISREG(named.st_mode) || lastUsed(named) >= before) return;
  const Descriptor file(::open(part.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file.isOpen() || ::flock(file.number(), LOCK_EX | LOCK_NB) != 0) return;
  // Since the first look it may have been put in its place, and the name given to another.
  if (::fstat(file.number(), &opened) != 0 || ::lstat(part.c_str(), &named) != 0 || !isSameFile(opened, named)) return;
  ::unlink(part.c_str());
}

}  // namespace

fs::path freshPart(const fs::path& folder) {
  static std::atomic<unsigned> counter{0};
  std::string name(kBefore);
  name.append(std::to_string(::getpid())).append("-").append(std::to_string(counter++)).append(kAfter);
  return folder / name;
}

void lockPart(const Descriptor& file) { ::flock(file.number(), LOCK_EX | LOCK_NB); }

Descriptor lockShared(const fs::path& file) {
  Descriptor opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (opened.isOpen()) ::flock(opened.number(), LOCK_SH | LOCK_NB);
  return opened;
}

void clearStrayParts(const fs::path& folder, std::time_t now) {
  std::vector<fs::path> parts;
  std::error_code failed;
  for (fs::directory_iterator it(folder.empty() ? "." : folder, failed); !failed && it != fs::directory_iterator();
       it.increment(failed)) {
    if (isPartName(it->path().filename().native())) parts.push_back(it->path());
  }
  const std::time_t before = now - std::chrono::seconds(kStrayAge).count();
  for (const fs::path& part : parts) removeIfStray(part, before);
}

namespace {

namespace fs = std::filesystem;

/// A pipe waits for its reader so long ...
constexpr int kReaderTries = 50;
constexpr std::chrono::milliseconds kReaderPause{100};
/// Where a file system has no hard links, previous versions up to this size are copied.
constexpr std::uintmax_t kMostCopied = 1U << 30U;

Error because(const fs::path& file, const std::string& what, int code) {
  return {file.string(), {}, what + ": " + std::generic_category().message(code)};
}

/// 0, or the errno of the failure.
int writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// While it lives, a pipe whose reader has gone gives this thread an error, not the signal that ends the program.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;
  ~NoPipeSignal() {
    const timespec now{};
    if (::sigismember(&before_, SIGPIPE) == 0) ::sigtimedwait(&pipe_, nullptr, &now);
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t pipe_{};
  sigset_t before_{};
};

/// Opened without waiting, since a pipe that nobody reads would hold the program for ever. -1: errno says why not.
int openStream(const fs::path& file) {
  for (int tries = 0;; ++tries) {
    const int stream = ::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (stream >= 0 || errno != ENXIO || tries == kReaderTries) return stream;
    std::this_thread::sleep_for(kReaderPause);
  }
}

/// Pipes, terminals and devices: nothing to replace, the bytes just go there.
Result<void> writeStream(const fs::path& file, std::string_view bytes) {
  Descriptor stream(openStream(file));
  if (!stream.isOpen() && errno == ENXIO) {
    return Error{file.string(), {}, "cannot be written: it is a pipe that no program reads"};
  }
  // Once it is open a slow reader is waited for, as everywhere.
  if (!stream.isOpen() || ::fcntl(stream.number(), F_SETFL, 0) != 0) return because(file, "cannot be written", errno);
  const NoPipeSignal quiet;
  const int failed = writeAll(stream.number(), bytes);
  if (failed != 0) return because(file, "cannot be written", failed);
  return {};
}

/// Creates a file nobody has, beside `file`, and locks it; its name goes to `made`. Not open: errno says why.
Descriptor createNeighbor(const fs::path& file, fs::path& made) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    made = freshPart(file.parent_path());
    Descriptor neighbor(::open(made.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!neighbor.isOpen() && errno != EEXIST) return neighbor;
    if (!neighbor.isOpen()) continue;
    lockPart(neighbor);
    struct stat created {};
    // Without a name: before it was locked, another program has taken it for a stray one.
    if (::fstat(neighbor.number(), &created) != 0 || created.st_nlink > 0) return neighbor;
  }
  errno = EEXIST;
  return {};
}

/// 0, or the errno of the failure. `mode` 0: what the system gives new files.
int fill(const Descriptor& neighbor, std::string_view bytes, mode_t mode) {
  if (const int failed = writeAll(neighbor.number(), bytes); failed != 0) return failed;
  if (mode != 0 && ::fchmod(neighbor.number(), mode) != 0) return errno;
  return ::fsync(neighbor.number()) == 0 ? 0 : errno;
}

/// Gives an open file without a name one that nobody has, beside `file`. 0, or the errno of the failure.
int nameNeighbor(const Descriptor& neighbor, const fs::path& file, fs::path& made) {
  const std::string open = "/proc/self/fd/" + std::to_string(neighbor.number());
  for (int attempt = 0; attempt < 1000; ++attempt) {
    made = freshPart(file.parent_path());
    if (::linkat(AT_FDCWD, open.c_str(), AT_FDCWD, made.c_str(), AT_SYMLINK_FOLLOW) == 0) return 0;
    if (errno != EEXIST) return errno;
  }
  return EEXIST;
}

/// A file that is written, beside its place.
struct Written {
  fs::path name;
  Descriptor lock;  ///< Held until the name is gone again.
};

/// Writes without a name and names what is whole, so that a process that is killed leaves nothing behind. False where
/// that failed, also because the file system has no such files.
bool writeUnnamed(const fs::path& file, std::string_view bytes, mode_t mode, Written& made) {
  const fs::path folder = file.parent_path();
  Descriptor neighbor(::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666));
  if (!neighbor.isOpen() || fill(neighbor, bytes, mode) != 0) return false;
  lockPart(neighbor);
  made.lock = neighbor.copy();
  if (nameNeighbor(neighbor, file, made.name) != 0) return false;
  if (neighbor.close()) return true;
  ::unlink(made.name.c_str());
  return false;
}

/// 0, or the errno of the failure; nothing is left then.
int writeNamed(const fs::path& file, std::string_view bytes, mode_t mode, Written& made) {
  Descriptor neighbor = createNeighbor(file, made.name);
  if (!neighbor.isOpen()) return errno;
  made.lock = neighbor.copy();
  int failed = fill(neighbor, bytes, mode);
  if (!neighbor.close() && failed == 0) failed = errno;
  if (failed != 0) ::unlink(made.name.c_str());
  return failed;
}

template <class Bytes>
Result<Bytes> readWhole(const fs::path& file, std::uintmax_t limit);

bool holds(const fs::path& file, std::string_view bytes) {
  std::error_code failed;
  if (fs::file_size(file, failed) != bytes.size() || failed) return false;
  const Result<std::string> present = readWhole<std::string>(file, bytes.size());
  return present && present.value() == bytes;
}

/// Another name for the file, or where the file system has none, a copy. 0, or the errno of the failure.
int doubleFile(const fs::path& file, Written& made) {
  made.lock = lockShared(file);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    made.name = freshPart(file.parent_path());
    if (::link(file.c_str(), made.name.c_str()) == 0) return 0;
    if (errno != EEXIST) break;
  }
  struct stat present {};
  const Result<std::string> bytes = readWhole<std::string>(file, kMostCopied);
  if (!bytes || ::stat(file.c_str(), &present) != 0) return EIO;
  return writeNamed(file, bytes.value(), present.st_mode & 07777, made);
}

/// The version that is replaced stays as NAME~. Where it cannot, because a folder has that name or the disk is full,
/// the new version is put in its place all the same: it is whole on the disk.
void keepPrevious(const fs::path& file) {
  Written made;
  fs::path kept = file;
  kept += '~';
  if (doubleFile(file, made) != 0) return;
  ::rename(made.name.c_str(), kept.c_str());
  ::unlink(made.name.c_str());  // A rename onto another name of the same file leaves both.
}

/// Files or folders that this run of the program has come to.
class SeenPaths {
 public:
  /// Whether it is the first time.
  bool add(const fs::path& file) {
    const std::scoped_lock lock(mutex_);
    return files_.insert(file.string()).second;
  }

 private:
  std::mutex mutex_;
  std::set<std::string> files_;
};

/// The files that it has written.
SeenPaths& writtenFiles() {
  static SeenPaths files;
  return files;
}

fs::path fullPath(const fs::path& file) {
  std::error_code failed;
  fs::path full = fs::weakly_canonical(file, failed);
  return failed ? file : full;
}

/// What killed programs left goes before this one writes into their folder for the first time.
void clearOnce(const fs::path& folder) {
  static SeenPaths cleared;
  if (cleared.add(fullPath(folder.empty() ? "." : folder))) clearStrayParts(folder, std::time(nullptr));
}

/// The rename itself must reach the disk too. Some file systems cannot; the file is whole either way.
void flushFolder(const fs::path& folder) {
  const Descriptor descriptor(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.isOpen()) ::fsync(descriptor.number());
}

/// A file on the disk beside the one that it is to replace; gone again unless it was put there.
class Neighbor {
 public:
  /// @param exists  there is a file that it replaces
  Neighbor(fs::path file, fs::path target, bool exists, Previous previous)
      : file_(std::move(file)), target_(std::move(target)), exists_(exists), previous_(previous) {}
  Neighbor(const Neighbor&) = delete;
  Neighbor& operator=(const Neighbor&) = delete;
  ~Neighbor() {
    if (!made_.name.empty()) ::unlink(made_.name.c_str());
  }

  Result<void> fill(std::string_view bytes, mode_t mode) {
    clearOnce(target_.parent_path());
    isSame_ = exists_ && previous_ == Previous::kKept && holds(target_, bytes);
    if (writeUnnamed(target_, bytes, mode, made_)) return {};
    const int failed = writeNamed(target_, bytes, mode, made_);
    if (failed == 0) return {};
    made_.name.clear();
    return because(file_, "cannot be written", failed);
  }

  /// A file that another program has written into the same folder.
  void take(const fs::path& made) { made_.name = made; }

  /// Before put().
  void keep() {
    if (previous_ == Previous::kKept && !isSame_ && writtenFiles().add(fullPath(target_)) && exists_) {
      keepPrevious(target_);
    }
  }

  Result<void> put() {
    if (::rename(made_.name.c_str(), target_.c_str()) != 0) return because(file_, "cannot be written", errno);
    made_.name.clear();
    return {};
  }

  void flush() const { flushFolder(target_.parent_path()); }

 private:
  fs::path file_;    ///< As the user gave it.
  fs::path target_;  ///< Links followed.
  Written made_;
  bool exists_ = false;
  Previous previous_ = Previous::kKept;
  bool isSame_ = false;  ///< What is replaced has these bytes.
};

/// A place for a regular file.
struct Place {
  fs::path target;
  mode_t mode = 0;
};

Result<Place> placeForFile(const fs::path& file, const struct stat* present) {
  if (!present) return Place{file, 0};
  if (S_ISDIR(present->st_mode)) return Error{file.string(), {}, "cannot be written: it is a folder"};
  if (!S_ISREG(present->st_mode)) return Error{file.string(), {}, "cannot be written: it is not a regular file"};
  // A rename would walk past a write protection; the designer set it on purpose.
  if (::access(file.c_str(), W_OK) != 0) return because(file, "cannot be written", errno);
  // Through a link to the file it names, so that the link stays one.
  std::error_code failed;
  fs::path target = fs::canonical(file, failed);
  if (failed) return because(file, "cannot be written", failed.value());
  return Place{std::move(target), static_cast<mode_t>(present->st_mode & 07777)};
}

template <class Bytes>
Result<Bytes> readWhole(const fs::path& file, std::uintmax_t limit) {
  // Without waiting: a pipe nobody writes to must not hang the program.
  const Descriptor source(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!source.isOpen()) return because(file, "cannot be read", errno);
  struct stat present {};
  if (::fstat(source.number(), &present) != 0) return because(file, "cannot be read", errno);
  if (S_ISDIR(present.st_mode)) return Error{file.string(), {}, "cannot be read: it is a folder"};
  if (!S_ISREG(present.st_mode)) return Error{file.string(), {}, "cannot be read: it is not a regular file"};

  const auto tooLarge = [&] {
    return Error{file.string(), {}, "is larger than " + std::to_string(limit) + " bytes, the most that is read"};
  };
  if (static_cast<std::uintmax_t>(present.st_size) > limit) return tooLarge();
  Bytes bytes;
  bytes.reserve(static_cast<std::size_t>(present.st_size));
  std::array<char, 65536> chunk{};
  for (;;) {
    const ssize_t count = ::read(source.number(), chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return because(file, "cannot be read", errno);
    if (count == 0) return bytes;
    bytes.insert(bytes.end(), chunk.data(), chunk.data() + count);
    if (bytes.size() > limit) return tooLarge();
  }
}

}  // namespace

Result<void> writeFileAtomically(const fs::path& file, std::string_view bytes, Previous previous) {
  struct stat present {};
  const bool exists = ::stat(file.c_str(), &present) == 0;
  if (exists && !S_ISREG(present.st_mode) && !S_ISDIR(present.st_mode)) return writeStream(file, bytes);
  return writeFilesAtomically({{file, bytes}}, previous);
}

Result<void> writeFilesAtomically(const std::vector<NamedBytes>& files, Previous previous) {
  std::vector<std::unique_ptr<Neighbor>> neighbors;
  for (const NamedBytes& each : files) {
    struct stat present {};
    const bool exists = ::stat(each.file.c_str(), &present) == 0;
    const Result<Place> place = placeForFile(each.file, exists ? &present : nullptr);
    if (!place) return place.error();
    neighbors.push_back(std::make_unique<Neighbor>(each.file, place->target, exists, previous));
    if (auto filled = neighbors.back()->fill(each.bytes, place->mode); !filled) return filled;
  }
  // The renames stand together: a process that is killed between two of them leaves files of two versions.
  for (const auto& neighbor : neighbors) neighbor->keep();
  for (const auto& neighbor : neighbors) {
    if (auto put = neighbor->put(); !put) return put;
  }
  for (const auto& neighbor : neighbors) neighbor->flush();
  return {};
}

Result<void> putFileAtomically(const fs::path& made, const fs::path& file) {
  struct stat present {};
  const bool exists = ::stat(file.c_str(), &present) == 0;
  const Result<Place> place = placeForFile(file, exists ? &present : nullptr);
  if (!place) return place.error();
  Neighbor neighbor(file, place->target, exists, Previous::kKept);
  neighbor.take(made);
  const Descriptor descriptor(::open(made.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor.isOpen() || ::fsync(descriptor.number()) != 0) return because(file, "cannot be written", errno);
  if (place->mode != 0 && ::fchmod(descriptor.number(), place->mode) != 0) {
    return because(file, "cannot be written", errno);
  }
  neighbor.keep();
  const Result<void> put = neighbor.put();
  neighbor.flush();
  return put;
}

Result<std::string> readWholeFile(const fs::path& file, std::uintmax_t limit) {
  return readWhole<std::string>(file, limit);
}

Result<std::vector<std::uint8_t>> readWholeBytes(const fs::path& file, std::uintmax_t limit) {
  return readWhole<std::vector<std::uint8_t>>(file, limit);
}

}  // namespace sinew
