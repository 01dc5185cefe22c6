// app/panels/panel_ui.cpp: buttons that run actions.

#include "app/panels/panel_ui.h"

#include <cstdint>

#include <imgui.h>
#include "app/viewport/render/thumbnails.h"

#include <algorithm>

namespace sinew::app {
namespace {

template <class Test>
bool anyKey(const PanelUi& ui, const Action& action, Test holds) {
  return std::ranges::any_of(shortcutsOf(action, ui.state.session.preferences),
                             [&](const Shortcut& shortcut) { return shortcut.key > 0 && holds(shortcut); });
}

}  // namespace

bool keyPressed(const PanelUi& ui, const Action& action) {
  const ImGuiIO& io = ImGui::GetIO();
  return anyKey(ui, action, [&](const Shortcut& shortcut) {
    const bool modified = shortcut.control == io.KeyCtrl && shortcut.shift == io.KeyShift && shortcut.alt == io.KeyAlt;
    return modified && ImGui::IsKeyPressed(shortcut.key, false);
  });
}

bool keyHeld(const PanelUi& ui, const Action& action) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return false;
  return anyKey(ui, action, [&](const Shortcut& shortcut) {
    const bool modified =
        (!shortcut.control || io.KeyCtrl) && (!shortcut.shift || io.KeyShift) && (!shortcut.alt || io.KeyAlt);
    return modified && ImGui::IsKeyDown(shortcut.key);
  });
}

std::string howToStart(const PanelUi& ui, const Action& action) {
  const std::string keys = keyText(action, ui.state);
  return keys.empty() ? std::string("choose ") + action.label : "press " + keys;
}

std::string tooltipOf(const PanelUi& ui, const Action& action) {
  std::string text = action.label;
  if (const std::string keys = keyText(action, ui.state); !keys.empty()) text += "  (" + keys + ")";
  return text + "\n" + hintOf(ui, action);
}

std::string hintOf(const PanelUi& ui, const Action& action) {
  const Possible possible = action.enabled(ui.state);
  return possible ? action.hint : std::string(action.hint) + "\nNot available: " + possible.reason();
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

ImTextureID thumbnailOf(const PanelUi& ui, const std::filesystem::path& document,
                        std::filesystem::file_time_type changed) {
  Thumbnails* const thumbnails = ui.state.session.thumbnails;
  const std::uintptr_t texture = thumbnails != nullptr ? thumbnails->texture(document, changed) : 0;
  return reinterpret_cast<ImTextureID>(texture);
}

}  // namespace sinew::app
