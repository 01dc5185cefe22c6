// app/editor/blending_edit.h: edits of groups, links and territories, and their colors.
#pragma once

#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "app/ui/style.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// Territories: the bones whose skin a muscle may move.

/// Territory mode: clicks on bones in picture and outliner change the active muscle's territory.
[[nodiscard]] bool editsTerritory(const EditorState& state);
void toggleTerritoryMode(EditorState& state);
void endTerritoryMode(ViewportTools& tools);

/// The muscle's bone, its parent and its children.
[[nodiscard]] Result<Rig> withDefaultTerritory(const Rig& rig, const std::vector<int>& indices);
void toggleTerritoryBone(EditorState& state, int bone);  ///< One undo step, or a refusal.

/// Bones of the mode's muscle, ascending; empty if the mode is off.
[[nodiscard]] std::vector<int> shownTerritory(const EditorState& state);
/// [V] 0..1, influence on each control vertex; empty if the mode is off.
[[nodiscard]] std::vector<float> shownTerritoryWeights(const EditorState& state);

// Colors and links of groups.

/// By index into Rig::groups (document/group_colors.h); muted for -1.
[[nodiscard]] Tint groupTint(const Rig& rig, int group);
[[nodiscard]] Tint groupTint(const Rig& rig, const std::string& group);  ///< By name; muted for an unknown group.
[[nodiscard]] Tint territoryTint();
[[nodiscard]] Tint animationTint(const Link& link);  ///< Of a link with keys or drivers.

[[nodiscard]] std::vector<std::vector<float>> linkTable(const Rig& rig);  ///< [groups][groups] linkAmount() for all.

/// What an edit did that ended with this amount: "Link legs and torso".
[[nodiscard]] std::string linkLabel(const Rig& rig, int groupA, int groupB, float amount);
[[nodiscard]] std::string percentText(float amount);  ///< "40 %"

// Each is one undo step or a refusal.

void toggleLink(EditorState& state, int groupA, int groupB);
/// In whole percents; 0 unlinks, but a link with keys or drivers keeps 1 %.
void setLinkAmount(EditorState& state, int groupA, int groupB, float amount);
/// The link with keys or drivers between two groups, or null.
[[nodiscard]] const Link* animatedLink(const Rig& rig, int groupA, int groupB);
void addEmptyGroup(EditorState& state);   ///< Adds an empty group and starts typing its name.
void groupSelection(EditorState& state);  ///< Moves the selected muscles to a new group and starts typing its name.
bool renameGroupTo(EditorState& state, GroupId group, const std::string& name);
/// Moves the group's muscles to group `into`; -1: removes an empty group only.
bool removeGroupOf(EditorState& state, int group, int into);
bool moveToGroup(EditorState& state, const std::vector<int>& indices, const std::string& group);
void selectMembers(Document& document, const std::string& group);

/// Muscles that a drag moves: the selection if the grabbed one is in it, else that one.
[[nodiscard]] std::vector<int> draggedMuscles(const Document& document, int grabbed);

/// Highlights a group's muscles in the picture for this frame.
void highlightGroup(EditorState& state, const std::string& group);

}  // namespace sinew::app
