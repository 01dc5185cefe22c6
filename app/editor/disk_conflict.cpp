// app/editor/disk_conflict.cpp: the question before saving, its answers, and watching files.
#include "app/editor/disk_conflict.h"

#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "app/document/file_stamp.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "core/files/clip_files.h"

namespace sinew::app {
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

}  // namespace sinew::app
