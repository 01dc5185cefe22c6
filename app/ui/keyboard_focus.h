// app/ui/keyboard_focus.h: the focus ring around the control that the keyboard operates. Tab shows it, a mouse press or
// Esc hides it; while shown it takes Tab, arrows, Space and Enter from the keymap.
#pragma once

#include <string>

#include "app/ui/input_queue.h"
#include "app/ui/ui.h"
#include "app/ui/widget_log.h"

namespace sinew::app {

/// Before ImGui::NewFrame: arrows, Space and Enter for the control with the ring and for open menus and lists.
void feedFocusKeys(const RawInput& input);
[[nodiscard]] bool focusShown();  ///< The ring is shown.
/// After NewFrame, with the controls of the last frame: Tab moves the ring to the next control, Ctrl+Tab to the next
/// panel, Shift backwards; within the front dialog or menu. @return whether the ring takes this frame's key
bool moveFocus(WidgetLog& controls, const RawInput& input);
bool dropFocus();                                                     ///< Hides the ring. @return whether it was shown
[[nodiscard]] std::string focusedControl(const WidgetLog& controls);  ///< Id of the control with the ring, or "".
void drawFocus(const Ui& ui);                                         ///< After all panels.

}  // namespace sinew::app
