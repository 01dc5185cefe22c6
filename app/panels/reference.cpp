// app/panels/reference.cpp: the panel Reference picture: side, file, opacity, size and position.

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
constexpr float kLowest = 40.0f;           // Least height; the panel scrolls.
constexpr float kReferencePercent = 100.0f;

/// @return whether the panel is to close
bool headRow(PanelUi& ui) {
  ImGui::AlignTextToFramePadding();
  heading(ui, "Reference picture");
  const float button = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
  return iconButton(ui, "reference/close", Icon::kClose, false, button, "Close; the pictures stay");
}

void sideRow(PanelUi& ui) {
  const int chosen = chooseWord(ui, "reference/side", {"Front", "Back", "Left", "Right", "Top"},
                                static_cast<int>(ui.state.open.reference.side));
  if (chosen >= 0) chooseReferenceSide(ui.state, static_cast<ReferenceSide>(chosen));
}

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
    if (iconButton(ui, "reference/remove", Icon::kClose, false, button, "Remove it; the file stays")) {
      removeReference(ui.state);
    }
  }
  if (choose) showReferenceDialog(ui.state);
}

/// @param value  a fraction, shown in percent
void percentSlider(PanelUi& ui, const char* text, const char* id, float& value, NumberLook look, const char* hint) {
  beginRow(ui, text);
  ImGui::SetNextItemWidth(-1.0f);
  float percent = kReferencePercent * value;
  if (numberSlider(ui, (std::string("##") + id).c_str(), percent, look)) value = percent / kReferencePercent;
  ui.widgets.note(id);
  tooltip(ui, hint);
}

/// @param value  a fraction of the character's height
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
  const int chosen = chooseWord(ui, "reference/depth", {"Behind", "Through"}, picture.inside ? 1 : 0);
  if (chosen >= 0) picture.inside = chosen == 1;
}

void pictureRows(PanelUi& ui, ReferencePicture& picture) {
  percentSlider(ui, "Opacity", "reference/opacity", picture.opacity, {"%.0f %%", 0.0f, 0.0f, kReferencePercent, 10.0f},
                "How opaque it is");
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
  const bool hidden =
      open.check.shown || open.muscleSet.shown || open.bodyParts.shown || open.clipList.shown || open.sculptFit.shown;
  if (!reference.shown || hidden) return;
  const glm::vec4& v = ui.state.frame.viewport;
  const float width = std::min(ui.px(kReferenceWidth), v.z - ui.px(kBesideTools + kFromEdges));
  const float rows = reference.chosen().file.empty() ? 3.0f : 8.0f;
  const float wanted = rows * ImGui::GetFrameHeightWithSpacing() + ui.px(14);
  const float height = std::clamp(lowestInPicture(ui) - ui.px(kReferenceTop), ui.px(kLowest), wanted);
  beginInPicture(ui, "reference", {ui.px(kBesideTools), lowestInPicture(ui) - height}, {width, height}, 0.94f, {10, 8});
  const bool close = headRow(ui);
  sideRow(ui);
  fileRow(ui);
  if (!reference.chosen().file.empty()) pictureRows(ui, reference.chosen());
  endInPicture();
  if (close) toggleReferencePanel(ui.state);
}

}  // namespace sinew::app
