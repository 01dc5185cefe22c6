// app/document/folder_listing.h: listings of folders for the path dialog, typed paths, and names of files.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::app {

/// "fox" for a/fox.rig.json, a/fox.glb and the like; the stem of other names.
[[nodiscard]] std::string nameWithoutEnding(const std::filesystem::path& file);

/// Every *.rig.json of a folder, by name, but those with a line break, which a list cannot hold.
[[nodiscard]] std::vector<std::filesystem::path> rigsIn(const std::filesystem::path& folder);

/// A path for a command in `folder`: relative inside it, never mistaken for an option or comment. Both are absolute.
[[nodiscard]] std::string pathWord(const std::filesystem::path& folder, const std::filesystem::path& file);

/// A list for --list, one rig per line.
[[nodiscard]] std::string listText(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& rigs);

inline constexpr std::array<std::string_view, 3> kCharacterEndings{".glb", ".gltf", ".vrm"};  ///< Lower case.

/// @param lowerName  in lower case
[[nodiscard]] inline bool isCharacterName(std::string_view lowerName) {
  return std::ranges::any_of(kCharacterEndings, [&](std::string_view end) { return lowerName.ends_with(end); });
}

/// "fox" of "fox.rig.json", "fox.glb" ...; nullopt for other names.
[[nodiscard]] inline std::optional<std::string> withoutEnding(std::string_view name) {
  const auto stemBefore = [name](std::string_view end) {
    const bool ends = name.size() > end.size() && name.ends_with(end);
    return ends ? std::optional(std::string(name.substr(0, name.size() - end.size()))) : std::nullopt;
  };
  std::optional<std::string> stem = stemBefore(".rig.json");
  for (std::size_t i = 0; i < kCharacterEndings.size() && !stem; ++i) stem = stemBefore(kCharacterEndings[i]);
  return stem;
}

struct FolderEntry {
  std::string name;
  bool folder = false;
  std::filesystem::file_time_type when;
  std::uintmax_t bytes = 0;  ///< 0 for folders.
};

/// Which files are listed; folders always are.
enum class FileFilter { kAll, kRigs, kCharacters, kPictures, kJobs, kReferences, kMovies, kSculpts };

/// A reference picture: .png, .jpg, .jpeg or .webp, in any case.
[[nodiscard]] bool isReferenceName(const std::string& name);

struct ListingOptions {
  FileFilter filter = FileFilter::kAll;
  bool hidden = false;       ///< With names that begin with a dot.
  bool newestFirst = false;  ///< Else by name.

  friend bool operator==(const ListingOptions&, const ListingOptions&) = default;
};

/// Folders first, then the files that the filter lets through. At most 5,000. An unreadable folder is empty.
[[nodiscard]] std::vector<FolderEntry> listFolder(const std::filesystem::path& folder, const ListingOptions& options);

struct FolderListing {
  std::vector<FolderEntry> entries;
  std::filesystem::path folder;
  ListingOptions options;
  std::optional<std::filesystem::file_time_type> changed;  ///< The folder's time when it was read.
};
/// Reads again if folder, options or the folder's time differ.
void refresh(FolderListing& listing, const std::filesystem::path& folder, const ListingOptions& options);

/// Path of typed text: absolute, below "~" (the home folder), or relative to the folder.
[[nodiscard]] std::filesystem::path resolveTyped(const std::filesystem::path& folder, std::string_view text);

/// Completes the unambiguous part, ignoring case if it can; a single folder gets a "/". Without a match: the text.
[[nodiscard]] std::string completePath(const std::filesystem::path& folder, const std::string& text,
                                       const ListingOptions& options);

/// Appends ".rig.json" unless the name ends in ".json"; replaces a character's ending.
[[nodiscard]] std::filesystem::path withRigEnding(std::filesystem::path file);

[[nodiscard]] std::filesystem::path homeFolder();  ///< $HOME, else the working folder.

/// A shortcut of the path dialog.
struct Place {
  std::string id;  ///< "home", "samples", "root", "recent/0" ...
  std::string name;
  std::filesystem::path folder;
};
/// Home, Desktop, Documents, Downloads, samples, folders of recent files and the root: those that exist, each once.
[[nodiscard]] std::vector<Place> places(const std::vector<std::filesystem::path>& recentFiles,
                                        const std::filesystem::path& sampleFolder);

[[nodiscard]] std::string dateText(std::filesystem::file_time_type when);  ///< "2026-11-21 04:35", local time.
[[nodiscard]] std::string sizeText(std::uintmax_t bytes);                  ///< "812 B", "34 KB", "1.2 MB".

}  // namespace sinew::app
