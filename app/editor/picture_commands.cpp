// app/editor/picture_commands.cpp: where pictures go, and under which name.

#include "app/editor/picture_commands.h"

#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "app/document/folder_listing.h"
#include "app/document/rig_list.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

/// What a line `XDG_PICTURES_DIR="$HOME/Bilder"` says; "" where it is another line.
fs::path pictureLine(std::string_view line) {
  constexpr std::string_view kBegin = "XDG_PICTURES_DIR=\"";
  constexpr std::string_view kHome = "$HOME/";
  if (!line.starts_with(kBegin) || line.size() <= kBegin.size() || !line.ends_with('"')) return {};
  line.remove_prefix(kBegin.size());
  line.remove_suffix(1);
  if (line.starts_with(kHome)) return homeFolder() / line.substr(kHome.size());
  return line.starts_with('/') ? fs::path(line) : fs::path{};
}

fs::path namedFolder() {
  std::ifstream file(configFolder().parent_path() / "user-dirs.dirs");
  for (std::string line; std::getline(file, line);) {
    if (fs::path folder = pictureLine(line); !folder.empty()) return folder;
  }
  return {};
}

fs::path folderForPictures(const EditorState& state) {
  const fs::path& last = state.session.preferences.pictureFolder;
  std::error_code failed;
  return !last.empty() && fs::is_directory(last, failed) ? last : picturesFolder();
}

std::string timeText() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d-%H%M%S", &local)};
}

}  // namespace

fs::path picturesFolder() {
  std::error_code failed;
  for (const fs::path& folder : {namedFolder(), homeFolder() / "Pictures"}) {
    if (!folder.empty() && fs::is_directory(folder, failed)) return folder;
  }
  return homeFolder();
}

fs::path withPictureEnding(fs::path file) {
  if (lowerEnding(file) != ".png") file += ".png";
  return file;
}

void showPictureDialog(EditorState& state) {
  state.dialogs.file = {};
  state.dialogs.file.kind = DialogKind::kSavePicture;
  state.dialogs.file.folder = folderForPictures(state);
  state.dialogs.file.text = nameWithoutEnding(state.document.name()) + ".png";
  state.dialogs.file.appearing = true;
}

void savePictureNow(EditorState& state) {
  const std::string begin =
      (folderForPictures(state) / (nameWithoutEnding(state.document.name()) + '-' + timeText())).string();
  fs::path file = begin + ".png";
  std::error_code failed;
  for (int again = 2; fs::exists(file, failed); ++again) file = begin + '-' + std::to_string(again) + ".png";
  state.session.pictureWanted = file;
}

void wantPicture(EditorState& state, const fs::path& file) {
  state.session.preferences.pictureFolder = file.parent_path();
  state.session.pictureWanted = file;
}

}  // namespace sinew::app
