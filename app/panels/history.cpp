// app/panels/history.cpp: the undo steps; a click goes there.

#include <imgui.h>

#include <string>

#include "app/editor/commands.h"
#include "app/panels/panels.h"

namespace sinew::app {

void drawHistory(PanelUi& ui) {
  ImGui::BeginChild("history-steps");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  const CommandStack& commands = ui.state.document.commands;
  const std::size_t position = commands.position();
  std::size_t wanted = position;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(commands.stepCount() + 1));
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto step = static_cast<std::size_t>(row);
      ImGui::PushID(row);
      ImGui::PushStyleColor(ImGuiCol_Text, step <= position ? palette::kText : palette::kMuted.faded(0.7f));
      const std::string& label = commands.label(step);
      const std::string shown = fitted(label, ImGui::GetContentRegionAvail().x);
      if (ImGui::Selectable((shown + "##step").c_str(), step == position)) wanted = step;
      ImGui::PopStyleColor();
      ImGui::PopID();
      ui.widgets.note("history/step/" + std::to_string(step));
      if (shown != label) tooltip(ui, label);
    }
  }
  if (wanted != position) {
    jumpTo(ui.state, wanted);
  } else if (ui.state.open.historyShown != position) {
    // A new step should be seen without scrolling for it.
    const float row = ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetScrollY(row * static_cast<float>(position) - 0.5f * ImGui::GetWindowHeight());
  }
  ui.state.open.historyShown = position;
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

}  // namespace sinew::app
