// app/panels/export_error.cpp: the plate of View > Export error.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "app/editor/export_error.h"
#include "app/panels/overlay.h"
#include "app/viewport/render/color_scales.h"

namespace sinew::app {
namespace {

constexpr float kExportErrorWidth = 300.0f;  // Design pixels, as all here.
constexpr float kPad = 12.0f;
constexpr float kExportErrorGap = 6.0f;
constexpr float kBar = 10.0f;
constexpr int kExportErrorSteps = 48;

std::string percent(float value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), value < 0.1f ? "%.2g %%" : "%.2f %%", static_cast<double>(value));
  return text.data();
}

/// From none to the largest of all moments.
void drawScale(PanelUi& ui, const ImVec2& at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto color = [](float x) {
    const glm::vec3 c = heatColor(x);
    return Tint{c.r, c.g, c.b}.packed();
  };
  const float low = at.y + ui.px(kBar);
  for (int i = 0; i < kExportErrorSteps; ++i) {
    const float a = static_cast<float>(i) / kExportErrorSteps;
    const float b = static_cast<float>(i + 1) / kExportErrorSteps;
    list.AddRectFilledMultiColor({at.x + a * width, at.y}, {at.x + b * width, low}, color(a), color(b), color(b),
                                 color(a));
  }
  const float range = exportErrorRange(ui.state);
  const float now = std::clamp(ui.state.session.exportError.largestNow / range, 0.0f, 1.0f);
  const float x = at.x + now * width;
  list.AddTriangleFilled({x - ui.px(4), at.y - ui.px(5)}, {x + ui.px(4), at.y - ui.px(5)}, {x, at.y + ui.px(1)},
                         palette::kText.packed());
  const std::string most = percent(range);
  list.AddText({at.x, low + ui.px(2)}, palette::kMuted.packed(), "0");
  list.AddText({at.x + width - ImGui::CalcTextSize(most.c_str()).x, low + ui.px(2)}, palette::kMuted.packed(),
               most.c_str());
}

}  // namespace

ImVec2 exportErrorSize(PanelUi& ui) {
  const float line = ImGui::GetTextLineHeight();
  const float room = ui.state.frame.viewport.z - ui.px(20);
  return {std::min(ui.px(kExportErrorWidth), room),
          3.0f * line + 2.0f * ImGui::GetFrameHeight() + ui.px(kBar + 2 * kPad + 24)};
}

void drawExportError(PanelUi& ui, const ImVec2& low) {
  ExportErrorState& error = ui.state.session.exportError;
  const float width = exportErrorSize(ui).x - ui.px(2 * kPad);
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 corner{low.x + ui.px(kPad), low.y + ui.px(kPad)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string title = "Error of " + error.last->file.filename().string() + ", percent of the height";
  list.AddText(corner, palette::kMuted.packed(), fitted(title, width).c_str());
  drawScale(ui, {corner.x, corner.y + line + ui.px(10)}, width);
  const float below = corner.y + 2.0f * line + ui.px(14 + kBar);
  const std::string now = "in this moment at most " + percent(error.largestNow);
  list.AddText({corner.x, below}, palette::kText.packed(), fitted(now, width).c_str());

  float y = below + line + ui.px(kExportErrorGap);
  ImGui::SetCursorScreenPos({corner.x, y});
  constexpr std::array<const char*, 3> kMeshes{"Live", "Exported", "Side by side"};  // As ExportedView.
  const int chosen = segmented(ui, "export-error/mesh", kMeshes.data(), 3, static_cast<int>(error.view), width);
  if (chosen >= 0) showExported(ui.state, static_cast<ExportedView>(chosen));
  y += ImGui::GetFrameHeight() + ui.px(kExportErrorGap);
  ImGui::SetCursorScreenPos({corner.x, y});
  const float half = 0.5f * (width - ui.px(kExportErrorGap));
  if (ImGui::Button("Go to largest", {half, 0.0f})) showLargestError(ui.state);
  ui.widgets.note("export-error/largest");
  tooltip(ui, largestErrorText(ui.state));
  ImGui::SameLine(0.0f, ui.px(kExportErrorGap));
  if (ImGui::Button("Close", {half, 0.0f})) error.shown = false;
  ui.widgets.note("export-error/close");
  ui.widgets.note("legend/export-error", {low.x, low.y, exportErrorSize(ui).x, exportErrorSize(ui).y});
}

}  // namespace sinew::app
