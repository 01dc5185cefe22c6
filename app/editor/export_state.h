// app/editor/export_state.h: what is chosen in the export dialogs. Remembered while the editor runs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/export/export_kinds.h"

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

}  // namespace sinew::app
