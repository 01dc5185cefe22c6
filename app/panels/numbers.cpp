// app/panels/numbers.cpp: frame times and counts over the picture.

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "app/panels/panels.h"

namespace sinew::app {
namespace {

constexpr float kWidth = 208.0f;  // Design pixels.

/// 12345 -> "12,345".
std::string grouped(long long value) {
  std::string digits = std::to_string(value);
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), ",");
  }
  return digits;
}

std::string milliseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 10.0 ? "%.2f" : "%.1f", value);
  return text;
}

void row(const char* name, const std::string& value) {
  mutedText(name);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x);
  ImGui::TextUnformatted(value.c_str());
}

void graph(Ui& ui) {
  const FrameStats& stats = ui.state.stats;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ui.px(30);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, palette::kBackground.faded(0.7f).packed(),
                     ui.px(3));
  const double top = std::max(stats.worst() * 1.1, 1.0);
  std::vector<ImVec2> points;
  for (int i = 0; i < stats.count(); ++i) {
    const float x = stats.count() > 1 ? static_cast<float>(i) / static_cast<float>(stats.count() - 1) : 1.0f;
    const auto y = static_cast<float>(stats.at(i) / top);
    points.push_back({corner.x + x * width, corner.y + height * (1.0f - y)});
  }
  list.PushClipRect(corner, {corner.x + width, corner.y + height}, true);
  list.AddPolyline(points.data(), static_cast<int>(points.size()), palette::kAccent.packed(), ImDrawFlags_None,
                   ui.px(1.4f));
  list.PopClipRect();
  ImGui::Dummy({width, height});
}

void times(Ui& ui) {
  const FrameStats& stats = ui.state.stats;
  char text[64];
  std::snprintf(text, sizeof text, "%.0f fps", stats.framesPerSecond());
  row(text, milliseconds(stats.now()) + " ms");
  row("median, worst", milliseconds(stats.median()) + ", " + milliseconds(stats.worst()));
  graph(ui);
  row("skin", milliseconds(stats.stages.skin * 1e3));
  row("patch", milliseconds(stats.stages.patch * 1e3));
  row("project", milliseconds(stats.stages.project * 1e3));
  row("upload", milliseconds(stats.upload * 1e3));
  row("draw", milliseconds(stats.draw * 1e3));
}

/// Names and values, from top to bottom.
std::vector<std::pair<const char*, std::string>> counts(const SmoothingReport& report, bool culling) {
  std::vector<std::pair<const char*, std::string>> rows{
      {"triangles", grouped(report.refinedTriangles)}, {"vertices", grouped(report.refinedVertices)},
      {"depth", std::to_string(report.depth)},         {"muscles", grouped(report.primitives)},
      {"projected", grouped(report.projected)},        {"implicit", grouped(report.implicitTriangles)},
      {"straddling", grouped(report.straddlingTriangles)}, {"normal", grouped(report.normalTriangles)}};
  const int all = report.implicitTriangles + report.straddlingTriangles + report.normalTriangles;
  if (culling) rows.emplace_back("culled", grouped(report.culledTriangles) + " of " + grouped(all));
  if (report.unresolved > 0) rows.emplace_back("unresolved", grouped(report.unresolved));
  return rows;
}

}  // namespace

void drawNumbers(Ui& ui) {
  if (!ui.state.layout.overlay) return;
  const auto lines = counts(ui.state.live->surface().report, ui.state.display.cullBackFaces);
  ImGui::PushFont(ui.fonts.mono);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.80f));
  const std::size_t rows = 7 + lines.size();
  const float height = static_cast<float>(rows) * ImGui::GetTextLineHeightWithSpacing() + ui.px(30 + 3 + 14 + 8);
  ImGui::SetCursorPos({ui.state.viewport.z - ui.px(kWidth + 10), ui.px(54)});
  ImGui::BeginChild("numbers", {ui.px(kWidth), height}, true,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysUseWindowPadding);
  times(ui);
  ImGui::Dummy({0.0f, ui.px(2)});
  for (const auto& [name, value] : lines) row(name, value);
  ImGui::EndChild();
  ui.widgets.note("overlay/numbers");
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

}  // namespace sinew::app
