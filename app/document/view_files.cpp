// app/document/view_files.cpp: views as JSON files, thumbnails as PNG files.
#include "app/document/view_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "app/document/file_stamp.h"
#include "app/document/preferences.h"
#include "app/document/recovery.h"
#include "core/files/disk/atomic_file.h"

namespace sinew::app {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestViewFile = 1u << 20;
constexpr std::string_view kFormat = "sinew-view";
constexpr std::size_t kNameLength = 16;  ///< Hexadecimal digits.

/// File name from a hash of the key.
std::string hashName(std::string_view key, const char* ending) {
  std::array<char, kNameLength + 1> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(stampOf(key).hash));
  return digits.data() + std::string(ending);
}

/// Two paths with the same hash share a file; the path in the file tells them apart.
fs::path viewFile(const fs::path& folder, const std::string& path) { return folder / hashName(path, ".json"); }

std::string canonicalPath(const fs::path& file) {
  std::error_code failed;
  const fs::path canonical = fs::weakly_canonical(file, failed);
  return failed ? std::string() : canonical.string();
}

/// Removes the oldest thumbnails, or views, beyond `most`, but not `kept`. Other files stay.
void removeOldest(const fs::path& folder, const fs::path& kept, std::size_t most) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed); !failed && it != fs::directory_iterator(); it.increment(failed)) {
    const fs::path& file = it->path();
    const std::string stem = file.stem().string();
    const bool isHash = stem.size() == kNameLength && stem.find_first_not_of("0123456789abcdef") == std::string::npos;
    const bool ours = file.extension() == kept.extension() && (isHash || kept.extension() == ".png");
    std::error_code gone;
    const auto when = fs::last_write_time(file, gone);
    if (ours && !gone && file != kept) files.emplace_back(when, file);
  }
  std::ranges::sort(files);
  for (std::size_t i = 0; i + most - 1 < files.size(); ++i) fs::remove(files[i].second, failed);
}

}  // namespace

fs::path thumbnailFolder() { return userFolder("XDG_CACHE_HOME", ".cache") / "sinew" / "thumbnails"; }

fs::path thumbnailFile(const fs::path& folder, const fs::path& document) {
  std::error_code failed;
  const fs::path whole = fs::canonical(document, failed);
  if (failed) return {};
  const auto when = fs::last_write_time(whole, failed).time_since_epoch().count();
  const std::uintmax_t bytes = failed ? 0 : fs::file_size(whole, failed);
  if (failed) return {};
  const std::string key = whole.string() + '\n' + std::to_string(when) + '\n' + std::to_string(bytes);
  return folder / hashName(key, ".png");
}

Result<void> keepThumbnail(const fs::path& folder, const fs::path& document, std::string_view png) {
  const fs::path file = thumbnailFile(folder, document);
  if (file.empty()) return Error{document.string(), "", "is not there"};
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (const Result<void> written = writeFileAtomically(file, png, Previous::kReplaced); !written) return written;
  removeOldest(folder, file, kMostThumbnails);
  return {};
}

fs::path viewsFolder() { return recoveryFolder().parent_path() / "views"; }

std::optional<Json> loadView(const fs::path& folder, const fs::path& file) {
  const std::string path = canonicalPath(file);
  const Result<std::string> text = readWholeFile(viewFile(folder, path), kLargestViewFile);
  if (path.empty() || !text) return std::nullopt;
  Result<Json> parsed = Json::parse(text.value());
  if (!parsed || parsed->at("format").text("") != kFormat || parsed->at("file").text("") != path) return std::nullopt;
  return parsed->at("view");
}

Result<void> storeView(const fs::path& folder, const fs::path& file, const Json& view) {
  const std::string path = canonicalPath(file);
  if (path.empty()) return Error{file.string(), "", "has no place in the file system"};
  std::error_code failed;
  fs::create_directories(folder, failed);
  const fs::path target = viewFile(folder, path);
  const Json whole =
      Json::object().set("format", std::string(kFormat)).set("version", 1).set("file", path).set("view", view);
  if (Result<void> written = writeFileAtomically(target, whole.dump(true) + "\n", Previous::kReplaced); !written)
    return written;
  removeOldest(folder, target, kMostViews);
  return {};
}

}  // namespace sinew::app
