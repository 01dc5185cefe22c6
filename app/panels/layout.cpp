// app/panels/layout.cpp: the window: regions, splitters, status line, and the highlight of a revealed control.

#include <algorithm>
#include <string>

#include <imgui_internal.h>  // ActiveIdClickOffset, which 1.86 keeps to itself.

#include "app/editor/commands.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/blending.h"
#include "app/panels/dialogs.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "app/panels/overlay.h"
#include "app/panels/panels.h"
#include "app/panels/timeline.h"
#include "app/ui/keyboard_focus.h"
#include "app/viewport/tools/axis_triad.h"

namespace sinew::app {
namespace {

const Control kHeaders[] = {
    {"inspector/header", "Panel Muscle", "inspector properties", nothing},
    {"surface/header", "Panel Surface", "properties settings", nothing},
    {"smoothing/header", "Panel Smoothing", "properties settings", nothing},
    {"layers/header", "Panel Layers", "parts of the mesh skin cloth rigid clothes hair eyes"},
};

constexpr float kBadgeRoom = 90.0f;  // Design pixels: width of the count of messages in the status line.
constexpr float kExportGap = 16.0f;  // Left of the background export.

constexpr double kMarkSeconds = 1.6;  // Duration of the highlight.
constexpr double kMarkStep = 0.04;
constexpr int kMostTries = 30;        // Frames that a dialog may take to open.
constexpr double kOpeningStep = 0.5;  // Seconds between checks whether the desktop has opened a page.

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

struct Box {
  float x = 0.0f;
  float y = 0.0f;
  float width = 0.0f;
  float height = 0.0f;
};

/// All regions of this frame, window coordinates.
struct Regions {
  Box left;
  Box right;
  Box viewport;
  Box bottom;
  Box status;
};

LayoutSizes sizesOf(const PanelUi& ui, float menuHeight) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  LayoutState wished = ui.state.view.layout;
  wished.bottom += keyRowsHeight(ui.state);
  return shownSizes(wished, display.x / ui.scale, (display.y - menuHeight) / ui.scale);
}

Regions divide(const PanelUi& ui, const LayoutSizes& sizes, float menuHeight) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const LayoutState& layout = ui.state.view.layout;
  const float gap = ui.px(kSplitter);
  const float left = ui.px(sizes.left);
  const float right = ui.px(sizes.right);
  const float leftGap = layout.leftShown ? gap : 0.0f;
  const float rightGap = layout.rightShown ? gap : 0.0f;
  const float bottom = ui.px(sizes.bottom);
  const float bottomTop = display.y - ui.px(kStatusHeight) - bottom;
  const float height = bottomTop - menuHeight - (layout.bottomShown ? gap : 0.0f);
  Regions regions;
  regions.left = {0.0f, menuHeight, left, height};
  regions.right = {display.x - right, menuHeight, right, height};
  regions.viewport = {left + leftGap, menuHeight, display.x - left - right - leftGap - rightGap, height};
  regions.bottom = {0.0f, bottomTop, display.x, bottom};
  regions.status = {0.0f, display.y - ui.px(kStatusHeight), display.x, ui.px(kStatusHeight)};
  return regions;
}

void beginRegion(const char* name, const Box& box, ImGuiWindowFlags more) {
  ImGui::SetNextWindowPos({box.x, box.y});
  ImGui::SetNextWindowSize({std::max(box.width, 1.0f), std::max(box.height, 1.0f)});
  ImGui::Begin(name, nullptr, kFixed | more);
}

/// A panel's size in the direction in which its splitter moves, design pixels.
struct Sized {
  float shown;  ///< In this frame.
  float least;
  float spare;    ///< The most that the neighbor can shrink.
  float& wished;  ///< The saved size; a drag sets it from the shown size and the pointer.
};

/// A bar between two panels. @param sign  of the direction in which the panel grows
void splitter(PanelUi& ui, const std::string& id, const Box& box, bool upright, float sign, const Sized& size) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
  beginRegion(id.c_str(), box, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar);
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  ImGui::InvisibleButton("bar", {box.width, box.height});
  ImGui::PopItemFlag();
  ui.widgets.note(id);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled({box.x + 1.0f, box.y + 1.0f},
                                              {box.x + box.width - 1.0f, box.y + box.height - 1.0f},
                                              palette::kAccent.faded(0.7f).packed(), 2.0f);
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 1.0f)) {
    // Relative to the grip: a bar at its limit waits for the pointer to come back.
    const ImVec2 grip = ImGui::GetCurrentContext()->ActiveIdClickOffset;
    const ImVec2 mouse = ImGui::GetMousePos();
    const float moved = upright ? mouse.x - grip.x - box.x : mouse.y - grip.y - box.y;
    const float most = std::max(size.shown + size.spare, size.least);
    if (moved != 0.0f) size.wished = std::clamp(size.shown + sign * moved / ui.scale, size.least, most);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

bool isDrawn(const PanelUi& ui, const Panel& panel) { return panel.always || ui.state.hasCharacter(); }

/// The panels of a region, each below its title.
void drawTitled(PanelUi& ui, Region region) {
  for (const Panel& panel : panels()) {
    if (panel.region != region) continue;
    if (panel.title[0] != '\0') heading(ui, panel.title);
    if (isDrawn(ui, panel)) panel.draw(ui);
  }
}

void drawLeft(PanelUi& ui, const Box& box, float history) {
  const float gap = ui.px(kSplitter);
  const float lower = ui.px(history);
  const Box top{box.x, box.y, box.width, box.height - lower - gap};
  const Box bar{box.x, box.y + top.height, box.width, gap};
  const Box bottom{box.x, bar.y + gap, box.width, lower};
  beginRegion("region-outliner", top, 0);
  drawTitled(ui, Region::kLeftTop);
  ImGui::End();
  splitter(ui, "layout/history", bar, false, -1.0f,
           {history, kHistoryLowest, top.height / ui.scale - kOutlinerLowest, ui.state.view.layout.history});
  beginRegion("region-history", bottom, 0);
  drawTitled(ui, Region::kLeftBottom);
  ImGui::End();
}

/// A title that folds its panel, which is saved. @return whether it is unfolded
bool foldingTitle(PanelUi& ui, const Panel& panel) {
  std::vector<std::string>& folded = ui.state.view.layout.folded;
  const bool wasOpen = std::ranges::find(folded, panel.id) == folded.end();
  ImGui::SetNextItemOpen(wasOpen);
  ImGui::PushStyleColor(ImGuiCol_Header, palette::kRaised);
  ImGui::PushFont(ui.fonts.strong);
  const bool open = ImGui::CollapsingHeader(panel.title);
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ui.widgets.note(std::string(panel.id) + "/header");
  if (open && !wasOpen) std::erase(folded, panel.id);
  if (!open && wasOpen) folded.emplace_back(panel.id);
  return open;
}

void drawRight(PanelUi& ui, const Box& box) {
  beginRegion("region-right", box, 0);
  for (const Panel& panel : panels()) {
    if (panel.region != Region::kRight || (panel.isWanted && !panel.isWanted(ui.state))) continue;
    if (!foldingTitle(ui, panel) || !isDrawn(ui, panel)) continue;
    ImGui::PushID(panel.id);
    panel.draw(ui);
    ImGui::PopID();
    ImGui::Dummy({0.0f, ui.px(6)});
  }
  ImGui::End();
}

void drawStatus(PanelUi& ui, const Box& box) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(12), ui.px(5)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kBackground);
  beginRegion("region-status", box, ImGuiWindowFlags_NoScrollbar);
  const EditorState& state = ui.state;
  const std::string text =
      state.hasCharacter() ? state.frame.route.status : "No character \xc2\xb7 Drop opens a .glb, .gltf or .rig.json";
  const float badge = state.session.messages.empty() ? 0.0f : ui.px(kBadgeRoom);
  const float exporting = exportStatusWidth(ui);
  const float room = ImGui::GetContentRegionAvail().x - badge;
  const ImVec2 place{ImGui::GetCursorPosX() + room - exporting, ImGui::GetCursorPosY()};
  const std::string shown = fitted(text, room - (exporting > 0.0f ? exporting + ui.px(kExportGap) : 0.0f));
  mutedText(shown.c_str());
  ui.widgets.note("status/line");
  if (shown != text) tooltip(ui, text);
  if (exporting > 0.0f) {
    ImGui::SetCursorPos(place);
    drawExportStatus(ui);
  }
  ImGui::SetCursorPos(place);
  drawMessageBadge(ui);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

void drawWelcome(PanelUi& ui, const Box& box) {
  const auto centered = [&](const char* text, float y) {
    const std::string shown = fitted(text, box.width - ui.px(16));
    ImGui::SetCursorPos({0.5f * (box.width - ImGui::CalcTextSize(shown.c_str()).x), y});
    ImGui::TextUnformatted(shown.c_str());
  };
  const float middle = 0.45f * box.height;
  ImGui::PushFont(ui.fonts.strong);
  centered("No character is open", middle - ui.px(34));
  ImGui::PopFont();
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted);
  centered("Drop a .glb, .gltf or .rig.json on the window, or", middle - ui.px(6));
  ImGui::PopStyleColor();
  const ImVec2 size{std::min(ui.px(150), box.width - ui.px(16)), ui.px(32)};
  ImGui::SetCursorPos({0.5f * (box.width - size.x), middle + ui.px(24)});
  if (textButton(ui, "viewport/open", "Open a file...", size)) showOpenDialog(ui.state);
}

/// Records what covers the picture: panels, which are child windows, boxes drawn by hand, and the axes in the corner.
void noteCovered(PanelUi& ui, const Box& box) {
  std::vector<glm::vec4>& covered = ui.state.frame.covered;
  covered.clear();
  const auto cover = [&](const glm::vec4& over) {
    const glm::vec2 corner(box.x, box.y);
    const glm::vec2 size = glm::max(glm::vec2(box.width, box.height), glm::vec2(1.0f));
    covered.emplace_back((glm::vec2(over) - corner) / size, (glm::vec2(over.z, over.w) - corner) / size);
  };
  for (const ImGuiWindow* const child : ImGui::GetCurrentWindow()->DC.ChildWindows) {
    const ImRect at = child->Rect();
    cover({at.Min.x, at.Min.y, at.Max.x, at.Max.y});
  }
  for (const glm::vec4& over : ui.covered) cover(over);
  const float ball = ui.px(2.0f * kTriadRadius + kTriadMargin);
  if (ui.state.hasCharacter())
    cover({box.x + box.width - ball, box.y + box.height - ball, box.x + box.width, box.y + box.height});
}

/// The panels over the picture, which itself is drawn later. @return whether the mouse is over the free picture
bool drawViewport(PanelUi& ui, const Box& box) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
  beginRegion("region-viewport", box,
              ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  const bool free = ImGui::IsWindowHovered();
  if (!ui.state.hasCharacter()) drawWelcome(ui, box);
  for (const Panel& panel : panels()) {
    if (panel.region == Region::kInViewport && isDrawn(ui, panel)) panel.draw(ui);
  }
  noteCovered(ui, box);
  ImGui::End();
  return free;
}

void drawSplitters(PanelUi& ui, const LayoutState& shown, const LayoutSizes& sizes, const Box& v) {
  const float gap = ui.px(kSplitter);
  LayoutState& wished = ui.state.view.layout;
  const Box left{v.x - gap, v.y, gap, v.height};
  const Box right{v.x + v.width, v.y, gap, v.height};
  const Box bottom{0.0f, v.y + v.height, ImGui::GetIO().DisplaySize.x, gap};
  const float across = v.width / ui.scale - kViewportNarrowest;
  const float upright = v.height / ui.scale - kViewportLowest;
  if (shown.leftShown) {
    splitter(ui, "layout/left", left, true, 1.0f, {sizes.left, kPanelNarrowest, across, wished.left});
  }
  if (shown.rightShown) {
    splitter(ui, "layout/right", right, true, -1.0f, {sizes.right, kPanelNarrowest, across, wished.right});
  }
  if (shown.bottomShown) {
    const float rows = keyRowsHeight(ui.state);
    splitter(ui, "layout/bottom", bottom, false, -1.0f, {sizes.bottom - rows, kBottomLowest, upright, wished.bottom});
  }
}

/// Before the panels: the revealed control gets the keyboard focus when it is first seen.
void seekRevealed(PanelUi& ui) {
  const RevealState& reveal = ui.state.dialogs.reveal;
  if (!reveal.id.empty()) ui.widgets.seek(reveal.id, reveal.until < 0.0);
}

/// Windows that open with the control may take the keyboard focus from it at first.
bool lacksKeyboard(const PanelUi& ui, const std::string& id) {
  const auto& all = ui.widgets.laidOut();
  const auto found = std::ranges::find(all, id, &LaidOut::id);
  return found != all.end() && found->item != 0 && focusedControl(ui.widgets) != id;
}

/// After the panels: highlights the control for a moment.
void markRevealed(PanelUi& ui) {
  RevealState& reveal = ui.state.dialogs.reveal;
  if (reveal.id.empty()) return;
  const double now = ui.state.frame.now;
  if (!ui.widgets.sought() || (reveal.until < 0.0 && reveal.tries < kMostTries && lacksKeyboard(ui, reveal.id))) {
    if (++reveal.tries > kMostTries || reveal.until >= 0.0) reveal = {};
    else ui.wakeIn(kMarkStep);
    return;
  }
  if (reveal.until < 0.0) reveal.until = now + kMarkSeconds;
  const double left = reveal.until - now;
  if (left <= 0.0) {
    reveal = {};
    return;
  }
  ui.wakeIn(kMarkStep);
  const glm::vec4& box = ui.widgets.rectangles().at(reveal.id);
  const float strength = std::min(1.0f, static_cast<float>(2.0 * left / kMarkSeconds));
  const float room = ui.px(3);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const ImVec2 low{box.x - room, box.y - room};
  const ImVec2 high{box.x + box.z + room, box.y + box.w + room};
  list.AddRectFilled(low, high, palette::kAccent.faded(0.22f * strength).packed(), ui.px(6));
  list.AddRect(low, high, palette::kAccent.faded(strength).packed(), ui.px(6), 0, ui.px(2));
}

}  // namespace

bool drawLayout(PanelUi& ui) {
  ui.escapeTaken = closeMenuOnEscape();
  seekRevealed(ui);
  ui.state.frame.hoveredPart = -1;
  const float menuHeight = drawMenuBar(ui);
  const LayoutSizes sizes = sizesOf(ui, menuHeight);
  const Regions regions = divide(ui, sizes, menuHeight);
  const Box& v = regions.viewport;
  ui.state.frame.viewport = {v.x, v.y, v.width, v.height};
  const ImVec2 pixelsPerUnit = ImGui::GetIO().DisplayFramebufferScale;
  ui.state.frame.viewportPixels = {std::max(1, static_cast<int>(v.width * pixelsPerUnit.x)),
                                   std::max(1, static_cast<int>(v.height * pixelsPerUnit.y))};
  const LayoutState shown = ui.state.view.layout;  // A panel that hides a region does so in the next frame.
  if (shown.leftShown) drawLeft(ui, regions.left, sizes.history);
  if (shown.rightShown) drawRight(ui, regions.right);
  const bool free = drawViewport(ui, v);
  if (shown.bottomShown) {
    beginRegion("region-bottom", regions.bottom, ImGuiWindowFlags_NoScrollbar);
    drawTitled(ui, Region::kBottom);
    ImGui::End();
  }
  drawStatus(ui, regions.status);
  drawSplitters(ui, shown, sizes, v);
  for (const Panel& panel : panels()) {
    if (panel.region == Region::kDialog) panel.draw(ui);
  }
  endAbandonedEdit(ui.state);
  drawFocus(ui);
  markRevealed(ui);
  if (ui.state.session.opener.busy()) ui.wakeIn(kOpeningStep);
  return free;
}

namespace {

/// Fits two sizes into a room: shrinks both in proportion to what each has above its least size.
void fit(float& a, float& b, float leastA, float leastB, float room) {
  const float spare = (a - leastA) + (b - leastB);
  const float over = a + b - std::max(room, leastA + leastB);
  if (over <= 0.0f || spare <= 0.0f) return;
  const float part = std::min(over / spare, 1.0f);
  a -= part * (a - leastA);
  b -= part * (b - leastB);
}

}  // namespace

LayoutSizes shownSizes(const LayoutState& wished, float width, float height) {
  LayoutSizes sizes;
  const float leastLeft = wished.leftShown ? kPanelNarrowest : 0.0f;
  const float leastRight = wished.rightShown ? kPanelNarrowest : 0.0f;
  const float bars = (wished.leftShown ? kSplitter : 0.0f) + (wished.rightShown ? kSplitter : 0.0f);
  if (wished.leftShown) sizes.left = std::max(wished.left, kPanelNarrowest);
  if (wished.rightShown) sizes.right = std::max(wished.right, kPanelNarrowest);
  fit(sizes.left, sizes.right, leastLeft, leastRight, width - bars - kViewportNarrowest);
  const float bottomBar = wished.bottomShown ? kSplitter : 0.0f;
  const float upright = height - kStatusHeight - bottomBar;
  if (wished.bottomShown) {
    sizes.bottom = std::clamp(wished.bottom, kBottomLowest, std::max(kBottomLowest, upright - kViewportLowest));
  }
  const float column = upright - sizes.bottom - kSplitter;
  sizes.history = std::clamp(wished.history, kHistoryLowest, std::max(kHistoryLowest, column - kOutlinerLowest));
  // In a very low window the outliner gets the larger half.
  sizes.history = std::max(0.0f, std::min(sizes.history, 0.45f * column));
  return sizes;
}

// The tabs at the left, and the history below them.

namespace {

const Control kMusclesTab{"outliner/tab", "Tab Muscles", "outliner bones tree list hierarchy"};
const Control kGroupsTab{"blending/tab", "Tab Groups", "blending cliques"};
const Control kLibraryTab{"library/tab", "Tab Library", "presets sets"};
const Control kShapesTab{"shapes/tab", "Tab Shapes", "morph targets blend shapes"};

constexpr float kTabGap = 13.0f;          ///< Design pixels.
constexpr double kTabHoldSeconds = 0.35;  ///< A muscle that is held over a tab this long opens it.

/// A tab; holding a dragged muscle over it opens it.
void drawTab(PanelUi& ui, const char* word, const char* id, LeftTab tab) {
  OutlinerState& outliner = ui.state.view.outliner;
  const bool active = outliner.tab == tab;
  ImGui::PushFont(ui.fonts.strong);
  const ImVec2 text = ImGui::CalcTextSize(word);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size{text.x + ui.px(2), text.y + ui.px(7)};
  if (ImGui::InvisibleButton(id, size)) outliner.tab = tab;
  ui.widgets.note(id);
  const bool dragged = ImGui::GetDragDropPayload() != nullptr;
  const bool over = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (dragged && over) {
    ui.wakeIn(kTabHoldSeconds);
    if (ImGui::GetIO().MouseDownDuration[0] > static_cast<float>(kTabHoldSeconds)) outliner.tab = tab;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Tint color = active || over ? palette::kText : palette::kMuted;
  list.AddText(low, color.packed(), word);
  if (active) {
    list.AddRectFilled({low.x, low.y + text.y + ui.px(4)}, {low.x + text.x, low.y + text.y + ui.px(6)},
                       palette::kAccent.packed(), ui.px(1));
  }
  ImGui::PopFont();
}

}  // namespace

void drawLeftTabs(PanelUi& ui) {
  ui.state.frame.highlighted.clear();
  if (ui.state.open.rename.appearing) ui.state.view.outliner.tab = LeftTab::kMuscles;
  drawTab(ui, "Muscles", kMusclesTab.id, LeftTab::kMuscles);
  ImGui::SameLine(0.0f, ui.px(kTabGap));
  drawTab(ui, "Groups", kGroupsTab.id, LeftTab::kGroups);
  ImGui::SameLine(0.0f, ui.px(kTabGap));
  drawTab(ui, "Library", kLibraryTab.id, LeftTab::kLibrary);
  ImGui::SameLine(0.0f, ui.px(kTabGap));
  drawTab(ui, "Shapes", kShapesTab.id, LeftTab::kShapes);
  switch (ui.state.view.outliner.tab) {
    case LeftTab::kMuscles:
      return drawOutliner(ui);
    case LeftTab::kGroups:
      drawBlending(ui);
      break;
    case LeftTab::kLibrary:
      drawLibrary(ui);
      break;
    case LeftTab::kShapes:
      drawShapes(ui);
      break;
  }
  keepDraggedShown(ui);
}

void drawHistory(PanelUi& ui) {
  ImGui::BeginChild("history-steps");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  const CommandStack& commands = ui.state.document.commands;
  const std::size_t position = commands.position();
  std::size_t wanted = position;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(commands.stepCount() + 1));
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const auto step = static_cast<std::size_t>(row);
      ImGui::PushID(row);
      ImGui::PushStyleColor(ImGuiCol_Text, step <= position ? palette::kText : palette::kMuted.faded(0.7f));
      const std::string& label = commands.label(step);
      const std::string shown = fitted(label, ImGui::GetContentRegionAvail().x);
      if (ImGui::Selectable((shown + "##step").c_str(), step == position)) wanted = step;
      ImGui::PopStyleColor();
      ImGui::PopID();
      ui.widgets.note("history/step/" + std::to_string(step));
      if (shown != label) tooltip(ui, label);
    }
  }
  if (wanted != position) {
    jumpTo(ui.state, wanted);
  } else if (ui.state.open.historyShown != position) {
    // Scrolls to a new step.
    const float row = ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetScrollY(row * static_cast<float>(position) - 0.5f * ImGui::GetWindowHeight());
  }
  ui.state.open.historyShown = position;
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

// All panels and their regions.

namespace {

constexpr Panel kPanels[] = {
    {"outliner", "", Region::kLeftTop, drawLeftTabs},
    {"history", "History", Region::kLeftBottom, drawHistory},
    {"inspector", "Muscle", Region::kRight, drawInspector},
    {"surface", "Surface", Region::kRight, drawSurfacePanel},
    {"smoothing", "Smoothing", Region::kRight, drawSmoothingPanel},
    {"layers", "Layers", Region::kRight, drawLayersPanel, false, hasParts},
    {"timeline", "", Region::kBottom, drawTimeline},
    {"display", "", Region::kInViewport, drawDisplayBar},
    {"toolstrip", "", Region::kInViewport, drawToolStrip},
    {"overlay", "", Region::kInViewport, drawNumbers},
    {"legend", "", Region::kInViewport, drawLegend},
    {"flex", "", Region::kInViewport, drawFlex},
    {"driven-key", "", Region::kInViewport, drawDrivenKey},
    {"check", "", Region::kInViewport, drawCheckList},
    {"muscle-set", "", Region::kInViewport, drawMuscleSet},
    {"fit-sculpt", "", Region::kInViewport, drawFitSculpt},
    {"body-parts", "", Region::kInViewport, drawBodyParts},
    {"clip-files", "", Region::kInViewport, drawClipList},
    {"reference", "", Region::kInViewport, drawReference},
    {"first-steps", "", Region::kInViewport, drawFirstSteps},
    {"viewport-menu", "", Region::kInViewport, drawViewportMenu},
    {"messages", "", Region::kInViewport, drawMessages, true},
    {"toast", "", Region::kInViewport, drawToast, true},
    {"export", "", Region::kDialog, drawExportDialog},
    {"farm", "", Region::kDialog, drawFarmDialog},
    {"pictures", "", Region::kDialog, drawPicturesDialog},
    {"dialog", "", Region::kDialog, drawFileDialog, true},
    {"locate", "", Region::kDialog, drawLocateQuestion, true},
    {"keep-muscles", "", Region::kDialog, drawKeepMusclesQuestion, true},
    {"recovery", "", Region::kDialog, drawRecoveryQuestion, true},
    {"conflict", "", Region::kDialog, drawConflictQuestion, true},
    {"unsaved", "", Region::kDialog, drawUnsavedQuestion, true},
    {"export-question", "", Region::kDialog, drawExportQuestion, true},
    {"keys", "", Region::kDialog, drawKeySheet, true},
    {"preferences", "", Region::kDialog, drawPreferences, true},
    {"palette", "", Region::kDialog, drawPalette, true},
};

}  // namespace

std::span<const Panel> panels() { return kPanels; }

}  // namespace sinew::app
