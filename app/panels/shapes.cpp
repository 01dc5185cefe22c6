// app/panels/shapes.cpp: the tab Shapes: a slider for each morph target, grouped by the first part of their names.

#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/editor/edit.h"
#include "app/editor/outliner.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "app/panels/panels.h"
#include "app/ui/code_points.h"
#include "core/geometry/at.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

Possible withMorphs(const EditorState& state) {
  const bool any = state.hasCharacter() && !state.character().morphTargets.empty();
  return withCharacter(state).also(any, "This character has no shapes");
}

const Control kFindShapes{"shapes/search", "Search shapes", "the morph targets blend shapes find", withMorphs};
const Control kResetShapes{"shapes/reset", "Reset shapes", "all morph targets blend shapes zero", withMorphs};

constexpr float kShapesFold = 14.0f;  // Design pixels, as all here.
constexpr float kShapesIndent = 10.0f;
constexpr float kNameShare = 0.46f;
constexpr float kStep = 0.1f;

/// Shapes whose names begin with the same word.
struct ShapeGroup {
  std::string name;  ///< The name before the first "." or "_"; empty: shapes that share it with no other.
  std::vector<int> shapes;
};

std::string firstPart(const std::string& name) {
  const std::size_t end = name.find_first_of("._");
  return end == std::string::npos || end == 0 ? std::string() : name.substr(0, end);
}

/// In the order of the file.
std::vector<ShapeGroup> groupsOf(const Rig& rig, const std::string& search) {
  std::vector<ShapeGroup> groups;
  std::vector<int> alone;
  for (int i = 0; i < static_cast<int>(rig.morphs.size()); ++i) {
    const std::string& name = at(rig.morphs, i).name;
    if (!containsText(name, search)) continue;
    const std::string part = firstPart(name);
    auto group = std::ranges::find(groups, part, &ShapeGroup::name);
    if (group == groups.end()) group = groups.insert(groups.end(), {part, {}});
    group->shapes.push_back(i);
  }
  for (const ShapeGroup& group : groups) {
    if (group.name.empty() || group.shapes.size() == 1) {
      alone.insert(alone.end(), group.shapes.begin(), group.shapes.end());
    }
  }
  std::erase_if(groups, [](const ShapeGroup& group) { return group.name.empty() || group.shapes.size() == 1; });
  std::ranges::sort(alone);
  if (!alone.empty()) groups.insert(groups.begin(), {std::string(), std::move(alone)});
  return groups;
}

/// The target's weight from file, clip and rig together; an expression's weight, which only the rig sets.
float weightNow(const PanelUi& ui, int shape) {
  const PosedRig& posed = ui.state.document.posedRig(ui.state.live->pose());
  const std::vector<MorphTarget>& targets = ui.state.character().morphTargets;
  const std::string& name = at(ui.state.document.rig().morphs, shape).name;
  const auto found = std::ranges::find(targets, name, &MorphTarget::name);
  if (found == targets.end()) return at(posed.numbers.morphs, shape);
  return posed.morphWeights[static_cast<std::size_t>(found - targets.begin())];
}

bool isMissing(const PanelUi& ui, const std::string& name) {
  const Character& character = ui.state.character();
  return std::ranges::find(character.morphTargets, name, &MorphTarget::name) == character.morphTargets.end() &&
         std::ranges::find(character.morphSets, name, &MorphSet::name) == character.morphSets.end();
}

/// 0 to 1, extended to include the weight.
NumberLook lookFor(float weight) {
  NumberLook look{"%.2f", 0.01f, std::min(0.0f, weight), std::max(1.0f, weight), kStep};
  look.clampTyped = false;
  return look;
}

/// Marks the weight in this pose on the slider.
void markNow(PanelUi& ui, float now, const NumberLook& look) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const float fraction = std::clamp((now - look.least) / (look.most - look.least), 0.0f, 1.0f);
  const float x = low.x + fraction * (high.x - low.x);
  const float half = ui.px(1.0f);
  ImGui::GetWindowDrawList()->AddRectFilled({x - half, low.y}, {x + half, low.y + ui.px(4)},
                                            palette::kText.faded(0.8f).packed());
}

void shapeMenu(PanelUi& ui, int shape, const AnimatedField& field) {
  const Rig& rig = ui.state.document.rig();
  const MorphWeight morph = at(rig.morphs, shape);
  if (!ImGui::BeginPopupContextItem(("shapes/" + morph.name).c_str())) return;
  if (const auto chosen = numberMenu(ui, field.format, morph.weight, 0.0f)) {
    edit(ui.state, "Shape " + morph.name, setMorphWeight(rig, morph.name, *chosen));
  }
  ImGui::Separator();
  animationMenu(ui, field);
  ImGui::EndPopup();
}

void drawSlider(PanelUi& ui, int shape) {
  const MorphWeight morph = at(ui.state.document.rig().morphs, shape);
  const std::string id = "shapes/" + morph.name;
  const AnimatedField field{{{Parameter::kMorphWeight, shape}}, {1.0f}, "%.2f"};
  const AnimatedLook animation = lookOf(ui, field);
  NumberLook look = lookFor(morph.weight);
  ImGui::SetNextItemWidth(-1.0f);
  if (animation.beingSet) {
    drawDrivenKeyField(ui, id, field, look);
    return shapeMenu(ui, shape, field);
  }
  float weight = morph.weight;
  Typing typing;
  look.typing = &typing;
  pushAnimatedColors(animation);
  const bool edited = numberSlider(ui, ("##" + id).c_str(), weight, look);
  popAnimatedColors(ui, animation);
  const float now = weightNow(ui, shape);
  if (now != morph.weight) markNow(ui, now, look);
  notePointed(ui, field);
  editNumber(
      ui, id, ("Shape " + morph.name).c_str(), edited, typing,
      [&] { return setMorphWeight(ui.state.document.rig(), morph.name, weight); },
      [&](const Rig& rig) {
        const int index = findMorph(rig, morph.name);
        return numberText(look.format, index < 0 ? 0.0f : at(rig.morphs, index).weight);
      });
  const std::string together =
      now != morph.weight ? "In this pose " + numberText(look.format, now) + ", with the file and the clip (the mark)\n"
                          : std::string();
  tooltip(ui, animation.words + together + "The weight that the rig adds to " + morph.name +
                  ". Right click: reset, key, drive.");
  shapeMenu(ui, shape, field);
}

/// A click on the name of an animated shape shows its keys and drivers.
void drawRow(PanelUi& ui, int shape, float indent) {
  const MorphWeight morph = at(ui.state.document.rig().morphs, shape);
  ShapesState& shapes = ui.state.open.shapes;
  const bool animated = !morph.animated.empty();
  const AnimateState& animate = ui.state.open.animate;
  if (animate.sectionWanted && animate.chosen.number.morph == morph.name) shapes.chosen = morph.name;
  const bool open = animated && shapes.chosen == morph.name;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = kNameShare * ImGui::GetContentRegionAvail().x;
  ImGui::PushID(shape);
  const bool pressed = ImGui::InvisibleButton("##name", {width, ImGui::GetFrameHeight()});
  ImGui::PopID();
  ui.widgets.note("shapes/name/" + morph.name);
  const bool missing = isMissing(ui, morph.name);
  const bool hovered = ImGui::IsItemHovered();
  tooltip(ui, morph.name + (missing ? "\nThis character has no shape of that name" : "") +
                  (animated ? "\nClick shows its keys and drivers" : ""));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = low.y + ImGui::GetStyle().FramePadding.y;
  const float fold = animated ? ui.px(kShapesFold) : 0.0f;
  if (animated) {
    drawIcon(list, open ? Icon::kFoldOpen : Icon::kFoldClosed,
             {low.x + ui.px(indent), low.y + 0.5f * (ImGui::GetFrameHeight() - fold)}, fold, palette::kMuted.packed());
  }
  const Tint color = missing ? palette::kMuted.faded(0.6f) : hovered && animated ? palette::kText : palette::kMuted;
  clippedText(list, {low.x + ui.px(indent) + fold, y}, width - ui.px(indent + 4) - fold, color.packed(),
              shownMorphName(ui.state.document.rig(), shape));
  ImGui::SameLine(0.0f, 0.0f);
  drawSlider(ui, shape);
  if (pressed && animated) shapes.chosen = open ? std::string() : morph.name;
  if (open) drawMorphAnimation(ui, shape);
}

/// @return whether the group is unfolded
bool drawGroup(PanelUi& ui, const ShapeGroup& group) {
  ShapesState& shapes = ui.state.open.shapes;
  const bool folded = shapes.folded.contains(group.name);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetFrameHeight();
  if (ImGui::InvisibleButton(("##group" + group.name).c_str(), {width, height})) {
    if (folded) shapes.folded.erase(group.name);
    else shapes.folded.insert(group.name);
  }
  ui.widgets.note("shapes/group/" + group.name);
  const Tint color = ImGui::IsItemHovered() ? palette::kText : palette::kText.faded(0.85f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  drawIcon(list, folded ? Icon::kFoldClosed : Icon::kFoldOpen, {low.x, low.y + 0.5f * (height - ui.px(kShapesFold))},
           ui.px(kShapesFold), color.packed());
  const float y = low.y + ImGui::GetStyle().FramePadding.y;
  const std::string count = std::to_string(group.shapes.size());
  const float room = width - ui.px(kShapesFold + 12) - ImGui::CalcTextSize(count.c_str()).x;
  const float title = std::min(ImGui::CalcTextSize(group.name.c_str()).x, room);
  clippedText(list, {low.x + ui.px(kShapesFold + 4), y}, title, color.packed(), group.name);
  list.AddText({low.x + ui.px(kShapesFold + 10) + title, y}, palette::kMuted.packed(), count.c_str());
  return !folded;
}

/// Whether to show the keys and drivers of one of its shapes.
bool isWanted(const PanelUi& ui, const ShapeGroup& group) {
  const AnimateState& animate = ui.state.open.animate;
  return animate.sectionWanted && std::ranges::any_of(group.shapes, [&](int shape) {
           return animate.chosen.number.morph == at(ui.state.document.rig().morphs, shape).name;
         });
}

void drawTop(PanelUi& ui, const Rig& rig) {
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##search", "Search the shapes", &ui.state.open.shapes.search);
  ui.widgets.note(kFindShapes.id);
  const bool any = std::ranges::any_of(rig.morphs, [](const MorphWeight& morph) { return morph.weight != 0.0f; });
  ImGui::BeginDisabled(!any);
  if (ImGui::Button("Reset all", {-1.0f, 0.0f})) edit(ui.state, "Reset all shapes", withoutMorphWeights(rig));
  ImGui::EndDisabled();
  ui.widgets.note(kResetShapes.id);
  tooltip(ui, any ? "Every weight that was set becomes 0. Keys and drivers stay"
                  : "Every weight that was set becomes 0. Not available: all are 0");
}

}  // namespace

void drawShapes(PanelUi& ui) {
  if (!ui.state.hasCharacter()) return;
  if (ui.state.document.rig().morphs.empty()) {
    return mutedParagraph(
        "This character has no shapes. Files bring them as morph targets (shape keys, blend shapes).");
  }
  drawTop(ui, ui.state.document.rig());
  ImGui::BeginChild("shapes");
  const std::string& search = ui.state.open.shapes.search;
  const std::vector<ShapeGroup> groups = groupsOf(ui.state.document.rig(), search);
  for (const ShapeGroup& group : groups) {
    if (isWanted(ui, group)) ui.state.open.shapes.folded.erase(group.name);
    const bool unfolded = group.name.empty() || drawGroup(ui, group);
    if (!unfolded && search.empty()) continue;
    for (const int shape : group.shapes) drawRow(ui, shape, group.name.empty() ? 0.0f : kShapesIndent);
  }
  if (groups.empty()) mutedText("No shape of that name");
  ImGui::EndChild();
}

}  // namespace sinew::app
