// app/editor/session_state.h: what lasts from the program's start to its end.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/document/export_queue.h"
#include "app/document/farm_job.h"
#include "app/document/preferences.h"
#include "app/document/recovery.h"
#include "app/editor/export_state.h"
#include "app/editor/toast.h"
#include "app/ui/desktop_opener.h"
#include "app/ui/frame_stats.h"
#include "app/viewport/gpu/surface_parts.h"
#include "sinew/rig/muscle_line.h"

namespace sinew::app {

class Thumbnails;

enum class MessageKind { kNote, kWarning, kError };

/// Whom a message is about: what was said of a document goes when another is opened.
enum class MessageAbout { kDocument, kProgram };

/// Stays until dismissed.
struct Message {
  MessageKind kind = MessageKind::kNote;
  std::string text;
  int count = 1;  ///< Times it was said.
  MessageAbout about = MessageAbout::kDocument;
  std::optional<MuscleLine> line = std::nullopt;  ///< What it warns of, as it was: the message goes when that changes.
};

/// Who computes the surface in the picture. The window's; no window: the processor.
struct SurfaceMakerState {
  bool onCard = false;
  std::string why;                           ///< What decided; "": the preferences.
  std::optional<PartSeconds> onCardSeconds;  ///< Of a late frame, by the card's own clock; nullopt: not known.
};

struct SessionState {
  std::filesystem::path viewsFolder;  ///< Where views of files are kept (view_files.h); "": they are not.
  Preferences preferences;            ///< Without layout and window, which stand in ViewState and in the window.
  std::vector<Message> messages;      ///< The last one is the newest.
  std::size_t messagesSaid = 0;       ///< Grows with every message.
  std::optional<Toast> toast;
  bool messagesShown = false;           ///< Unfolded: by a new message, until they are folded.
  std::vector<LeftBehind> leftBehind;   ///< By a crash: offered until answered.
  bool saveFailed = false;              ///< Until the keeper has seen it: what is unsaved is kept at once.
  std::optional<LeftBehind> recovered;  ///< Open now: thrown away once this process has its own copy.
  std::size_t documentsOpened = 0;      ///< Grows whenever document or character is replaced.
  std::optional<std::filesystem::path> pictureWanted;  ///< The window writes its picture there after this frame.
  Thumbnails* thumbnails = nullptr;                    ///< The window's; null without one.
  FrameStats stats;
  SurfaceMakerState surfaceMaker;
  ExportQueue exports;                  ///< In the background.
  std::string program = thisProgram();  ///< Draws pictures in the background.
  DesktopOpener opener;                 ///< Of pages.
  ExportErrorState exportError;
  /// As soon as they are done; asked for at these documentsOpened and CommandStack::revision(): what is edited after
  /// that is asked about.
  std::optional<std::pair<std::size_t, std::size_t>> quitAfterExports;
  bool quit = false;
};

}  // namespace sinew::app
