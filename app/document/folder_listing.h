// app/document/folder_listing.h: what the path dialog shows of a folder, and what a typed path means.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::app {

struct FolderEntry {
  std::string name;
  bool folder = false;
  std::filesystem::file_time_type when;
  std::uintmax_t bytes = 0;  ///< 0 for folders.
};

/// Which files; folders are always there.
enum class FileFilter { kAll, kRigs, kCharacters, kPictures, kJobs, kReferences, kMovies };

/// Whether the name is that of a picture to work after: .png, .jpg, .jpeg, .webp; capitals too.
[[nodiscard]] bool isReferenceName(const std::string& name);

struct ListingOptions {
  FileFilter filter = FileFilter::kAll;
  bool hidden = false;       ///< Names that begin with a dot as well.
  bool newestFirst = false;  ///< Else by name.

  friend bool operator==(const ListingOptions&, const ListingOptions&) = default;
};

/// Folders first, then files that can be opened (.glb, .gltf, .rig.json) pictures (.png; to work after .jpg and .webp
/// too; of exports .webp, .gif and .mp4 too) or farm jobs (.sh, .json, .txt), as the filter says, each in the order
/// asked for. At most 5,000. An unreadable folder is empty.
[[nodiscard]] std::vector<FolderEntry> listFolder(const std::filesystem::path& folder, const ListingOptions& options);

/// A folder's entries kept until something changes.
struct FolderListing {
  std::vector<FolderEntry> entries;
  std::filesystem::path folder;
  ListingOptions options;
  std::optional<std::filesystem::file_time_type> changed;  ///< The folder's own time when it was read.
};
/// Reads again if the folder, the options or the folder's time are others.
void refresh(FolderListing& listing, const std::filesystem::path& folder, const ListingOptions& options);

/// Typed text against a folder: absolute paths stay, "~" is the home folder, the rest is relative to the folder.
[[nodiscard]] std::filesystem::path resolveTyped(const std::filesystem::path& folder, std::string_view text);

/// The text as far as the names in the folder it points into leave no choice; a lone folder with a "/" after it. Case
/// counts only if it must. Nothing fits: the text.
[[nodiscard]] std::string completePath(const std::filesystem::path& folder, const std::string& text,
                                       const ListingOptions& options);

/// The name a rig is saved under: ".rig.json" is appended unless it ends so or in ".json", and takes the place of a
/// character's ending.
[[nodiscard]] std::filesystem::path withRigEnding(std::filesystem::path file);

/// $HOME, else the working folder.
[[nodiscard]] std::filesystem::path homeFolder();

/// A place to jump to.
struct Place {
  std::string id;  ///< "home", "samples", "root", "recent/0" ...
  std::string name;
  std::filesystem::path folder;
};
/// Home, its Documents, Downloads and Desktop if there are such, samples, the folders of recent files, the root: those
/// that are there, each once.
[[nodiscard]] std::vector<Place> places(const std::vector<std::filesystem::path>& recentFiles,
                                        const std::filesystem::path& sampleFolder);

/// "2026-11-21 04:35", local time.
[[nodiscard]] std::string dateText(std::filesystem::file_time_type when);
/// "812 B", "34 KB", "1.2 MB".
[[nodiscard]] std::string sizeText(std::uintmax_t bytes);

}  // namespace sinew::app
