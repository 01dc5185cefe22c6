// app/panels/export_status.cpp: the background export in the status line, and the legend of View > Export error.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "app/editor/export_error.h"
#include "app/panels/overlay.h"
#include "app/viewport/render/color_scales.h"

namespace sinew::app {
namespace {

constexpr float kWidestName = 240.0f;  // Design pixels, as all here.
constexpr float kExportStatusBar = 120.0f;
constexpr float kBarHeight = 6.0f;
constexpr float kExportStatusGap = 8.0f;
constexpr float kButton = 20.0f;
constexpr double kLookSeconds = 0.1;  // Between updates of the progress.

struct Words {
  std::string name;
  std::string done;  ///< "45 %"
  std::string more;  ///< "+2"; "": no other export waits.
};

Words exportWordsFor(PanelUi& ui, const std::vector<ExportStand>& stands) {
  Words words;
  words.name = fitted(stands.front().file.filename().string(), ui.px(kWidestName));
  words.done = std::to_string(static_cast<int>(100.0 * stands.front().share)) + " %";
  if (stands.size() > 1) words.more = "+" + std::to_string(stands.size() - 1);
  return words;
}

float widthOf(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

/// Width of the longest text, so that nothing moves.
float doneWidth() { return widthOf("100 %"); }

std::string hintFor(const EditorState& state, const std::vector<ExportStand>& stands) {
  std::string hint = (stands.front().canceled ? "Stopping " : "Exporting ") + stands.front().file.string();
  for (std::size_t i = 1; i < stands.size(); ++i) hint += "\nthen " + stands[i].file.string();
  return state.session.quitAfterExports ? hint + "\nThe editor closes when it is done." : hint;
}

void drawBar(PanelUi& ui, const ExportStand& stand) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float top = at.y + 0.5f * (ImGui::GetTextLineHeight() - ui.px(kBarHeight));
  const ImVec2 low{at.x, top};
  const ImVec2 high{at.x + ui.px(kExportStatusBar), top + ui.px(kBarHeight)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, palette::kLine.packed(), 0.5f * ui.px(kBarHeight));
  const float filled = static_cast<float>(stand.share) * ui.px(kExportStatusBar);
  if (filled >= 1.0f) {
    list.AddRectFilled(low, {low.x + filled, high.y}, (stand.canceled ? palette::kMuted : palette::kAccent).packed(),
                       0.5f * ui.px(kBarHeight));
  }
  ImGui::Dummy({ui.px(kExportStatusBar), ImGui::GetTextLineHeight()});
}

/// "fox.glb: largest 6.9 %"
std::string shortText(const EditorState& state) {
  const LastExport& last = *state.session.exportError.last;
  const std::string text = largestErrorText(state);
  return last.file.filename().string() + ": " + text.substr(0, text.find(" in \""));
}

/// The largest error of the last export; a click shows it.
void drawLastExport(PanelUi& ui) {
  if (!hasExportError(ui.state)) return;
  const std::string text = shortText(ui.state);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("##last-export", {widthOf(text), ImGui::GetTextLineHeight()});
  const bool over = ImGui::IsItemHovered();
  ui.widgets.note("status/export-error");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto color = (over ? palette::kText : palette::kAccent).packed();
  list.AddText(at, color, text.c_str());
  const float line = at.y + ImGui::GetTextLineHeight();
  if (over) list.AddLine({at.x, line}, {at.x + widthOf(text), line}, color);
  const std::string whole = largestErrorText(ui.state);
  tooltip(ui, ui.state.session.exportError.last->file.string() + "\n" + whole + "\nClick to see it in the picture.");
  if (clicked) showLargestError(ui.state);
}

}  // namespace

float exportStatusWidth(PanelUi& ui) {
  const std::vector<ExportStand> stands = ui.state.session.exports.stands();
  if (stands.empty()) return hasExportError(ui.state) ? widthOf(shortText(ui.state)) : 0.0f;
  const Words words = exportWordsFor(ui, stands);
  const float more = words.more.empty() ? 0.0f : widthOf(words.more) + ui.px(kExportStatusGap);
  return widthOf(words.name) + ui.px(kExportStatusBar + kButton + 3.0f * kExportStatusGap) + doneWidth() + more;
}

void drawExportStatus(PanelUi& ui) {
  const std::vector<ExportStand> stands = ui.state.session.exports.stands();
  if (stands.empty()) return drawLastExport(ui);
  ui.wakeIn(kLookSeconds);
  const Words words = exportWordsFor(ui, stands);
  const std::string hint = hintFor(ui.state, stands);
  ImGui::BeginGroup();
  ImGui::TextUnformatted(words.name.c_str());
  ImGui::SameLine(0.0f, ui.px(kExportStatusGap));
  drawBar(ui, stands.front());
  ImGui::SameLine(0.0f, ui.px(kExportStatusGap));
  const float from = ImGui::GetCursorPosX();
  mutedText(words.done.c_str());
  if (!words.more.empty()) {
    ImGui::SameLine();
    ImGui::SetCursorPosX(from + doneWidth() + ui.px(kExportStatusGap));
    mutedText(words.more.c_str());
  }
  ImGui::EndGroup();
  ui.widgets.note("status/export");
  tooltip(ui, hint);
  const float right = from + doneWidth() + (words.more.empty() ? 0.0f : widthOf(words.more) + ui.px(kExportStatusGap));
  ImGui::SameLine();
  ImGui::SetCursorPosX(right + ui.px(kExportStatusGap));
  const float size = ui.px(kButton);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - 0.5f * (size - ImGui::GetTextLineHeight()));
  if (iconButton(ui, "status/export-cancel", Icon::kClose, false, size)) ui.state.session.exports.cancel();
  tooltip(ui, "Cancel this export; no file is written");
}

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

/// The scale from 0 to the largest error of all sample times.
void drawScale(PanelUi& ui, const ImVec2& at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float low = at.y + ui.px(kBar);
  drawRamp(at, width, low, kExportErrorSteps, [](float x) {
    const glm::vec3 c = heatColor(x);
    return Tint{c.r, c.g, c.b}.packed();
  });
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
  const std::string now = "at this time at most " + percent(error.largestNow);
  list.AddText({corner.x, below}, palette::kText.packed(), fitted(now, width).c_str());
  float y = below + line + ui.px(kExportErrorGap);
  ImGui::SetCursorScreenPos({corner.x, y});
  constexpr std::array<const char*, 3> kMeshes{"Live", "Exported", "Side by side"};  // The values of ExportedView.
  const int chosen = segmented(ui, "export-error/mesh", kMeshes.data(), 3, static_cast<int>(error.view), width);
  if (chosen >= 0) showExported(ui.state, static_cast<ExportedView>(chosen));
  y += ImGui::GetFrameHeight() + ui.px(kExportErrorGap);
  ImGui::SetCursorScreenPos({corner.x, y});
  const float half = 0.5f * (width - ui.px(kExportErrorGap));
  if (ImGui::Button("Go to largest", {half, 0.0f})) showLargestError(ui.state);
  ui.widgets.note("export-error/largest");
  tooltip(ui, largestErrorText(ui.state));
  ImGui::SameLine(0.0f, ui.px(kExportErrorGap));
  if (textButton(ui, "export-error/close", "Close", {half, 0.0f})) error.shown = false;
  ui.widgets.note("legend/export-error", {low.x, low.y, exportErrorSize(ui).x, exportErrorSize(ui).y});
}

}  // namespace sinew::app
