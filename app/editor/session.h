// app/editor/session.h: samples, recent files, recovery after a crash, help and first steps.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

// Help > First steps: five things to try in any order.

enum class FirstStep : std::size_t { kTurn, kSelect, kScale, kAdd, kCompare };

/// Opens the first sample, after asking about unsaved changes, and shows the list; or hides it.
void toggleFirstSteps(EditorState& state);
void followFirstSteps(EditorState& state);  ///< Once a frame: ticks off what was done since the document was opened.
[[nodiscard]] bool firstStepsDone(const FirstStepsState& steps);

/// A character that comes with the program.
struct Sample {
  std::string name;  ///< "Horse wrapped"
  std::filesystem::path file;
};

[[nodiscard]] std::vector<Sample> samples();  ///< Existing ones: rigs in a fixed order, then characters without a rig.
[[nodiscard]] std::filesystem::path firstSample();               ///< Opened without an argument; "": there is none.
[[nodiscard]] bool isSample(const std::filesystem::path& file);  ///< In the folder of the program's samples.
/// Folder of a file for new files beside it; the home folder for samples.
[[nodiscard]] std::filesystem::path workFolder(const std::filesystem::path& file);

void rememberDocument(EditorState& state);  ///< Adds the document's file to the recent ones, unless it is a sample.

/// Opens the document of a recovery file as modified, or reports why not.
void recover(EditorState& state, const std::filesystem::path& recoveryFile);
void discardRecovery(EditorState& state, const std::filesystem::path& recoveryFile);

struct HelpPage {
  std::string name;   ///< File name: "opening"
  std::string title;  ///< Its first heading: "Opening a character"
  std::filesystem::path file;
};

/// Pages of the documentation by title, read once. Empty if not installed.
[[nodiscard]] const std::vector<HelpPage>& helpPages();
/// Opens it in the desktop's program; without one, a message names its path.
void openHelpPage(EditorState& state, const HelpPage& page);
void followOpenedPages(EditorState& state);  ///< Once a frame: reports pages that the desktop could not open.

void showPalette(Dialogs& dialogs);
void jumpToMuscle(EditorState& state, PrimitiveId primitive);  ///< Selects and frames it.
void jumpToBone(EditorState& state, int bone);

[[nodiscard]] Preferences currentPreferences(const EditorState& state);  ///< The preferences with the current layout.

}  // namespace sinew::app
