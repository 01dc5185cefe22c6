// app/ui/widget_log.cpp: where every control is on the screen.

#include "app/ui/widget_log.h"

#include <imgui.h>

#include <algorithm>

namespace sinew::app {

void WidgetLog::beginFrame() {
  rectangles_.clear();
  repeated_.clear();
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
  // A sliver cannot be clicked: its centre would lie on the edge of what covers the rest.
  if (right - x < 3.0f || bottom - y < 3.0f) return;
  note(id, {x, y, right - x, bottom - y});
}

void WidgetLog::note(const std::string& id, const glm::vec4& rectangle) {
  if (!rectangles_.emplace(id, rectangle).second) repeated_.push_back(id);
}

}  // namespace sinew::app
