// app/panels/pictures_dialog.cpp: File > Export > Turntable or contact sheet.
#include <imgui.h>
#include <imgui_stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "app/editor/pictures_commands.h"
#include "app/panels/dialogs.h"
#include "app/panels/panel_ui.h"
#include "app/ui/number_field.h"
#include "app/viewport/render/movie.h"

namespace sinew::app {
namespace {

constexpr float kPicturesDialogWidth = 540.0f;  // Design pixels.
constexpr std::array kEndings{".webp", ".gif", ".mp4"};

void pictureLabel(PanelUi& ui, const char* text) { dialogLabel(ui, text, kExportLabels); }
void explainPictures(PanelUi& ui, const std::string& text) { dialogExplain(ui, text.c_str(), kExportLabels); }

/// A whole number in a slider that fills the row.
void countSlider(PanelUi& ui, const char* id, int& count, const char* format, int least, int most) {
  auto shown = static_cast<float>(count);
  ImGui::SetNextItemWidth(-1.0f);
  const NumberLook look{format, 0.0f, static_cast<float>(least), static_cast<float>(most), 1.0f, true};
  if (numberSlider(ui, (std::string("##") + id).c_str(), shown, look)) count = static_cast<int>(shown);
  ui.widgets.note(id);
}

/// Two whole numbers side by side.
void pairRow(PanelUi& ui, const std::array<const char*, 2>& ids, const std::array<const char*, 2>& formats,
             glm::ivec2& pair, int least, int most) {
  const float gap = ui.px(8);
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
  for (int axis = 0; axis < 2; ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    if (axis > 0) ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(width);
    auto shown = static_cast<float>(pair[axis]);
    const NumberLook look{formats[index], 1.0f, static_cast<float>(least), static_cast<float>(most), 8.0f, true};
    if (numberField((std::string("##") + ids[index]).c_str(), shown, look)) pair[axis] = static_cast<int>(shown);
    ui.widgets.note(ids[index]);
  }
}

bool hasClip(const EditorState& state) { return state.open.transport.clip >= 0; }

void turntableRows(PanelUi& ui) {
  PicturesDialogState& dialog = ui.state.dialogs.pictures;
  if (hasClip(ui.state)) {
    pictureLabel(ui, "Motion");
    const int clicked = chooseWord(ui, "pictures/motion", {"This moment", "Clip plays"}, dialog.plays ? 1 : 0);
    if (clicked >= 0) dialog.plays = clicked == 1;
  }
  if (!dialog.plays || !hasClip(ui.state)) {
    pictureLabel(ui, "Pictures");
    countSlider(ui, "pictures/turns", dialog.turns, "%.0f around", 2, kMostTurntable);
  }
  pictureLabel(ui, "Speed");
  int rate = static_cast<int>(dialog.rate);
  countSlider(ui, "pictures/rate", rate, "%.0f a second", 1, 60);
  dialog.rate = rate;
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "Once around in %.1f s, %d pictures.", turntableSeconds(ui.state),
                pictureCount(ui.state));
  explainPictures(ui, text.data());
  pictureLabel(ui, "Format");
  const auto chosen = std::ranges::find(kEndings, dialog.ending);
  const int clicked = segmented(ui, "pictures/format", kEndings.data(), static_cast<int>(kEndings.size()),
                                static_cast<int>(chosen - kEndings.begin()), ImGui::GetContentRegionAvail().x);
  if (clicked >= 0) choosePicturesEnding(dialog, kEndings[static_cast<std::size_t>(clicked)]);
  const Result<void> able = checkMovieName(std::string("x") + dialog.ending);
  explainPictures(ui, able ? (dialog.ending == ".webp"  ? "Small and exact; browsers play it."
                              : dialog.ending == ".gif" ? "256 colors; plays anywhere."
                                                        : "A film; players and editors take it.")
                           : able.error().reason);
}

void sheetRows(PanelUi& ui) {
  PicturesDialogState& dialog = ui.state.dialogs.pictures;
  if (hasClip(ui.state)) {
    pictureLabel(ui, "Shows");
    const int clicked = chooseWord(ui, "pictures/shows", {"All sides", "The clip"}, dialog.ofClip ? 1 : 0);
    if (clicked >= 0) dialog.ofClip = clicked == 1;
  }
  pictureLabel(ui, "Cells");
  pairRow(ui, {"pictures/columns", "pictures/rows"}, {"%.0f columns", "%.0f rows"}, dialog.cells, 1, kMostCells);
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "One picture of %d x %d pixels.", dialog.cells.x * dialog.size.x,
                dialog.cells.y * dialog.size.y);
  explainPictures(ui, text.data());
}

/// @return whether Enter was pressed in the name
bool placeRow(PanelUi& ui) {
  PicturesDialogState& dialog = ui.state.dialogs.pictures;
  ExportPlace& place = picturesPlace(dialog);
  pictureLabel(ui, "File");
  const float button = ui.px(96);
  ImGui::SetNextItemWidth(-button - ui.px(8));
  const bool entered = ImGui::InputTextWithHint(
      "##name", "Name", &place.name, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note("pictures/place");
  if (ImGui::IsItemEdited()) {
    dialog.error.clear();
    dialog.overwriteAsked = false;
  }
  ImGui::SameLine(0.0f, ui.px(8));
  const bool browse = ImGui::Button("Choose...", {button, 0.0f});
  ui.widgets.note("pictures/place-browse");
  ImGui::SetCursorPosX(ui.px(kExportLabels));
  mutedLine(ui, "in " + place.folder.string());
  ImGui::Dummy({0.0f, ui.px(6)});
  if (browse) browseForPicturesPlace(ui.state);
  return entered;
}

bool drawPicturesDialogRows(PanelUi& ui) {
  PicturesDialogState& dialog = ui.state.dialogs.pictures;
  pictureLabel(ui, "Make");
  const int clicked = chooseWord(ui, "pictures/what", {"Turntable", "Contact sheet"}, dialog.sheet ? 1 : 0);
  if (clicked >= 0) {
    dialog.sheet = clicked == 1;
    dialog.error.clear();
    dialog.overwriteAsked = false;
  }
  explainPictures(ui, "As the picture is seen now: shading, light, background and height of the eye.");
  if (dialog.sheet) sheetRows(ui);
  else turntableRows(ui);
  pictureLabel(ui, dialog.sheet ? "Each" : "Size");
  pairRow(ui, {"pictures/width", "pictures/height"}, {"%.0f wide", "%.0f high"}, dialog.size, kLeastPictureSide,
          kMostPictureSide);
  ImGui::Dummy({0.0f, ui.px(4)});
  ImGui::Separator();
  ImGui::Dummy({0.0f, ui.px(4)});
  return placeRow(ui);
}

void drawPicturesDialogComplaint(PanelUi& ui) {
  PicturesDialogState& dialog = ui.state.dialogs.pictures;
  if (dialog.error.empty() && !dialog.overwriteAsked) return;
  const std::string asked = picturesFile(dialog).filename().string() + " already exists. Replace it?";
  ImGui::PushStyleColor(ImGuiCol_Text, dialog.error.empty() ? palette::kWarning : palette::kError);
  ImGui::TextWrapped("%s", dialog.error.empty() ? asked.c_str() : dialog.error.c_str());
  ImGui::PopStyleColor();
  ui.widgets.note("pictures/complaint");
}

/// @return whether the dialog is over
bool drawEnd(PanelUi& ui, bool entered) {
  PicturesDialogState& dialog = ui.state.dialogs.pictures;
  drawPicturesDialogComplaint(ui);
  const float width = ui.px(104);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0f * width - ui.px(8));
  const bool canceled = ImGui::Button(dialog.overwriteAsked ? "Keep" : "Cancel", {width, 0.0f});
  ui.widgets.note("pictures/cancel");
  ImGui::SameLine(0.0f, ui.px(8));
  const bool confirmed = accentButton(dialog.overwriteAsked ? "Replace" : "Draw", {width, 0.0f});
  ui.widgets.note("pictures/ok");
  if (confirmed || entered) return confirmPictures(ui.state);
  if (!canceled && !escapePressed(ui)) return false;
  if (dialog.overwriteAsked) {
    dialog.overwriteAsked = false;
    return false;
  }
  closePicturesDialog(ui.state.dialogs);
  return true;
}

}  // namespace

void drawPicturesDialog(PanelUi& ui) {
  // The path dialog takes its place while it is open.
  if (!ui.state.dialogs.pictures.shown || ui.state.dialogs.file.kind != DialogKind::kNone) return;
  constexpr const char* kTitle = "Turntable or contact sheet";
  if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  placeDialog(ui, kPicturesDialogWidth);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    // Enter is the button, unless it ends the typing of a number.
    const bool free = !ImGui::IsAnyItemActive();
    const bool pressed = ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) || ImGui::IsKeyPressed(GLFW_KEY_KP_ENTER, false);
    const bool entered = drawPicturesDialogRows(ui) || (free && pressed);
    const bool browsing = ui.state.dialogs.file.kind != DialogKind::kNone;
    if (browsing || drawEnd(ui, entered)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace sinew::app
