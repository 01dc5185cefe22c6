// app/panels/pictures_dialog.cpp: File > Export > Turntable or contact sheet.
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "app/editor/picture_commands.h"
#include "app/panels/dialogs.h"
#include "app/ui/number_field.h"
#include "app/viewport/render/picture_files.h"

namespace sinew::app {
namespace {

bool hasClip(const EditorState& state) { return state.open.transport.clip >= 0; }

template <bool kSheet>
Possible makes(const EditorState& state) {
  return action("file/export-pictures")
      .enabled(state)
      .also(state.dialogs.pictures.sheet == kSheet,
            kSheet ? "Choose the contact sheet first" : "Choose the turntable first");
}
template <bool kSheet>
Possible makesOfClip(const EditorState& state) {
  return makes<kSheet>(state).also(hasClip(state), "Choose a clip first");
}
Possible standsStill(const EditorState& state) {
  return makes<false>(state).also(!hasClip(state) || !state.dialogs.pictures.plays, "The clip sets their number");
}

const Control kPicturesWhat{"pictures/what/turntable", "Pictures: turntable or contact sheet", "movie render make"};
const Control kPicturesMotion{"pictures/motion/this moment", "Pictures: motion", "clip plays still moment",
                              makesOfClip<false>};
const Control kPicturesTurns{"pictures/turns", "Pictures: number around", "turntable frames", standsStill};
const Control kPicturesRate{"pictures/rate", "Pictures: speed", "fps rate a second", makes<false>};
const Control kPicturesFormat{"pictures/format/.webp", "Pictures: format", "webp gif mp4 ending", makes<false>};
const Control kPicturesShows{"pictures/shows/all sides", "Pictures: sides or clip", "contact sheet", makesOfClip<true>};
const Control kPicturesCells{"pictures/columns", "Pictures: cells", "contact sheet columns rows", makes<true>};
const Control kPicturesSize{"pictures/width", "Pictures: size", "resolution width height pixels"};
const Control kPicturesFile{"pictures/place", "Pictures: file", "path folder name"};
const Control kPicturesDraw{"pictures/ok", "Pictures: draw", "start run render write"};

constexpr float kPicturesDialogWidth = 540.0f;  // Design pixels.
constexpr std::array kEndings{".webp", ".gif", ".mp4"};

void pictureLabel(PanelUi& ui, const char* text) { dialogLabel(ui, text, kExportLabels); }
void explainPictures(PanelUi& ui, const std::string& text) { dialogExplain(ui, text.c_str(), kExportLabels); }

/// Two integers side by side.
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
  bool browse = false;
  const bool entered =
      placeRow(ui, kPicturesFile.id, "File", picturesPlace(dialog), {dialog.error, dialog.overwriteAsked, browse});
  if (browse) browseForPicturesPlace(ui.state);
  return entered;
}

void drawPicturesDialogComplaint(PanelUi& ui) {
  PicturesDialogState& dialog = ui.state.dialogs.pictures;
  if (dialog.error.empty() && !dialog.overwriteAsked) return;
  dialogComplaint(dialog.error, picturesFile(dialog).filename().string() + " already exists. Replace it?");
  ui.widgets.note("pictures/complaint");
}

/// @return whether to close the dialog
bool drawEnd(PanelUi& ui, bool entered) {
  PicturesDialogState& dialog = ui.state.dialogs.pictures;
  drawPicturesDialogComplaint(ui);
  const float width = ui.px(104);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0f * width - ui.px(8));
  const bool canceled = textButton(ui, "pictures/cancel", dialog.overwriteAsked ? "Keep" : "Cancel", {width, 0.0f});
  ImGui::SameLine(0.0f, ui.px(8));
  const bool confirmed = accentButton(ui, "pictures/ok", dialog.overwriteAsked ? "Replace" : "Draw", {width, 0.0f});
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
  // The path dialog replaces it while it is open.
  if (!ui.state.dialogs.pictures.shown || ui.state.dialogs.file.kind != DialogKind::kNone) return;
  placeDialog(ui, kPicturesDialogWidth);
  drawModal(ui, "Turntable or contact sheet", [&] {
    const bool confirmed = enterConfirms();
    const bool entered = drawPicturesDialogRows(ui) || confirmed;
    const bool browsing = ui.state.dialogs.file.kind != DialogKind::kNone;
    return browsing || drawEnd(ui, entered);
  });
}

}  // namespace sinew::app
