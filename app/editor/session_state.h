// app/editor/session_state.h: what lasts from the program's start to its end.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/document/preferences.h"
#include "app/document/recovery.h"
#include "app/editor/frame_stats.h"

namespace sinew::app {

enum class MessageKind { kNote, kWarning, kError };

/// Stays until dismissed.
struct Message {
  MessageKind kind = MessageKind::kNote;
  std::string text;
  int count = 1;  ///< Times it was said.
};

struct SessionState {
  std::filesystem::path viewsFolder;  ///< Where views of files are kept (view_files.h); "": they are not.
  Preferences preferences;            ///< Without layout and window, which stand in ViewState and in the window.
  std::vector<Message> messages;
  bool messagesShown = false;           ///< Unfolded: by a new message, until they are folded.
  std::vector<LeftBehind> leftBehind;   ///< By a crash: offered until answered.
  std::optional<LeftBehind> recovered;  ///< Open now: thrown away once this process has its own copy.
  std::size_t documentsOpened = 0;      ///< Grows whenever document or character is replaced.
  FrameStats stats;
  bool quit = false;
};

}  // namespace sinew::app
