// app/panels/export_status.cpp: what is exported in the background, in the status line.

#include <imgui.h>

#include <string>
#include <vector>

#include "app/editor/export_error.h"
#include "app/panels/overlay.h"

namespace sinew::app {
namespace {

constexpr float kWidestName = 240.0f;  // Design pixels, as all here.
constexpr float kExportStatusBar = 120.0f;
constexpr float kBarHeight = 6.0f;
constexpr float kExportStatusGap = 8.0f;
constexpr float kButton = 20.0f;
constexpr double kLookSeconds = 0.1;  // Between looks at how far it is.

/// What is written beside the bar.
struct Words {
  std::string name;
  std::string share;  ///< "45 %"
  std::string more;   ///< "+2"; "": nothing waits.
};

Words wordsFor(PanelUi& ui, const std::vector<ExportStand>& stands) {
  Words words;
  words.name = fitted(stands.front().file.filename().string(), ui.px(kWidestName));
  words.share = std::to_string(static_cast<int>(100.0 * stands.front().share)) + " %";
  if (stands.size() > 1) words.more = "+" + std::to_string(stands.size() - 1);
  return words;
}

float widthOf(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

/// The widest reading, so that nothing moves while it grows.
float shareWidth() { return widthOf("100 %"); }

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

/// How far the last export is off; a click shows where.
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
  const Words words = wordsFor(ui, stands);
  const float more = words.more.empty() ? 0.0f : widthOf(words.more) + ui.px(kExportStatusGap);
  return widthOf(words.name) + ui.px(kExportStatusBar + kButton + 3.0f * kExportStatusGap) + shareWidth() + more;
}

void drawExportStatus(PanelUi& ui) {
  const std::vector<ExportStand> stands = ui.state.session.exports.stands();
  if (stands.empty()) return drawLastExport(ui);
  ui.wakeIn(kLookSeconds);
  const Words words = wordsFor(ui, stands);
  const std::string hint = hintFor(ui.state, stands);
  ImGui::BeginGroup();
  ImGui::TextUnformatted(words.name.c_str());
  ImGui::SameLine(0.0f, ui.px(kExportStatusGap));
  drawBar(ui, stands.front());
  ImGui::SameLine(0.0f, ui.px(kExportStatusGap));
  const float from = ImGui::GetCursorPosX();
  mutedText(words.share.c_str());
  if (!words.more.empty()) {
    ImGui::SameLine();
    ImGui::SetCursorPosX(from + shareWidth() + ui.px(kExportStatusGap));
    mutedText(words.more.c_str());
  }
  ImGui::EndGroup();
  ui.widgets.note("status/export");
  tooltip(ui, hint);
  const float right = from + shareWidth() + (words.more.empty() ? 0.0f : widthOf(words.more) + ui.px(kExportStatusGap));
  ImGui::SameLine();
  ImGui::SetCursorPosX(right + ui.px(kExportStatusGap));
  const float size = ui.px(kButton);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - 0.5f * (size - ImGui::GetTextLineHeight()));
  if (iconButton(ui, "status/export-cancel", Icon::kClose, false, size)) ui.state.session.exports.cancel();
  tooltip(ui, "Cancel this export; no file is written");
}

}  // namespace sinew::app
