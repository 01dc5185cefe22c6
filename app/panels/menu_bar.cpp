// app/panels/menu_bar.cpp: the menu bar: actions, recent files, samples and help pages.

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

#include "app/editor/commands.h"
#include "app/editor/session.h"
#include "app/panels/panels.h"
#include "app/ui/code_points.h"
#include "app/ui/reading_order.h"
#include "app/viewport/render/thumbnails.h"

namespace sinew::app {
namespace {

constexpr float kMenuBarThumbnailHeight = 36.0f;  // Design pixels.

/// A submenu of files. @param id  "file/recent"
bool beginFiles(PanelUi& ui, const std::string& id, const char* title, bool any) {
  const bool open = ImGui::BeginMenu(title, any);
  ui.widgets.note(id);
  return open;
}

/// Beside the next menu item; empty space without a thumbnail.
void drawThumbnail(PanelUi& ui, const std::filesystem::path& document) {
  std::error_code failed;
  const auto changed = std::filesystem::last_write_time(document, failed);
  const ImTextureID texture = failed ? ImTextureID{} : thumbnailOf(ui, document, changed);
  const float height = ui.px(kMenuBarThumbnailHeight);
  const float width = height * static_cast<float>(kThumbnailSize.x) / static_cast<float>(kThumbnailSize.y);
  const float line = ImGui::GetCursorPosY();
  if (texture) ImGui::Image(texture, {width, height});
  else ImGui::Dummy({width, height});
  ImGui::SameLine(0.0f, ui.px(8));
  ImGui::SetCursorPosY(line + 0.5f * (height - ImGui::GetTextLineHeight()));
}

void drawRecent(PanelUi& ui) {
  // A copy: opening a file moves it to the front.
  const std::vector<std::filesystem::path> recent = ui.state.session.preferences.recentFiles;
  if (!beginFiles(ui, "file/recent", "Open recent", !recent.empty())) return;
  for (std::size_t i = 0; i < recent.size(); ++i) {
    std::error_code failed;
    const bool there = std::filesystem::is_regular_file(recent[i], failed);
    const std::string id = "file/recent/" + std::to_string(i);
    drawThumbnail(ui, recent[i]);
    const std::string place = "   " + (there ? recent[i].parent_path().string() : std::string("no longer there"));
    const std::string name = readableName(recent[i].filename().string(), "file", static_cast<int>(i) + 1);
    const bool chosen =
        ImGui::MenuItem((inReadingOrder(name) + "##" + id).c_str(), inReadingOrder(place).c_str(), false, there);
    ui.widgets.note(id);
    if (chosen) request(ui.state, {IntentKind::kOpenFile, recent[i]});
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Clear this list")) ui.state.session.preferences.recentFiles.clear();
  ui.widgets.note("file/recent/clear");
  ImGui::EndMenu();
}

void drawSamples(PanelUi& ui) {
  const std::vector<Sample> all = samples();
  if (!beginFiles(ui, "file/samples", "Samples", !all.empty())) return;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool chosen = ImGui::MenuItem(all[i].name.c_str());
    ui.widgets.note("file/samples/" + std::to_string(i));
    if (chosen) request(ui.state, {IntentKind::kOpenFile, all[i].file});
  }
  ImGui::EndMenu();
}

void drawPages(PanelUi& ui) {
  const std::vector<HelpPage>& all = helpPages();
  if (!beginFiles(ui, "help/pages", "Pages", !all.empty())) return;
  for (const HelpPage& page : all) {
    const bool chosen = ImGui::MenuItem(page.title.c_str());
    ui.widgets.note("help/pages/" + page.name);
    tooltip(ui, page.file.string());
    if (chosen) openHelpPage(ui.state, page);
  }
  ImGui::EndMenu();
}

/// A submenu for actions whose ids begin alike.
struct Submenu {
  std::string_view begin;  ///< Of their ids; without the last letter, the submenu's id.
  const char* title;
  std::string_view further = "";  ///< Ids of further actions, each between spaces.
};
constexpr Submenu kSubmenus[] = {
    {"file/export-", "Export"},
    {"edit/shape-", "Add shape on bone"},
    {"view/light-", "Light"},
    {"view/background-", "Background"},
    {"view/look-", "Look from", " view/front view/back view/left view/right view/top view/bottom "}};

const Submenu* submenuOf(const Action& item) {
  const std::string_view id = item.id;
  const std::string whole = ' ' + std::string(id) + ' ';
  const auto* const found = std::ranges::find_if(kSubmenus, [&](const Submenu& each) {
    return id.starts_with(each.begin) || each.further.find(whole) != std::string_view::npos;
  });
  return found == std::end(kSubmenus) ? nullptr : found;
}

void drawItem(PanelUi& ui, const Action& item) {
  const bool checked = item.checked != nullptr && item.enabled(ui.state) && item.checked(ui.state);
  const bool chosen =
      ImGui::MenuItem(item.label, ("   " + keyText(item, ui.state)).c_str(), checked, item.enabled(ui.state));
  ui.widgets.note(item.id);
  tooltip(ui, hintOf(ui, item));
  if (chosen) run(item, ui.state);
}

void drawSubmenu(PanelUi& ui, const Submenu& submenu) {
  // Noted by rectangle: once it is open, the last item is one of its own.
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const glm::vec4 row(place.x, place.y, ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight());
  const bool open = ImGui::BeginMenu(submenu.title);
  ui.widgets.note(std::string(submenu.begin.substr(0, submenu.begin.size() - 1)), row);
  if (!open) return;
  for (const Action& item : actions()) {
    if (submenuOf(item) == &submenu) drawItem(ui, item);
  }
  ImGui::EndMenu();
}

void drawItems(PanelUi& ui, const Menu& menu) {
  bool first = true;
  const Submenu* last = nullptr;
  for (const Action& item : actions()) {
    if (item.menu() != menu.id) continue;
    if (item.separatorBefore && !first) ImGui::Separator();
    first = false;
    const Submenu* const submenu = submenuOf(item);
    if (submenu == nullptr) drawItem(ui, item);
    else if (submenu != last) drawSubmenu(ui, *submenu);
    last = submenu;
    if (std::string_view(item.id) == "file/open") {
      drawRecent(ui);
      drawSamples(ui);
    }
    if (std::string_view(item.id) == "help/keys") drawPages(ui);
  }
}

void drawMenu(PanelUi& ui, const Menu& menu) {
  const bool open = ImGui::BeginMenu(menu.title);
  ui.widgets.note(std::string("menu/") + menu.id);
  if (!open) return;
  drawItems(ui, menu);
  ImGui::EndMenu();
}

/// Menus that have no room are submenus of the last one.
void drawMenus(PanelUi& ui) {
  std::vector<float> widths;
  for (const Menu& menu : menus()) {
    widths.push_back(ImGui::CalcTextSize(menu.title).x + 2.0f * ImGui::GetStyle().ItemSpacing.x);
  }
  const std::size_t shown = fittingCount(widths, ImGui::GetContentRegionAvail().x, ui.px(30));
  for (std::size_t i = 0; i < shown; ++i) drawMenu(ui, menus()[i]);
  if (shown == widths.size()) return;
  const bool open = ImGui::BeginMenu("\xc2\xbb");
  ui.widgets.note("menu/more");
  if (!open) return;
  for (std::size_t i = shown; i < widths.size(); ++i) drawMenu(ui, menus()[i]);
  ImGui::EndMenu();
}

void drawName(PanelUi& ui) {
  const std::string name = ui.state.document.name() + (ui.state.document.commands.modified() ? " *" : "");
  const float left = ImGui::GetCursorPosX() + ui.px(12);
  const float room = ImGui::GetWindowWidth() - left - ui.px(12);
  if (room < ui.px(40)) return;
  const std::string shown = fitted(name, room);
  const float centered = 0.5f * (ImGui::GetWindowWidth() - ImGui::CalcTextSize(shown.c_str()).x);
  ImGui::SameLine(std::max(centered, left));
  mutedText(shown.c_str());
  if (shown != name) tooltip(ui, name);
}

}  // namespace

float drawMenuBar(PanelUi& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(8), ui.px(6)});
  float height = 0.0f;
  if (ImGui::BeginMainMenuBar()) {
    height = ImGui::GetWindowSize().y;
    drawMenus(ui);
    if (ui.state.hasCharacter()) drawName(ui);
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar();
  return height;
}

}  // namespace sinew::app
