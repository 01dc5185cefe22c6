// app/editor/export_state.h: what is chosen in the export dialogs, and what the last export came to. Remembered while
// the editor runs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/document/export_kinds.h"
#include "sinew/surface/smoother.h"

namespace sinew::app {

enum class ExportDialog { kNone, kCharacter, kFarmJob };

/// A file to be written.
struct ExportPlace {
  std::filesystem::path folder;  ///< Absolute.
  std::string name;              ///< As typed: may be a path, relative to the folder or not.
};

struct ExportDialogState {
  ExportDialog shown = ExportDialog::kNone;
  std::size_t kind = 0;      ///< Index into exportKinds().
  ExportSettings settings;   ///< `clips` are those with a check mark.
  bool chosenClips = false;  ///< Those alone, else all.
  std::string oneClip;       ///< For kinds that take one; one that the character lacks: that which plays.
  bool advanced = false;     ///< That part is unfolded.

  // One document's; another begins with its own.
  std::filesystem::path of;  ///< The rig, or a character without one.
  ExportPlace place;         ///< The character.
  ExportPlace pattern;       ///< Farm, a whole folder: the characters, with "{name}".
  ExportPlace job;           ///< Farm: the job's file.

  std::string target = "slurm";               ///< Farm: of farmTargets().
  std::vector<std::filesystem::path> rigs{};  ///< Farm: in the open rig's folder, it included; as the dialog opened.
  bool wholeFolder = false;                   ///< Farm: all rigs beside the open one.
  int tasks = 0;                              ///< Farm; 0: as many as there are rigs, up to 16.

  bool overwriteAsked = false;  ///< "Replace it?" is on the screen.
  std::string error;            ///< Why the last try failed.
};

inline constexpr int kMostTurntable = 720;  ///< Pictures once around.
inline constexpr int kMostCells = 32;       ///< Of a contact sheet, each way.
inline constexpr int kLeastPictureSide = 16;
inline constexpr int kMostPictureSide = 8192;

/// File > Export > Turntable or contact sheet.
struct PicturesDialogState {
  bool shown = false;
  bool sheet = false;  ///< One picture of many, else a moving one.

  int turns = 72;      ///< Turntable: pictures once around.
  double rate = 24.0;  ///< Pictures a second.
  bool plays = false;  ///< The clip plays while the eye goes around once, else the moment that is shown stays.
  std::string ending = ".webp";
  glm::ivec2 cells{4, 2};      ///< Sheet: columns and rows.
  bool ofClip = false;         ///< Sheet: moments of the clip, else all sides of the moment that is shown.
  glm::ivec2 size{1280, 720};  ///< Of each picture.

  // One document's; another begins with its own.
  std::filesystem::path of;
  ExportPlace turntable;
  ExportPlace sheetPlace;

  bool overwriteAsked = false;
  std::string error;
};

/// An export that is done, as far as it can be compared with the live surface.
struct LastExport {
  std::filesystem::path file;
  std::shared_ptr<const Character> character;
  Rig rig;  ///< With the detail that it was exported with.
  std::shared_ptr<const ExportedSurface> played;
  ErrorFigures largest;  ///< Of all clips, at keys and between.
};

/// Which of the two meshes View > Export error draws.
enum class ExportedView { kLive, kExported, kBoth };

/// What View > Export error draws: the live surface as it was exported, or what the file shows, each vertex displaced
/// by their distance.
struct ExportErrorState {
  std::optional<LastExport> last;
  bool shown = false;
  ExportedView view = ExportedView::kLive;
  glm::vec3 aside{0.0f};  ///< kBoth: from the live surface to the exported mesh, world.

  Surface surface;
  Surface beside;            ///< kBoth: the exported mesh where it stands; positions, normals and displacement alone.
  float largestNow = 0.0f;   ///< In this moment, percent of the height.
  std::size_t revision = 0;  ///< Counts what has been drawn.
  std::optional<Smoother> smoother;
  std::size_t madeOf = 0;  ///< Live revision that `surface` was made in; 0: none.
  ExportedView madeView = ExportedView::kLive;
  glm::vec3 madeAside{0.0f};
};

}  // namespace sinew::app
