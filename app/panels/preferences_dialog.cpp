// app/panels/preferences_dialog.cpp: the preferences, and the page that changes keys.

#include <imgui_stdlib.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/bindings.h"
#include "app/panels/dialogs.h"
#include "app/ui/number_field.h"
#include "core/geometry/nearest_name.h"

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
  const int clicked = chooseWord(ui, "preferences/moving", {"Automatic", "Full"}, full ? 1 : 0);
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
  const int clicked =
      chooseWord(ui, "preferences/surface", {"Automatic", "Processor", "Graphics card"}, static_cast<int>(by));
  if (clicked >= 0) by = kSurfaceBys[static_cast<std::size_t>(clicked)];
  tooltip(ui,
          "Automatic: both are measured when a character is opened, and the faster computes what is seen.\nPicking, "
          "saved pictures and exports always use the processor.");
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
  if (textButton(ui, kForget.id, kForget.label)) ui.state.session.preferences.recentFiles.clear();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  closed = accentButton(ui, "preferences/close", "Close", {width, 0.0f});
}

}  // namespace

void drawPreferences(PanelUi& ui) {
  if (!ui.state.dialogs.preferences) return;
  placeDialog(ui, kPreferencesDialogWidth);
  drawModal(ui, "Preferences", [&] {
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
    if (!closed && !escapePressed(ui)) return false;
    ui.state.dialogs.preferences = false;
    endKeyCapture(ui.state);
    return true;
  });
}

// The page Keys: every action with its keys.

namespace {

const Control kFindKeys{"preferences/keys/search", "Change a key", "shortcut hotkey keyboard binding customize"};
const Control kResetAllKeys{"preferences/keys/reset-all", "Reset all keys", "shortcut hotkey default"};

constexpr float kKeysPageListHeight = 380.0f;  // Design pixels.
constexpr float kKeyWidth = 116.0f;
constexpr float kResetWidth = 52.0f;
constexpr float kLeastHeight = 120.0f;  // Of the list, in a low window.
constexpr float kAroundList = 320.0f;   // Height of everything else.

/// Whether label, menu or one of the keys contains the searched text.
bool isFound(const PanelUi& ui, const Menu& menu, const Action& item) {
  const std::string query = lowerCase(ui.state.dialogs.keySearch);
  std::string text = std::string(item.label) + '\n' + menu.title;
  for (const Shortcut& shortcut : shortcutsOf(item, ui.state.session.preferences)) text += '\n' + textOf(shortcut);
  return lowerCase(text).find(query) != std::string::npos;
}

std::string heldModifiers() {
  const ImGuiIO& io = ImGui::GetIO();
  return std::string(io.KeyCtrl ? "Ctrl+" : "") + (io.KeyAlt ? "Alt+" : "") + (io.KeyShift ? "Shift+" : "");
}

/// The key that goes down in this frame, or the modifier that goes up, as it may begin Ctrl+K. 0: none.
int pressedKey() {
  for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
    if (isModifier(key) ? ImGui::IsKeyReleased(key) : ImGui::IsKeyPressed(key, false)) return key;
  }
  return 0;
}

void takeKey(PanelUi& ui) {
  KeyCapture& capture = ui.state.dialogs.keyCapture;
  if (capture.step == KeyCapture::Step::kNone) return;
  const ImGuiIO& io = ImGui::GetIO();
  const int key = pressedKey();
  if (key == GLFW_KEY_ESCAPE) {
    ui.escapeTaken = true;  // Must not close the dialog.
    endKeyCapture(ui.state);
  } else if (key != 0 && capture.step == KeyCapture::Step::kWaiting) {
    if (isModifier(key) && !capture.notice.empty()) return;  // The release of a refused modifier.
    if (io.KeySuper) capture.notice = "The desktop uses Super with another key.";
    else captureKey(ui.state, {key, io.KeyCtrl, io.KeyShift, io.KeyAlt});
  }
}

void searchRow(PanelUi& ui) {
  const float width = ui.px(104);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - width - ImGui::GetStyle().ItemSpacing.x);
  ImGui::InputTextWithHint("##search", "Search actions and keys", &ui.state.dialogs.keySearch);
  ui.widgets.note(kFindKeys.id);
  if (ImGui::IsItemActivated()) endKeyCapture(ui.state);
  ImGui::SameLine();
  ImGui::BeginDisabled(ui.state.session.preferences.keyChanges().empty());
  if (ImGui::Button("Reset all", {width, 0.0f})) {
    resetAllKeys(ui.state.session.preferences);
    endKeyCapture(ui.state);
  }
  ui.widgets.note(kResetAllKeys.id);
  tooltip(ui, "Give every action the keys of the keymap");
  ImGui::EndDisabled();
}

std::string noticeOf(const KeyCapture& capture) {
  if (!capture.notice.empty()) return capture.notice;
  if (capture.step == KeyCapture::Step::kNone) return "Click a key to change it. An action can have two.";
  return "Press a key for \"" + std::string(action(capture.action).label) + "\". Backspace or Del clears, Esc cancels.";
}

/// Instructions, why a key was refused, or the question. The height is fixed, so that the list does not move.
void noticeRow(PanelUi& ui) {
  const KeyCapture capture = ui.state.dialogs.keyCapture;
  const bool asking = capture.step == KeyCapture::Step::kAsking;
  const float button = ui.px(72);
  const float right = ImGui::GetContentRegionMax().x - 2.0f * button - ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float room = asking ? right - ImGui::GetCursorPosX() - ui.px(8) : ImGui::GetContentRegionAvail().x;
  const Tint tint = !capture.notice.empty()                      ? palette::kWarning
                    : capture.step == KeyCapture::Step::kWaiting ? palette::kText
                                                                 : palette::kMuted;
  clippedText(*ImGui::GetWindowDrawList(), {corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, room, tint.packed(),
              noticeOf(capture));
  ImGui::Dummy({0.0f, ImGui::GetFrameHeight()});
  if (!asking) return;
  ImGui::SameLine(right);
  if (textButton(ui, "preferences/keys/replace", "Replace", {button, 0.0f})) replaceKeys(ui.state);
  ImGui::SameLine();
  if (textButton(ui, "preferences/keys/cancel", "Cancel", {button, 0.0f})) endKeyCapture(ui.state);
}

void keyButton(PanelUi& ui, const Action& item, int slot) {
  const KeyCapture& capture = ui.state.dialogs.keyCapture;
  const bool chosen = capture.step != KeyCapture::Step::kNone && capture.action == item.id && capture.slot == slot;
  std::string text = textOf(shortcutsOf(item, ui.state.session.preferences)[static_cast<std::size_t>(slot)]);
  if (chosen && capture.step == KeyCapture::Step::kWaiting) text = heldModifiers() + "...";
  if (chosen && capture.step == KeyCapture::Step::kAsking && !capture.key.empty()) text = capture.key;
  const bool empty = text.empty();
  ImGui::PushStyleColor(ImGuiCol_Button, chosen  ? palette::kAccent.faded(0.45f)
                                         : empty ? palette::kRaised.faded(0.4f)
                                                 : palette::kRaised);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, chosen ? palette::kAccent.faded(0.45f) : palette::kLine);
  ImGui::PushID(slot);
  const bool clicked = ImGui::Button((text + "##key").c_str(), {ui.px(kKeyWidth), 0.0f});
  ImGui::PopID();
  ImGui::PopStyleColor(2);
  ui.widgets.note("preferences/keys/" + std::string(item.id) + "/" + std::to_string(slot + 1));
  if (clicked) startKeyCapture(ui.state, item, slot);
}

void actionRow(PanelUi& ui, const Action& item) {
  const bool changed = isRebound(item, ui.state.session.preferences);
  ImGui::PushID(item.id);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, changed ? palette::kAccent : palette::kText);
  ImGui::TextUnformatted(item.label);
  ImGui::PopStyleColor();
  tooltip(ui, item.hint);
  for (const int slot : {0, 1}) {
    ImGui::TableNextColumn();
    keyButton(ui, item, slot);
  }
  ImGui::TableNextColumn();
  if (changed) {
    if (ImGui::SmallButton("Reset")) requestKeyReset(ui.state, item);
    ui.widgets.note("preferences/keys/" + std::string(item.id) + "/reset");
    tooltip(ui, "Give it the keys of the keymap");
  }
  ImGui::PopID();
}

void menuRows(PanelUi& ui, const Menu& menu) {
  bool first = true;
  for (const Action& item : actions()) {
    if (item.menu() != menu.id || !isFound(ui, menu, item)) continue;
    if (first) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      heading(ui, menu.title);
    }
    first = false;
    actionRow(ui, item);
  }
}

void list(PanelUi& ui) {
  const float room = ImGui::GetIO().DisplaySize.y - ui.px(kAroundList);
  const float height = std::max(std::min(ui.px(kKeysPageListHeight), room), ui.px(kLeastHeight));
  ImGui::BeginChild("keys", {0.0f, height});
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ui.px(4), ui.px(1)});
  if (ImGui::BeginTable("actions", 4, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, ui.px(kKeyWidth));
    ImGui::TableSetupColumn("second", ImGuiTableColumnFlags_WidthFixed, ui.px(kKeyWidth));
    ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, ui.px(kResetWidth));
    for (const Menu& menu : menus()) menuRows(ui, menu);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

}  // namespace

void drawKeymapChoice(PanelUi& ui, const std::string& id) {
  for (const Keymap keymap : kKeymaps) {
    if (keymap != kKeymaps.front()) ImGui::SameLine();
    const bool chosen = ImGui::RadioButton(titleOf(keymap), ui.state.session.preferences.keymap == keymap);
    ui.widgets.note(id + nameOf(keymap));
    if (!chosen) continue;
    ui.state.session.preferences.keymap = keymap;
    endKeyCapture(ui.state);
  }
}

void drawKeysPage(PanelUi& ui) {
  takeKey(ui);
  ImGui::AlignTextToFramePadding();
  mutedText("Keymap");
  ImGui::SameLine();
  drawKeymapChoice(ui, "preferences/keymap/");
  searchRow(ui);
  noticeRow(ui);
  list(ui);
  ImGui::Dummy({0.0f, ui.px(2)});
}

}  // namespace sinew::app
