// app/panels/menu_bar.cpp: the action table as menus.

#include <imgui.h>

#include <string>

#include "app/panels/panels.h"

namespace sinew::app {
namespace {

void drawItems(Ui& ui, const Menu& menu) {
  bool first = true;
  for (const Action& item : actions()) {
    if (item.menu() != menu.id) continue;
    if (item.separatorBefore && !first) ImGui::Separator();
    first = false;
    const bool checked = item.checked != nullptr && item.enabled(ui.state) && item.checked(ui.state);
    const bool chosen =
        ImGui::MenuItem(item.label, ("   " + textOf(item.shortcut)).c_str(), checked, item.enabled(ui.state));
    ui.widgets.note(item.id);
    if (chosen) run(item, ui.state);
  }
}

}  // namespace

float drawMenuBar(Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(8), ui.px(6)});
  float height = 0.0f;
  if (ImGui::BeginMainMenuBar()) {
    height = ImGui::GetWindowSize().y;
    for (const Menu& menu : menus()) {
      const bool open = ImGui::BeginMenu(menu.title);
      ui.widgets.note(std::string("menu/") + menu.id);
      if (!open) continue;
      drawItems(ui, menu);
      ImGui::EndMenu();
    }
    const std::string name = ui.state.document.name() + (ui.state.document.commands.modified() ? " *" : "");
    ImGui::SameLine(0.5f * (ImGui::GetWindowWidth() - ImGui::CalcTextSize(name.c_str()).x));
    if (ui.state.hasCharacter()) mutedText(name.c_str());
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar();
  return height;
}

}  // namespace sinew::app
