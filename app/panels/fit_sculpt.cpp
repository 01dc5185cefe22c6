// app/panels/fit_sculpt.cpp: the panel of Muscles > Fit to a sculpt: how far muscles may go, progress, what is left.

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/document/shown_names.h"
#include "app/editor/fit_sculpt_commands.h"
#include "app/panels/dialogs.h"
#include "app/panels/overlay.h"
#include "app/ui/number_field.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

constexpr float kFitWidth = 340.0f;  // Design pixels, as all here.
constexpr float kFitLabels = 84.0f;
constexpr float kFitRows = 5.0f;  // Besides two lines of text.

void fitLabel(PanelUi& ui, const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(ui.px(kFitLabels));
  ImGui::SetNextItemWidth(-1.0f);
}

void drawFitOptions(PanelUi& ui) {
  SculptFitState& fit = ui.state.open.sculptFit;
  fitLabel(ui, "Keep");
  NumberLook look{"%.2f", 0.01f, kLeastHold, kMostHold, 0.0f};
  look.logarithmic = true;
  static_cast<void>(numberSlider(ui, "##hold", fit.hold, look));
  ui.widgets.note("fit-sculpt/hold");
  tooltip(ui, "1 keeps my muscles, 0.01 matches the sculpt");
  fitLabel(ui, "Carves");
  static_cast<void>(countSlider(ui, "fit-sculpt/carves", fit.carves, "%.0f", 0, 20));
  tooltip(ui, "At most so many carves are added where the sculpt is lower than the skin");
  ImGui::Checkbox("Both sides alike", &fit.mirror);
  ui.widgets.note("fit-sculpt/mirror");
  tooltip(ui, "Twins stay mirror images; otherwise each side follows its own side of the sculpt");
  ImGui::SameLine();
  ImGui::BeginDisabled(!fitIsCurrent(ui.state));
  ImGui::Checkbox("Show what is left", &fit.showsLeft);
  ImGui::EndDisabled();
  ui.widgets.note("fit-sculpt/left");
  tooltip(ui, "Color the skin by how far the sculpt is above or below it");
}

std::string percent(double share) {
  char text[24];
  std::snprintf(text, sizeof text, "%.0f %%", 100.0 * share);
  return text;
}

std::string fitSummary(const EditorState& state) {
  const SculptFitState& fit = state.open.sculptFit;
  if (!fit.complaint.empty()) return fit.complaint;
  if (isFitting(state)) return "Fitting: " + percent(fitShare(state));
  if (!fit.result) return "Not fitted yet";
  if (!fitIsCurrent(state)) return "The rig has changed since it was fitted";
  return "Explained " + percent(fit.result->after.explained) + ", before " + percent(fit.result->before.explained);
}

std::string fitDetails(const EditorState& state) {
  const SculptFitState& fit = state.open.sculptFit;
  if (showsLeft(state)) return "Red: the sculpt is 1 % of the height higher; blue: lower";
  if (!fit.result) return "";
  char text[64];
  std::snprintf(text, sizeof text, "%.2f %% of the height left; check: ", 100.0 * fit.result->after.rms);
  return text + (fit.findings.empty() ? std::string("nothing found") : withCount(fit.findings.size(), "finding"));
}

}  // namespace

void drawFitSculpt(PanelUi& ui) {
  EditorState& state = ui.state;
  SculptFitState& fit = state.open.sculptFit;
  if (!fit.shown) return;
  const float width = widthInPicture(ui, kFitWidth);
  const float height =
      kFitRows * ImGui::GetFrameHeightWithSpacing() + 2.0f * ImGui::GetTextLineHeightWithSpacing() + ui.px(12);
  beginInPicture(ui, "fit-sculpt", {ui.px(kBesideTools), std::max(lowestInPicture(ui) - height, 0.0f)}, {width, height},
                 0.94f, {10, 8}, ImGuiWindowFlags_NoScrollbar);
  fitLabel(ui, "Sculpt");
  ImGui::TextUnformatted(
      fitted(inReadingOrder(fit.file.filename().string()), ImGui::GetContentRegionAvail().x).c_str());
  ui.widgets.note("fit-sculpt/file");
  tooltip(ui, fit.file.string());
  drawFitOptions(ui);
  const std::string summary = fitSummary(state);
  mutedText(fitted(summary, ImGui::GetContentRegionAvail().x).c_str());
  ui.widgets.note("fit-sculpt/summary");
  tooltip(ui, summary);
  const std::string details = fitDetails(state);
  mutedText(fitted(details, ImGui::GetContentRegionAvail().x).c_str());
  if (!details.empty()) tooltip(ui, details);
  const bool fitting = isFitting(state);
  const bool pressed = fitting ? textButton(ui, "fit-sculpt/cancel", "Cancel", {}, "Leave the muscles as they are")
                               : textButton(ui, "fit-sculpt/fit", "Fit again", {}, "Fit with these settings");
  ImGui::SameLine();
  const bool other = textButton(ui, "fit-sculpt/other", "Another sculpt...");
  ImGui::SameLine();
  const bool closed = textButton(ui, "fit-sculpt/close", "Done", {}, "Keep the muscles and close this");
  endInPicture();
  if (fitting) ui.wakeIn(0.1);
  if (pressed && fitting) cancelFit(state);
  else if (pressed) startFit(state);
  if (other) showSculptDialog(state);
  if (closed) closeFit(state);
}

}  // namespace sinew::app
