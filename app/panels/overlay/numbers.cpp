// app/panels/overlay/numbers.cpp: frame times and counts over the picture.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/panels/overlay/overlay.h"

namespace sinew::app {
namespace {

constexpr float kWidth = 208.0f;  // Design pixels.
constexpr float kGraphHeight = 34.0f;
constexpr std::size_t kTimeRows = 11;

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

constexpr double kSmoothFrame = 1000.0 / 60.0;  ///< Milliseconds; the line to stay under.

/// Frames of the last seconds, oldest left; the line is a sixtieth of a second.
void graph(PanelUi& ui) {
  const FrameStats& stats = ui.state.session.stats;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ui.px(kGraphHeight);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, palette::kBackground.faded(0.7f).packed(),
                     ui.px(3));
  // Both the line and the worst frame are in sight.
  const double top = std::max(stats.worst(), kSmoothFrame) * 1.15;
  const auto heightOf = [&](double ms) { return corner.y + height * (1.0f - static_cast<float>(ms / top)); };
  std::vector<ImVec2> points;
  for (int i = 0; i < stats.count(); ++i) {
    const float x = stats.count() > 1 ? static_cast<float>(i) / static_cast<float>(stats.count() - 1) : 1.0f;
    points.push_back({corner.x + x * width, heightOf(stats.at(i))});
  }
  list.PushClipRect(corner, {corner.x + width, corner.y + height}, true);
  const float line = heightOf(kSmoothFrame);
  list.AddLine({corner.x, line}, {corner.x + width, line}, palette::kGood.faded(0.55f).packed(), 1.0f);
  list.AddPolyline(points.data(), static_cast<int>(points.size()), palette::kAccent.packed(), ImDrawFlags_None,
                   ui.px(1.4f));
  const char* label = "16.7";
  const float letters = 0.8f * ImGui::GetFontSize();
  const float above = line - letters - 1.0f;
  const ImVec2 at{corner.x + width - 2.2f * letters, above > corner.y ? above : line + 1.0f};
  list.AddRectFilled({at.x - ui.px(2), at.y}, {corner.x + width, at.y + letters},
                     palette::kBackground.faded(0.8f).packed(), ui.px(2));
  list.AddText(ImGui::GetFont(), letters, at, palette::kGood.faded(0.9f).packed(), label);
  list.PopClipRect();
  ImGui::Dummy({width, height});
}

void times(PanelUi& ui) {
  const FrameStats& stats = ui.state.session.stats;
  char text[64];
  std::snprintf(text, sizeof text, "%.0f fps", stats.framesPerSecond());
  row(text, milliseconds(stats.now()) + " ms");
  row("median, worst", milliseconds(stats.median()) + ", " + milliseconds(stats.worst()));
  graph(ui);
  const std::array stages{std::pair{"prepare", stats.prepare},    std::pair{"skin", stats.stages.skin},
                          std::pair{"patch", stats.stages.patch}, std::pair{"project", stats.stages.project},
                          std::pair{"folds", stats.stages.folds}, std::pair{"normals", stats.stages.normals},
                          std::pair{"upload", stats.upload},      std::pair{"draw", stats.draw},
                          std::pair{"interface", stats.ui}};
  for (const auto& [name, seconds] : stages) row(name, milliseconds(seconds * 1e3));
}

/// Names and values, from top to bottom.
std::vector<std::pair<const char*, std::string>> counts(const SmoothingReport& report, bool culling) {
  std::vector<std::pair<const char*, std::string>> rows{{"triangles", grouped(report.refinedTriangles)},
                                                        {"vertices", grouped(report.refinedVertices)},
                                                        {"depth", std::to_string(report.depth)},
                                                        {"muscles", grouped(report.primitives)},
                                                        {"projected", grouped(report.projected)},
                                                        {"implicit", grouped(report.implicitTriangles)},
                                                        {"straddling", grouped(report.straddlingTriangles)},
                                                        {"normal", grouped(report.normalTriangles)}};
  const int all = report.implicitTriangles + report.straddlingTriangles + report.normalTriangles;
  if (culling) rows.emplace_back("culled", grouped(report.culledTriangles) + " of " + grouped(all));
  if (report.unresolved > 0) rows.emplace_back("unresolved", grouped(report.unresolved));
  return rows;
}

constexpr const char* kAuto = "auto";

ImVec2 autoDepthSize(PanelUi& ui) { return {ImGui::CalcTextSize(kAuto).x + ui.px(10), ImGui::GetTextLineHeight()}; }

/// Beside the word depth: whether it follows the size on screen. @return its place on the screen.
ImVec2 drawAutoDepth(PanelUi& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 corner{at.x + ImGui::CalcTextSize("depth").x + ui.px(8), at.y};
  const ImVec2 size = autoDepthSize(ui);
  const bool on = action("view/auto-depth").checked(ui.state);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Tint back = on ? palette::kAccent.faded(0.28f) : palette::kText.faded(0.08f);
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, back.packed(), ui.px(3));
  list.AddText({corner.x + ui.px(5), corner.y}, (on ? palette::kText : palette::kMuted).packed(), kAuto);
  return corner;
}

/// The numbers let the mouse through to the picture, so what is pressed lies in the viewport behind them.
void pressAutoDepth(PanelUi& ui, const ImVec2& corner) {
  ImGui::SetCursorScreenPos(corner);
  const bool pressed = ImGui::InvisibleButton("auto-depth", autoDepthSize(ui));
  ui.widgets.note("overlay/auto-depth");
  tooltip(ui, tooltipOf(ui, action("view/auto-depth")));
  if (pressed) run(action("view/auto-depth"), ui.state);
}

}  // namespace

void drawNumbers(PanelUi& ui) {
  if (!ui.state.view.layout.overlay) return;
  const auto lines = counts(ui.state.live->surface().report, ui.state.view.display.cullBackFaces);
  ImGui::PushFont(ui.fonts.mono);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.80f));
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float height = static_cast<float>(kTimeRows + lines.size()) * line + ui.px(kGraphHeight + 3 + 14 + 8);
  ImGui::SetCursorPos({ui.state.frame.viewport.z - ui.px(kWidth + 10), ui.px(54)});
  ImGui::BeginChild("numbers", {ui.px(kWidth), height}, true,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysUseWindowPadding);
  times(ui);
  ImGui::Dummy({0.0f, ui.px(2)});
  ImVec2 depth{0.0f, 0.0f};
  for (const auto& [name, value] : lines) {
    if (std::string_view(name) == "depth") depth = drawAutoDepth(ui);
    row(name, value);
  }
  ImGui::EndChild();
  ui.widgets.note("overlay/numbers");
  pressAutoDepth(ui, depth);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

}  // namespace sinew::app
