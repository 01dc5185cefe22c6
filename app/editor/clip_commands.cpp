// app/editor/clip_commands.cpp: clips of other files.

#include "app/editor/clip_commands.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

#include "app/document/command_stack.h"
#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/muscle_set_commands.h"
#include "core/bodies/transfer_clips.h"
#include "core/character/clip_names.h"
#include "core/geometry/at.h"
#include "core/rig/animated_edit.h"
#include "sinew/files/gltf_import.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

std::string shortName(const std::string& file) { return fs::path(file).filename().string(); }

/// Index of the file in Rig::clipFiles, or -1.
int entryOf(const Document& document, const fs::path& file) {
  const std::vector<std::string>& names = document.rig().clipFiles;
  const auto isIt = [&](const std::string& name) {
    std::error_code failed;
    return fs::equivalent(document.clipFiles.folder / fs::path(name), file, failed) && !failed;
  };
  const auto found = std::ranges::find_if(names, isIt);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// Names of a file's clips. @param file  as in the rig
std::vector<std::string> clipsOf(const Character& character, const std::string& file) {
  std::vector<std::string> names;
  for (const AnimationClip& clip : character.clips) {
    if (clip.addedFrom == file) names.push_back(clip.name);
  }
  return names;
}

/// carriedOver(), else the first clip.
Transport carriedOrFirst(const Transport& transport, const Character& before, const Character& after) {
  if (const auto same = carriedOver(transport, before, after)) return *same;
  Transport other = transport;
  other.ranges = rangesOf(keptRanges(transport.ranges, before), after);
  chooseClip(other, firstClip(after.clips), after);
  return other;
}

/// Reports files that have become unreadable.
void reportGone(EditorState& state, const std::vector<ClipFileReport>& before) {
  for (const ClipFileReport& file : state.document.clipFiles.files) {
    const auto was = std::ranges::find(before, file.file, &ClipFileReport::file);
    if (!file.missing || (was != before.end() && was->missing)) continue;
    addMessage(state.session, MessageKind::kWarning, "Its clips are left out: " + file.missing->plainText());
    showClipList(state);
  }
}

/// Reads the rig's clip files. If the surface cannot be made, the character stays unchanged.
void readClipFiles(EditorState& state) {
  Document& document = state.document;
  const std::shared_ptr<const Character> before = document.character;
  const std::vector<ClipFileReport> files = document.clipFiles.files;
  loadClipFiles(document);
  state.open.clipList.changed.clear();
  // Keeps those of the character's buffers, which have no name in front.
  std::erase_if(state.open.clipList.looks, [](const auto& look) { return !look.first.starts_with('\n'); });
  reportGone(state, files);
  if (document.character == before) return;
  const Transport transport = carriedOrFirst(state.open.transport, *before, *document.character);
  Result<LiveSurface> live = LiveSurface::create(document, transport);
  if (!live) {
    document.character = before;
    return addMessage(state.session, MessageKind::kError, live.error().plainText());
  }
  state.live = std::move(live).value();
  state.open.transport = transport;
  ++state.session.documentsOpened;
  // Results that depend on clips.
  state.open.timeline = {};
  state.open.lineRange = {};
  state.open.muscleSet.motions.reset();
}

/// Error: the file would add no clips.
Result<void> checkAdds(const Document& document, const std::string& name) {
  Rig alone = document.rig();
  alone.clipFiles = {name};
  const WithClipFiles with = withClipFiles(document.character, alone, document.clipFiles.folder);
  const ClipFileReport& report = with.files.front();
  if (report.missing) return *report.missing;
  if (!clipsOf(*with.character, name).empty()) return {};
  const std::string why = report.notes.empty() ? std::string("it has no clips") : report.notes.back();
  return Error{report.path.string(), "", why, "no clips are added"};
}

std::string refused(EditorState& state, const Error& error) {
  addMessage(state.session, MessageKind::kError, error.plainText());
  return error.plainText();
}

void playFirstOf(EditorState& state, const std::string& name) {
  const int clip = indexOf(state.character(), {name, 0});
  if (clip < 0) return;
  chooseClip(state.open.transport, clip, state.character());
  state.open.transport.playing = clipDuration(state.open.transport, state.character()) > 0.0;
}

/// @param done  "Added"
void reportClips(EditorState& state, const std::string& done, const std::string& name) {
  const std::size_t count = clipsOf(state.character(), name).size();
  const auto report = std::ranges::find(state.document.clipFiles.files, name, &ClipFileReport::file);
  const bool differs = report != state.document.clipFiles.files.end() && !report->notes.empty();
  say(state, done + ' ' + withCount(count, "clip") + " of " + shortName(name) + (differs ? ": see the list" : ""));
  if (differs) showClipList(state);
}

constexpr const char* kBusy = "Finish the current edit first";

/// One undo step that adds the file. @param rig  with the file
std::string nameInRig(EditorState& state, const std::string& label, Rig rig, const std::string& name,
                      const std::string& done) {
  if (const Result<void> brings = checkAdds(state.document, name); !brings) return refused(state, brings.error());
  if (!edit(state, label, std::move(rig))) return state.open.refusal;
  followClipFiles(state);
  playFirstOf(state, name);
  reportClips(state, done, name);
  return "";
}

/// Names of added clips if the file were last, as when it is added again.
std::map<std::string, std::string> namesWithLast(const Document& document, int file) {
  Rig rig = document.rig();
  std::rotate(rig.clipFiles.begin() + file, rig.clipFiles.begin() + file + 1, rig.clipFiles.end());
  const WithClipFiles last = withClipFiles(document.character, rig, document.clipFiles.folder);
  const std::vector<ClipId> ids = clipIds(*document.character);
  std::map<std::string, std::string> names;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const int then = ids[i].file.empty() ? -1 : indexOf(*last.character, ids[i]);
    if (then >= 0) names[document.character->clips[i].name] = at(last.character->clips, then).name;
  }
  return names;
}

}  // namespace

std::string addClips(EditorState& state, const fs::path& file) {
  if (!state.hasCharacter()) return "";
  if (isBusy(state)) {
    sayRefusal(state, kBusy);
    return kBusy;
  }
  if (const int known = entryOf(state.document, file); known >= 0) {
    const std::string name = at(state.document.rig().clipFiles, known);
    readClipFiles(state);
    if (const auto& gone = at(state.document.clipFiles.files, known).missing) return gone->plainText();
    reportClips(state, "Read again:", name);
    return "";
  }
  const std::string name = clipFileName(state.document, file);
  Rig rig = state.document.rig();
  rig.clipFiles.push_back(name);
  return nameInRig(state, "Add clips of " + shortName(name), std::move(rig), name, "Added");
}

void readClipFilesAgain(EditorState& state) {
  readClipFiles(state);
  say(state, "Read again: " + withCount(state.document.clipFiles.files.size(), "clip file"));
}

void removeClipFile(EditorState& state, int file) {
  const std::string name = at(state.document.rig().clipFiles, file);
  const std::vector<std::string> gone = clipsOf(state.character(), name);
  std::size_t keyed = 0;
  for (const std::string& clip : gone) keyed += countKeyTracks(state.document.rig(), clip);
  Rig rig = withClipsRenamed(state.document.rig(), namesWithLast(state.document, file));
  rig.clipFiles.erase(rig.clipFiles.begin() + file);
  if (!edit(state, "Remove clips of " + shortName(name), std::move(rig))) return;
  followClipFiles(state);
  const std::string kept =
      keyed == 0 ? "" : "; keys of " + withCount(keyed, "number") + " are kept for when it is added again";
  say(state, "Removed " + shortName(name) + (gone.empty() ? "" : ": " + withCount(gone.size(), "clip")) + kept);
}

std::string locateClipFile(EditorState& state, const std::string& name, const fs::path& file) {
  Rig rig = state.document.rig();
  const auto entry = std::ranges::find(rig.clipFiles, name);
  if (entry == rig.clipFiles.end()) return "";
  if (entryOf(state.document, file) >= 0) {
    return refused(state, {file.string(), "", "its clips are added already", "cannot take the place of " + name});
  }
  *entry = clipFileName(state.document, file);
  const std::string now = *entry;
  return nameInRig(state, "Locate " + shortName(name), std::move(rig), now, "Found");
}

void showClipsDialog(EditorState& state) {
  showOpenDialog(state);
  state.dialogs.file.then = {IntentKind::kAddClips, {}};
  state.dialogs.file.filter = FileFilter::kCharacters;
}

void showLocateClipsDialog(EditorState& state, int file) {
  showClipsDialog(state);
  FileDialogState& dialog = state.dialogs.file;
  dialog.clipsFor = at(state.document.rig().clipFiles, file);
  std::error_code ignored;
  if (fs::is_regular_file(dialog.folder / shortName(dialog.clipsFor), ignored)) {
    dialog.text = shortName(dialog.clipsFor);
  }
}

void showClipList(EditorState& state) {
  closePanels(state);
  state.open.clipList.shown = true;
}

void toggleClipList(EditorState& state) {
  if (state.open.clipList.shown) state.open.clipList.shown = false;
  else showClipList(state);
}

void followClipFiles(EditorState& state) {
  if (state.hasCharacter() && !clipFilesAreCurrent(state.document)) readClipFiles(state);
}

std::optional<Transport> carriedOver(const Transport& transport, const Character& before, const Character& after) {
  Transport same = transport;
  same.ranges = rangesOf(keptRanges(transport.ranges, before), after);
  if (transport.clip < 0) return same;
  const std::vector<ClipId> ids = clipIds(before);
  same.clip = indexOf(after, at(ids, transport.clip));
  if (same.clip < 0) return std::nullopt;
  same.time = std::min(transport.time, clipDuration(same, after));
  return same;
}

DroppedClips lookForClips(const Document& document, const fs::path& file) {
  std::error_code failed;
  if (fs::equivalent(file, document.characterFile, failed) && !failed) return {};
  const auto clips = importClips(file);
  if (!clips) return {};
  const Character& character = *document.character;
  const bool sameBones = haveSameBones(clips.value()->skeleton, character.skeleton, character.height);
  return {true, clips.value()->mesh.triangles.empty() || sameBones};
}

}  // namespace sinew::app
