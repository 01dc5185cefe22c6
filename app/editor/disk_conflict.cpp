// app/editor/disk_conflict.cpp: asking, the answers, and noticing early.

#include "app/editor/disk_conflict.h"

#include <system_error>
#include <utility>

#include "app/document/file_stamp.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

Intent closeQuestion(EditorState& state) { return std::exchange(state.dialogs.conflict, {}).then; }

void saveThen(EditorState& state, const fs::path& file, const Intent& then) {
  if (saveTo(state, file).empty()) perform(state, then);
}

/// What the system can say without reading the file.
DiskLook lookAt(const fs::path& file) {
  std::error_code failed;
  DiskLook look{true, fs::last_write_time(file, failed), 0};
  if (failed) return {true, {}, 0};
  look.bytes = fs::file_size(file, failed);
  return look;
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

}  // namespace sinew::app
