// app/panels/preferences_dialog.cpp: what the user may set for all documents.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/editor/bindings.h"
#include "app/panels/dialog_parts.h"
#include "app/panels/dialogs.h"
#include "app/ui/number_field.h"

namespace sinew::app {
namespace {

const Control kKeymap{"preferences/keymap/maya", "Keymap", "maya blender keyboard shortcuts hotkeys"};
const Control kInterfaceScale{"preferences/scale", "Size of the interface", "scale zoom font text dpi"};
const Control kMoving{"preferences/moving/automatic", "Resolution while moving", "pixels speed fast quality"};
const Control kSurfaceBy{"preferences/surface/automatic", "Surface computed by",
                         "graphics card gpu processor cpu speed fast"};
const Control kAutosave{"preferences/autosave", "Autosave", "recovery backup crash seconds"};
const Control kResetLayout{"preferences/reset-layout", "Button Reset layout", "panels sizes default"};
const Control kForget{"preferences/forget", "Clear recent files", "history forget"};

constexpr const char* kPreferencesDialogTitle = "Preferences";
constexpr float kPreferencesDialogWidth = 600.0f;  // Design pixels.
constexpr float kLabelWidth = 170.0f;
constexpr std::array kScales{0.0f, 1.0f, 1.25f, 1.5f, 1.75f, 2.0f, 2.5f, 3.0f};

void preferenceLabel(PanelUi& ui, const Control& control) { dialogLabel(ui, control.label, kLabelWidth); }
void explain(PanelUi& ui, const char* text) { dialogExplain(ui, text, kLabelWidth); }

void keymapRow(PanelUi& ui) {
  preferenceLabel(ui, kKeymap);
  drawKeymapChoice(ui, "preferences/keymap/");
  const Preferences& preferences = ui.state.session.preferences;
  std::string text = preferences.keymap == Keymap::kMaya
                         ? "Q W E R choose select, move, rotate, scale."
                         : "G R S grab, rotate, scale at once; X deletes, Shift+D duplicates.";
  if (const std::size_t changed = preferences.keyChanges().size(); changed > 0) {
    text += " You changed the keys of " + std::to_string(changed) + (changed == 1 ? " action." : " actions.");
  }
  if (const std::string key = keyText(action("help/keys"), ui.state); !key.empty())
    text += " " + key + " lists all keys.";
  explain(ui, text.c_str());
}

std::string scaleText(float scale, float system) {
  std::array<char, 48> text{};
  if (scale > 0.0f) std::snprintf(text.data(), text.size(), "%.0f %%", static_cast<double>(scale) * 100.0);
  else std::snprintf(text.data(), text.size(), "as in the system (%.0f %%)", static_cast<double>(system) * 100.0);
  return text.data();
}

void scaleRow(PanelUi& ui) {
  preferenceLabel(ui, kInterfaceScale);
  float& scale = ui.state.session.preferences.scale;
  ImGui::SetNextItemWidth(-1.0f);
  const bool open = ImGui::BeginCombo("##scale", scaleText(scale, ui.state.frame.systemScale).c_str());
  ui.widgets.note(kInterfaceScale.id);
  if (open) {
    for (std::size_t i = 0; i < kScales.size(); ++i) {
      if (ImGui::Selectable(scaleText(kScales[i], ui.state.frame.systemScale).c_str(), scale == kScales[i])) {
        scale = kScales[i];
      }
      ui.widgets.note("preferences/scale/" + std::to_string(i));
    }
    ImGui::EndCombo();
  }
  explain(ui, "Scales text, icons, spacing and handles.");
}

void resolutionRow(PanelUi& ui) {
  preferenceLabel(ui, kMoving);
  bool& full = ui.state.session.preferences.fullWhileMoving;
  constexpr std::array<const char*, 2> kChoices{"Automatic", "Full"};
  const int clicked = segmented(ui, "preferences/moving", kChoices.data(), static_cast<int>(kChoices.size()),
                                full ? 1 : 0, ImGui::GetContentRegionAvail().x);
  if (clicked >= 0) full = clicked == 1;
  tooltip(ui,
          "Automatic: on a computer without a graphics processor the picture is drawn with fewer pixels while it plays "
          "or is turned, as far as it takes for 40 pictures a second.\nFull: always with all pixels, however long "
          "that takes.");
  explain(ui, "At rest the picture always has its full resolution, and saved pictures do.");
}

void surfaceRow(PanelUi& ui) {
  preferenceLabel(ui, kSurfaceBy);
  SurfaceBy& by = ui.state.session.preferences.surfaceBy;
  constexpr std::array<const char*, 3> kChoices{"Automatic", "Processor", "Graphics card"};
  const int clicked = segmented(ui, "preferences/surface", kChoices.data(), static_cast<int>(kChoices.size()),
                                static_cast<int>(by), ImGui::GetContentRegionAvail().x);
  if (clicked >= 0) by = kSurfaceBys[static_cast<std::size_t>(clicked)];
  tooltip(ui,
          "Automatic: both are measured when a character is opened, and the faster computes what is seen.\nPicking, "
          "saved pictures and exports are the processor's, whoever draws.");
  const SurfaceMakerState& maker = ui.state.session.surfaceMaker;
  const std::string now = maker.onCard ? "Now: the graphics card" : "Now: the processor";
  explain(ui, (now + (maker.why.empty() ? "" : " (" + maker.why + ")") + ".").c_str());
}

void autosaveRow(PanelUi& ui) {
  preferenceLabel(ui, kAutosave);
  auto seconds = static_cast<float>(ui.state.session.preferences.autosaveSeconds);
  ImGui::SetNextItemWidth(-1.0f);
  const bool changed =
      numberSlider(ui, "##autosave", seconds, {"every %.0f seconds", 0.0f, 5.0f, 300.0f, 5.0f, true, true});
  ui.widgets.note(kAutosave.id);
  if (changed) ui.state.session.preferences.autosaveSeconds = static_cast<double>(std::round(seconds));
  explain(ui,
          "Unsaved changes go to a recovery file, never to the rig file. After a crash the next start offers them.");
}

void pageChoice(PanelUi& ui) {
  PreferencesPage& page = ui.state.dialogs.preferencesPage;
  constexpr std::array<const char*, 2> kPages{"General", "Keys"};
  const int clicked = segmented(ui, "preferences/page", kPages.data(), static_cast<int>(kPages.size()),
                                static_cast<int>(page), ui.px(200));
  if (clicked >= 0) {
    page = static_cast<PreferencesPage>(clicked);
    endKeyCapture(ui.state);
  }
  ImGui::Dummy({0.0f, ui.px(4)});
}

void buttons(PanelUi& ui, bool& closed) {
  const float width = ui.px(104);
  if (ImGui::Button("Reset layout")) run(action("window/reset-layout"), ui.state);
  ui.widgets.note(kResetLayout.id);
  tooltip(ui, action("window/reset-layout").hint);
  ImGui::SameLine();
  if (ImGui::Button(kForget.label)) ui.state.session.preferences.recentFiles.clear();
  ui.widgets.note(kForget.id);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  closed = accentButton("Close", {width, 0.0f});
  ui.widgets.note("preferences/close");
}

}  // namespace

void drawPreferences(PanelUi& ui) {
  if (!ui.state.dialogs.preferences) return;
  if (!ImGui::IsPopupOpen(kPreferencesDialogTitle)) ImGui::OpenPopup(kPreferencesDialogTitle);
  placeDialog(ui, kPreferencesDialogWidth);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kPreferencesDialogTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    pageChoice(ui);
    if (ui.state.dialogs.preferencesPage == PreferencesPage::kKeys) {
      drawKeysPage(ui);
    } else {
      keymapRow(ui);
      scaleRow(ui);
      resolutionRow(ui);
      surfaceRow(ui);
      autosaveRow(ui);
    }
    ImGui::Separator();
    ImGui::Dummy({0.0f, ui.px(2)});
    bool closed = false;
    buttons(ui, closed);
    if (closed || escapePressed(ui)) {
      ui.state.dialogs.preferences = false;
      endKeyCapture(ui.state);
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace sinew::app
