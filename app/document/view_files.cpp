// app/document/view_files.cpp: views of files as small JSON files.

#include "app/document/view_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "app/document/recovery.h"
#include "core/files/disk/atomic_file.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestViewFile = 1u << 20;
constexpr std::string_view kFormat = "sinew-view";
constexpr std::size_t kNameLength = 16;  ///< Hexadecimal digits.

std::string canonicalPath(const fs::path& file) {
  std::error_code failed;
  const fs::path canonical = fs::weakly_canonical(file, failed);
  return failed ? std::string() : canonical.string();
}

/// FNV-1a, 64 bits. Two paths of one hash share a place; the path in the file says whose it is.
std::string hashOf(const std::string& path) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : path) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  std::string digits(kNameLength, '0');
  for (std::size_t i = 0; i < kNameLength; ++i) digits[i] = "0123456789abcdef"[(hash >> (60 - 4 * i)) & 15u];
  return digits;
}

bool isView(const fs::path& file) {
  const std::string stem = file.stem().string();
  return file.extension() == ".json" && stem.size() == kNameLength &&
         stem.find_first_not_of("0123456789abcdef") == std::string::npos;
}

void removeOldest(const fs::path& folder, const fs::path& kept) {
  std::vector<std::pair<fs::file_time_type, fs::path>> views;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed); !failed && it != fs::directory_iterator(); it.increment(failed)) {
    std::error_code gone;
    if (const auto when = fs::last_write_time(it->path(), gone); !gone && isView(it->path()) && it->path() != kept) {
      views.emplace_back(when, it->path());
    }
  }
  if (views.size() < kMostViews) return;
  std::ranges::sort(views);
  for (std::size_t i = 0; i + kMostViews - 1 < views.size(); ++i) fs::remove(views[i].second, failed);
}

}  // namespace

fs::path viewsFolder() { return recoveryFolder().parent_path() / "views"; }

std::optional<Json> loadView(const fs::path& folder, const fs::path& file) {
  const std::string path = canonicalPath(file);
  const Result<std::string> text = readWholeFile(folder / (hashOf(path) + ".json"), kLargestViewFile);
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
  const fs::path target = folder / (hashOf(path) + ".json");
  const Json whole =
      Json::object().set("format", std::string(kFormat)).set("version", 1).set("file", path).set("view", view);
  if (Result<void> written = writeFileAtomically(target, whole.dump(true) + "\n", Previous::kReplaced); !written)
    return written;
  removeOldest(folder, target);
  return {};
}

}  // namespace sinew::app
