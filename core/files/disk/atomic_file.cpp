// core/files/disk/atomic_file.cpp: POSIX files; every failure becomes a readable message.
#include "core/files/disk/atomic_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <memory>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

#include <sys/file.h>
#include <sys/stat.h>

namespace sinew {

// Stray parts.

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBefore = ".sinew-";
constexpr std::string_view kAfter = ".part";
constexpr std::string_view kDigits = "0123456789";

/// Removes digits from the front. False without any.
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

/// Time of the last write; for a second name of an older file, of the last change of any kind.
std::time_t lastUsed(const struct stat& file) { return file.st_nlink > 1 ? file.st_ctim.tv_sec : file.st_mtim.tv_sec; }

bool isSameFile(const struct stat& a, const struct stat& b) { return a.st_ino == b.st_ino && a.st_dev == b.st_dev; }

/// Only a regular file: links are not followed.
void removeIfStray(const fs::path& part, std::time_t before) {
  struct stat named {};
  struct stat opened {};
  if (::lstat(part.c_str(), &named) != 0 || !S_ISREG(named.st_mode) || lastUsed(named) >= before) return;
  const Descriptor file(::open(part.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file.isOpen() || ::flock(file.number(), LOCK_EX | LOCK_NB) != 0) return;
  // By now it may have been renamed to its place and the name reused.
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

// Writing and reading.

namespace {

constexpr int kReaderTries = 50;  ///< How long a pipe waits for its reader.
constexpr std::chrono::milliseconds kReaderPause{100};
/// Previous versions up to this size are copied where the file system has no hard links.
constexpr std::uintmax_t kMostCopied = 1U << 30U;

Error because(const fs::path& file, const std::string& what, int code) {
  return {file.string(), {}, what + ": " + std::generic_category().message(code)};
}

/// 0 or errno.
int writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Blocks SIGPIPE in this thread, so that writing to a closed pipe gives an error.
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

/// Opens without blocking, as a pipe without a reader would block forever. -1: see errno.
int openStream(const fs::path& file) {
  for (int tries = 0;; ++tries) {
    const int stream = ::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (stream >= 0 || errno != ENXIO || tries == kReaderTries) return stream;
    std::this_thread::sleep_for(kReaderPause);
  }
}

/// Pipes, terminals and devices.
Result<void> writeStream(const fs::path& file, std::string_view bytes) {
  Descriptor stream(openStream(file));
  if (!stream.isOpen() && errno == ENXIO) {
    return Error{file.string(), {}, "cannot be written: it is a pipe that no program reads"};
  }
  // Once open, wait for a slow reader.
  if (!stream.isOpen() || ::fcntl(stream.number(), F_SETFL, 0) != 0) return because(file, "cannot be written", errno);
  const NoPipeSignal quiet;
  const int failed = writeAll(stream.number(), bytes);
  if (failed != 0) return because(file, "cannot be written", failed);
  return {};
}

/// Creates and locks a new file beside `file`, named `made`. Not open: see errno.
Descriptor createNeighbor(const fs::path& file, fs::path& made) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    made = freshPart(file.parent_path());
    Descriptor neighbor(::open(made.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!neighbor.isOpen() && errno != EEXIST) return neighbor;
    if (!neighbor.isOpen()) continue;
    lockPart(neighbor);
    struct stat created {};
    // Unlinked: another program took it for a stray part before it was locked.
    if (::fstat(neighbor.number(), &created) != 0 || created.st_nlink > 0) return neighbor;
  }
  errno = EEXIST;
  return {};
}

/// 0 or errno. `mode` 0: the system's default.
int fill(const Descriptor& neighbor, std::string_view bytes, mode_t mode) {
  if (const int failed = writeAll(neighbor.number(), bytes); failed != 0) return failed;
  if (mode != 0 && ::fchmod(neighbor.number(), mode) != 0) return errno;
  return ::fsync(neighbor.number()) == 0 ? 0 : errno;
}

/// Gives an unnamed open file a new name beside `file`. 0 or errno.
int nameNeighbor(const Descriptor& neighbor, const fs::path& file, fs::path& made) {
  const std::string open = "/proc/self/fd/" + std::to_string(neighbor.number());
  for (int attempt = 0; attempt < 1000; ++attempt) {
    made = freshPart(file.parent_path());
    if (::linkat(AT_FDCWD, open.c_str(), AT_FDCWD, made.c_str(), AT_SYMLINK_FOLLOW) == 0) return 0;
    if (errno != EEXIST) return errno;
  }
  return EEXIST;
}

/// A written file beside its target.
struct Written {
  fs::path name;
  Descriptor lock;  ///< Held as long as the name exists.
};

/// Writes an unnamed file and names it when whole, so that a killed process leaves nothing behind. False if that fails,
/// for example because the file system has no unnamed files.
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

/// 0 or errno; a failure leaves no file.
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

/// A second name for the file, or a copy. 0 or errno.
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

/// Keeps the previous version as NAME~. If that fails (a folder, a full disk), the new one still replaces the file.
void keepPrevious(const fs::path& file) {
  Written made;
  fs::path kept = file;
  kept += '~';
  if (doubleFile(file, made) != 0) return;
  ::rename(made.name.c_str(), kept.c_str());
  ::unlink(made.name.c_str());  // A rename onto another name of the same file leaves both.
}

/// Paths seen in this run of the program.
class SeenPaths {
 public:
  /// Whether it is new.
  bool add(const fs::path& file) {
    const std::scoped_lock lock(mutex_);
    return files_.insert(file.string()).second;
  }

 private:
  std::mutex mutex_;
  std::set<std::string> files_;
};

SeenPaths& writtenFiles() {
  static SeenPaths files;
  return files;
}

fs::path fullPath(const fs::path& file) {
  std::error_code failed;
  fs::path full = fs::weakly_canonical(file, failed);
  return failed ? file : full;
}

/// Removes stray parts before the first write into a folder.
void clearOnce(const fs::path& folder) {
  static SeenPaths cleared;
  if (cleared.add(fullPath(folder.empty() ? "." : folder))) clearStrayParts(folder, std::time(nullptr));
}

/// Flushes the rename to disk. Some file systems cannot; the file is whole either way.
void flushFolder(const fs::path& folder) {
  const Descriptor descriptor(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.isOpen()) ::fsync(descriptor.number());
}

/// A file beside its target; removed unless put() renames it.
class Neighbor {
 public:
  /// @param exists  the target exists
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

  /// Uses a file that another program has written into the same folder.
  void take(const fs::path& made) { made_.name = made; }

  /// Keeps the previous version. Before put().
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
  bool isSame_ = false;  ///< The target has these bytes already.
};

/// Target of a regular file.
struct FileTarget {
  fs::path path;
  mode_t mode = 0;
};

Result<FileTarget> targetFor(const fs::path& file, const struct stat* present) {
  if (!present) return FileTarget{file, 0};
  if (S_ISDIR(present->st_mode)) return Error{file.string(), {}, "cannot be written: it is a folder"};
  if (!S_ISREG(present->st_mode)) return Error{file.string(), {}, "cannot be written: it is not a regular file"};
  // A rename would ignore write protection, which is set on purpose.
  if (::access(file.c_str(), W_OK) != 0) return because(file, "cannot be written", errno);
  // Follow links, so that they remain links.
  std::error_code failed;
  fs::path target = fs::canonical(file, failed);
  if (failed) return because(file, "cannot be written", failed.value());
  return FileTarget{std::move(target), static_cast<mode_t>(present->st_mode & 07777)};
}

template <class Bytes>
Result<Bytes> readWhole(const fs::path& file, std::uintmax_t limit) {
  // Without blocking: a pipe without a writer must not hang the program.
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
    const Result<FileTarget> target = targetFor(each.file, exists ? &present : nullptr);
    if (!target) return target.error();
    neighbors.push_back(std::make_unique<Neighbor>(each.file, target->path, exists, previous));
    if (auto filled = neighbors.back()->fill(each.bytes, target->mode); !filled) return filled;
  }
  // Renames follow each other at once: a process killed between two of them leaves files of two versions.
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
  const Result<FileTarget> target = targetFor(file, exists ? &present : nullptr);
  if (!target) return target.error();
  Neighbor neighbor(file, target->path, exists, Previous::kKept);
  neighbor.take(made);
  const Descriptor descriptor(::open(made.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor.isOpen() || ::fsync(descriptor.number()) != 0) return because(file, "cannot be written", errno);
  if (target->mode != 0 && ::fchmod(descriptor.number(), target->mode) != 0) {
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
