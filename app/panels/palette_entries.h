// app/panels/palette_entries.h: the entries of the palette, and what choosing one does.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/actions.h"
#include "app/editor/editor_state.h"
#include "app/panels/palette_controls.h"
#include "app/panels/palette_search.h"
#include "app/ui/icons.h"

namespace sinew::app {

/// A button of a panel, as a command.
struct PanelCommand {
  const char* id;  ///< "panel/learn"
  const char* label;
  const char* context;   ///< "Inspector: Set > Learn": panel, row and text of the button.
  const char* synonyms;  ///< Other names, separated by spaces.
  Possible (*enabled)(const EditorState&);
  void (*run)(EditorState&);
};
[[nodiscard]] std::span<const PanelCommand> panelCommands();

/// Names of the action in other programs, separated by spaces; "" for most.
[[nodiscard]] std::string_view synonymsOf(std::string_view actionId);

enum class EntryKind { kAction, kPanel, kControl, kMuscle, kGroup, kBone, kPart, kClip, kSet, kPage, kFile };

struct PaletteEntry {
  EntryKind kind = EntryKind::kAction;
  /// "file/save", "panel/learn", "control/surface/iso", "muscle/NAME", "group/NAME", "bone/NAME", "part/NAME",
  /// "clip/NAME", "set/NAME", "set/NAME/MUSCLE", "page/opening", "sample/0", "recent/0"
  std::string id;
  const Action* action = nullptr;
  const Control* control = nullptr;
  PrimitiveId muscle = {};
  std::filesystem::path file = {};
  SetEntry set = {};
  int place = -1;        ///< Index of the command (kPanel), clip (-1: bind pose), bone, part, group or help page.
  std::string why = {};  ///< Why it cannot be used now; "" if it can.
};

struct PaletteEntries {
  std::vector<PaletteEntry> entries;
  std::vector<Candidate> candidates;  ///< The same rows.
};

[[nodiscard]] PaletteEntries gatherEntries(const EditorState& state);
void chooseEntry(EditorState& state, const PaletteEntry& entry);
[[nodiscard]] Icon iconOf(const PaletteEntry& entry);

}  // namespace sinew::app
