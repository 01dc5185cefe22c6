// app/panels/shared/panel_ui.cpp: buttons that run actions.

#include "app/panels/shared/panel_ui.h"

#include <imgui.h>

namespace sinew::app {

std::string tooltipOf(const PanelUi& ui, const Action& action) {
  std::string text = action.label;
  if (const std::string keys = keyText(action, ui.state); !keys.empty()) text += "  (" + keys + ")";
  return text + "\n" + action.hint;
}

void actionButton(PanelUi& ui, const std::string& id, const Action& action, Icon icon, float size) {
  const bool enabled = action.enabled(ui.state);
  const bool active = enabled && action.checked != nullptr && action.checked(ui.state);
  ImGui::BeginDisabled(!enabled);
  const bool pressed = iconButton(ui, id, icon, active, size);
  ImGui::EndDisabled();
  tooltip(ui, tooltipOf(ui, action));
  if (pressed) run(action, ui.state);
}

void actionPill(PanelUi& ui, const std::string& id, const Action& action) {
  const bool active = action.checked != nullptr && action.checked(ui.state);
  const bool pressed = pillButton(ui, id, action.label, active);
  tooltip(ui, tooltipOf(ui, action));
  if (pressed) run(action, ui.state);
}

}  // namespace sinew::app
