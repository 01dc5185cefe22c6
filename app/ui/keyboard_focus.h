// app/ui/keyboard_focus.h: the ring around the control that the keyboard works on, and how it moves.
//
// Tab brings it up; a press of the mouse or Esc takes it away. While it is shown it has Tab, the arrows, Space and
// Enter; otherwise these keys mean what the keymap says.
#pragma once

#include <string>

#include "app/ui/input_queue.h"
#include "app/ui/ui.h"
#include "app/ui/widget_log.h"

namespace sinew::app {

/// Before ImGui::NewFrame: arrows, Space and Enter for the control with the ring, and for menus and lists that are
/// open.
void feedFocusKeys(const RawInput& input);
/// The ring is shown.
[[nodiscard]] bool focusShown();
/// After NewFrame, with the controls of the last frame: Tab moves the ring to the next control, Ctrl+Tab to the next
/// panel, with Shift back; within the dialog or menu that is in front. @return whether the ring has this frame's key.
bool moveFocus(WidgetLog& controls, const RawInput& input);
/// Takes it away. @return whether it was shown
bool dropFocus();
/// Name of the control with the ring; "" without one.
[[nodiscard]] std::string focusedControl(const WidgetLog& controls);
/// After all panels.
void drawFocus(const Ui& ui);

}  // namespace sinew::app
