// app/document/file_stamp.h: whether a file still holds what it held when it was read or written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sinew::app {

/// What a file held, as a length and a hash of its bytes. Its date says nothing: copies and version control keep or
/// change it as they like.
struct FileStamp {
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;  ///< FNV-1a, 64 bits: the same in every run.

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

[[nodiscard]] FileStamp stampOf(std::string_view content);
/// Of a .gltf with the buffers that it names. None: there is no such file, or it cannot be read.
[[nodiscard]] std::optional<FileStamp> stampOfFile(const std::filesystem::path& file);

/// As text, for the recovery file; "" for none.
[[nodiscard]] std::string textOfStamp(const std::optional<FileStamp>& stamp);
[[nodiscard]] std::optional<FileStamp> stampFromText(const std::string& text);

/// What the system says of a file without reading it.
struct DiskLook {
  bool looked = false;
  std::filesystem::file_time_type written{};
  std::uintmax_t bytes = 0;

  friend bool operator==(const DiskLook&, const DiskLook&) = default;
};
[[nodiscard]] DiskLook lookAt(const std::filesystem::path& file);

enum class OnDisk { kSame, kChanged, kGone };

/// @param known  none: the file was not there, or its content is not known
[[nodiscard]] OnDisk compareWithDisk(const std::filesystem::path& file, const std::optional<FileStamp>& known);

/// A name beside the file that nothing has yet: "arm.rig.json" -> "arm 2.rig.json", "arm 3.rig.json" ...
[[nodiscard]] std::filesystem::path freeNameBeside(const std::filesystem::path& file);

}  // namespace sinew::app
