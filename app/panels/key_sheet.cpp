// app/panels/key_sheet.cpp: the sheet of keys and mouse gestures in the current keymap.

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/panels/dialogs.h"
#include "app/ui/data_files.h"

namespace sinew::app {
namespace {

constexpr const char* kKeySheetTitle = "Keys and mouse";
constexpr float kKeySheetWidth = 860.0f;  // Design pixels.
constexpr float kWideWidth = 1220.0f;
constexpr float kTwoColumns = 640.0f;
constexpr float kLineGap = 1.0f;
constexpr float kAroundSheet = 136.0f;  // Height of everything else in the window.
constexpr float kKeysAt = 0.60f;        // Fraction of a column's width.

/// A heading with lines: an action and its key or gesture.
struct Section {
  std::string title;
  std::vector<std::pair<std::string, std::string>> lines;
};

const std::vector<Section>& mouseSections() {
  static const std::vector<Section> sections{{"In the picture",
                                              {{"Orbit", "drag, Alt+drag or middle"},
                                               {"Pan", "right or Shift+middle"},
                                               {"Zoom to the pointer", "wheel"},
                                               {"Select, add to it", "click, Shift+click"},
                                               {"Select what lies behind", "click again"},
                                               {"Select in a box", "Ctrl+drag"},
                                               {"Menu of what lies there", "right click"},
                                               {"Add a muscle", "Add muscle, press, drag"}}},
                                             {"While dragging a handle",
                                              {{"Along one axis", "X  Y  Z"},
                                               {"In steps", "Ctrl"},
                                               {"Precisely", "Shift"},
                                               {"By a typed number", "digits, Enter"},
                                               {"A pole from the middle", "Alt"},
                                               {"Cancel", "Esc or right button"}}},
                                             {"In fields",
                                              {{"Change a number", "drag"},
                                               {"Precisely", "Shift"},
                                               {"In steps", "Ctrl"},
                                               {"Type a number", "double click"},
                                               {"Complete a path", "Tab"},
                                               {"Cancel", "Esc"}}}};
  return sections;
}

std::vector<Section> sectionsOf(const Preferences& preferences) {
  std::vector<Section> sections;
  for (const Menu& menu : menus()) {
    Section section{menu.title, {}};
    for (const Action& item : actions()) {
      if (item.menu() != menu.id) continue;
      const std::array<Shortcut, 2> keys = shortcutsOf(item, preferences);
      std::string text = textOf(keys[0]);
      if (keys[1].key != 0) text += (text.empty() ? "" : "  or  ") + textOf(keys[1]);
      if (!text.empty()) section.lines.emplace_back(item.label, text);
    }
    if (!section.lines.empty()) sections.push_back(std::move(section));
  }
  sections.insert(sections.end(), mouseSections().begin(), mouseSections().end());
  return sections;
}

/// In lines, with the gap below.
std::size_t heightOf(const Section& section) { return section.lines.size() + 2; }

std::size_t linesOf(std::span<const Section> sections) {
  std::size_t all = 0;
  for (const Section& section : sections) all += heightOf(section);
  return all;
}

/// The first section of each column, for the lowest columns that hold all sections in order.
std::vector<std::size_t> columnsOf(const std::vector<Section>& sections, std::size_t count) {
  for (std::size_t lines = linesOf(sections) / count;; ++lines) {
    std::vector<std::size_t> begins{0};
    std::size_t used = 0;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      if (used > 0 && used + heightOf(sections[i]) > lines) {
        begins.push_back(i);
        used = 0;
      }
      used += heightOf(sections[i]);
    }
    if (begins.size() <= count) return begins;
  }
}

std::size_t tallest(const std::vector<Section>& sections, const std::vector<std::size_t>& begins) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : sections.size();
    most = std::max(most, linesOf(std::span(sections).subspan(begins[i], end - begins[i])));
  }
  return most;
}

void drawSection(PanelUi& ui, const Section& section) {
  heading(ui, section.title.c_str());
  const float left = ImGui::GetCursorPosX();
  const float width = ImGui::GetContentRegionAvail().x;
  for (const auto& [what, how] : section.lines) {
    const std::string shown = fitted(what, kKeysAt * width - ui.px(8));
    mutedText(shown.c_str());
    if (shown != what) tooltip(ui, what);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + kKeysAt * width);
    const std::string keys = fitted(how, (1.0f - kKeysAt) * width);
    ImGui::TextUnformatted(keys.c_str());
    if (keys != how) tooltip(ui, how);
  }
  ImGui::Dummy({0.0f, ui.px(6)});
}

void drawColumns(PanelUi& ui, const std::vector<Section>& sections, const std::vector<std::size_t>& begins,
                 float height) {
  ImGui::BeginChild("sheet", {0.0f, height});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(kLineGap)});
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ui.px(14), 0.0f});
  const int columns = static_cast<int>(begins.size());
  if (ImGui::BeginTable("keys", columns, ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_BordersInnerV)) {
    for (std::size_t i = 0; i < sections.size(); ++i) {
      if (std::ranges::binary_search(begins, i)) ImGui::TableNextColumn();
      drawSection(ui, sections[i]);
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar(2);
  ImGui::EndChild();
}

/// Two columns; three if two are too tall and there is room; one in a narrow window.
void drawSheet(PanelUi& ui) {
  const std::vector<Section> sections = sectionsOf(ui.state.session.preferences);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float line = ImGui::GetTextLineHeight() + ui.px(kLineGap);
  const float room = std::max(display.y - ui.px(kAroundSheet), ui.px(120));
  const auto heightFor = [&](std::size_t columns) {
    return static_cast<float>(tallest(sections, columnsOf(sections, columns))) * line;
  };
  const bool third = heightFor(2) > room && display.x >= ui.px(kWideWidth + 20.0f);
  const bool narrow = display.x < ui.px(kTwoColumns);
  const std::size_t columns = third ? 3 : (narrow ? 1 : 2);
  placeDialog(ui, third ? kWideWidth : kKeySheetWidth);
  bool open = true;
  if (!ImGui::BeginPopupModal(kKeySheetTitle, &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) return;
  const bool toggled = keyPressed(ui, action("help/keys")) && !ImGui::IsWindowAppearing();
  ImGui::AlignTextToFramePadding();
  mutedText("Keymap");
  ImGui::SameLine();
  drawKeymapChoice(ui, "keys/");
  ImGui::Separator();
  drawColumns(ui, sections, columnsOf(sections, columns), std::min(heightFor(columns), room));
  ImGui::AlignTextToFramePadding();
  mutedText((std::string("Sinew ") + programVersion()).c_str());
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ui.px(104));
  const bool closed = textButton(ui, "keys/close", "Close", {ui.px(104), 0.0f});
  if (closed || !open || toggled || escapePressed(ui) || ImGui::IsMouseClicked(1)) {
    ui.state.dialogs.keySheet = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace

void drawKeySheet(PanelUi& ui) {
  if (!ui.state.dialogs.keySheet) return;
  if (!ImGui::IsPopupOpen(kKeySheetTitle)) ImGui::OpenPopup(kKeySheetTitle);
  pushDialogStyle(ui);
  drawSheet(ui);
  popDialogStyle();
}

}  // namespace sinew::app
