// app/document/thumbnail_files.cpp: names from documents, and no more files than a cache should hold.

#include "app/document/thumbnail_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include "core/files/disk/atomic_file.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

/// FNV-1a, 64 bits.
std::uint64_t hashed(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001b3u;
  return hash;
}

void removeOldest(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed); !failed && it != fs::directory_iterator(); it.increment(failed)) {
    std::error_code ignored;
    if (it->path().extension() == ".png") files.emplace_back(it->last_write_time(ignored), it->path());
  }
  if (files.size() <= kMostThumbnails) return;
  std::ranges::sort(files);
  files.resize(files.size() - kMostThumbnails);
  for (const auto& [when, file] : files) fs::remove(file, failed);
}

}  // namespace

fs::path thumbnailFolder() {
  if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder != nullptr && *folder == '/') {
    return fs::path(folder) / "sinew" / "thumbnails";
  }
  const char* home = std::getenv("HOME");
  std::error_code ignored;
  return (home != nullptr && *home != '\0' ? fs::path(home) / ".cache" : fs::temp_directory_path(ignored)) / "sinew" /
         "thumbnails";
}

fs::path thumbnailFile(const fs::path& folder, const fs::path& document) {
  std::error_code failed;
  const fs::path whole = fs::canonical(document, failed);
  if (failed) return {};
  const auto when = fs::last_write_time(whole, failed).time_since_epoch().count();
  const std::uintmax_t bytes = failed ? 0 : fs::file_size(whole, failed);
  if (failed) return {};
  const std::string key = whole.string() + '\n' + std::to_string(when) + '\n' + std::to_string(bytes);
  std::array<char, 24> name{};
  std::snprintf(name.data(), name.size(), "%016llx.png", static_cast<unsigned long long>(hashed(key)));
  return folder / name.data();
}

Result<void> keepThumbnail(const fs::path& folder, const fs::path& document, std::string_view png) {
  const fs::path file = thumbnailFile(folder, document);
  if (file.empty()) return Error{document.string(), "", "is not there"};
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (const Result<void> written = writeFileAtomically(file, png, Previous::kReplaced); !written) return written;
  removeOldest(folder);
  return {};
}

}  // namespace sinew::app
