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
void rememberView(const EditorState& state);  ///< Keeps the document's view, except a sample's. Ignores failures.

/// Clip and time of a view, or `otherwise` if the character lacks the clip.
[[nodiscard]] Transport transportOf(const Json& view, const Character& character, const Transport& otherwise);
void restoreView(EditorState& state, const Json& view);  ///< Restores the rest; keeps missing and unusable values.

}  // namespace sinew::app
