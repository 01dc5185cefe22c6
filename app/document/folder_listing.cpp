// app/document/folder_listing.cpp: folders for the path dialog.
#include "app/document/folder_listing.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <system_error>
#include <tuple>

#include "core/geometry/nearest_name.h"

namespace sinew::app {

namespace fs = std::filesystem;

std::string nameWithoutEnding(const fs::path& file) {
  return withoutEnding(file.filename().string()).value_or(file.stem().string());
}

std::vector<fs::path> rigsIn(const fs::path& folder) {
  std::vector<fs::path> rigs;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed); !failed && it != fs::directory_iterator(); it.increment(failed)) {
    const std::string name = it->path().filename().string();
    std::error_code unknown;
    if (name.ends_with(".rig.json") && name.find('\n') == std::string::npos && it->is_regular_file(unknown)) {
      rigs.push_back(it->path());
    }
  }
  std::ranges::sort(rigs);
  return rigs;
}

std::string pathWord(const fs::path& folder, const fs::path& file) {
  const fs::path relative = file.lexically_relative(folder);
  if (relative.empty() || *relative.begin() == "..") return file.string();
  const std::string word = relative.string();
  return std::string("-# \t").find(word.front()) == std::string::npos ? word : "./" + word;
}

std::string listText(const fs::path& folder, const std::vector<fs::path>& rigs) {
  std::string text;
  for (const fs::path& rig : rigs) text += pathWord(folder, rig) + '\n';
  return text;
}

namespace {

constexpr std::size_t kMostEntries = 5000;
constexpr std::array kJobEndings{".sh", ".json", ".txt"};
constexpr std::size_t kMostRecentPlaces = 5;
constexpr std::array kMovieEndings{".png", ".webp", ".gif", ".mp4"};
constexpr std::array kSculptEndings{".glb", ".gltf", ".vrm", ".obj", ".ply"};
constexpr std::array kReferenceEndings{".png", ".jpg", ".jpeg", ".webp"};

bool passes(const std::string& lowerName, FileFilter filter) {
  if (filter == FileFilter::kPictures) return lowerName.ends_with(".png");
  if (filter == FileFilter::kReferences) return isReferenceName(lowerName);
  if (filter == FileFilter::kSculpts) {
    return std::ranges::any_of(kSculptEndings, [&](const char* end) { return lowerName.ends_with(end); });
  }
  if (filter == FileFilter::kMovies) {
    return std::ranges::any_of(kMovieEndings, [&](const char* end) { return lowerName.ends_with(end); });
  }
  const bool rig = lowerName.ends_with(".rig.json");
  if (filter == FileFilter::kJobs) {
    return !rig && std::ranges::any_of(kJobEndings, [&](const char* end) { return lowerName.ends_with(end); });
  }
  const bool character = isCharacterName(lowerName);
  return (rig && filter != FileFilter::kCharacters) || (character && filter != FileFilter::kRigs);
}

FolderEntry entryOf(const fs::directory_entry& found, bool folder) {
  std::error_code failed;
  FolderEntry entry{found.path().filename().string(), folder, found.last_write_time(failed), 0};
  if (failed) entry.when = {};
  if (!folder) entry.bytes = found.file_size(failed);
  if (failed) entry.bytes = 0;
  return entry;
}

void sortEntries(std::vector<FolderEntry>& entries, bool newestFirst) {
  const auto byName = [](const FolderEntry& a, const FolderEntry& b) {
    return std::tuple(!a.folder, lowerCase(a.name), a.name) < std::tuple(!b.folder, lowerCase(b.name), b.name);
  };
  std::ranges::sort(entries, [&](const FolderEntry& a, const FolderEntry& b) {
    if (newestFirst && a.folder == b.folder && a.when != b.when) return a.when > b.when;
    return byName(a, b);
  });
}

std::size_t sameLetters(const std::string& a, const std::string& b) {
  std::size_t count = 0;
  while (count < a.size() && count < b.size() && toLower(a[count]) == toLower(b[count])) ++count;
  return count;
}

void addPlace(std::vector<Place>& all, std::string id, std::string name, const fs::path& folder) {
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) return;
  const fs::path clean = folder.lexically_normal();
  if (std::ranges::find(all, clean, &Place::folder) != all.end()) return;
  all.push_back({std::move(id), std::move(name), clean});
}

}  // namespace

bool isReferenceName(const std::string& name) {
  const std::string lower = lowerCase(name);
  return std::ranges::any_of(kReferenceEndings, [&](const char* end) { return lower.ends_with(end); });
}

std::vector<FolderEntry> listFolder(const fs::path& folder, const ListingOptions& options) {
  std::vector<FolderEntry> entries;
  std::error_code error;
  fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && it != fs::directory_iterator() && entries.size() < kMostEntries; it.increment(error)) {
    const std::string name = it->path().filename().string();
    std::error_code ignored;
    const bool isFolder = it->is_directory(ignored);
    if (name.starts_with('.') && !options.hidden) continue;
    if (isFolder || passes(lowerCase(name), options.filter)) entries.push_back(entryOf(*it, isFolder));
  }
  sortEntries(entries, options.newestFirst);
  return entries;
}

void refresh(FolderListing& listing, const fs::path& folder, const ListingOptions& options) {
  std::error_code failed;
  const fs::file_time_type now = fs::last_write_time(folder, failed);
  const std::optional<fs::file_time_type> changed = failed ? std::nullopt : std::optional(now);
  if (listing.changed && listing.folder == folder && listing.options == options && listing.changed == changed) return;
  listing = {listFolder(folder, options), folder, options, changed};
}

fs::path resolveTyped(const fs::path& folder, std::string_view text) {
  const char* home = std::getenv("HOME");
  if (home != nullptr && (text == "~" || text.starts_with("~/"))) {
    return (fs::path(home) / fs::path(text.substr(text.size() > 1 ? 2 : 1))).lexically_normal();
  }
  return (folder / fs::path(text)).lexically_normal();
}

std::string completePath(const fs::path& folder, const std::string& text, const ListingOptions& options) {
  const std::size_t slash = text.rfind('/');
  const std::string before = slash == std::string::npos ? "" : text.substr(0, slash + 1);
  const std::string begun = text.substr(before.size());
  ListingOptions wide = options;
  wide.hidden = options.hidden || begun.starts_with('.');
  std::vector<FolderEntry> fitting = listFolder(before.empty() ? folder : resolveTyped(folder, before), wide);
  std::erase_if(fitting, [&](const FolderEntry& entry) { return sameLetters(entry.name, begun) < begun.size(); });
  if (std::ranges::any_of(fitting, [&](const FolderEntry& entry) { return entry.name.starts_with(begun); })) {
    std::erase_if(fitting, [&](const FolderEntry& entry) { return !entry.name.starts_with(begun); });
  }
  if (fitting.empty()) return text;
  std::string common = fitting.front().name;
  for (const FolderEntry& entry : fitting) common.resize(sameLetters(common, entry.name));
  if (fitting.size() == 1 && fitting.front().folder) common += '/';
  return before + common;
}

fs::path withRigEnding(fs::path file) {
  const std::string ending = lowerCase(file.extension().string());
  if (isCharacterName(ending)) file.replace_extension();
  if (!lowerCase(file.filename().string()).ends_with(".json")) file += ".rig.json";
  return file;
}

fs::path homeFolder() {
  const char* const home = std::getenv("HOME");
  std::error_code ignored;
  return home != nullptr && *home != '\0' ? fs::path(home) : fs::current_path(ignored);
}

std::vector<Place> places(const std::vector<fs::path>& recentFiles, const fs::path& sampleFolder) {
  std::vector<Place> all;
  const fs::path home = homeFolder();
  addPlace(all, "home", "Home", home);
  for (const char* name : {"Desktop", "Documents", "Downloads"}) addPlace(all, lowerCase(name), name, home / name);
  addPlace(all, "samples", "Samples", sampleFolder);
  const std::size_t fixed = all.size();
  for (const fs::path& file : recentFiles) {
    if (all.size() >= fixed + kMostRecentPlaces) break;
    const fs::path folder = file.parent_path();
    addPlace(all, "recent/" + std::to_string(all.size() - fixed), folder.filename().string(), folder);
  }
  addPlace(all, "root", "Computer", "/");
  return all;
}

std::string dateText(fs::file_time_type when) {
  const auto system = std::chrono::file_clock::to_sys(when);
  const std::time_t seconds =
      std::chrono::system_clock::to_time_t(std::chrono::time_point_cast<std::chrono::system_clock::duration>(system));
  std::tm local{};
  if (localtime_r(&seconds, &local) == nullptr) return "";
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local)};
}

std::string sizeText(std::uintmax_t bytes) {
  std::array<char, 32> text{};
  const auto count = static_cast<double>(bytes);
  if (bytes < 1024) std::snprintf(text.data(), text.size(), "%.0f B", count);
  else if (bytes < 1024 * 1024) std::snprintf(text.data(), text.size(), "%.0f KB", count / 1024.0);
  else std::snprintf(text.data(), text.size(), "%.1f MB", count / (1024.0 * 1024.0));
  return text.data();
}

}  // namespace sinew::app
