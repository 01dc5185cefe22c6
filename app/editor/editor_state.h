// app/editor/editor_state.h: all that the editor remembers between frames, as plain data.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/document/document.h"
#include "app/document/preferences.h"
#include "app/document/recovery.h"
#include "app/editor/folder_listing.h"
#include "app/editor/frame_stats.h"
#include "app/editor/panel_states.h"
#include "app/editor/pose_history.h"
#include "app/editor/timeline_state.h"
#include "app/playback.h"
#include "app/render/scene.h"
#include "app/tools/input_router.h"

namespace sinew::app {

enum class MessageKind { kNote, kWarning, kError };

/// Stays until dismissed.
struct Message {
  MessageKind kind = MessageKind::kNote;
  std::string text;
  int count = 1;  ///< Times it was said.
};

/// What waits for "save your changes?" or for a path.
enum class IntentKind { kNone, kOpenFile, kReopen, kRecover, kQuit };
struct Intent {
  IntentKind kind = IntentKind::kNone;
  std::filesystem::path file;  ///< To open; kRecover: of LeftBehind.
};

enum class DialogKind { kNone, kOpen, kSaveAs };

/// The path dialog.
struct FileDialogState {
  DialogKind kind = DialogKind::kNone;
  std::filesystem::path folder;
  std::string text;        ///< The path field.
  std::string error;       ///< Why the last try failed.
  bool appearing = false;  ///< The path field takes the keyboard with the next frame.
  Intent then;             ///< After a successful Save As.
  FileFilter filter = FileFilter::kAll;
  std::vector<std::filesystem::path> back;     ///< Folders before this one, oldest first.
  std::vector<std::filesystem::path> forward;  ///< Folders that were left by going back, nearest last.
  bool overwriteAsked = false;                 ///< "Replace it?" is on the screen.
  bool naming = false;                         ///< A new folder's name is being typed.
  std::string newFolder;
  FolderListing listing;  ///< Of the folder, as last read.
  bool reveal = false;    ///< The list scrolls to the file that the field names.
};

/// A muscle's name being typed in the outliner.
struct RenameState {
  PrimitiveId primitive;  ///< 0 if none.
  std::string text;
  bool appearing = false;
};

/// Angles as typed, so that showing them back never changes them. Valid while `rotation` is the primitive's.
struct EulerState {
  PrimitiveId primitive;
  glm::quat rotation{0.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 degrees{0.0f};
};

/// The command palette.
struct PaletteState {
  bool shown = false;
  bool appearing = false;  ///< The search field takes the keyboard with the next frame.
  std::string query;
  int chosen = 0;  ///< Row that Enter takes.
};

/// Everything. Panels read it and change it through commands.h; the document's rig only through its command stack.
struct EditorState {
  Document document;
  std::optional<LiveSurface> live;
  std::size_t documentsOpened = 0;  ///< Grows with every opened document.
  Transport transport;
  TimelineState timeline;
  DisplaySettings display;
  ViewportTools tools;
  RouteResult route;  ///< Of the last frame.
  std::vector<Message> messages;
  bool messagesShown = false;  ///< Unfolded: by a new message, until it is put away.
  FrameStats stats;
  Preferences preferences;  ///< Without layout and window, which stand here and in the window.
  LayoutState layout;

  PanelStates panels;  ///< Outliner, groups, inspector, before and after.

  FileDialogState dialog;
  Intent question;  ///< Asking about unsaved changes before this; kNone: not asking.
  RenameState rename;
  EulerState euler;
  std::vector<std::pair<std::string, glm::quat>> copiedPose;  ///< Joints by file name, and their turns.
  PoseHistory poseHistory;
  std::string outlinerFilter;
  PrimitiveId revealed;          ///< The muscle the outliner has scrolled to last.
  std::size_t historyShown = 0;  ///< The step the history has scrolled to last.
  unsigned gestureItem = 0;      ///< ImGui id of the field whose drag or typing is one undo step; 0: none.
  std::string fieldError;        ///< Why a typed value was refused; shown until the next edit.
  bool keySheet = false;
  bool preferencesShown = false;
  PaletteState palette;
  std::vector<LeftBehind> leftBehind;   ///< By a crash: offered until answered.
  bool recoveryAsked = false;           ///< The offer is on the screen.
  std::optional<LeftBehind> recovered;  ///< Open now: thrown away once this process has its own copy.
  bool frameWanted = false;             ///< Frame the character as soon as the viewport's size is known.
  bool quit = false;

  glm::vec4 viewport{0.0f};  ///< x, y, width, height in window coordinates; of the last layout.
  glm::ivec2 viewportPixels{1, 1};
  float uiScale = 1.0f;      ///< Window coordinates per design pixel.
  float systemScale = 1.0f;  ///< What it would be if the system alone were asked.

  [[nodiscard]] bool hasCharacter() const { return document.character != nullptr && live.has_value(); }
  [[nodiscard]] const Character& character() const { return *document.character; }
};

}  // namespace sinew::app
