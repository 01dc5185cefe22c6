// app/window/session_keeper.cpp: preferences, views and unsaved work on disk.
#include "app/window/session_keeper.h"

#include <system_error>
#include <utility>

#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/open_file.h"
#include "app/editor/session.h"
#include "app/editor/view_memory.h"

namespace sinew::app {
namespace {

constexpr double kSettleSeconds = 1.0;  ///< Unchanged for so long before it is written.
constexpr double kDiskSeconds = 1.0;    ///< Between checks of open files.

Preferences preferencesOf(const EditorState& state, const WindowPlace& window) {
  Preferences preferences = currentPreferences(state);
  if (window.width > 0) preferences.window = window;
  return preferences;
}

}  // namespace

SessionKeeper::SessionKeeper(std::filesystem::path preferencesFile, std::filesystem::path recoveryFolder,
                             std::filesystem::path viewsFolder)
    : preferencesFile_(std::move(preferencesFile)),
      recoveryFolder_(std::move(recoveryFolder)),
      viewsFolder_(std::move(viewsFolder)) {}

void SessionKeeper::start(EditorState& state) {
  const LoadedPreferences loaded = loadPreferences(preferencesFile_);
  state.session.preferences = loaded.preferences;
  state.view.layout = loaded.preferences.layout;
  state.session.viewsFolder = viewsFolder_;
  base_ = stored_ = seen_ = loaded.preferences;
  if (!loaded.complaint.empty())
    addMessage(state.session, MessageKind::kWarning, loaded.complaint, MessageAbout::kProgram);
  state.session.leftBehind = findLeftBehind(recoveryFolder_);
  state.dialogs.recovery = !state.session.leftBehind.empty();
  Result<RecoveryFile> claimed = RecoveryFile::claim(recoveryFolder_);
  if (claimed) {
    recovery_ = std::move(claimed).value();
  } else {
    addMessage(state.session, MessageKind::kWarning, "Autosave is off: " + claimed.error().plainText(),
               MessageAbout::kProgram);
  }
}

void SessionKeeper::tick(EditorState& state, double now, const WindowPlace& window) {
  keepRecent(state);
  keepWork(state, now);
  keepView(state, now);
  if (now - diskSeenAt_ >= kDiskSeconds) {
    diskSeenAt_ = now;
    watchDisk(state);
    watchReadFiles(state);
  }
  keepPreferences(state, now, window);
}

std::optional<double> SessionKeeper::secondsLeft(const EditorState& state, double now) const {
  return clock_.secondsLeft(now, state.session.preferences.autosaveSeconds);
}

void SessionKeeper::finish(EditorState& state, const WindowPlace& window) {
  if (recovery_) recovery_->finish();
  rememberView(state);
  const Preferences last = preferencesOf(state, window);
  if (last != stored_) writePreferences(state, last);
}

/// Puts this document in front, and merges files that other editors have opened.
void SessionKeeper::keepRecent(EditorState& state) {
  const std::pair now(state.session.documentsOpened, state.document.file());
  if (now == remembered_ || now.second.empty()) return;
  remembered_ = now;
  rememberDocument(state);
  Preferences& mine = state.session.preferences;
  std::error_code failed;
  if (!std::filesystem::exists(preferencesFile_, failed)) return;
  mine.recentFiles = mergedPreferences(base_, mine, loadPreferences(preferencesFile_).preferences).recentFiles;
}

void SessionKeeper::keepWork(EditorState& state, double now) {
  if (!recovery_) return;
  if (state.session.recovered && writeWork(state)) {
    discardLeftBehind(*state.session.recovered);
    state.session.recovered.reset();
  }
  if (std::exchange(state.session.saveFailed, false)) clock_.hurry();
  switch (clock_.look(now, state.session.preferences.autosaveSeconds, state.document.commands,
                      state.session.documentsOpened, state.open.transport.clip)) {
    case AutosaveClock::Deed::kNothing:
      break;
    case AutosaveClock::Deed::kWrite:
      writeWork(state);
      break;
    case AutosaveClock::Deed::kRemove:
      recovery_->remove();
      break;
  }
}

bool SessionKeeper::writeWork(EditorState& state) {
  const Result<void> written = recovery_->write(state.document);
  if (written) clock_.wrote(state.document.commands.revision());
  else
    addMessage(state.session, MessageKind::kWarning, "Autosave failed: " + written.error().plainText(),
               MessageAbout::kProgram);
  return written.ok();
}

/// Looks once in kSettleSeconds and keeps a changed view once it rests.
void SessionKeeper::keepView(const EditorState& state, double now) {
  if (viewsFolder_.empty() || !state.hasCharacter() || (viewSeenAt_ && now - *viewSeenAt_ < kSettleSeconds)) return;
  viewSeenAt_ = now;
  const std::string view =
      state.document.name() + std::to_string(state.session.documentsOpened) + viewToJson(state, false).dump();
  if (std::exchange(viewSeen_, view) != view || view == viewStored_) return;
  viewStored_ = view;
  rememberView(state);
}

void SessionKeeper::keepPreferences(EditorState& state, double now, const WindowPlace& window) {
  Preferences current = preferencesOf(state, window);
  if (current == stored_) return;
  if (current != seen_) {
    seen_ = std::move(current);
    seenAt_ = now;
  } else if (now - seenAt_ >= kSettleSeconds) {
    writePreferences(state, current);
  }
}

/// Keeps changes of other windows. A failure is reported once; the next change tries again.
void SessionKeeper::writePreferences(EditorState& state, const Preferences& preferences) {
  stored_ = preferences;
  const Result<void> saved = saveMergedPreferences(base_, preferences, preferencesFile_);
  if (saved) {
    base_ = preferences;
  } else {
    addMessage(state.session, MessageKind::kWarning, "Preferences not saved: " + saved.error().plainText(),
               MessageAbout::kProgram);
  }
}

}  // namespace sinew::app
