// app/editor/picture_commands.cpp: pictures, turntables and contact sheets as files.
#include "app/editor/picture_commands.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <numbers>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/document/folder_listing.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/session.h"
#include "app/viewport/render/picture_files.h"
#include "app/viewport/render/scene.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "sinew/files/rig_json.h"
#include "sinew/geometry/threads.h"

namespace sinew::app {

namespace {

namespace fs = std::filesystem;

constexpr int kLargestSheet = 16384;  ///< Pixels, as `sinew render --sheet` allows.
constexpr int kMostPictures = 10000;  ///< As --turntable.

/// The shortest text that reads back as this number.
std::string numberText(double number) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), written.ptr};
}

const AnimationClip* shownClip(const EditorState& state) {
  const int clip = state.open.transport.clip;
  return clip < 0 ? nullptr : &at(state.character().clips, clip);
}

/// The clip plays in the turntable or over the sheet.
bool moves(const EditorState& state) {
  const PicturesDialogState& dialog = state.dialogs.pictures;
  const AnimationClip* const clip = shownClip(state);
  return clip != nullptr && clip->duration > 0.0f && (dialog.sheet ? dialog.ofClip : dialog.plays);
}

int clipFrames(const EditorState& state) {
  constexpr double kSameFrame = 1e-3;
  return static_cast<int>(double{shownClip(state)->duration} * state.dialogs.pictures.rate + kSameFrame) + 1;
}

void addLook(const EditorState& state, std::vector<std::string>& words) {
  const DisplaySettings& shown = state.view.display;
  words.insert(words.end(), {"--shading", nameOf(shown.shading)});
  std::string show;
  const auto add = [&](bool isShown, const char* word) {
    if (isShown) show += (show.empty() ? "" : ",") + std::string(word);
  };
  add(shown.anatomy, "muscles");
  add(shown.skeleton, "skeleton");
  add(shown.primitives, "primitives");
  add(shown.influence, "influence");
  add(shown.wire, "wire");
  add(shown.controlMesh, "control");
  add(shown.relief, "relief");
  if (!show.empty()) words.insert(words.end(), {"--show", show});
  if (shown.anatomy) words.insert(words.end(), {"--glass", numberText(double{shown.glass})});
  if (!shown.ground) words.emplace_back("--no-ground");
  const PictureLook& look = state.session.preferences.look;
  words.insert(words.end(), {"--light", nameOf(look.light), "--background", nameOf(look.backdrop)});
  if (look.occlusion) words.emplace_back("--ao");
}

void addView(const EditorState& state, std::vector<std::string>& words) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const Camera& camera = state.view.tools.camera;
  const CameraStand& stand = camera.transition ? camera.transition->to : camera.stand;
  const auto degrees = [&](float angle) { return numberText(std::round(10.0 * kDegrees * double{angle}) / 10.0); };
  words.push_back("--view=" + degrees(stand.yaw) + ',' + degrees(stand.pitch));
  if (camera.orthographic) words.emplace_back("--orthographic");
}

std::string refusalOf(EditorState& state, const fs::path& file) {
  PicturesDialogState& dialog = state.dialogs.pictures;
  std::error_code ignored;
  if (file.empty()) return "It needs a name";
  if (!fs::is_directory(file.parent_path(), ignored)) return "There is no folder " + file.parent_path().string();
  if (fs::is_directory(file, ignored)) return file.filename().string() + " is a folder";
  if (!dialog.sheet) {
    if (const Result<void> able = checkMovieName(file); !able) return able.error().reason;
    if (pictureCount(state) > kMostPictures) return "At this rate the clip has more than 10,000 pictures";
  }
  for (int axis = 0; dialog.sheet && axis < 2; ++axis) {
    if (dialog.cells[axis] * dialog.size[axis] > kLargestSheet) {
      return "The sheet would be more than 16,384 pixels " + std::string(axis == 0 ? "wide" : "high");
    }
  }
  return "";
}

/// A job on a copy of the rig in a folder of its own.
Result<PictureJob> jobOf(const EditorState& state) {
  auto folder = JobFolder::make();
  if (!folder) return folder.error();
  PictureJob job{folder.value(), state.session.program, nameWithoutEnding(state.document.file()) + ".rig.json",
                 pictureArguments(state)};
  job.arguments.insert(job.arguments.end(), {"--threads", std::to_string(std::max(1, threadCount() - 1))});
  const fs::path rig = job.folder->path() / job.input;
  if (const Result<void> saved = saveRig(rigAsIn(state.document, rig), rig); !saved) return saved.error();
  return job;
}

}  // namespace

void showPicturesDialog(EditorState& state) {
  PicturesDialogState& dialog = state.dialogs.pictures;
  dialog.shown = true;
  dialog.overwriteAsked = false;
  dialog.error.clear();
  if (dialog.of == state.document.file()) return;
  dialog.of = state.document.file();
  const fs::path folder = workFolder(dialog.of);
  const std::string stem = nameWithoutEnding(dialog.of);
  dialog.turntable = {folder, stem + "_turntable" + dialog.ending};
  dialog.sheetPlace = {folder, stem + "_sheet.png"};
}

void closePicturesDialog(Dialogs& dialogs) {
  dialogs.pictures.shown = dialogs.pictures.overwriteAsked = false;
  dialogs.pictures.error.clear();
}

ExportPlace& picturesPlace(PicturesDialogState& dialog) { return dialog.sheet ? dialog.sheetPlace : dialog.turntable; }

void browseForPicturesPlace(EditorState& state) {
  const ExportPlace& place = picturesPlace(state.dialogs.pictures);
  const fs::path file = resolveTyped(place.folder, place.name).lexically_normal();
  state.dialogs.pictures.overwriteAsked = false;
  showPathDialog(state, DialogKind::kPicturesPlace, file.parent_path(), file.filename().string());
}

void takePicturesPlace(PicturesDialogState& dialog, const fs::path& file) {
  ExportPlace& place = picturesPlace(dialog);
  place = {file.parent_path(), file.filename().string()};
  if (!dialog.sheet && isMovieName(file)) dialog.ending = lowerEnding(file);
  place.name = picturesFile(dialog).filename().string();
  dialog.error.clear();
}

void choosePicturesEnding(PicturesDialogState& dialog, const std::string& ending) {
  dialog.ending = ending;
  fs::path name = dialog.turntable.name;
  if (isMovieName(name)) dialog.turntable.name = name.replace_extension(ending).string();
  dialog.error.clear();
  dialog.overwriteAsked = false;
}

fs::path picturesFile(PicturesDialogState& dialog) {
  const ExportPlace& place = picturesPlace(dialog);
  if (place.name.empty()) return {};
  fs::path file = resolveTyped(place.folder, place.name).lexically_normal();
  const std::string wanted = dialog.sheet ? ".png" : dialog.ending;
  if (lowerEnding(file) != wanted) file += wanted;
  return file;
}

int pictureCount(const EditorState& state) {
  const PicturesDialogState& dialog = state.dialogs.pictures;
  if (dialog.sheet) return dialog.cells.x * dialog.cells.y;
  return moves(state) ? clipFrames(state) : dialog.turns;
}

double turntableSeconds(const EditorState& state) { return pictureCount(state) / state.dialogs.pictures.rate; }

std::vector<std::string> pictureArguments(const EditorState& state) {
  const PicturesDialogState& dialog = state.dialogs.pictures;
  std::vector<std::string> words;
  const AnimationClip* const clip = shownClip(state);
  if (clip != nullptr) words.insert(words.end(), {"--clip", clip->name});
  if (clip != nullptr && !moves(state)) words.insert(words.end(), {"--time", numberText(state.open.transport.time)});
  if (dialog.sheet) {
    words.insert(words.end(), {"--sheet", std::to_string(dialog.cells.x) + 'x' + std::to_string(dialog.cells.y)});
  } else {
    if (moves(state)) words.insert(words.end(), {"--frames", "0:" + std::to_string(clipFrames(state) - 1)});
    words.insert(words.end(),
                 {"--fps", numberText(dialog.rate), "--turntable", std::to_string(std::max(pictureCount(state), 2))});
  }
  words.insert(words.end(), {"--size", std::to_string(dialog.size.x) + 'x' + std::to_string(dialog.size.y)});
  addView(state, words);
  addLook(state, words);
  return words;
}

bool confirmPictures(EditorState& state) {
  PicturesDialogState& dialog = state.dialogs.pictures;
  const fs::path file = picturesFile(dialog);
  dialog.error = refusalOf(state, file);
  if (!dialog.error.empty()) return false;
  std::error_code ignored;
  if (!dialog.overwriteAsked && fs::exists(file, ignored)) {
    dialog.overwriteAsked = true;
    return false;
  }
  Result<PictureJob> job = jobOf(state);
  dialog.overwriteAsked = false;
  if (!job) dialog.error = job.error().plainText();
  if (!job) return false;
  ExportOrder order;
  order.file = file;
  order.pictures = std::move(job).value();
  state.session.exports.add(std::move(order));
  const bool first = state.session.exports.stands().size() == 1;
  const std::string name = file.filename().string();
  say(state, first ? "Drawing " + name + " in the background" : name + " is drawn next");
  closePicturesDialog(state.dialogs);
  return true;
}

namespace {

/// The folder of a line `XDG_PICTURES_DIR="$HOME/Bilder"`; "" for other lines.
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

std::string nowText() {
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
  showPathDialog(state, DialogKind::kSavePicture, folderForPictures(state),
                 nameWithoutEnding(state.document.name()) + ".png");
}

void savePictureNow(EditorState& state) {
  const std::string begin =
      (folderForPictures(state) / (nameWithoutEnding(state.document.name()) + '-' + nowText())).string();
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
