// app/panels/reference.cpp: a picture to work after: from which side, which file, how and where it is shown.

#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/editor/reference_commands.h"
#include "app/panels/overlay.h"
#include "app/ui/number_field.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

constexpr float kReferenceWidth = 330.0f;  // Design pixels, as all here.
constexpr float kReferenceTop = 92.0f;     // Under the display bar and the numbers.
constexpr float kLowest = 40.0f;           // It scrolls.
constexpr float kReferencePercent = 100.0f;

/// @return whether the panel is to close
bool headRow(PanelUi& ui) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(ui.fonts.strong);
  ImGui::TextUnformatted("Reference picture");
  ImGui::PopFont();
  const float button = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
  return iconButton(ui, "reference/close", Icon::kClose, false, button, "Close; the pictures stay");
}

void sideRow(PanelUi& ui) {
  constexpr const char* kSides[] = {"Front", "Back", "Left", "Right", "Top"};
  const int chosen = segmented(ui, "reference/side", kSides, static_cast<int>(kReferenceSides),
                               static_cast<int>(ui.state.open.reference.side), ImGui::GetContentRegionAvail().x);
  if (chosen >= 0) chooseReferenceSide(ui.state, static_cast<ReferenceSide>(chosen));
}

/// The file, whether it is shown, and what takes it away.
void fileRow(PanelUi& ui) {
  ReferencePicture& picture = ui.state.open.reference.chosen();
  const bool any = !picture.file.empty();
  const float button = ImGui::GetFrameHeight();
  const float gap = ui.px(4);
  const float width = ImGui::GetContentRegionAvail().x - (any ? 2.0f * (button + gap) : 0.0f);
  const std::string name = any ? picture.file.filename().string() + (picture.pixels ? "" : " (missing)") : "Choose...";
  const bool choose =
      ImGui::Button((fitted(inReadingOrder(name), width - ui.px(12)) + "##file").c_str(), {width, 0.0f});
  ui.widgets.note("reference/file");
  tooltip(ui,
          any ? picture.file.string() + "\nClick: another picture" : "A .png, .jpg or .webp. One can be dropped, too");
  if (any) {
    ImGui::SameLine(0.0f, gap);
    if (iconButton(ui, "reference/shown", picture.shown ? Icon::kEye : Icon::kEyeShut, picture.shown, button,
                   "Show or hide it")) {
      picture.shown = !picture.shown;
    }
    ImGui::SameLine(0.0f, gap);
    if (iconButton(ui, "reference/remove", Icon::kClose, false, button, "Take it away; the file stays")) {
      removeReference(ui.state);
    }
  }
  if (choose) showReferenceDialog(ui.state);
}

/// A number in per cent. @param value  share
void percentSlider(PanelUi& ui, const char* text, const char* id, float& value, NumberLook look, const char* hint) {
  beginRow(ui, text);
  ImGui::SetNextItemWidth(-1.0f);
  float percent = kReferencePercent * value;
  if (numberSlider(ui, (std::string("##") + id).c_str(), percent, look)) value = percent / kReferencePercent;
  ui.widgets.note(id);
  tooltip(ui, hint);
}

/// In per cent of the character's height.
void offsetRow(PanelUi& ui, const char* text, const char* id, float& value, const char* hint) {
  beginRow(ui, text);
  ImGui::SetNextItemWidth(-1.0f);
  float percent = kReferencePercent * value;
  const NumberLook look{"%.1f %%", 0.1f, -kReferencePercent * kMostReferenceOffset,
                        kReferencePercent * kMostReferenceOffset, 1.0f};
  if (numberField((std::string("##") + id).c_str(), percent, look)) value = percent / kReferencePercent;
  ui.widgets.note(id);
  tooltip(ui, hint);
}

void depthRow(PanelUi& ui, ReferencePicture& picture) {
  beginRow(ui, "Depth");
  constexpr const char* kDepths[] = {"Behind", "Through"};
  const int chosen =
      segmented(ui, "reference/depth", kDepths, 2, picture.inside ? 1 : 0, ImGui::GetContentRegionAvail().x);
  if (chosen >= 0) picture.inside = chosen == 1;
}

void pictureRows(PanelUi& ui, ReferencePicture& picture) {
  percentSlider(ui, "Opacity", "reference/opacity", picture.opacity, {"%.0f %%", 0.0f, 0.0f, kReferencePercent, 10.0f},
                "How much of it is seen");
  NumberLook size{"%.1f %%", 0.0f, kReferencePercent * kLeastReferenceScale, kReferencePercent * kMostReferenceScale,
                  10.0f};
  size.logarithmic = true;
  percentSlider(ui, "Size", "reference/scale", picture.scale, size,
                "Height of the picture, in per cent of the body as it is seen from there");
  offsetRow(ui, "Right", "reference/right", picture.offset.x,
            "How far to the right, in per cent of the character's height");
  offsetRow(ui, "Up", "reference/up", picture.offset.y, "How far up, in per cent of the character's height");
  depthRow(ui, picture);
}

}  // namespace

void drawReference(PanelUi& ui) {
  ReferenceState& reference = ui.state.open.reference;
  // One panel at a time.
  const DocumentView& open = ui.state.open;
  const bool hidden = open.check.shown || open.muscleSet.shown || open.bodyParts.shown || open.clipList.shown;
  if (!reference.shown || hidden) return;
  const glm::vec4& v = ui.state.frame.viewport;
  const float width = std::min(ui.px(kReferenceWidth), v.z - ui.px(kBesideTools + kFromEdges));
  const float rows = reference.chosen().file.empty() ? 3.0f : 8.0f;
  const float wanted = rows * ImGui::GetFrameHeightWithSpacing() + ui.px(14);
  const float height = std::clamp(lowestInPicture(ui) - ui.px(kReferenceTop), ui.px(kLowest), wanted);
  ImGui::SetCursorPos({ui.px(kBesideTools), lowestInPicture(ui) - height});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.94f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::BeginChild("reference", {width, height}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  const bool close = headRow(ui);
  sideRow(ui);
  fileRow(ui);
  if (!reference.chosen().file.empty()) pictureRows(ui, reference.chosen());
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  if (close) toggleReferencePanel(ui.state);
}

}  // namespace sinew::app
