// app/panels/dialog_parts.cpp: rows and buttons that dialogs have in common.
#include "app/panels/dialog_parts.h"

namespace sinew::app {

bool accentButton(const char* label, const ImVec2& size) {
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.45f));
  const bool pressed = ImGui::Button(label, size);
  ImGui::PopStyleColor();
  return pressed;
}

void dialogLabel(Ui& ui, const char* text, float width) {
  ImGui::AlignTextToFramePadding();
  mutedText(text);
  ImGui::SameLine(ui.px(width));
}

void dialogExplain(Ui& ui, const char* text, float width) {
  ImGui::SetCursorPosX(ui.px(width));
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted.faded(0.8f));
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::Dummy({0.0f, ui.px(6)});
}

}  // namespace sinew::app
