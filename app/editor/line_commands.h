// app/editor/line_commands.h: edits of the selected muscles' lines.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// The lines that carry the selected muscles, except for those of sheets, which follow from their sheets.
struct SelectedLines {
  std::vector<int> indices;  ///< Into Rig::lines, ascending, each once.
  int active = -1;           ///< The active muscle's, else the first; -1: none.
  std::size_t muscles = 0;   ///< Selected muscles on a line.

  [[nodiscard]] bool several() const { return indices.size() > 1; }
};
[[nodiscard]] SelectedLines selectedLines(const Document& document);
[[nodiscard]] std::vector<int> flexingLines(const Document& document);  ///< With those of sheets, ascending.

[[nodiscard]] std::string namedLines(const Rig& rig, const std::vector<int>& lines);  ///< "biceps L", or "3 lines"

/// Changes all lines, or none on a refusal. @param change  must keep name and mirror
[[nodiscard]] Result<Rig> editLines(Rig rig, const std::vector<int>& lines,
                                    const std::function<void(MuscleLine&)>& change);

// One undo step each. Skips lines that cannot change; a refusal if none can.
void setRestToNow(EditorState& state);  ///< Rest length from this pose.
void setFullContractionToNow(EditorState& state);
void learnContraction(EditorState& state);  ///< From all clips and the range of motion.
void addViaPoints(EditorState& state);      ///< To lines without one.
void removeViaPoints(EditorState& state);
void takeOffLines(EditorState& state);              ///< Selected muscles follow their bones again.
void attachOtherEnd(EditorState& state, int bone);  ///< Of selected muscles without a line.

void forgetSettledWarnings(EditorState& state);  ///< Once a frame: removes warnings about lines that have changed.

}  // namespace sinew::app
