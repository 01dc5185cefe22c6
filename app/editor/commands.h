// app/editor/commands.h: what the editor can be told to do, from any menu, key, panel or dropped file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/editor/editor_state.h"

namespace sinew::app {

// What the picture's context menu does that no other menu does.

/// What a right click was made on becomes what the menu's actions work on: a muscle that is not selected is selected
/// alone, a bone too; on nothing the selection stays.
void selectForMenu(Document& document, const ViewportHover& target);

/// Only this muscle, or only this bone.
void selectEntry(Document& document, const PickEntry& entry);

/// A muscle on the skin where the menu was asked for, as a click of the add-muscle tool makes one, in the pose of this
/// frame. One undo step. Without skin there: nothing.
void addMuscleAt(EditorState& state, const ViewportHover& target);

/// Why an action of the menu is gray; "" while it is not, or where nothing better than its hint can be said.
[[nodiscard]] std::string whyDisabled(const EditorState& state, std::string_view actionId);

/// Something is being dragged or typed: no other edit begins.
[[nodiscard]] bool isBusy(const EditorState& state);

/// Does it, or first asks what becomes of unsaved changes.
void request(EditorState& state, const Intent& intent);
void perform(EditorState& state, const Intent& intent);

void showOpenDialog(EditorState& state);
/// @param then done after a successful save.
void showSaveDialog(EditorState& state, const Intent& then);
/// Saves where the rig lies; or asks for a place, or what to do where the file has changed on disk. @return whether it
/// is saved now.
bool save(EditorState& state, const Intent& then);
/// @return an empty text, or why it failed (also a message).
std::string saveTo(EditorState& state, const std::filesystem::path& file);

void undo(EditorState& state);
void redo(EditorState& state);
void jumpTo(EditorState& state, std::size_t step);

void addMuscle(EditorState& state, int bone, ShapePreset preset = ShapePreset::kEllipsoid);
void deleteSelection(EditorState& state);
void duplicateSelection(EditorState& state);
void startRename(EditorState& state, PrimitiveId primitive);
/// One undo step. @return whether it has the name now.
bool rename(EditorState& state, PrimitiveId primitive, const std::string& name);
void selectNothing(EditorState& state);

/// Shows all of a box in the part of the picture that no panel lies over.
void frameInPicture(EditorState& state, const Bounds& boundsInWorld, bool animated);
/// Selected muscles if there are, else the whole character. @param animated false: at once.
void frameSelection(EditorState& state, bool animated);
void cycleAxes(EditorState& state);

/// What the picture asks of the surface: the eye if hidden sides are left out, and the character's size.
[[nodiscard]] SurfaceView surfaceView(const EditorState& state);

/// Rig indices of the selected primitives, ascending.
[[nodiscard]] std::vector<int> selectedIndices(const Document& document);
/// What the viewport draws for the rig: all muscles, or the selected and hovered alone.
[[nodiscard]] std::vector<PrimitiveShape> shownShapes(const EditorState& state, bool all);

}  // namespace sinew::app
