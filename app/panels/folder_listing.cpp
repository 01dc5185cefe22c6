// app/panels/folder_listing.cpp: folders for the path dialog.

#include "app/panels/folder_listing.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <tuple>

namespace sinew::app {
namespace {

constexpr std::size_t kMostEntries = 5000;

std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool isRig(const std::string& lowerName) { return lowerName.ends_with(".rig.json"); }

bool isOpenable(const std::string& lowerName) {
  return isRig(lowerName) || lowerName.ends_with(".glb") || lowerName.ends_with(".gltf");
}

}  // namespace

std::vector<FolderEntry> listFolder(const std::filesystem::path& folder, bool rigsOnly) {
  std::vector<FolderEntry> entries;
  std::error_code error;
  std::filesystem::directory_iterator it(folder, std::filesystem::directory_options::skip_permission_denied, error);
  for (; !error && it != std::filesystem::directory_iterator() && entries.size() < kMostEntries; it.increment(error)) {
    const std::string name = it->path().filename().string();
    std::error_code ignored;
    const bool isFolder = it->is_directory(ignored);
    const std::string lower = lowerCase(name);
    if (name.starts_with('.') || !(isFolder || (rigsOnly ? isRig(lower) : isOpenable(lower)))) continue;
    entries.push_back({name, isFolder});
  }
  std::ranges::sort(entries, [](const FolderEntry& a, const FolderEntry& b) {
    return std::tuple(!a.folder, lowerCase(a.name), a.name) < std::tuple(!b.folder, lowerCase(b.name), b.name);
  });
  return entries;
}

std::filesystem::path resolveTyped(const std::filesystem::path& folder, std::string_view text) {
  const char* home = std::getenv("HOME");
  if (home != nullptr && (text == "~" || text.starts_with("~/"))) {
    return (std::filesystem::path(home) / std::filesystem::path(text.substr(text.size() > 1 ? 2 : 1)))
        .lexically_normal();
  }
  return (folder / std::filesystem::path(text)).lexically_normal();
}

std::filesystem::path withRigEnding(std::filesystem::path file) {
  if (!lowerCase(file.filename().string()).ends_with(".json")) file += ".rig.json";
  return file;
}

}  // namespace sinew::app
