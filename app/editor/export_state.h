// app/editor/export_state.h: choices of the export dialogs, and the last export.
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

}  // namespace sinew::app
