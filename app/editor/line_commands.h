// app/editor/line_commands.h: what menus and the inspector do to the lines of the selected muscles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// The lines that carry the selected muscles.
struct SelectedLines {
  std::vector<int> indices;  ///< Into Rig::lines, ascending, each once.
  int active = -1;           ///< The active muscle's, else the first; -1: none.
  std::size_t muscles = 0;   ///< Selected muscles that ride one.

  [[nodiscard]] bool several() const { return indices.size() > 1; }
};
[[nodiscard]] SelectedLines selectedLines(const Document& document);

/// "biceps L", or "3 lines". @param lines  into the rig, in range
[[nodiscard]] std::string namedLines(const Rig& rig, const std::vector<int>& lines);

/// Changes each; `change` must leave name and mirror alone. One refusal, and nothing is changed.
[[nodiscard]] Result<Rig> editLines(Rig rig, const std::vector<int>& lines,
                                    const std::function<void(MuscleLine&)>& change);

// One undo step each. A line for which it cannot be done is left out; if none remains, that is a refusal.
void setRestToNow(EditorState& state);  ///< The length in this pose becomes the rest length.
void setFullContractionToNow(EditorState& state);
void learnContraction(EditorState& state);  ///< From all clips and the range of motion.
void addViaPoints(EditorState& state);      ///< To the lines that have none.
void removeViaPoints(EditorState& state);
void takeOffLines(EditorState& state);              ///< The selected muscles ride their bones again.
void attachOtherEnd(EditorState& state, int bone);  ///< Of the selected muscles that ride no line.

/// Warnings about lines that have changed since go; once a frame.
void forgetSettledWarnings(EditorState& state);

}  // namespace sinew::app
