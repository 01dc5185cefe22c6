// app/panels/keys_page.cpp: every action with its keys, and how they are changed.

#include <imgui.h>
#include <imgui_stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>

#include "app/editor/bindings.h"
#include "app/panels/dialogs.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

const Control kFindKeys{"preferences/keys/search", "Change a key", "shortcut hotkey keyboard binding customize"};
const Control kResetAllKeys{"preferences/keys/reset-all", "Reset all keys", "shortcut hotkey default"};

constexpr float kKeysPageListHeight = 380.0f;  // Design pixels.
constexpr float kKeyWidth = 116.0f;
constexpr float kResetWidth = 52.0f;
constexpr float kLeastHeight = 120.0f;  // The list's, in a low window.
constexpr float kAroundList = 320.0f;   // Height of all else, with some of the window around the dialog.

/// Its label, its menu or one of its keys contains what is searched for.
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

/// The key that goes down in this frame, or the modifier that goes up: it may have been the start of Ctrl+K. 0: none.
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
    ui.escapeTaken = true;  // It does not close the dialog as well.
    endKeyCapture(ui.state);
  } else if (key != 0 && capture.step == KeyCapture::Step::kWaiting) {
    if (isModifier(key) && !capture.notice.empty()) return;  // The end of one that was refused.
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

/// What is waited for, why a key was refused, or the question; always as high, so that the list stays where it is.
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
  if (ImGui::Button("Replace", {button, 0.0f})) replaceKeys(ui.state);
  ui.widgets.note("preferences/keys/replace");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {button, 0.0f})) endKeyCapture(ui.state);
  ui.widgets.note("preferences/keys/cancel");
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
