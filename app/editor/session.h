// app/editor/session.h: what outlives one document: samples, recent files, work recovered after a crash.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

// Help > First steps: five things to try, each done when it is done, in any order.

enum class FirstStep : std::size_t { kTurn, kSelect, kScale, kAdd, kCompare };

/// Opens the first sample and shows the list; or puts it away. Unsaved changes are asked about first.
void toggleFirstSteps(EditorState& state);

/// Once a frame while the list is shown: ticks off what has been done to the open document since it was opened.
void followFirstSteps(EditorState& state);
[[nodiscard]] bool firstStepsDone(const FirstStepsState& steps);

/// A character that comes with the program.
struct Sample {
  std::string name;  ///< "Horse wrapped"
  std::filesystem::path file;
};

/// Those that are there: rigs in a fixed order, then characters that no rig has as its own.
[[nodiscard]] std::vector<Sample> samples();
/// What opens without an argument: the first sample; "" if there is none.
[[nodiscard]] std::filesystem::path firstSample();
/// Lies in the folder that ships with the program.
[[nodiscard]] bool isSample(const std::filesystem::path& file);

/// Puts the open document's file among the recent ones, unless it is a sample.
void rememberDocument(EditorState& state);

/// The document becomes what the crash left in this recovery file; it counts as modified. A message says why not.
void recover(EditorState& state, const std::filesystem::path& recoveryFile);
/// Throws the left work away.
void discardRecovery(EditorState& state, const std::filesystem::path& recoveryFile);

/// A page of the documentation.
struct HelpPage {
  std::string name;   ///< Of its file: "opening"
  std::string title;  ///< Its first heading: "Opening a character"
  std::filesystem::path file;
};

/// By title; read once. Empty where they are not installed.
[[nodiscard]] const std::vector<HelpPage>& helpPages();
/// In the program that the desktop has for it; a message with its path says if there is none.
void openHelpPage(EditorState& state, const HelpPage& page);
/// Once a frame: the same for what the desktop could not open after all.
void followOpenedPages(EditorState& state);

void showPalette(Dialogs& dialogs);
/// Selects it and brings it into the picture.
void jumpToMuscle(EditorState& state, PrimitiveId primitive);
void jumpToBone(EditorState& state, int bone);

/// What is to be written of the preferences: with the layout as it stands.
[[nodiscard]] Preferences currentPreferences(const EditorState& state);

}  // namespace sinew::app
