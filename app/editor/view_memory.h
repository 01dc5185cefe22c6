// app/editor/view_memory.h: the last view of a file: clip, time, shading, camera, filters, visibility.
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/editor_state.h"
#include "core/files/json/json.h"

namespace sinew::app {

/// The open document's view. @param withPlayingTime  with the time of a playing clip, which always changes
[[nodiscard]] Json viewToJson(const EditorState& state, bool withPlayingTime);

/// The view kept for the document's file; nullopt for samples.
[[nodiscard]] std::optional<Json> rememberedView(const SessionState& session, const Document& document);
/// Keeps the open document's view, unless it is a sample. Ignores failures.
void rememberView(const EditorState& state);

/// Clip and time of a view, or `otherwise` if the character lacks the clip.
[[nodiscard]] Transport transportOf(const Json& view, const Character& character, const Transport& otherwise);
/// Restores the rest of the view; missing and unusable values stay unchanged.
void restoreView(EditorState& state, const Json& view);

}  // namespace sinew::app
