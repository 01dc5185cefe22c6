// app/panels/layers_panel.cpp: the parts of the mesh: skin, cloth or rigid, guessed or set. docs/characters.md.

#include "app/panels/inspector.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/shown_names.h"
#include "app/editor/visibility_commands.h"
#include "app/ui/code_points.h"
#include "app/ui/keyboard_focus.h"
#include "app/ui/number_field.h"
#include "app/viewport/render/color_scales.h"
#include "core/geometry/at.h"
#include "core/rig/mesh_layers.h"

namespace sinew::app {
namespace {

Possible withSetLayers(const EditorState& state) {
  return withCharacter(state)
      .also(hasParts(state), "This character is a single part")
      .also(!state.document.rig().layers.empty(), "All layers are as guessed");
}

const Control kGuessAll{"layers/guess-all", "Guess all layers", "parts of the mesh skin cloth rigid reset automatic",
                        withSetLayers};

constexpr float kOneLine = 390.0f;  // Design pixels, as all here. In a narrower panel the name is above its layers.
constexpr float kLayers = 140.0f;   // Width in one line.
constexpr float kOrigin = 62.0f;
constexpr float kSmall = 220.0f;  // In a narrower panel "Guess" is an icon.
constexpr float kLayersPanelGap = 6.0f;
constexpr float kDot = 18.0f;
constexpr float kBetween = 5.0f;  // Between parts that take two lines.

/// Data that all rows share.
struct LayerList {
  std::vector<std::string> names;
  std::vector<SkinLayer> layers;
  SharedEnds ends;
  int allTriangles = 0;
};

LayerList listOf(EditorState& state) {
  const Character& character = state.character();
  std::vector<int>& triangles = state.open.layers.triangles;
  if (triangles.empty()) {
    triangles.assign(character.parts.size(), 0);
    for (const ControlTriangle& triangle : character.mesh.triangles) ++at(triangles, triangle.part);
  }
  return {shownPartNames(character), partLayers(state), {}, static_cast<int>(character.mesh.triangles.size())};
}

std::string partHint(const PanelUi& ui, const LayerList& list, int part) {
  const int triangles = at(ui.state.open.layers.triangles, part);
  const LayerColor& layer = layerColor(at(list.layers, part));
  const float percent = 100.0f * static_cast<float>(triangles) / static_cast<float>(std::max(list.allTriangles, 1));
  return at(ui.state.character().parts, part).name + "\n" + std::to_string(triangles) + " triangles of the file, " +
         numberText(percent < 10.0f ? "%.1f %%" : "%.0f %%", percent) + "\n" + layer.name + ", " +
         (isLayerSet(ui.state, part) ? "set by you" : "guessed") + ". " + layer.hint +
         ".\nClick marks it in the picture.";
}

/// Dot, name and number of triangles; a click toggles the part's highlight in the picture.
void drawPartName(PanelUi& ui, const LayerList& list, int part, float width, bool oneLine) {
  int& chosen = ui.state.open.layers.chosen;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  if (ImGui::InvisibleButton("name", {width, height})) chosen = chosen == part ? -1 : part;
  ui.widgets.note("layers/part/" + at(ui.state.character().parts, part).name);
  if (ImGui::IsItemFocused() && focusShown()) ui.state.frame.hoveredPart = part;
  if (!ImGui::IsItemVisible()) return;
  const bool marked = chosen == part;
  const bool hovered = ImGui::IsItemHovered();
  tooltip(ui, partHint(ui, list, part));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (marked || hovered) {
    draw.AddRectFilled(low, {low.x + width, low.y + height},
                       (marked ? palette::kAccent.faded(0.20f) : palette::kText.faded(0.08f)).packed(), ui.px(4));
  }
  const glm::vec3& color = layerColor(at(list.layers, part)).srgb;
  draw.AddCircleFilled({low.x + ui.px(8), low.y + 0.5f * height}, ui.px(4), Tint{color.r, color.g, color.b}.packed(),
                       16);
  const float y = low.y + ImGui::GetStyle().FramePadding.y;
  const std::string count =
      std::to_string(at(ui.state.open.layers.triangles, part)) + (oneLine ? std::string() : " triangles");
  const float right = low.x + width - ui.px(4) - ImGui::CalcTextSize(count.c_str()).x;
  const bool counted = right - low.x > 0.5f * width;
  const float end = counted ? right - ui.px(8) : low.x + width - ui.px(4);
  clippedText(draw, {low.x + ui.px(kDot), y}, end - low.x - ui.px(kDot), palette::kText.packed(), at(list.names, part),
              list.ends);
  if (counted) draw.AddText({right, y}, palette::kMuted.packed(), count.c_str());
}

/// "guessed", or the button that restores the guess. @param small  an icon, or nothing if the layer is guessed
void drawOrigin(PanelUi& ui, int part, float width, bool small) {
  if (!isLayerSet(ui.state, part)) {
    ImGui::AlignTextToFramePadding();
    mutedText(small ? "" : "guessed");
    return;
  }
  const std::string id = "layers/guess/" + at(ui.state.character().parts, part).name;
  const std::string hint = std::string("Reset to the guess: ") + nameOf(at(ui.state.live->guessedLayers(), part));
  const bool pressed =
      small ? iconButton(ui, id, Icon::kReset, false, width, hint) : textButton(ui, id, "Guess", {width, 0.0f}, hint);
  if (pressed) setPartLayer(ui.state, part, std::nullopt);
}

void drawPart(PanelUi& ui, const LayerList& list, int part) {
  constexpr const char* kWords[] = {"Skin", "Cloth", "Rigid"};
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  const bool oneLine = room >= ui.px(kOneLine);
  const bool small = room < ui.px(kSmall);
  const float gap = ui.px(kLayersPanelGap);
  const float origin = small ? ImGui::GetFrameHeight() : ui.px(kOrigin);
  const float layers = oneLine ? ui.px(kLayers) : room - origin - gap;
  const float name = oneLine ? room - layers - origin - 2.0f * gap : room;
  ImGui::PushID(part);
  drawPartName(ui, list, part, name, oneLine);
  if (oneLine) ImGui::SameLine(0.0f, gap);
  const int now = static_cast<int>(at(list.layers, part));
  const bool isSet = isLayerSet(ui.state, part);
  const int clicked = segmented(ui, "layers/set/" + at(ui.state.character().parts, part).name, kWords, 3, now, layers);
  ImGui::SameLine(0.0f, gap);
  drawOrigin(ui, part, origin, small);
  if (!oneLine) ImGui::Dummy({0.0f, ui.px(kBetween)});
  ImGui::PopID();
  const ImVec2 high{low.x + room, ImGui::GetCursorScreenPos().y};
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high)) ui.state.frame.hoveredPart = part;
  // A guessed layer can be set, so that it stays.
  if (clicked >= 0 && (clicked != now || !isSet)) setPartLayer(ui.state, part, static_cast<SkinLayer>(clicked));
}

/// Layers of parts that only another character has.
void drawMissing(PanelUi& ui) {
  const std::vector<std::string> missing = missingParts(ui.state.document.rig(), ui.state.character());
  if (missing.empty()) return;
  mutedLine(ui, "Not on this character:");
  ui.widgets.note("layers/missing");
  int number = 0;
  for (const std::string& name : missing) {
    ImGui::PushID(--number);
    const float button = ui.px(kOrigin);
    const float room = ImGui::GetContentRegionAvail().x - button - ui.px(kLayersPanelGap);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const int index = findLayer(ui.state.document.rig(), name);
    const std::string text =
        readableName(name, "part", -number) + ": " + nameOf(at(ui.state.document.rig().layers, index).layer);
    clippedText(*ImGui::GetWindowDrawList(), {low.x + ui.px(kDot), low.y + ImGui::GetStyle().FramePadding.y},
                room - ui.px(kDot), palette::kMuted.packed(), text);
    const ImVec2 end{low.x + room, low.y + ImGui::GetFrameHeight()};
    tooltipWhile(ui, ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, end),
                 text + "\nThis character has no part of that name. It is kept for one that has.");
    ImGui::SetCursorScreenPos({end.x + ui.px(kLayersPanelGap), low.y});
    const bool pressed = textButton(ui, "layers/forget/" + name, "Forget", {button, 0.0f});
    ImGui::PopID();
    if (pressed) forgetPart(ui.state, name);
  }
}

}  // namespace

void drawLayersPanel(PanelUi& ui) {
  LayerList list = listOf(ui.state);
  const std::vector<std::string_view> names(list.names.begin(), list.names.end());
  list.ends = sharedEnds(names);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ui.px(2)});
  for (int part = 0; part < static_cast<int>(list.names.size()); ++part) drawPart(ui, list, part);
  drawMissing(ui);
  ImGui::PopStyleVar();
  const bool any = !ui.state.document.rig().layers.empty();
  ImGui::BeginDisabled(!any);
  const bool pressed = ImGui::Button("Guess all", {-1.0f, 0.0f});
  ImGui::EndDisabled();
  ui.widgets.note(kGuessAll.id);
  tooltip(ui,
          any ? "Resets every part to its guess" : "Resets every part to its guess. Not available: all are guessed");
  if (pressed) guessAllLayers(ui.state);
}

}  // namespace sinew::app
