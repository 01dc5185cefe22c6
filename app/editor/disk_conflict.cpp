// app/editor/disk_conflict.cpp: asking, the answers, and noticing early.

#include "app/editor/disk_conflict.h"

#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "app/document/file_stamp.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "core/base/lower_case.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

Intent closeQuestion(EditorState& state) { return std::exchange(state.dialogs.conflict, {}).then; }

void saveThen(EditorState& state, const fs::path& file, const Intent& then) {
  if (saveTo(state, file).empty()) perform(state, then);
}

/// @param seen  the last look, which becomes the present one
/// @return nullopt: nothing has happened since that look
std::optional<OnDisk> lookAgain(const fs::path& file, const std::optional<FileStamp>& known, DiskLook& seen) {
  const DiskLook before = seen;
  seen = lookAt(file);
  if (seen == before) return std::nullopt;
  const OnDisk found = compareWithDisk(file, known);
  const bool datedAnew = before.looked && lowerCase(file.extension().string()) == ".gltf";
  return found == OnDisk::kSame && datedAnew && known ? OnDisk::kChanged : found;
}

void warn(EditorState& state, const fs::path& file, const std::string& what) {
  addMessage(state.session, MessageKind::kWarning, file.filename().string() + what);
}

void watchCharacter(EditorState& state) {
  const Document& document = state.document;
  if (!document.characterOnDisk) return;
  const auto found = lookAgain(document.characterFile, document.characterOnDisk, state.open.characterLook);
  if (found == OnDisk::kChanged) {
    warn(state, document.characterFile,
         " was changed on disk by another program. File > Reopen loads the new version.");
  } else if (found == OnDisk::kGone) {
    warn(state, document.characterFile, " is no longer on disk. It stays open, but cannot be exported.");
  }
}

void watchClips(EditorState& state, const ClipFileReport& file, const std::optional<FileStamp>& known) {
  ClipListState& list = state.open.clipList;
  const auto found = lookAgain(file.path, known, list.looks[file.file]);
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
  const std::string name = document.rigFile.filename().string();
  if (found == OnDisk::kGone) {
    addMessage(state.session, MessageKind::kWarning, name + " is no longer on disk. Saving asks what to do.");
  } else if (document.commands.modified()) {
    addMessage(state.session, MessageKind::kWarning,
               name + " was changed on disk by another program. Saving asks which version to keep.");
  } else {
    addMessage(state.session, MessageKind::kWarning,
               name + " was changed on disk by another program. File > Reopen loads the new version.");
  }
}

void watchReadFiles(EditorState& state) {
  if (!state.hasCharacter()) return;
  watchCharacter(state);
  const Document::ClipFiles& clips = state.document.clipFiles;
  for (std::size_t i = 0; i < clips.files.size(); ++i) watchClips(state, clips.files[i], clips.onDisk[i]);
}

}  // namespace sinew::app
