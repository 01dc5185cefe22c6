// app/document/file_stamp.h: whether a file has changed on disk, and locks between running editors.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sinew::app {

/// An open file with a lock on it, which the system releases when the process ends.
class FileLock {
 public:
  FileLock() = default;
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  [[nodiscard]] bool held() const { return descriptor_ >= 0; }

 private:
  int descriptor_ = -1;
};

/// Waits up to 0.5 s for another holder (milliseconds unless it hangs). Not held on timeout or without the folder.
[[nodiscard]] FileLock lockFolder(const std::filesystem::path& folder);

/// Length and hash of a file's bytes. Dates are unreliable: copies and version control change them.
struct FileStamp {
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;  ///< FNV-1a, 64 bits.

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

[[nodiscard]] FileStamp stampOf(std::string_view content);
/// Includes the buffers that a .gltf names. nullopt: the file cannot be read.
[[nodiscard]] std::optional<FileStamp> stampOfFile(const std::filesystem::path& file);

[[nodiscard]] std::string textOfStamp(const std::optional<FileStamp>& stamp);  ///< For the recovery file; "" for none.
[[nodiscard]] std::optional<FileStamp> stampFromText(const std::string& text);

/// Time and size of a file; `looked` is false before the first look.
struct DiskLook {
  bool looked = false;
  std::filesystem::file_time_type written{};
  std::uintmax_t bytes = 0;

  friend bool operator==(const DiskLook&, const DiskLook&) = default;
};
[[nodiscard]] DiskLook lookAt(const std::filesystem::path& file);

enum class OnDisk { kSame, kChanged, kGone };

/// @param known  nullopt: the file was missing or its content is unknown
[[nodiscard]] OnDisk compareWithDisk(const std::filesystem::path& file, const std::optional<FileStamp>& known);

/// A free name in the same folder: "arm.rig.json" -> "arm 2.rig.json", "arm 3.rig.json" ...
[[nodiscard]] std::filesystem::path freeNameBeside(const std::filesystem::path& file);

}  // namespace sinew::app
