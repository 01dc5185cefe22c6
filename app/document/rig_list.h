// app/document/rig_list.h: rigs of a folder, and their names as a farm job says them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sinew::app {

/// "fox" for a/fox.rig.json, a/fox.glb and the like; of other names the stem.
[[nodiscard]] std::string nameWithoutEnding(const std::filesystem::path& file);

/// Every *.rig.json of a folder, by name; none with a line break in its name, which no list can hold.
[[nodiscard]] std::vector<std::filesystem::path> rigsIn(const std::filesystem::path& folder);

/// A path as a word of a command that runs in `folder`: relative where it lies inside, and never taken for an option or
/// a comment. @param folder, file  absolute
[[nodiscard]] std::string pathWord(const std::filesystem::path& folder, const std::filesystem::path& file);

/// A list for --list, one rig a line.
[[nodiscard]] std::string listText(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& rigs);

}  // namespace sinew::app
