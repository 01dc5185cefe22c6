#pragma once  // app/panels/editor_state.h: all that the editor remembers between frames, as plain data.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/panels/frame_stats.h"
#include "app/playback.h"
#include "app/render/scene.h"
#include "app/tools/input_router.h"

namespace sinew::app {

enum class MessageKind { kNote, kError };

/// Stays until dismissed.
struct Message {
  MessageKind kind = MessageKind::kNote;
  std::string text;
  int count = 1;  ///< Times it was said.
};

/// What waits for "save your changes?" or for a path.
enum class IntentKind { kNone, kOpenFile, kReopen, kQuit };
struct Intent {
  IntentKind kind = IntentKind::kNone;
  std::filesystem::path file;
};

enum class DialogKind { kNone, kOpen, kSaveAs };

/// The path dialog.
struct FileDialogState {
  DialogKind kind = DialogKind::kNone;
  std::filesystem::path folder;
  std::string text;   ///< The path field.
  std::string error;  ///< Why the last try failed.
  bool appearing = false;  ///< The path field takes the keyboard with the next frame.
  Intent then;  ///< After a successful Save As.
};

/// A muscle's name being typed in the outliner.
struct RenameState {
  std::string primitive;  ///< "" if none.
  std::string text;
  bool appearing = false;
};

/// Angles as typed, so that showing them back never changes them. Valid while `rotation` is the primitive's.
struct EulerState {
  std::string primitive;
  glm::quat rotation{0.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 degrees{0.0f};
};

/// Sizes of the panels in design pixels.
struct LayoutState {
  float left = 264.0f;
  float right = 304.0f;
  float history = 170.0f;  ///< Height, in the left column.
  bool overlay = true;     ///< Numbers over the viewport.
};

/// Everything. Panels read it and change it through commands.h; the document's rig only through its command stack.
struct EditorState {
  Document document;
  std::optional<LiveSurface> live;
  std::size_t documentsOpened = 0;  ///< Grows with every opened document.
  Transport transport;
  DisplaySettings display;
  ViewportTools tools;
  RouteResult route;  ///< Of the last frame.
  std::vector<Message> messages;
  FrameStats stats;
  LayoutState layout;

  FileDialogState dialog;
  Intent question;  ///< Asking about unsaved changes before this; kNone: not asking.
  RenameState rename;
  EulerState euler;
  std::string outlinerFilter;
  std::string revealed;          ///< The muscle the outliner has scrolled to last.
  std::size_t historyShown = 0;  ///< The step the history has scrolled to last.
  unsigned gestureItem = 0;      ///< ImGui id of the field whose drag or typing is one undo step; 0: none.
  std::string fieldError;        ///< Why a typed value was refused; shown until the next edit.
  bool keySheet = false;
  bool frameWanted = false;  ///< Frame the character as soon as the viewport's size is known.
  bool quit = false;
  double wakeAfter = 0.0;  ///< Seconds until the interface wants another frame though nothing happens; 0: it does not.

  glm::vec4 viewport{0.0f};  ///< x, y, width, height in window coordinates; of the last layout.
  glm::ivec2 viewportPixels{1, 1};
  float uiScale = 1.0f;  ///< Window coordinates per design pixel.

  [[nodiscard]] bool hasCharacter() const { return document.character != nullptr && live.has_value(); }
  [[nodiscard]] const Character& character() const { return *document.character; }
};

}  // namespace sinew::app
