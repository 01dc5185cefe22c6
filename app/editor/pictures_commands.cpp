// app/editor/pictures_commands.cpp: what is seen, as words of the command line.
#include "app/editor/pictures_commands.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>
#include <utility>

#include "app/document/folder_listing.h"
#include "app/document/rig_list.h"
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

const fs::path& pictureFileOf(const Document& document) {
  return document.rigFile.empty() ? document.characterFile : document.rigFile;
}

/// The shortest text that is this number again.
std::string numberText(double number) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), written.ptr};
}

const AnimationClip* shownClip(const EditorState& state) {
  const int clip = state.open.transport.clip;
  return clip < 0 ? nullptr : &at(state.character().clips, clip);
}

/// The clip moves: in a turntable or over a sheet.
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

/// The rig as it is on the screen, in a folder of its own.
Result<PictureJob> jobOf(const EditorState& state) {
  auto folder = JobFolder::make();
  if (!folder) return folder.error();
  PictureJob job{folder.value(), state.session.program, nameWithoutEnding(pictureFileOf(state.document)) + ".rig.json",
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
  if (dialog.of == pictureFileOf(state.document)) return;
  dialog.of = pictureFileOf(state.document);
  std::error_code ignored;
  // The program's own folder is no place to work in.
  const fs::path folder =
      isSample(dialog.of) ? homeFolder() : fs::absolute(dialog.of, ignored).lexically_normal().parent_path();
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
  state.dialogs.file = {};
  state.dialogs.file.kind = DialogKind::kPicturesPlace;
  state.dialogs.file.folder = file.parent_path();
  state.dialogs.file.text = file.filename().string();
  state.dialogs.file.appearing = true;
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

}  // namespace sinew::app
