// app/editor/blending_edit.h: what the two views of the blending graph do to the rig, and their colors.
#pragma once

#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "app/ui/style.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// Which bones' skin a muscle may move: the mode, the edits, the tint.

/// Clicks on bones, in the picture and in the outliner, change the active muscle's territory.
[[nodiscard]] bool editsTerritory(const EditorState& state);
void toggleTerritoryMode(EditorState& state);
void endTerritoryMode(ViewportTools& tools);

/// Back to the default: the muscle's bone, the one above it and those below.
[[nodiscard]] Result<Rig> withDefaultTerritory(const Rig& rig, const std::vector<int>& indices);

/// One undo step; a refusal is said as refuse() does.
void toggleTerritoryBone(EditorState& state, int bone);

/// [bones of the territory], ascending; of the mode's muscle. Empty if the mode is off.
[[nodiscard]] std::vector<int> shownTerritory(const EditorState& state);
/// [V] 0..1, how much of the muscle each control vertex takes; empty if the mode is off.
[[nodiscard]] std::vector<float> shownTerritoryWeights(const EditorState& state);

/// The color a group has everywhere, by its place in Rig::groups (document/group_colors.h); muted for -1.
[[nodiscard]] Tint groupTint(const Rig& rig, int group);
/// By name; muted for a group that is not there.
[[nodiscard]] Tint groupTint(const Rig& rig, const std::string& group);
/// What is within a territory, in every panel as in the picture.
[[nodiscard]] Tint territoryTint();

/// Whether two groups are linked.
[[nodiscard]] bool areLinked(const Rig& rig, const std::string& a, const std::string& b);
/// [groups][groups] the same for all, symmetric, by index.
[[nodiscard]] std::vector<std::vector<bool>> linkTable(const Rig& rig);

// Each is one undo step or a refusal, as edit() says.

void toggleLink(EditorState& state, int groupA, int groupB);
/// A new empty group, chosen, its name ready to be typed.
void addEmptyGroup(EditorState& state);
/// The selected muscles in a group of their own, chosen, its name ready to be typed.
void groupSelection(EditorState& state);
bool renameGroupTo(EditorState& state, GroupId group, const std::string& name);
/// The group's muscles go to `into` (an index); -1: only if it is empty.
bool removeGroupOf(EditorState& state, int group, int into);
bool moveToGroup(EditorState& state, const std::vector<int>& indices, const std::string& group);
void selectMembers(Document& document, const std::string& group);

/// The muscles that a drag of one of them takes along: all that are selected if it is among them, else it alone.
[[nodiscard]] std::vector<int> draggedMuscles(const Document& document, int grabbed);

/// Lights up the muscles of a group in the picture, for this frame.
void highlightGroup(EditorState& state, const std::string& group);

}  // namespace sinew::app
