// app/panels/legend.cpp: legends of the colors in the picture, and the line that names the mode.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/editor/blending_edit.h"
#include "app/editor/export_error.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/overlay.h"
#include "app/ui/number_field.h"
#include "app/viewport/render/color_scales.h"

namespace sinew::app {
namespace {

Possible withAnatomy(const EditorState& state) {
  return withCharacter(state).also(state.view.display.anatomy, "Show the anatomy first");
}

const Control kClearSkin{"legend/glass", "Clear skin", "anatomy transparent glass opacity", withAnatomy};

constexpr float kMargin = 10.0f;  // Design pixels, as all here.
constexpr float kScaleWidth = 220.0f;
constexpr float kUnderTools = 110.0f;  // Height that the display bar and the shortest strip of tools need.
constexpr float kScaleNarrowest = 110.0f;
constexpr int kLegendSteps = 64;

struct LegendBox {
  ImVec2 low;
  ImVec2 high;
};

bool modeShown(const EditorState& state) {
  return state.document.visibility.bare || editsTerritory(state) || state.document.visibility.isolated;
}

/// Distance of the plate from the picture's lower edge, window coordinates.
float underPlate(PanelUi& ui) { return modeShown(ui.state) ? ImGui::GetFrameHeight() + ui.px(22) : ui.px(kMargin); }

float heatHeight(PanelUi& ui) { return 3.0f * ImGui::GetTextLineHeight() + ui.px(46); }
float anatomyHeight(PanelUi& ui) { return ImGui::GetFrameHeight() + ImGui::GetTextLineHeight() + ui.px(41); }
bool showsLevels(PanelUi& ui) { return !ui.state.live->preparation()->refinement().isUniform; }

/// Triangles of the file in each zone.
std::array<int, kZones> zoneCounts(const EditorState& state) {
  std::array<int, kZones> counts{};
  const std::vector<SkinLayer> layers = partLayers(state);
  const std::vector<ControlTriangle>& triangles = state.character().mesh.triangles;
  const std::vector<TriangleClass>& found = state.live->surface().classes;
  for (std::size_t t = 0; t < found.size(); ++t) {
    ++counts[zoneOf(found[t], layers[static_cast<std::size_t>(triangles[t].part)])];
  }
  return counts;
}

struct ZoneRow {
  const char* name;
  const char* hint;
  glm::vec3 srgb;
  int triangles;
};

/// The classes of skin, and the layers of other parts if there are any.
std::vector<ZoneRow> zoneRows(const EditorState& state) {
  const std::array<int, kZones> counts = zoneCounts(state);
  std::vector<ZoneRow> rows;
  for (const ClassColor& each : classColors()) {
    rows.push_back({each.name, each.hint, each.srgb, counts[zoneOf(each.kind, SkinLayer::kSkin)]});
  }
  for (const LayerColor& each : layerColors()) {
    const std::size_t zone = zoneOf(TriangleClass::kNormal, each.layer);
    if (each.layer != SkinLayer::kSkin && counts[zone] > 0)
      rows.push_back({each.name, each.hint, each.srgb, counts[zone]});
  }
  return rows;
}

float classesHeight(PanelUi& ui) {
  const float lines = static_cast<float>(zoneRows(ui.state).size()) + (showsLevels(ui) ? 2.0f : 1.0f);
  return lines * (ImGui::GetTextLineHeight() + ui.px(4)) + ui.px(16);
}

/// Draws the background of a legend at the picture's lower left corner, above the line of the mode.
LegendBox plate(PanelUi& ui, float width, float height) {
  const glm::vec4& v = ui.state.frame.viewport;
  const ImVec2 low{v.x + ui.px(kMargin), v.y + v.w - underPlate(ui) - height};
  const ImVec2 high{low.x + width, low.y + height};
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, palette::kPanel.faded(0.85f).packed(), ui.px(6));
  ui.covered.emplace_back(low.x, low.y, high.x, high.y);
  return {low, high};
}

std::string number(float value, const char* unit) {
  char text[48];
  const float size = std::abs(value);
  std::snprintf(text, sizeof text, size >= 100.0f ? "%.0f%s" : (size >= 1.0f ? "%.2f%s" : "%.3f%s"),
                static_cast<double>(value), unit);
  return text;
}

/// Least and largest displacement of the current surface, character units.
std::array<float, 2> measured(const Surface& surface) {
  std::array<float, 2> range{0.0f, 0.0f};
  for (const float d : surface.displacement) range = {std::min(range[0], d), std::max(range[1], d)};
  return range;
}

void drawTick(PanelUi& ui, ImDrawList& list, float x, float top, float bar, const std::string& text, float align) {
  list.AddLine({x, top + bar}, {x, top + bar + ui.px(4)}, palette::kMuted.packed(), 1.0f);
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
  list.AddText({x - align * extent.x, top + bar + ui.px(5)}, palette::kText.packed(), text.c_str());
}

/// The scale with its ends in percent of H, and the range of the current surface.
void drawHeat(PanelUi& ui) {
  const float line = ImGui::GetTextLineHeight();
  const float room = ui.state.frame.viewport.z - ui.px(2 * kMargin + 2 * 12);
  const float width = std::min(ui.px(kScaleWidth), room);
  if (width < ui.px(kScaleNarrowest)) return;
  const LegendBox box = plate(ui, width + ui.px(2 * 12), heatHeight(ui));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float left = box.low.x + ui.px(12);
  list.AddText({left, box.low.y + ui.px(8)}, palette::kMuted.packed(), "Displacement");
  const float top = box.low.y + ui.px(12) + line;
  const float bar = ui.px(10);
  drawRamp({left, top}, width, top + bar, kLegendSteps, [](float x) {
    const glm::vec3 c = heatColor(2.0f * x - 1.0f);
    return Tint{c.r, c.g, c.b}.packed();
  });
  const float range = ui.state.view.display.heatRange;
  const float height = ui.state.character().height;
  drawTick(ui, list, left, top, bar, number(-100.0f * range, "% H"), 0.0f);
  if (width > ui.px(150)) drawTick(ui, list, left + 0.5f * width, top, bar, "0", 0.5f);
  drawTick(ui, list, left + width, top, bar, "+" + number(100.0f * range, "% H"), 1.0f);
  const std::array<float, 2> found = measured(ui.state.live->surface());
  for (const float value : found) {
    const float x = left + width * std::clamp(0.5f + 0.5f * value / (range * height), 0.0f, 1.0f);
    list.AddTriangleFilled({x - ui.px(4), top - ui.px(5)}, {x + ui.px(4), top - ui.px(5)}, {x, top + ui.px(1)},
                           palette::kText.packed());
  }
  const std::string text = "here " + number(100.0f * found[0] / height, "%") + " to +" +
                           number(100.0f * found[1] / height, "%") + "  (" + number(found[1], " units") + ")";
  const ImVec2 below{left, top + bar + line + ui.px(10)};
  const bool cut = clippedText(list, below, width, palette::kMuted.packed(), text);
  const bool over = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(below, {left + width, below.y + line});
  tooltipWhile(ui, cut && over, text);
  ui.widgets.note("legend/heat", {box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y});
}

/// A swatch for each level of subdivision: darker is finer.
void drawLevels(PanelUi& ui, const LegendBox& box, float y, bool over) {
  constexpr std::array kLevels{1, 2, 3, 4, 6, 12};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight() + ui.px(4);
  const float swatch = ui.px(20);
  float x = box.high.x - ui.px(12) - swatch * static_cast<float>(kLevels.size());
  clippedText(list, {box.low.x + ui.px(12), y}, x - box.low.x - ui.px(16), palette::kMuted.packed(), "Split");
  for (const int level : kLevels) {
    const glm::vec3 color = srgbFromLinear(levelShade(level) * linearFromSrgb(classColors()[2].srgb));
    list.AddRectFilled({x, y}, {x + swatch - ui.px(1), y + ImGui::GetTextLineHeight()},
                       Tint{color.r, color.g, color.b}.packed());
    const std::string text = std::to_string(level);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    list.AddText({x + 0.5f * (swatch - width), y}, (level < 4 ? palette::kPanel : palette::kText).packed(),
                 text.c_str());
    x += swatch;
  }
  tooltipWhile(ui, over && ImGui::IsMouseHoveringRect({box.low.x, y}, {box.high.x, y + line}),
               "Adaptive detail: about how many pieces a triangle of the file has along a side. Darker is finer.");
}

void drawClasses(PanelUi& ui) {
  const float line = ImGui::GetTextLineHeight() + ui.px(4);
  const float width = std::min(ui.px(210), ui.state.frame.viewport.z - ui.px(2 * kMargin));
  const LegendBox box = plate(ui, width, classesHeight(ui));
  const bool over = ImGui::IsWindowHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  clippedText(list, {box.low.x + ui.px(12), box.low.y + ui.px(8)}, width - ui.px(24), palette::kMuted.packed(),
              "Triangles of the file");
  float y = box.low.y + ui.px(8) + line;
  const int all = std::max(static_cast<int>(ui.state.character().mesh.triangles.size()), 1);
  for (const ZoneRow& row : zoneRows(ui.state)) {
    list.AddRectFilled({box.low.x + ui.px(12), y + ui.px(2)}, {box.low.x + ui.px(24), y + ui.px(14)},
                       Tint{row.srgb.r, row.srgb.g, row.srgb.b}.packed(), ui.px(3));
    const std::string count =
        std::to_string(row.triangles) + "  " + std::to_string((100 * row.triangles + all / 2) / all) + "%";
    const float right = box.high.x - ui.px(12) - ImGui::CalcTextSize(count.c_str()).x;
    const float left = box.low.x + ui.px(32);
    clippedText(list, {left, y}, right - ui.px(6) - left, palette::kText.packed(), row.name);
    if (right >= left) list.AddText({right, y}, palette::kMuted.packed(), count.c_str());
    tooltipWhile(ui, over && ImGui::IsMouseHoveringRect({box.low.x, y}, {box.high.x, y + line}), row.hint);
    y += line;
  }
  if (showsLevels(ui)) drawLevels(ui, box, y, over);
  ui.widgets.note("legend/classes", {box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y});
}

/// A slider for the clearness of the skin, and the colors of the muscles.
void drawAnatomy(PanelUi& ui) {
  const float line = ImGui::GetTextLineHeight();
  const float room = ui.state.frame.viewport.z - ui.px(2 * kMargin + 2 * 12);
  const float width = std::min(ui.px(kScaleWidth), room);
  if (width < ui.px(kScaleNarrowest)) return;
  const LegendBox box = plate(ui, width + ui.px(2 * 12), anatomyHeight(ui));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner{box.low.x + ui.px(12), box.low.y + ui.px(10)};
  const float slider = 0.62f * width;
  list.AddText({corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, palette::kMuted.packed(), kClearSkin.label);
  ImGui::SetCursorScreenPos({corner.x + width - slider, corner.y});
  ImGui::SetNextItemWidth(slider);
  float percent = 100.0f * ui.state.view.display.glass;
  NumberLook look;
  look.format = "%.0f%%";
  look.least = 0.0f;
  look.most = 100.0f;
  look.step = 10.0f;
  if (numberSlider(ui, "##glass", percent, look)) ui.state.view.display.glass = percent / 100.0f;
  ui.widgets.note(kClearSkin.id);
  tooltip(ui, "How clear the skin over the muscles is. 0%: as without Anatomy, 100%: only a faint rim is left.");
  const float top = corner.y + ImGui::GetFrameHeight() + ui.px(8);
  drawRamp({corner.x, top}, width, top + ui.px(10), kLegendSteps, [](float activation) {
    const glm::vec3 c = fleshColor(activation);
    return Tint{c.r, c.g, c.b}.packed();
  });
  const ImVec2 below{corner.x, top + ui.px(13)};
  list.AddText(below, palette::kMuted.packed(), "loose");
  list.AddText({corner.x + width - ImGui::CalcTextSize("flexed").x, below.y}, palette::kMuted.packed(), "flexed");
  const bool over =
      ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect({corner.x, top}, {corner.x + width, below.y + line});
  tooltipWhile(ui, over, "How far a muscle on a line is flexed. Muscles without a line are drawn in between.");
  ui.widgets.note("legend/anatomy", {box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y});
}

/// The mode's name at the picture's lower edge. @param button  leaves it; null: none  @param color  swatch; null: none
void drawMode(PanelUi& ui, const std::string& text, const char* button, const char* id, void (*leave)(EditorState&),
              const Tint* color = nullptr) {
  const glm::vec4& v = ui.state.frame.viewport;
  const float buttonWidth = button == nullptr ? 0.0f : ImGui::CalcTextSize(button).x + ui.px(24);
  const float swatch = color == nullptr ? 0.0f : ui.px(20);
  const float width = std::min(ImGui::CalcTextSize(text.c_str()).x + ui.px(28) + swatch + buttonWidth, v.z - ui.px(20));
  const float height = ImGui::GetFrameHeight() + ui.px(8);
  const ImVec2 low{v.x + 0.5f * (v.z - width), v.y + v.w - ui.px(14) - height};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + height}, palette::kPanel.faded(0.92f).packed(), ui.px(7));
  list.AddRect(low, {low.x + width, low.y + height}, palette::kAccent.faded(0.7f).packed(), ui.px(7));
  if (color != nullptr) {
    const ImVec2 at{low.x + ui.px(12), low.y + 0.5f * (height - ui.px(12))};
    list.AddRectFilled(at, {at.x + ui.px(12), at.y + ui.px(12)}, color->packed(), ui.px(3));
  }
  clippedText(list, {low.x + ui.px(12) + swatch, low.y + 0.5f * (height - ImGui::GetTextLineHeight())},
              width - swatch - buttonWidth - ui.px(16), palette::kText.packed(), text);
  ui.covered.emplace_back(low.x, low.y, low.x + width, low.y + height);
  ui.widgets.note(std::string(id) + "/banner", {low.x, low.y, width - buttonWidth, height});
  if (button == nullptr) return;
  ImGui::SetCursorScreenPos({low.x + width - buttonWidth, low.y + ui.px(4)});
  if (textButton(ui, std::string(id) + "/done", button, {buttonWidth - ui.px(4), 0.0f})) leave(ui.state);
}

/// Height of the legend; 0: none, or a panel takes its place.
float plateHeight(PanelUi& ui) {
  const DocumentView& open = ui.state.open;
  if (open.check.shown || open.muscleSet.shown || open.clipList.shown || open.reference.shown || open.sculptFit.shown)
    return 0.0f;
  if (showsExportError(ui.state)) return exportErrorSize(ui).y;
  if (ui.state.view.display.anatomy) return anatomyHeight(ui);
  const Shading shading = ui.state.view.display.shading;
  return shading == Shading::kHeat ? heatHeight(ui) : (shading == Shading::kClasses ? classesHeight(ui) : 0.0f);
}

}  // namespace

float legendHeight(PanelUi& ui) {
  const float below = modeShown(ui.state) ? underPlate(ui) : 0.0f;
  const float plate = plateHeight(ui);
  const float all = plate > 0.0f ? underPlate(ui) + plate : below;
  // If there is no room for both, only the tools are hidden.
  return ui.state.frame.viewport.w - all >= ui.px(kUnderTools) ? all : below;
}

void drawLegend(PanelUi& ui) {
  EditorState& state = ui.state;
  if (legendHeight(ui) > underPlate(ui)) {
    if (showsExportError(state)) drawExportError(ui, plate(ui, exportErrorSize(ui).x, exportErrorSize(ui).y).low);
    else if (state.view.display.anatomy) drawAnatomy(ui);
    else if (state.view.display.shading == Shading::kHeat) drawHeat(ui);
    else if (state.view.display.shading == Shading::kClasses) drawClasses(ui);
  }
  if (state.document.visibility.bare) {
    drawMode(ui, "Before: without muscles", state.view.bare.latched && !state.view.bare.byKey ? "Show" : nullptr,
             "before", latchBare);
  } else if (editsTerritory(state)) {
    const std::size_t bones = shownTerritory(state).size();
    const Tint color = territoryTint();
    drawMode(
        ui,
        "Territory of " + state.document.activeName() + ": " + std::to_string(bones) +
            (bones == 1 ? " bone" : " bones") + ". Click bones here or in the list.",
        "Done", "territory", [](EditorState& s) { endTerritoryMode(s.view.tools); }, &color);
  } else if (state.document.visibility.isolated) {
    drawMode(ui, hiddenText(state.document).empty() ? "Isolated" : hiddenText(state.document), "Show all", "isolated",
             [](EditorState& s) { showAll(s.document); });
  }
}

void drawBeforeButton(PanelUi& ui, float size) {
  const Action& before = action("view/before");
  const bool active = ui.state.document.visibility.bare;
  iconButton(ui, "toolstrip/before", Icon::kBefore, active, size, tooltipOf(ui, before) + " or the button is held.");
  holdBefore(ui, ImGui::IsItemActive());
}

void holdBefore(PanelUi& ui, bool held) { holdBare(ui.state, keyHeld(ui, action("view/before")), held); }

void drawTerritoryButton(PanelUi& ui, float size) {
  const Action& territory = action("tool/territory");
  ImGui::BeginDisabled(!territory.enabled(ui.state));
  const bool pressed = iconButton(ui, "toolstrip/territory", Icon::kTerritory, editsTerritory(ui.state), size);
  ImGui::EndDisabled();
  tooltip(ui, tooltipOf(ui, territory));
  if (pressed) run(territory, ui.state);
}

}  // namespace sinew::app
