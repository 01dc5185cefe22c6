// app/window/session_keeper.h: writes preferences and unsaved work to the disk while the editor runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "app/document/preferences.h"
#include "app/document/recovery.h"
#include "app/editor/editor_state.h"

namespace sinew::app {

/// Lives from start to clean exit. After a crash the recovery file stays for the next start.
class SessionKeeper {
 public:
  /// @param viewsFolder  "": views of files are not kept
  SessionKeeper(std::filesystem::path preferencesFile, std::filesystem::path recoveryFolder,
                std::filesystem::path viewsFolder = {});

  void start(EditorState& state);  ///< Loads preferences and layout; offers work left by a crash. Failures: messages.
  /// Call every frame and at least once a second. @param now  seconds, monotonic
  void tick(EditorState& state, double now, const WindowPlace& window);
  /// Seconds until tick() has work; nullopt: not before a change.
  [[nodiscard]] std::optional<double> secondsLeft(const EditorState& state, double now) const;
  void finish(EditorState& state, const WindowPlace& window);  ///< Clean exit.

 private:
  void keepRecent(EditorState& state);
  void keepWork(EditorState& state, double now);
  void keepView(const EditorState& state, double now);
  void keepPreferences(EditorState& state, double now, const WindowPlace& window);
  void writePreferences(EditorState& state, const Preferences& preferences);
  bool writeWork(EditorState& state);

  std::filesystem::path preferencesFile_;
  std::filesystem::path recoveryFolder_;
  std::filesystem::path viewsFolder_;
  std::optional<RecoveryFile> recovery_;
  AutosaveClock clock_;
  Preferences base_;    ///< This window's when last read or written.
  Preferences stored_;  ///< The same, or those that could not be written.
  Preferences seen_;    ///< At the last look.
  double seenAt_ = 0.0;
  std::string viewStored_;  ///< As last kept, with its document.
  std::string viewSeen_;    ///< At the last look.
  std::optional<double> viewSeenAt_;
  double diskSeenAt_ = -1e9;
  std::pair<std::size_t, std::filesystem::path> remembered_;  ///< Opened document and its file.
};

}  // namespace sinew::app
