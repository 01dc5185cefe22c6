// app/ui/keyboard_focus.cpp: ImGui's gamepad navigation, fed with keys while the ring is shown. Its keyboard navigation
// stays off: it would always take arrows and Space, and its Tab knows fields only.
#include "app/ui/keyboard_focus.h"

#include <imgui.h>
#include <imgui_internal.h>  // Which item has the keyboard, and open popups.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <vector>

namespace sinew::app {
namespace {

struct NavigationKey {
  int key;
  ImGuiNavInput_ meaning;
};
constexpr NavigationKey kNavigationKeys[] = {
    {GLFW_KEY_LEFT, ImGuiNavInput_DpadLeft},  {GLFW_KEY_RIGHT, ImGuiNavInput_DpadRight},
    {GLFW_KEY_UP, ImGuiNavInput_DpadUp},      {GLFW_KEY_DOWN, ImGuiNavInput_DpadDown},
    {GLFW_KEY_SPACE, ImGuiNavInput_Activate}, {GLFW_KEY_ENTER, ImGuiNavInput_Activate},
    {GLFW_KEY_ENTER, ImGuiNavInput_Input},    {GLFW_KEY_KP_ENTER, ImGuiNavInput_Activate},
    {GLFW_KEY_KP_ENTER, ImGuiNavInput_Input},
};

int keyOf(const RawInput& input) { return input.pressedKey >= 0 ? input.pressedKey : input.repeatedKey; }

bool typesText() { return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive(); }

ImGuiWindow* frontPopup() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.OpenPopupStack.empty() ? nullptr : context.OpenPopupStack.back().Window;
}

bool menuIsOpen() {
  const ImGuiWindow* const popup = frontPopup();
  return popup != nullptr && (popup->Flags & ImGuiWindowFlags_Modal) == 0;
}

/// Controls for Tab, in drawing order.
std::vector<const LaidOut*> reachable(const WidgetLog& controls) {
  const ImGuiWindow* const popup = frontPopup();
  std::vector<const LaidOut*> all;
  for (const LaidOut& control : controls.laidOut()) {
    if (control.item == 0 || !control.usable || control.whole.z < 1.0f || control.whole.w < 1.0f) continue;
    const ImGuiWindow* const window = ImGui::FindWindowByName(control.window.c_str());
    if (window == nullptr || !window->WasActive) continue;
    if (popup != nullptr && window->RootWindow != popup->RootWindow) continue;
    if (popup == nullptr && (window->RootWindow->Flags & ImGuiWindowFlags_Popup) != 0) continue;
    // Skips what is cut off and cannot be scrolled to.
    const bool seen = control.visible.z >= 3.0f && control.visible.w >= 3.0f;
    if (!seen && !control.scrollsX && !control.scrollsY) continue;
    if (std::ranges::find(all, control.item, &LaidOut::item) == all.end()) all.push_back(&control);
  }
  return all;
}

std::size_t nextOf(const std::vector<const LaidOut*>& all, std::size_t now, bool back, bool panels) {
  const std::size_t step = back ? all.size() - 1 : 1;
  std::size_t next = (now + step) % all.size();
  if (!panels) return next;
  const auto panelOf = [&](std::size_t i) { return ImGui::FindWindowByName(all[i]->window.c_str())->RootWindow; };
  while (next != now && panelOf(next) == panelOf(now)) next = (next + step) % all.size();
  // Backwards as well, to the panel's first control.
  while (back && next > 0 && panelOf(next - 1) == panelOf(next)) --next;
  return next;
}

}  // namespace

bool focusShown() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.NavId != 0 && context.NavWindow != nullptr && !context.NavDisableHighlight;
}

void feedFocusKeys(const RawInput& input) {
  ImGuiIO& io = ImGui::GetIO();
  if (input.pressedButton >= 0) ImGui::GetCurrentContext()->NavDisableHighlight = true;
  const bool takes = (focusShown() || menuIsOpen()) && !typesText();
  if (takes) io.ConfigFlags |= ImGuiConfigFlags_NavEnableGamepad;
  else io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableGamepad;
  io.BackendFlags |= ImGuiBackendFlags_HasGamepad;
  if (!takes || input.control || input.alt || input.super) return;
  for (const NavigationKey& key : kNavigationKeys) {
    if (key.key == keyOf(input)) io.NavInputs[key.meaning] = 1.0f;
  }
}

bool moveFocus(WidgetLog& controls, const RawInput& input) {
  ImGui::GetCurrentContext()->NavWindowingTarget = nullptr;  // Disables ImGui's Ctrl+Tab, which switches windows.
  const int key = keyOf(input);
  if (key < 0 || input.alt || input.super || typesText()) return false;
  if (key != GLFW_KEY_TAB) {
    const auto isOurs = [key](const NavigationKey& each) { return each.key == key; };
    return focusShown() && !input.control && std::ranges::any_of(kNavigationKeys, isOurs);
  }
  ImGui::NavMoveRequestCancel();  // ImGui's own Tab.
  const std::vector<const LaidOut*> all = reachable(controls);
  if (all.empty()) return true;
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const auto now = std::ranges::find(all, context.NavId, &LaidOut::item);
  std::size_t next = input.shift ? all.size() - 1 : 0;
  // The ring first appears at the item that the mouse used last.
  if (now != all.end()) {
    const auto place = static_cast<std::size_t>(now - all.begin());
    next = focusShown() ? nextOf(all, place, input.shift, input.control) : place;
  }
  controls.focusOn(all[next]->item);
  return true;
}

bool dropFocus() {
  if (!focusShown()) return false;
  ImGui::GetCurrentContext()->NavDisableHighlight = true;
  return true;
}

std::string focusedControl(const WidgetLog& controls) {
  if (!focusShown()) return "";
  const auto& all = controls.laidOut();
  const auto found = std::ranges::find(all, ImGui::GetCurrentContext()->NavId, &LaidOut::item);
  return found == all.end() ? "" : found->id;
}

void drawFocus(const Ui& ui) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!focusShown()) return;
  const auto& all = ui.widgets.laidOut();
  const auto found = std::ranges::find(all, context.NavId, &LaidOut::item);
  if (found == all.end() || found->visible.z < 1.0f || found->visible.w < 1.0f) return;
  const glm::vec4& box = found->visible;
  const float room = ui.px(1.5f);
  ImGui::GetForegroundDrawList()->AddRect({box.x - room, box.y - room}, {box.x + box.z + room, box.y + box.w + room},
                                          palette::kAccent.packed(), ui.px(5), 0, ui.px(2));
}

}  // namespace sinew::app
