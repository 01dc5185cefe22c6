// app/ui/widget_log.cpp: where every control is on the screen.

#include "app/ui/widget_log.h"

#include <imgui.h>
#include <imgui_internal.h>  // Windows around a window, and whether they scroll.

#include <algorithm>
#include <utility>

namespace sinew::app {
namespace {

void noteScrolling(LaidOut& item) {
  for (const ImGuiWindow* window = ImGui::GetCurrentWindow(); window != nullptr; window = window->ParentWindow) {
    item.scrollsX = item.scrollsX || window->ScrollMax.x > 0.0f;
    item.scrollsY = item.scrollsY || window->ScrollMax.y > 0.0f;
    if ((window->Flags & ImGuiWindowFlags_ChildWindow) == 0) break;
  }
}

/// Focuses the last item visibly.
void takeFocus(ImGuiWindow* window) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGui::FocusWindow(window);
  context.NavInitRequest = false;  // A new dialog would focus its first control in the next frame.
  context.NavInitResultId = 0;
  ImGui::SetFocusID(context.LastItemData.ID, window);
  context.NavDisableHighlight = false;
  context.NavDisableMouseHover = true;
}

}  // namespace

void WidgetLog::seek(const std::string& id, bool focus) {
  sought_ = id;
  focusSought_ = focus;
}

void WidgetLog::beginFrame() {
  sought_.clear();
  rectangles_.clear();
  laidOut_.clear();
}

void WidgetLog::note(const std::string& id) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 clipLow = list.GetClipRectMin();
  const ImVec2 clipHigh = list.GetClipRectMax();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float x = std::max({low.x, clipLow.x, 0.0f});
  const float y = std::max({low.y, clipLow.y, 0.0f});
  const float right = std::min({high.x, clipHigh.x, display.x});
  const float bottom = std::min({high.y, clipHigh.y, display.y});
  LaidOut item{id,
               ImGui::GetCurrentWindow()->Name,
               {low.x, low.y, high.x - low.x, high.y - low.y},
               {x, y, std::max(right - x, 0.0f), std::max(bottom - y, 0.0f)}};
  noteScrolling(item);
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  // After Begin(), the window counts as the last item.
  item.item = context.LastItemData.ID == window->MoveId ? 0 : context.LastItemData.ID;
  item.usable = (context.LastItemData.InFlags & (ImGuiItemFlags_Disabled | ImGuiItemFlags_NoNav)) == 0;
  const bool sought = !sought_.empty() && id == sought_;
  const bool focused = item.item != 0 && item.item == focusWanted_;
  if (focused) focusWanted_ = 0;
  if (item.item != 0 && (focused || (sought && focusSought_))) takeFocus(window);
  const bool cut = item.visible.z < item.whole.z - 1.0f || item.visible.w < item.whole.w - 1.0f;
  if ((sought || focused) && cut) ImGui::ScrollToBringRectIntoView(window, ImRect(low, high));
  laidOut_.push_back(std::move(item));
  if (right - x < 3.0f || bottom - y < 3.0f) return;  // Too narrow to click.
  note(id, {x, y, right - x, bottom - y});
}

void WidgetLog::note(const std::string& id, const glm::vec4& rectangle) { rectangles_.emplace(id, rectangle); }

}  // namespace sinew::app
