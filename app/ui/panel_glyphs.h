// app/ui/panel_glyphs.h: the small marks of outliner, groups and territory, drawn as vectors.
#pragma once

#include <string>

#include <imgui.h>

#include "app/ui/ui.h"

namespace sinew::app {

enum class Glyph {
  kEye,
  kEyeShut,
  kLock,
  kUnlocked,
  kSolo,
  kFilter,
  kMatrix,
  kGraph,
  kArrange,
  kBefore,
  kTerritory,
  kFoldOpen,
  kFoldClosed,
  kReset,
  kPlus,
};

/// Draws into a square. @param topLeft, size  screen coordinates.
void drawGlyph(ImDrawList& list, Glyph glyph, const ImVec2& topLeft, float size, ImU32 color);

/// Square button without a frame until it is hovered; lit when active. Notes itself as `id`.
bool glyphButton(Ui& ui, const std::string& id, Glyph glyph, bool active, float size, const std::string& hint);

/// Two or more words of which one is chosen, in a row that fills the width; notes itself as ID/WORD in lower case.
/// @return the index that was clicked, or -1
int segmented(Ui& ui, const std::string& id, const char* const* words, int count, int chosen, float width);

/// Text with an ellipsis in its middle if it does not fit a width, into a draw list.
void clippedText(ImDrawList& list, const ImVec2& at, float width, ImU32 color, const std::string& text);

}  // namespace sinew::app
