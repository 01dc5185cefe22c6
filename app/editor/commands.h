// app/editor/commands.h: commands of menus, keys, panels and dropped files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/editor/editor_state.h"

namespace sinew::app {

[[nodiscard]] bool isBusy(const EditorState& state);  ///< Something is being dragged or typed: no other edit may begin.

void request(EditorState& state, const Intent& intent);  ///< Performs the intent, after asking about unsaved changes.
void perform(EditorState& state, const Intent& intent);

/// Opens the path dialog. @param text  in the path field
void showPathDialog(EditorState& state, DialogKind kind, const std::filesystem::path& folder,
                    const std::string& text = "");
void showOpenDialog(EditorState& state);
void showSaveDialog(EditorState& state, const Intent& then);  ///< @param then  performed after a successful save
/// Saves to the rig's file, or asks for a path, or about a file that changed on disk. @return whether it saved
bool save(EditorState& state, const Intent& then);
std::string saveTo(EditorState& state, const std::filesystem::path& file);  ///< @return "", or why not (also a message)

void undo(EditorState& state);
void redo(EditorState& state);
void jumpTo(EditorState& state, std::size_t step);

void addMuscle(EditorState& state, int bone, ShapePreset preset = ShapePreset::kEllipsoid);
void deleteSelection(EditorState& state);
void duplicateSelection(EditorState& state);
void startRename(EditorState& state, PrimitiveId primitive);
/// One undo step. @return whether the muscle has the name now
bool rename(EditorState& state, PrimitiveId primitive, const std::string& name);
void selectNothing(EditorState& state);

/// Fits a box into the uncovered part of the picture.
void frameInPicture(EditorState& state, const Bounds& boundsInWorld, bool animated);
void frameSelection(EditorState& state, bool animated);  ///< The selected muscles, else the whole character.
void cycleAxes(EditorState& state);

[[nodiscard]] SurfaceView surfaceView(const EditorState& state);  ///< The view for LiveSurface::update().

/// Rig indices of the selected primitives, ascending.
[[nodiscard]] std::vector<int> selectedIndices(const Document& document);
/// Muscles that the viewport draws: all, or the selected and hovered ones.
[[nodiscard]] std::vector<PrimitiveShape> shownShapes(const EditorState& state, bool all);

// The picture's context menu.

/// Selects what a right click was on, unless it is selected already. On nothing the selection stays.
void selectForMenu(Document& document, const ViewportHover& target);
void selectEntry(Document& document, const PickEntry& entry);  ///< Selects only this muscle or bone.
/// Adds a muscle on the skin under the click, like the add-muscle tool. One undo step.
void addMuscleAt(EditorState& state, const ViewportHover& target);
/// Why an action of the menu is disabled; "" if it is not, or if its hint says it better.
[[nodiscard]] std::string whyDisabled(const EditorState& state, std::string_view actionId);

}  // namespace sinew::app
