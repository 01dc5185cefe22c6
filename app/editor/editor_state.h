// app/editor/editor_state.h: the editor's state as plain data, by lifetime.
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
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "app/document/document.h"
#include "app/document/export_kinds.h"
#include "app/document/export_queue.h"
#include "app/document/farm_job.h"
#include "app/document/file_stamp.h"
#include "app/document/folder_listing.h"
#include "app/document/playback.h"
#include "app/document/preferences.h"
#include "app/document/recovery.h"
#include "app/editor/document_view.h"
#include "app/ui/data_files.h"
#include "app/ui/frame_stats.h"
#include "app/viewport/gpu/surface_parts.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/tools/input_router.h"
#include "sinew/rig/muscle_line.h"
#include "sinew/surface/smoother.h"

namespace sinew::app {

// Choices of the export dialogs, and the last export.

enum class ExportDialog { kNone, kCharacter, kFarmJob };

struct ExportPlace {
  std::filesystem::path folder;  ///< Absolute.
  std::string name;              ///< As typed; may be a path.
};

struct ExportDialogState {
  ExportDialog shown = ExportDialog::kNone;
  std::size_t kind = 0;      ///< Index into exportKinds().
  ExportSettings settings;   ///< `clips` are the checked ones.
  bool chosenClips = false;  ///< Only checked clips, else all.
  std::string oneClip;       ///< For kinds that take one; if the character lacks it, the playing clip.
  bool advanced = false;     ///< Unfolded.

  // Of one document.
  std::filesystem::path of;  ///< Document::file()
  ExportPlace place;         ///< The exported character.
  ExportPlace pattern;       ///< Farm, whole folder: the characters, with "{name}".
  ExportPlace job;           ///< Farm: the job's file.

  std::string target = "slurm";               ///< Farm: of farmTargets().
  std::vector<std::filesystem::path> rigs{};  ///< Farm: all rigs in the open rig's folder.
  bool wholeFolder = false;                   ///< Farm: export all of them.
  int tasks = 0;                              ///< Farm; 0: one per rig, up to 16.

  bool overwriteAsked = false;  ///< "Replace it?" is shown.
  std::string error;            ///< Of the last try.
};

inline constexpr int kMostTurntable = 720;  ///< Pictures once around.
inline constexpr int kMostCells = 32;       ///< Of a contact sheet, each way.
inline constexpr int kLeastPictureSide = 16;
inline constexpr int kMostPictureSide = 8192;

/// File > Export > Turntable or contact sheet.
struct PicturesDialogState {
  bool shown = false;
  bool sheet = false;  ///< Contact sheet, else turntable.

  int turns = 72;      ///< Turntable: pictures once around.
  double rate = 24.0;  ///< Pictures per second.
  bool plays = false;  ///< Turntable: the clip plays meanwhile.
  std::string ending = ".webp";
  glm::ivec2 cells{4, 2};      ///< Sheet: columns and rows.
  bool ofClip = false;         ///< Sheet: times of the clip, else all sides of the current pose.
  glm::ivec2 size{1280, 720};  ///< Of each picture.

  // Of one document.
  std::filesystem::path of;
  ExportPlace turntable;
  ExportPlace sheetPlace;

  bool overwriteAsked = false;
  std::string error;
};

/// A finished export, for comparison with the live surface.
struct LastExport {
  std::filesystem::path file;
  std::shared_ptr<const Character> character;
  Rig rig;  ///< With the detail of the export.
  std::shared_ptr<const ExportedSurface> played;
  ErrorFigures largest;  ///< Of all clips, at keys and between.
};

enum class ExportedView { kLive, kExported, kBoth };

/// View > Export error: the live surface as exported, or the file's mesh, with their distance as displacement.
struct ExportErrorState {
  std::optional<LastExport> last;
  bool shown = false;
  ExportedView view = ExportedView::kLive;
  glm::vec3 aside{0.0f};  ///< kBoth: offset of the exported mesh, world.

  Surface surface;
  Surface beside;            ///< kBoth: positions, normals and displacement of the exported mesh.
  float largestNow = 0.0f;   ///< At the current time, percent of the height.
  std::size_t revision = 0;  ///< Grows with each update.
  std::optional<Smoother> smoother;
  std::size_t madeOf = 0;  ///< Live revision of `surface`; 0: none.
  ExportedView madeView = ExportedView::kLive;
  glm::vec3 madeAside{0.0f};
};

/// A short note that fades after a time that depends on its length.
struct Toast {
  std::string text;
  bool refusal = false;  ///< Shown longer.
  double since = 0.0;    ///< FrameState::now
};

[[nodiscard]] float opacity(const Toast& toast, double now);
/// Seconds until its opacity changes; nullopt: it is gone.
[[nodiscard]] std::optional<double> secondsToChange(const Toast& toast, double now);

// State of the view that stays when another document is opened.

enum class LeftTab { kMuscles, kGroups, kLibrary, kShapes };

enum class OutlinerOrder { kBones, kRegions, kGroups };  ///< Muscles under the tree of bones, or in a flat list.

struct OutlinerState {
  LeftTab tab = LeftTab::kMuscles;
  OutlinerOrder order = OutlinerOrder::kBones;
  bool onlyWithMuscles = false;  ///< Hides bones without a muscle on or below them.
  std::set<std::string> folded;  ///< Paths of bones, and foldedKey() of parts.
  bool unattachedFolded = false;
  bool helperBones = false;  ///< Shows bones that move no skin, in the picture as well.
};

struct InspectorState {
  bool percent = false;        ///< Lengths in percent of the height, else in character units.
  bool shapeOpen = false;      ///< Unfolded: shape,
  bool sheetOpen = false;      ///< further numbers of a sheet,
  bool territoryOpen = false;  ///< bones of a default territory,
  bool animationOpen = false;  ///< drivers and keys.
  std::string boneFilter;      ///< Of the open list of bones.
};

/// "Before": the character without muscles.
struct BareState {
  bool latched = false;  ///< By menu, or while the key is held.
  bool byKey = false;
};

inline constexpr std::size_t kFirstSteps = 5;

/// Help > First steps.
struct FirstStepsState {
  bool shown = false;
  std::array<bool, kFirstSteps> done{};
  std::size_t document = 0;        ///< SessionState::documentsOpened for the following.
  CameraStand stand;               ///< When the document was opened.
  std::shared_ptr<const Rig> rig;  ///< When the document was opened.
};

struct ViewState {
  DisplaySettings display;
  ViewportTools tools;
  LayoutState layout;
  OutlinerState outliner;
  std::string outlinerFilter;
  bool groupsAsGraph = false;  ///< Instead of the matrix.
  InspectorState inspector;
  BareState bare;
  FirstStepsState firstSteps;
  std::vector<std::pair<std::string, glm::quat>> copiedPose;  ///< Joints by file name, and rotations.
};

// State of the whole run.

class Thumbnails;

enum class MessageKind { kNote, kWarning, kError };

enum class MessageAbout { kDocument, kProgram };  ///< Messages about a document are removed when another is opened.

struct Message {
  MessageKind kind = MessageKind::kNote;
  std::string text;
  int count = 1;  ///< Repetitions.
  MessageAbout about = MessageAbout::kDocument;
  std::optional<MuscleLine> line = std::nullopt;  ///< Removed when this line changes.
};

/// Who computes the surface.
struct SurfaceMakerState {
  bool onCard = false;
  std::string why;                           ///< The reason; "": the preferences.
  std::optional<PartSeconds> onCardSeconds;  ///< Of a recent frame, by the card's clock; nullopt: unknown.
};

struct SessionState {
  std::filesystem::path viewsFolder;  ///< For views (view_files.h); "": not kept.
  Preferences preferences;            ///< Without layout and window, which ViewState and the window have.
  std::vector<Message> messages;      ///< Newest last.
  std::size_t messagesSaid = 0;       ///< Grows with every message.
  std::optional<Toast> toast;
  bool messagesShown = false;                          ///< Unfolded by a new message.
  std::vector<LeftBehind> leftBehind;                  ///< By a crash; offered until answered.
  bool saveFailed = false;                             ///< Tells the keeper to write unsaved work at once.
  std::optional<LeftBehind> recovered;                 ///< Open; removed once this process has its own copy.
  std::size_t documentsOpened = 0;                     ///< Grows whenever document or character is replaced.
  std::optional<std::filesystem::path> pictureWanted;  ///< The window writes its picture there.
  Thumbnails* thumbnails = nullptr;                    ///< Null without a window.
  FrameStats stats;
  SurfaceMakerState surfaceMaker;
  ExportQueue exports;
  std::string program = thisProgram();  ///< Draws pictures in the background.
  DesktopOpener opener;
  ExportErrorState exportError;
  /// documentsOpened and CommandStack::revision() at the request: later edits are asked about.
  std::optional<std::pair<std::size_t, std::size_t>> quitAfterExports;
  bool quit = false;
};

// Dialogs.

/// Waits for "save your changes?" or for a path.
enum class IntentKind { kNone, kOpenFile, kOpenWithMuscles, kAddClips, kReopen, kRecover, kQuit };
struct Intent {
  IntentKind kind = IntentKind::kNone;
  std::filesystem::path file;  ///< kRecover: LeftBehind::file
};

enum class DialogKind {
  kNone,
  kOpen,
  kSaveAs,
  kSavePicture,
  kExportPlace,
  kJobPlace,
  kPicturesPlace,
  kReference,
  kSculpt
};

struct FileDialogState {
  DialogKind kind = DialogKind::kNone;
  std::filesystem::path folder;
  std::string text;                 ///< The path field.
  std::string error;                ///< Of the last try.
  bool appearing = false;           ///< Focuses the path field.
  Intent then;                      ///< Save As: after success; Open: in place of opening.
  std::filesystem::path locateFor;  ///< Open: the rig whose character is chosen.
  std::string clipsFor;             ///< kAddClips: the missing entry of Rig::clipFiles; "": add one.
  FileFilter filter = FileFilter::kAll;
  std::vector<std::filesystem::path> back;     ///< Former folders, oldest first.
  std::vector<std::filesystem::path> forward;  ///< Folders left by going back, nearest last.
  bool overwriteAsked = false;                 ///< "Replace it?" is shown.
  bool naming = false;                         ///< A new folder's name is being typed.
  std::string newFolder;
  FolderListing listing;
  bool reveal = false;  ///< Scroll to the field's file.
};

/// Question about a rig with a missing character.
struct LocateState {
  std::filesystem::path rigFile;  ///< "": closed.
  std::filesystem::path characterFile;
};

/// A muscle of a set, or the whole set.
struct SetEntry {
  std::string set;
  std::string muscle;
};

struct PaletteState {
  bool shown = false;
  bool appearing = false;  ///< Focuses the search field.
  std::string query;
  int chosen = -1;             ///< Row chosen with the arrows; -1: Enter takes the best one.
  std::vector<SetEntry> sets;  ///< Read when the palette opens.
};

/// A control to scroll to, focus and highlight.
struct RevealState {
  std::string id;       ///< In the WidgetLog; "": none.
  int tries = 0;        ///< Frames without it.
  double until = -1.0;  ///< End of the highlight (FrameState::now); negative: not shown yet.
};

/// "Your file has changed on disk"
struct ConflictQuestion {
  OnDisk found = OnDisk::kSame;  ///< kSame: closed.
  Intent then;                   ///< After the answer.
};

enum class PreferencesPage { kGeneral, kKeys };

/// Assigning a key: waiting for it, or asking about a key of another action.
struct KeyCapture {
  enum class Step { kNone, kWaiting, kAsking };
  Step step = Step::kNone;
  std::string action;  ///< Id.
  int slot = 0;        ///< First or second key.
  std::string key;     ///< Asking: "Ctrl+D"; "": about a reset.
  std::string notice;  ///< The question, or why a key was refused.
};

struct Dialogs {
  FileDialogState file;
  LocateState locate;
  ConflictQuestion conflict;
  Intent question;                    ///< Question about unsaved changes before this; kNone: closed.
  std::filesystem::path keepMuscles;  ///< Question whether this dropped character gets the muscles; "": closed.
  bool droppedHasClips = false;       ///< ... or whether to add its clips.
  ExportDialogState exporting;
  PicturesDialogState pictures;
  bool exportQuestion = false;  ///< Question whether to quit during exports.
  PaletteState palette;
  RevealState reveal;
  bool keySheet = false;
  bool preferences = false;
  PreferencesPage preferencesPage = PreferencesPage::kGeneral;
  std::string keySearch;  ///< Filter of the list of keys.
  KeyCapture keyCapture;
  bool recovery = false;  ///< Offers work left by a crash.
};

struct FrameState {
  RouteResult route;             ///< Of the viewport's tools.
  std::vector<int> highlighted;  ///< Rig indices of muscles hovered in panels.
  int hoveredPart = -1;          ///< Index into Character::parts, hovered in a panel.
  glm::vec4 viewport{0.0f};      ///< x, y, width, height in window coordinates.
  glm::ivec2 viewportPixels{1, 1};
  std::vector<glm::vec4> covered;  ///< Parts of the picture under panels, 0..1: low x and y, high x and y.
  double now = 0.0;                ///< Seconds, monotonic.
  int pictureSamples = 0;          ///< Samples of the shown picture; 1 while something moves.
  float pictureScale = 1.0f;       ///< Picture pixels per viewport pixel, along an edge.
  float uiScale = 1.0f;            ///< Window coordinates per design pixel.
  bool arrowsTaken = false;        ///< A focused list used Up and Down in the last frame.
  float systemScale = 1.0f;        ///< uiScale of the system.
};

/// Panels change it through the commands of this directory, the rig only through the command stack.
struct EditorState {
  Document document;
  std::optional<LiveSurface> live;  ///< The document's surface; nullopt without a character.
  DocumentView open;
  ViewState view;
  Dialogs dialogs;
  SessionState session;
  FrameState frame;

  [[nodiscard]] bool hasCharacter() const { return document.character != nullptr && live.has_value(); }
  [[nodiscard]] const Character& character() const { return *document.character; }
};

}  // namespace sinew::app
