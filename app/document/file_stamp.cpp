// app/document/file_stamp.cpp: hashing a file, comparing, names that are free.
#include "app/document/file_stamp.h"

#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/files/clip_files.h"
#include "core/files/disk/atomic_file.h"

namespace sinew::app {

namespace {

constexpr int kTries = 100;
constexpr std::chrono::milliseconds kBetweenTries{5};

}  // namespace

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileLock lockFolder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return {};
  FileLock lock(descriptor);
  for (int i = 0; i < kTries; ++i) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return lock;
    std::this_thread::sleep_for(kBetweenTries);
  }
  return {};
}

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestStampedFile = 1u << 30;

/// Without buffers.
std::optional<FileStamp> stampOfItself(const fs::path& file) {
  const Result<std::string> content = readWholeFile(file, kLargestStampedFile);
  if (!content) return std::nullopt;
  return stampOf(content.value());
}

/// "arm 2" -> "arm"
std::string withoutNumber(const std::string& stem) {
  std::size_t end = stem.size();
  while (end > 0 && std::isdigit(static_cast<unsigned char>(stem[end - 1])) != 0) --end;
  return end < stem.size() && end > 1 && stem[end - 1] == ' ' ? stem.substr(0, end - 1) : stem;
}

}  // namespace

FileStamp stampOf(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // Fowler, Noll, Vo: FNV-1a (IETF draft-eastlake-fnv).
  for (const char c : content)
    hash = (hash ^ static_cast<std::uint64_t>(static_cast<unsigned char>(c))) * 0x100000001b3u;
  return {content.size(), hash};
}

std::optional<FileStamp> stampOfFile(const fs::path& file) {
  const std::optional<FileStamp> own = stampOfItself(file);
  if (!own) return std::nullopt;
  FileStamp whole = *own;
  for (const fs::path& buffer : bufferFilesOf(file)) {
    const std::optional<FileStamp> part = stampOfItself(buffer);
    whole.hash = stampOf(textOfStamp(whole) + ' ' + textOfStamp(part)).hash;
    whole.bytes += part ? part->bytes : 0;
  }
  return whole;
}

std::string textOfStamp(const std::optional<FileStamp>& stamp) {
  if (!stamp) return "";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%llu:%016llx", static_cast<unsigned long long>(stamp->bytes),
                static_cast<unsigned long long>(stamp->hash));
  return text.data();
}

std::optional<FileStamp> stampFromText(const std::string& text) {
  unsigned long long bytes = 0;
  unsigned long long hash = 0;
  if (std::sscanf(text.c_str(), "%llu:%llx", &bytes, &hash) != 2) return std::nullopt;
  return FileStamp{bytes, hash};
}

DiskLook lookAt(const fs::path& file) {
  std::error_code failed;
  DiskLook look{true, fs::last_write_time(file, failed), 0};
  if (failed) return {true, {}, 0};
  look.bytes = fs::file_size(file, failed);
  return look;
}

OnDisk compareWithDisk(const fs::path& file, const std::optional<FileStamp>& known) {
  std::error_code failed;
  if (!fs::exists(file, failed)) return known ? OnDisk::kGone : OnDisk::kSame;
  return known && stampOfFile(file) == known ? OnDisk::kSame : OnDisk::kChanged;
}

fs::path freeNameBeside(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::string ending = name.ends_with(".rig.json") ? ".rig.json" : file.extension().string();
  const std::string stem = withoutNumber(name.substr(0, name.size() - ending.size()));
  std::error_code failed;
  for (int number = 2;; ++number) {
    fs::path beside = file.parent_path() / (stem + ' ' + std::to_string(number) + ending);
    if (!fs::exists(fs::symlink_status(beside, failed))) return beside;
  }
}

}  // namespace sinew::app
