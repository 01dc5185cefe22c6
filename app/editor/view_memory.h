// app/editor/view_memory.h: a file opened again looks as it was left: clip, time, shading, camera, filters, visibility.
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/editor_state.h"
#include "core/files/json/json.h"

namespace sinew::app {

/// What is remembered of the open document. The time of a clip that plays is left out on demand: it never rests.
[[nodiscard]] Json viewToJson(const EditorState& state, bool withPlayingTime);

/// The view kept for this document's file; none for samples, which always open alike.
[[nodiscard]] std::optional<Json> rememberedView(const SessionState& session, const Document& document);
/// Keeps it now. Without a document, for a sample or where no view is to be kept: nothing. A failure is not told: the
/// next start opens the file as if for the first time.
void rememberView(const EditorState& state);

/// Clip and moment of a view. What the character does not have is as in `otherwise`.
[[nodiscard]] Transport transportOf(const Json& view, const Character& character, const Transport& otherwise);
/// All else, into a state that shows the document. What is absent, of another type or out of its range stays as it is.
void restoreView(EditorState& state, const Json& view);

}  // namespace sinew::app
