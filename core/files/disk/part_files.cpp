// core/files/disk/part_files.cpp: a part without a lock is nobody's.
#include "core/files/disk/part_files.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <sys/file.h>
#include <sys/stat.h>

namespace sinew {
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

}  // namespace sinew
