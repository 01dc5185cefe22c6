// app/editor/editor_state.h: all that the editor remembers between frames, as plain data, by how long it lives.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/document/document.h"
#include "app/document/export_queue.h"
#include "app/document/farm_job.h"
#include "app/document/file_stamp.h"
#include "app/document/folder_listing.h"
#include "app/document/playback.h"
#include "app/document/preferences.h"
#include "app/document/recovery.h"
#include "app/editor/document_view.h"
#include "app/editor/export_state.h"
#include "app/ui/data_files.h"
#include "app/ui/frame_stats.h"
#include "app/viewport/gpu/surface_parts.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/tools/input_router.h"
#include "sinew/rig/muscle_line.h"

namespace sinew::app {

// The short note of what has just been done, or why it was not.

/// Shown for a time that depends on its length, then fades. Asks for no answer; what has to stay is a Message.
struct Toast {
  std::string text;
  bool refusal = false;  ///< Something was not done: shown longer.
  double since = 0.0;    ///< FrameState::now when it was said.
};

/// 1: fully shown, then less; 0: gone.
[[nodiscard]] float opacity(const Toast& toast, double now);
/// Seconds until it looks different; none: it is gone.
[[nodiscard]] std::optional<double> secondsToChange(const Toast& toast, double now);

// What stays as it is when another document is opened: how the designer looks and works.

enum class LeftTab { kMuscles, kGroups, kLibrary, kShapes };

/// What the rows of the muscles stand under: the tree of bones, or a flat list.
enum class OutlinerOrder { kBones, kRegions, kGroups };

/// Rows have keys: "m:" and a muscle's identity, or "b:" and a bone's path.
struct OutlinerState {
  LeftTab tab = LeftTab::kMuscles;
  OutlinerOrder order = OutlinerOrder::kBones;
  bool onlyWithMuscles = false;  ///< Bones without a muscle on them or below are left out.
  std::set<std::string> folded;  ///< Paths of the bones, and names of the parts of a flat list, that are closed.
  bool unattachedFolded = false;
  bool helperBones = false;  ///< Bones that move no skin are shown, in the picture as well.
};

struct InspectorState {
  bool percent = false;        ///< Lengths in per cent of the height, else in character units.
  bool shapeOpen = false;      ///< The rows that change a muscle's shape are unfolded.
  bool territoryOpen = false;  ///< The list of a default territory's bones is unfolded.
  std::string boneFilter;      ///< Typed into the list of bones that is open.
  bool animationOpen = false;  ///< Drivers and keys are unfolded.
};

/// "Before": the character without muscles while a key or a button is held.
struct BareState {
  bool latched = false;  ///< Switched on from a menu; or the key went down and is not up yet.
  bool byKey = false;
};

inline constexpr std::size_t kFirstSteps = 5;

/// Help > First steps.
struct FirstStepsState {
  bool shown = false;
  std::array<bool, kFirstSteps> done{};
  std::size_t document = 0;        ///< SessionState::documentsOpened that what follows is of.
  CameraStand stand;               ///< As the document was opened.
  std::shared_ptr<const Rig> rig;  ///< Likewise.
};

struct ViewState {
  DisplaySettings display;
  ViewportTools tools;
  LayoutState layout;
  OutlinerState outliner;
  std::string outlinerFilter;
  bool groupsAsGraph = false;  ///< Nodes and edges instead of the matrix.
  InspectorState inspector;
  BareState bare;
  FirstStepsState firstSteps;
  std::vector<std::pair<std::string, glm::quat>> copiedPose;  ///< Joints by file name, and their turns.
};

// What lasts from the program's start to its end.

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

// Which dialogs are open, and what has been typed into them.

/// What waits for "save your changes?" or for a path.
enum class IntentKind { kNone, kOpenFile, kOpenWithMuscles, kAddClips, kReopen, kRecover, kQuit };
struct Intent {
  IntentKind kind = IntentKind::kNone;
  std::filesystem::path file;  ///< To open; kRecover: of LeftBehind.
};

/// The dialogs of exports only choose a place, kReference a picture to work after.
enum class DialogKind { kNone, kOpen, kSaveAs, kSavePicture, kExportPlace, kJobPlace, kPicturesPlace, kReference };

/// The path dialog.
struct FileDialogState {
  DialogKind kind = DialogKind::kNone;
  std::filesystem::path folder;
  std::string text;                 ///< The path field.
  std::string error;                ///< Why the last try failed.
  bool appearing = false;           ///< The path field takes the keyboard with the next frame.
  Intent then;                      ///< After a successful Save As; Open: what is done with the file, if not opened.
  std::filesystem::path locateFor;  ///< Open: not any file but the character of this rig.
  std::string clipsFor;             ///< kAddClips: the entry of Rig::clipFiles that is gone; "": one more.
  FileFilter filter = FileFilter::kAll;
  std::vector<std::filesystem::path> back;     ///< Folders before this one, oldest first.
  std::vector<std::filesystem::path> forward;  ///< Folders that were left by going back, nearest last.
  bool overwriteAsked = false;                 ///< "Replace it?" is on the screen.
  bool naming = false;                         ///< A new folder's name is being typed.
  std::string newFolder;
  FolderListing listing;  ///< The folder's, as last read.
  bool reveal = false;    ///< The list scrolls to the file that the field names.
};

/// A rig whose character is not where the rig says: asking what to do.
struct LocateState {
  std::filesystem::path rigFile;  ///< "": not asking.
  std::filesystem::path characterFile;
};

/// A muscle of a set that fits this kind of body; without a muscle the whole set.
struct SetEntry {
  std::string set;
  std::string muscle;
};

/// The command palette.
struct PaletteState {
  bool shown = false;
  bool appearing = false;  ///< The search field takes the keyboard with the next frame.
  std::string query;
  int chosen = -1;             ///< Row that was chosen with the arrows; -1: none, Enter takes the best one.
  std::vector<SetEntry> sets;  ///< Read when the palette opens.
};

/// A control that is brought into sight, gets the keyboard and is marked for a moment.
struct RevealState {
  std::string id;       ///< As WidgetLog knows it; "": none.
  int tries = 0;        ///< Frames in which it was not there yet.
  double until = -1.0;  ///< The mark goes then, on FrameState::now; less than 0: it has not been seen yet.
};

/// "Your file has changed on disk": waits for which version is to stay.
struct ConflictQuestion {
  OnDisk found = OnDisk::kSame;  ///< kSame: not asking.
  Intent then;                   ///< After the answer.
};

/// Which part of the preferences is shown.
enum class PreferencesPage { kGeneral, kKeys };

/// Another key for an action: waiting for it, or asking what to do as it is taken.
struct KeyCapture {
  enum class Step { kNone, kWaiting, kAsking };
  Step step = Step::kNone;
  std::string action;  ///< Id.
  int slot = 0;        ///< Its first or second key.
  std::string key;     ///< Asked about, as "Ctrl+D"; "": about a reset.
  std::string notice;  ///< The question, or why the last key was refused.
};

struct Dialogs {
  FileDialogState file;
  LocateState locate;
  ConflictQuestion conflict;
  Intent question;                    ///< Asking about unsaved changes before this; kNone: not asking.
  std::filesystem::path keepMuscles;  ///< A character that was dropped: asking whether it gets the muscles. "": not.
  bool droppedHasClips = false;       ///< ... or whether its clips are added here.
  ExportDialogState exporting;
  PicturesDialogState pictures;
  bool exportQuestion = false;  ///< Asking whether to quit though exports are not done.
  PaletteState palette;
  RevealState reveal;
  bool keySheet = false;
  bool preferences = false;
  PreferencesPage preferencesPage = PreferencesPage::kGeneral;
  std::string keySearch;  ///< Typed above the list of keys.
  KeyCapture keyCapture;
  bool recovery = false;  ///< What a crash left behind is being offered.
};

/// Made anew in each frame.
struct FrameState {
  RouteResult route;             ///< What the viewport's tools did.
  std::vector<int> highlighted;  ///< Rig indices of muscles that a panel's hover lights up.
  int hoveredPart = -1;          ///< Index into Character::parts, of the part that a panel's hover lights up.
  glm::vec4 viewport{0.0f};      ///< x, y, width, height in window coordinates; of the last layout.
  glm::ivec2 viewportPixels{1, 1};
  std::vector<glm::vec4> covered;  ///< Parts of the picture under panels: low x and y, high x and y, 0..1 of it.
  double now = 0.0;                ///< Seconds on a clock that only grows.
  int pictureSamples = 0;          ///< That the shown picture is the mean of; 1 while something moves.
  float pictureScale = 1.0f;       ///< Pixels of the shown picture per pixel of the viewport, along an edge.
  float uiScale = 1.0f;            ///< Window coordinates per design pixel.
  bool arrowsTaken = false;        ///< A list with the focus uses Up and Down; of the last frame.
  float systemScale = 1.0f;        ///< What it would be if the system alone were asked.
};

/// Panels read it and change it through the commands of this directory; the rig only through the command stack.
struct EditorState {
  Document document;
  std::optional<LiveSurface> live;  ///< The document's surface; none without a character.
  DocumentView open;                ///< Begins anew with each document.
  ViewState view;                   ///< Stays when another document is opened.
  Dialogs dialogs;
  SessionState session;
  FrameState frame;

  [[nodiscard]] bool hasCharacter() const { return document.character != nullptr && live.has_value(); }
  [[nodiscard]] const Character& character() const { return *document.character; }
};

}  // namespace sinew::app
