#pragma once  // app/panels/folder_listing.h: what the path dialog shows of a folder, and what a typed path means.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::app {

struct FolderEntry {
  std::string name;
  bool folder = false;
};

/// Folders first, then files that can be opened (.glb, .gltf, .rig.json), each by name; hidden ones left out. At most
/// 5,000. An unreadable folder is empty.
[[nodiscard]] std::vector<FolderEntry> listFolder(const std::filesystem::path& folder, bool rigsOnly);

/// Typed text against a folder: absolute paths stay, "~" is the home folder, the rest is relative to the folder.
[[nodiscard]] std::filesystem::path resolveTyped(const std::filesystem::path& folder, std::string_view text);

/// The name a rig is saved under: ".rig.json" is appended unless it ends so or in ".json".
[[nodiscard]] std::filesystem::path withRigEnding(std::filesystem::path file);

}  // namespace sinew::app
