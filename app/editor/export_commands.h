// app/editor/export_commands.h: File > Export: its dialogs, what they start, and what is said when it is done.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "app/document/farm_job.h"
#include "app/editor/editor_state.h"

namespace sinew::app {

/// A farm reads the rig from its file: it has to be there, as it is on the screen.
[[nodiscard]] bool rigIsSaved(const EditorState& state);

/// The dialogs begin with what was chosen before; places begin anew with each document: beside the rig, NAME_muscled.
void showExportDialog(EditorState& state);
void showFarmDialog(EditorState& state);
void closeExportDialog(Dialogs& dialogs);

[[nodiscard]] const ExportKind& chosenKind(const Dialogs& dialogs);
/// Another kind: names get its ending, unless theirs was chosen and is one of its own.
void chooseKind(Dialogs& dialogs, std::size_t kind);
/// The clip of kinds that take one; "" where the character has none.
[[nodiscard]] std::string chosenOneClip(const EditorState& state);
/// What will be exported with: clips only if they are chosen one by one, in the character's order.
[[nodiscard]] ExportSettings chosenSettings(const EditorState& state);

/// Farm: of farmTargets(); the job's file gets its ending.
void chooseTarget(Dialogs& dialogs, const FarmTarget& target);

/// Where the export goes, or the job's file, as the dialog that is open shows it.
[[nodiscard]] ExportPlace& placeOf(Dialogs& dialogs, DialogKind kind);
/// Asks for it in the path dialog.
void browseForPlace(EditorState& state, DialogKind kind);
/// What the path dialog has given. @param file  absolute
void takePlace(Dialogs& dialogs, DialogKind kind, const std::filesystem::path& file);

/// Farm: the rigs that the job exports, and how many tasks it has.
[[nodiscard]] std::vector<std::filesystem::path> farmRigs(const EditorState& state);
[[nodiscard]] int farmTasks(const EditorState& state);

/// What is there already and would be replaced.
[[nodiscard]] std::vector<std::filesystem::path> replacedFiles(EditorState& state);
/// What the dialog's button does: the export begins in the background, or the job's file is written. Before it replaces
/// files it asks, in the dialog. @return whether the dialog is done; else it says why not.
bool confirmExport(EditorState& state);

/// Once a frame: says what has ended.
void followExports(EditorState& state);
/// The editor closes when all exports are done, unless one fails.
void quitAfterExports(EditorState& state);
}  // namespace sinew::app
