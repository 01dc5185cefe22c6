// app/panels/dialog_parts.h: rows and buttons that dialogs have in common.
#pragma once

#include <imgui.h>

#include "app/ui/ui.h"

namespace sinew::app {

/// The button that Enter would mean.
[[nodiscard]] bool accentButton(const char* label, const ImVec2& size);
/// A row's name; what follows stands `width` design pixels from the left.
void dialogLabel(Ui& ui, const char* text, float width);
/// What a row means, below it, with some space after it.
void dialogExplain(Ui& ui, const char* text, float width);

}  // namespace sinew::app
