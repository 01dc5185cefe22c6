// app/editor/export_commands.h: the dialogs of File > Export, the exports they start, and their outcome.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "app/document/farm_job.h"
#include "app/editor/editor_state.h"

namespace sinew::app {

[[nodiscard]] bool rigIsSaved(const EditorState& state);  ///< It has a file without unsaved changes, as farm jobs need.

/// The dialogs keep the last choices; paths start as NAME_muscled beside each document.
void showExportDialog(EditorState& state);
void showFarmDialog(EditorState& state);
void closeExportDialog(Dialogs& dialogs);

[[nodiscard]] const ExportKind& chosenKind(const Dialogs& dialogs);
void chooseKind(Dialogs& dialogs, std::size_t kind);  ///< Names get the kind's ending unless they have one already.
/// The clip for kinds that take one; "": the character has none.
[[nodiscard]] std::string chosenOneClip(const EditorState& state);
/// Settings of the export; `clips` only if chosen one by one, in the character's order.
[[nodiscard]] ExportSettings chosenSettings(const EditorState& state);

void chooseTarget(Dialogs& dialogs, const FarmTarget& target);  ///< Farm: the job's file gets the target's ending.

/// Path of the export or of the job's file in the open dialog.
[[nodiscard]] ExportPlace& placeOf(Dialogs& dialogs, DialogKind kind);
void browseForPlace(EditorState& state, DialogKind kind);  ///< Opens the path dialog for it.
/// Takes the path dialog's file. @param file  absolute
void takePlace(Dialogs& dialogs, DialogKind kind, const std::filesystem::path& file);

/// Farm: the rigs that the job exports, and how many tasks it has.
[[nodiscard]] std::vector<std::filesystem::path> farmRigs(const EditorState& state);
[[nodiscard]] int farmTasks(const EditorState& state);

[[nodiscard]] std::vector<std::filesystem::path> replacedFiles(EditorState& state);  ///< Files that would be replaced.
/// Exports, or writes the job's file; asks before replacing files. @return false: the dialog shows why it is not done
bool confirmExport(EditorState& state);

void followExports(EditorState& state);     ///< Once a frame: reports finished exports.
void quitAfterExports(EditorState& state);  ///< Closes the editor when all exports are done, unless one fails.
}  // namespace sinew::app
