// app/editor/open_file.cpp: a file becomes the open document, or a message says why not.
#include "app/editor/open_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/document/command_stack.h"
#include "app/document/document.h"
#include "app/document/file_stamp.h"
#include "app/document/folder_listing.h"
#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/clip_commands.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/pose_commands.h"
#include "app/editor/session.h"
#include "app/editor/view_memory.h"
#include "core/bodies/retarget.h"
#include "core/character/bindings.h"
#include "core/character/clip_names.h"
#include "core/files/clip_files.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/attachment.h"
#include "core/rig/motion_clip.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// The question before saving, its answers, and watching files.

namespace {

namespace fs = std::filesystem;

Intent closeQuestion(EditorState& state) { return std::exchange(state.dialogs.conflict, {}).then; }

void saveThen(EditorState& state, const fs::path& file, const Intent& then) {
  if (saveTo(state, file).empty()) perform(state, then);
}

/// Looks at a file that was read, and at the buffers of a .gltf.
/// @param name  of the file in ClipListState::looks  @param seen  in, out: the last look
/// @return nullopt: unchanged since the last look
std::optional<OnDisk> lookAgain(EditorState& state, const fs::path& file, const std::string& name,
                                const std::optional<FileStamp>& known, DiskLook& seen) {
  std::map<std::string, DiskLook>& looks = state.open.clipList.looks;
  const std::string first = name + '\n';
  const DiskLook before = seen;
  seen = lookAt(file);
  bool isNew = seen != before;
  if (isNew) {
    // Its buffers may differ now.
    std::erase_if(looks, [&](const auto& look) { return look.first.starts_with(first); });
    for (const fs::path& buffer : bufferFilesOf(file)) looks[first + buffer.string()] = lookAt(buffer);
  }
  for (auto look = looks.lower_bound(first); look != looks.end() && look->first.starts_with(first); ++look) {
    const DiskLook now = lookAt(look->first.substr(first.size()));
    isNew = isNew || now != look->second;
    look->second = now;
  }
  if (!isNew) return std::nullopt;
  return compareWithDisk(file, known);
}

void warn(EditorState& state, const fs::path& file, const std::string& what) {
  addMessage(state.session, MessageKind::kWarning, file.filename().string() + what);
}

void watchCharacter(EditorState& state) {
  const Document& document = state.document;
  if (!document.characterOnDisk) return;
  const auto found = lookAgain(state, document.characterFile, "", document.characterOnDisk, state.open.characterLook);
  if (found == OnDisk::kChanged) {
    warn(state, document.characterFile,
         " was changed on disk by another program. File > Reopen loads the new version.");
  } else if (found == OnDisk::kGone) {
    warn(state, document.characterFile, " is no longer on disk. It stays open, but cannot be exported.");
  }
}

void watchClips(EditorState& state, const ClipFileReport& file, const std::optional<FileStamp>& known) {
  ClipListState& list = state.open.clipList;
  const auto found = lookAgain(state, file.path, file.file, known, list.looks[file.file]);
  if (!found) return;
  if (*found != OnDisk::kChanged) list.changed.erase(file.file);
  if (*found == OnDisk::kGone) {
    warn(state, file.path, " is no longer on disk. Its clips play until the rig is opened again.");
  } else if (*found == OnDisk::kChanged && list.changed.insert(file.file).second) {
    warn(state, file.path,
         (known ? " was changed" : " was written") +
             std::string(" on disk by another program. Play > Read clip files again loads its clips."));
  }
}

}  // namespace

bool asksBeforeSaving(EditorState& state, const Intent& then) {
  const OnDisk found = compareWithDisk(state.document.rigFile, state.document.rigOnDisk);
  if (found == OnDisk::kSame) return false;
  state.dialogs.conflict = {found, then};
  return true;
}

void saveBeside(EditorState& state) {
  const Intent then = closeQuestion(state);
  saveThen(state, freeNameBeside(state.document.rigFile), then);
}

void discardForDisk(EditorState& state) {
  const Intent then = closeQuestion(state);
  perform(state, then.kind == IntentKind::kNone ? Intent{IntentKind::kReopen, {}} : then);
}

void saveOverDisk(EditorState& state) {
  const Intent then = closeQuestion(state);
  saveThen(state, state.document.rigFile, then);
}

void leaveUnsaved(EditorState& state) { closeQuestion(state); }

void watchDisk(EditorState& state) {
  const Document& document = state.document;
  if (!state.hasCharacter() || document.rigFile.empty()) return;
  const DiskLook look = lookAt(document.rigFile);
  if (look == state.open.disk) return;
  state.open.disk = look;
  const OnDisk found = compareWithDisk(document.rigFile, document.rigOnDisk);
  if (found == OnDisk::kSame) return;
  if (found == OnDisk::kGone) {
    warn(state, document.rigFile, " is no longer on disk. Saving asks what to do.");
  } else {
    warn(state, document.rigFile,
         std::string(" was changed on disk by another program. ") + (document.commands.modified()
                                                                         ? "Saving asks which version to keep."
                                                                         : "File > Reopen loads the new version."));
  }
}

void watchReadFiles(EditorState& state) {
  if (!state.hasCharacter()) return;
  watchCharacter(state);
  const Document::ClipFiles& clips = state.document.clipFiles;
  for (std::size_t i = 0; i < clips.files.size(); ++i) watchClips(state, clips.files[i], clips.onDisk[i]);
}

namespace {

/// "line 12, column 3" of "byte 61 (line 12, column 3)"; "" for other places.
std::string lineOf(const std::string& place) {
  const std::size_t from = place.find("(line ");
  if (!place.starts_with("byte ") || from == std::string::npos || !place.ends_with(')')) return "";
  return place.substr(from + 1, place.size() - from - 2);
}

/// A message of the parser (core/files/json/json.cpp) in plain words.
struct Meaning {
  std::string_view said;
  const char* meant;
};

constexpr std::array kMeanings{
    Meaning{"unexpected end of input", "the file ends too early"},
    Meaning{"missing closing quote", "a text has no closing quote"},
    Meaning{"UTF-8", "this is no text (not UTF-8)"},
    Meaning{"invalid number", "this is no number"},
    Meaning{"control character", "a line break or control character inside a text"},
    Meaning{"expected end of input", "the file goes on after its end"},
    Meaning{"'}'; expected", "a \"}\" where something else should be, perhaps after a comma too many"},
    Meaning{"']'; expected", "a \"]\" where something else should be, perhaps after a comma too many"},
    Meaning{"; expected '}'", "a comma or a closing bracket is missing before this"},
    Meaning{"; expected ']'", "a comma or a closing bracket is missing before this"},
    Meaning{"expected ':'", "a colon is missing before this"},
};

std::string meaningOf(const std::string& reason) {
  for (const Meaning& meaning : kMeanings) {
    if (reason.find(meaning.said) != std::string::npos) return meaning.meant;
  }
  return "this cannot be read";
}

/// Error::plainText(); for JSON: "limb.rig.json is damaged or not a rig: line 12, column 3: the file ends too early".
std::string openErrorText(const Error& error) {
  const std::string line = lineOf(error.place);
  if (line.empty()) return error.plainText();
  const std::string name = std::filesystem::path(error.file).filename().string();
  const bool rig = name.ends_with(".json");
  return (name.empty() ? "The file" : name) + " is damaged or not a " + (rig ? "rig" : "character") + ": " + line +
         ": " + meaningOf(error.reason);
}

bool isCharacter(const std::filesystem::path& file) { return isCharacterName(lowerCase(file.filename().string())); }

/// A summary in a toast; messages name each muscle.
void reportRetargeted(EditorState& state, const Retargeted& done) {
  for (const auto& [name, why] : done.leftOut)
    addQuietly(state.session, MessageKind::kWarning, name + " is left out: " + why);
  for (const std::string& line : done.mended) addQuietly(state.session, MessageKind::kNote, "Mended " + line);
  std::string text = withCount(allLeads(done.rig).size(), "muscle") + " kept";
  if (!done.leftOut.empty()) text += ", " + std::to_string(done.leftOut.size()) + " left out";
  if (!done.mended.empty()) text += ", " + std::to_string(done.mended.size()) + " mended";
  say(state, text + (done.leftOut.empty() && done.mended.empty() ? "" : ": see the messages"));
}

}  // namespace

void dropFile(EditorState& state, const std::filesystem::path& file) {
  if (!isCharacter(file) || !state.hasCharacter()) return request(state, {IntentKind::kOpenFile, file});
  const DroppedClips clips = lookForClips(state.document, file);
  if (clips.nothingElse) {
    addClips(state, file);
  } else if (!state.document.rig().primitives.empty()) {
    state.dialogs.keepMuscles = file;
    state.dialogs.droppedHasClips = clips.any;
  } else {
    request(state, {IntentKind::kOpenFile, file});
  }
}

void showRetargetDialog(EditorState& state) {
  showOpenDialog(state);
  state.dialogs.file.then = {IntentKind::kOpenWithMuscles, {}};
  state.dialogs.file.filter = FileFilter::kCharacters;
}

void openWithMuscles(EditorState& state, const std::filesystem::path& file) {
  Result<Document> opened = openDocument(file);
  if (!opened) return addMessage(state.session, MessageKind::kError, openErrorText(opened.error()));
  const Document& from = state.document;
  Result<Retargeted> done =
      retarget(from.rig(), *from.character, *from.mirror, Motions(opened->character), *opened->mirror);
  if (!done) {
    const Error error{file.string(), "", done.error().reason, "cannot take the muscles"};
    return addMessage(state.session, MessageKind::kError, error.plainText());
  }
  Rig rig = done->rig;
  rig.character = opened->rig().character;
  Document document = std::move(opened).value();
  document.commands.apply("Muscles of " + from.name(), std::move(rig));
  if (showDocument(state, std::move(document))) reportRetargeted(state, done.value());
}

namespace {

void show(EditorState& state, Document document, LiveSurface live, const Transport& transport) {
  cancelDrags(state.view.tools, state.document);
  rememberView(state);
  state.document = std::move(document);
  state.live = std::move(live);
  state.open = {};
  state.open.transport = transport;
  state.document.commands.startFrom(transport.overrides, keptRanges(transport.ranges, state.character()));
  state.open.frameWanted = true;
  state.open.helperBones = helperBones(state.character());
  state.frame.route = {};
  state.view.tools.hover = {};
  state.view.tools.territoryMode = false;
  ++state.session.documentsOpened;
  forgetDocumentMessages(state.session);
  setScene(state.view.tools.camera, boundsOf(state.live->surface().positions), state.character().height);
}

/// Reports a mesh without blended skin weights, which looks like one with them.
void reportRigid(EditorState& state) {
  const ControlMesh& mesh = state.character().mesh;
  const std::size_t vertices = mesh.positions.size();
  const auto isWhole = [](const Influence& influence) { return !(influence.weight < 1.0f); };
  if (mesh.influences.size() > vertices || !std::ranges::all_of(mesh.influences, isWhole)) return;
  const std::vector<bool> carrying = bonesWithSkin(state.character());
  const auto carries = std::ranges::find(carrying, true);
  const bool one = std::ranges::count(carrying, true) == 1;
  const std::string name = state.document.characterFile.filename().string();
  const std::string what =
      one ? " has no skin weights: all of it follows the bone " +
                shownBoneName(state.character().skeleton, static_cast<int>(carries - carrying.begin())) +
                " and nothing bends"
          : " has no blended skin weights: its parts follow their bones rigidly and nothing bends";
  addMessage(state.session, MessageKind::kNote, name + what);
}

void reportIgnored(EditorState& state) {
  const std::string name = state.document.characterFile.filename().string();
  for (const std::string& ignored : state.character().ignored) {
    addMessage(state.session, MessageKind::kNote, name + ": " + ignored);
  }
  const std::vector<ClipFileReport>& files = state.document.clipFiles.files;
  const std::vector<Error> gone = missingOf(files);
  for (const Error& missing : gone) {
    addMessage(state.session, MessageKind::kWarning, "Its clips are left out: " + missing.plainText());
  }
  if (!gone.empty()) showClipList(state);
  for (const std::string& note : notesOf(files)) {  // The list of clip files has them too.
    addQuietly(state.session, MessageKind::kNote, note);
  }
  for (const Error& missing : missingBones(state.document.rig(), state.character().skeleton)) {
    addMessage(state.session, MessageKind::kNote, missing.plainText() + "; it is kept, but has no effect");
  }
}

}  // namespace

bool openFile(EditorState& state, const std::filesystem::path& file) {
  Result<Document> opened = openDocument(file);
  if (!opened) {
    if (const auto missing = missingCharacter(file)) state.dialogs.locate = {file, *missing};
    else addMessage(state.session, MessageKind::kError, openErrorText(opened.error()));
    return false;
  }
  return showDocument(state, std::move(opened).value());
}

bool showDocument(EditorState& state, Document document) {
  Transport transport;
  transport.clip = firstClip(document.character->clips);
  transport.playing = clipDuration(transport, *document.character) > 0.0;
  const std::optional<Json> view = rememberedView(state.session, document);
  if (view) {
    document.character = withClipNamed(document.character, view->at("clip").at("name").text(""));
    transport = transportOf(*view, *document.character, transport);
  }
  Result<LiveSurface> live = LiveSurface::create(document, transport);
  if (!live) {
    Error error = live.error();
    error.file = document.file().string();
    addMessage(state.session, MessageKind::kError, error.plainText());
    return false;
  }
  show(state, std::move(document), std::move(live).value(), transport);
  if (view) restoreView(state, *view);
  reportRigid(state);
  reportIgnored(state);
  return true;
}

void reopen(EditorState& state) {
  const std::filesystem::path file = state.document.file();
  const std::shared_ptr<const Character> before = state.document.character;
  const Transport transport = state.open.transport;
  const Camera camera = state.view.tools.camera;
  const std::vector<NamedTurn> turns = namedTurns(transport.overrides, state.character().skeleton);
  if (!openFile(state, file)) return;
  state.view.tools.camera = camera;
  state.open.frameWanted = false;
  if (const auto same = carriedOver(transport, *before, state.character())) state.open.transport = *same;
  // By name, because the character may have changed on disk.
  state.open.transport.overrides = turnsOf(turns, transport.overrides.from, state.character().skeleton).overrides;
  state.document.commands.startFrom(state.open.transport.overrides,
                                    keptRanges(state.open.transport.ranges, state.character()));
}

void showLocateDialog(EditorState& state) {
  const LocateState asked = std::exchange(state.dialogs.locate, {});
  FileDialogState dialog;
  std::error_code ignored;
  dialog.kind = DialogKind::kOpen;
  dialog.locateFor = std::filesystem::absolute(asked.rigFile, ignored);
  dialog.folder = dialog.locateFor.parent_path();
  dialog.filter = FileFilter::kCharacters;
  dialog.appearing = true;
  const std::filesystem::path name = asked.characterFile.filename();
  if (std::filesystem::is_regular_file(dialog.folder / name, ignored)) dialog.text = name.string();
  state.dialogs.file = std::move(dialog);
}

std::string openWithCharacter(EditorState& state, const std::filesystem::path& rigFile,
                              const std::filesystem::path& characterFile) {
  Result<Document> opened = openRigWith(rigFile, characterFile);
  if (!opened) return opened.error().text();
  return showDocument(state, std::move(opened).value()) ? "" : state.session.messages.back().text;
}

}  // namespace sinew::app
