// app/panels/field_edit.cpp: gestures of the command stack around ImGui's items.

#include "app/panels/field_edit.h"

#include <imgui.h>
#include <imgui_internal.h>  // GetItemID, which 1.86 keeps to itself.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sinew::app {

void beginFieldEdit(PanelUi& ui, const std::string& id, const char* label) {
  ui.widgets.note(id);
  if (!ImGui::IsItemActivated()) return;
  ui.state.document.commands.beginGesture(label);
  ui.state.open.gestureItem = ImGui::GetItemID();
}

void endFieldEdit(PanelUi& ui, const std::string& label) {
  if (!ImGui::IsItemDeactivated() || ui.state.open.gestureItem != ImGui::GetItemID()) return;
  // Esc puts the text back that the field began with, which is the value rounded for reading: take the value itself.
  if (ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) {
    ui.state.document.commands.cancelGesture();
  } else {
    if (label.empty()) ui.state.document.commands.endGesture();
    else ui.state.document.commands.endGesture(label);
    sayRefusedField(ui.state);
  }
  ui.state.open.gestureItem = 0;
  ui.state.open.refusal.clear();
}

void endAbandonedEdit(EditorState& state) {
  if (state.open.gestureItem == 0 || ImGui::IsAnyItemActive()) return;
  state.document.commands.endGesture();
  state.open.gestureItem = 0;
}

}  // namespace sinew::app
