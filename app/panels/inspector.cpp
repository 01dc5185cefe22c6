// app/panels/inspector.cpp: the selected muscles: name, bone, group, placement, effect, territory.

#include "app/panels/inspector.h"
#include "app/panels/bone_list.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/outliner_edit.h"
#include "app/panels/inspector_lines.h"
#include "app/ui/number_field.h"
#include "app/ui/readable_names.h"
#include "app/ui/reading_order.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

const Control kMuscleName{"inspector/name", "Name", "of the muscle rename"};
const Control kMuscleBone{"inspector/bone", "Bone", "of the muscle parent reparent joint"};
const Control kMuscleGroup{"inspector/group", "Group", "of the muscle blend"};
const Control kEffectSection{"inspector/section/effect", "Section Effect", "reach amount"};
const Control kMuscleReach{"inspector/reach", "Reach", "influence falloff softness", nullptr, kEffectSection.id};
const Control kAmount{"inspector/amount", "Amount", "strength weight opacity", nullptr, kEffectSection.id};
const Control kSign{"inspector/adds", "Effect", "adds or carves sign subtract negative positive", nullptr,
                    kEffectSection.id};

/// What fits into a drop-down list of the row's width, beside its arrow.
std::string comboText(const std::string& text) {
  const float frame = ImGui::GetFrameHeight() + 2.0f * ImGui::GetStyle().FramePadding.x;
  return fitted(text, ImGui::GetContentRegionAvail().x - frame);
}

void nameRow(PanelUi& ui, const Subjects& subjects) {
  beginRow(ui, kMuscleName);
  if (subjects.several()) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted((std::to_string(subjects.indices.size()) + " muscles").c_str());
    ui.widgets.note("inspector/names");
    std::string names;
    for (const int index : subjects.indices) {
      names += (names.empty() ? "" : ", ") + shownMuscleName(*subjects.rig, index);
    }
    tooltip(ui, names + "\nEdits apply to all of them.");
    return;
  }
  const std::string& name = subjects.shown().name;
  std::string text = name;
  const bool entered = ImGui::InputText("##name", &text, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note(kMuscleName.id);
  if (entered || ImGui::IsItemDeactivatedAfterEdit()) rename(ui.state, subjects.shown().id(), text);
}

void boneRow(PanelUi& ui, const Subjects& subjects) {
  const Skeleton& skeleton = ui.state.character().skeleton;
  beginRow(ui, kMuscleBone);
  const bool differ = subjects.differ([](const Primitive& p) { return p.bone; });
  const std::string missing = subjects.bone < 0 ? " (missing)" : "";
  const std::vector<std::string> names = shownFileNames(skeleton);
  const std::string own = subjects.bone < 0 ? subjects.shown().bone : at(names, subjects.bone);
  const std::string shown = differ ? "mixed" : own + missing;
  const bool open = ImGui::BeginCombo("##bone", comboText(shown).c_str(), ImGuiComboFlags_HeightLarge);
  ui.widgets.note(kMuscleBone.id);
  if (!open) {
    const std::string inFile = differ ? shown : subjects.shown().bone + missing;
    tooltip(ui, inFile + "\nThe bone that carries the muscle. On another one it keeps its place in the world.");
    return;
  }
  const int bone = boneList(ui, kMuscleBone.id, subjects.bone, differ ? -1 : subjects.bone, [](int) { return true; });
  if (bone >= 0) reparentMuscles(ui.state, subjects.indices, bone);
  ImGui::EndCombo();
}

void groupDot(PanelUi& ui, const ImVec2& at, float height, int group) {
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + ui.px(10), at.y + 0.5f * height}, ui.px(4.5f),
                                              groupTint(ui.state.document.rig(), group).packed(), 16);
}

void groupRow(PanelUi& ui, const Subjects& subjects) {
  const Rig& rig = *subjects.rig;
  beginRow(ui, kMuscleGroup);
  const bool differ = subjects.differ([](const Primitive& p) { return p.group; });
  const std::string& own = subjects.shown().group;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const int ownGroup = findGroup(rig, own);
  const std::string shown = differ ? "mixed" : "    " + (ownGroup < 0 ? own : shownGroupName(rig, ownGroup));
  const bool open = ImGui::BeginCombo("##group", comboText(shown).c_str());
  ui.widgets.note(kMuscleGroup.id);
  if (!open) {
    tooltip(ui, "Muscles of one group add up; the Groups tab says which groups blend with each other.");
    if (!differ) groupDot(ui, corner, ImGui::GetFrameHeight(), ownGroup);
    return;
  }
  for (int group = 0; group < static_cast<int>(rig.groups.size()); ++group) {
    const std::string& name = at(rig.groups, group).name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool chosen =
        ImGui::Selectable(("     " + inReadingOrder(shownGroupName(rig, group))).c_str(), !differ && name == own);
    ui.widgets.note("inspector/group/" + name);
    groupDot(ui, {at.x - ui.px(2), at.y}, ImGui::GetTextLineHeight(), group);
    if (chosen) moveToGroup(ui.state, subjects.indices, name);
  }
  ImGui::Separator();
  const bool wanted = ImGui::Selectable("     New group");
  ui.widgets.note("inspector/group-new");
  if (wanted) groupSelection(ui.state);
  ImGui::EndCombo();
}

/// What the reach does not allow of the shape is lessened, and that said.
void setReach(PanelUi& ui, Primitive& primitive, float reach) {
  primitive.reach = reach;
  Shape& shape = primitive.placement.shape;
  const Shape legal = legalShape(shape, reach);
  if (legal == shape || !(reach > 1.0f)) return;
  for (const ShapeNumber& number : shapeNumbers()) {
    if (number.of(legal) == number.of(shape)) continue;
    say(ui.state, std::string(number.words) + " of " + primitive.name + " lessened: with a larger reach it can be " +
                      numberText("%.2f", number.of(legal)) + " at most");
  }
  shape = legal;
}

void reachRow(PanelUi& ui, const Subjects& subjects) {
  beginRow(ui, kMuscleReach);
  NumberField field{kMuscleReach.id,
                    "Reach of",
                    "%.3f",
                    0.005f,
                    1.01f,
                    8.0f,
                    {},
                    {},
                    {},
                    kNewReach,
                    Together::kAdd,
                    "How far the muscle's influence reaches, in radii. A larger reach fades out more softly."};
  field.get = [](const Primitive& p) { return p.reach; };
  field.set = [&ui](Primitive& p, float value) { setReach(ui, p, value); };
  field.step = 0.1f;
  field.name = kMuscleReach.label;
  field.parameter = Parameter::kReach;
  ImGui::SetNextItemWidth(-1.0f);
  drawNumberField(ui, subjects, field);
}

void amountRow(PanelUi& ui, const Subjects& subjects) {
  constexpr float kPercent = 100.0f;
  beginRow(ui, kAmount);
  NumberField field{kAmount.id,
                    "Amount of",
                    "%.0f %%",
                    0.5f,
                    0.0f,
                    kPercent * kMostAmount,
                    {},
                    {},
                    {},
                    kPercent,
                    Together::kAdd,
                    "How strongly the muscle works: at 0 % it is not there, at 200 % twice as strong where it blends."};
  field.get = [](const Primitive& p) { return p.amount; };
  field.set = [](Primitive& p, float value) { p.amount = value; };
  field.scale = [](const Primitive&) { return kPercent; };
  field.step = 10.0f;
  field.name = kAmount.label;
  field.parameter = Parameter::kAmount;
  ImGui::SetNextItemWidth(-1.0f);
  drawNumberField(ui, subjects, field);
}

void signRow(PanelUi& ui, const Subjects& subjects) {
  beginRow(ui, kSign);
  const bool differ = subjects.differ([](const Primitive& p) { return p.sign; });
  constexpr const char* kSigns[] = {"Adds", "Carves"};
  const int now = differ ? -1 : (subjects.shown().sign > 0 ? 0 : 1);
  const int chosen = segmented(ui, "inspector", kSigns, 2, now, ImGui::GetContentRegionAvail().x);
  if (chosen < 0 || chosen == now) return;
  const int sign = chosen == 0 ? 1 : -1;
  editSubjects(ui, subjects, sign > 0 ? "Add with" : "Carve with", [sign](Primitive& p) { p.sign = sign; });
}

void nothingSelected(PanelUi& ui) {
  ImGui::PushTextWrapPos(0.0f);
  const int bone = ui.state.document.selection.bone;
  if (bone >= 0) {
    const std::string name = shownBoneName(ui.state.character().skeleton, bone);
    mutedText(("Bone " + name + ". Add a muscle on it with + in the list, or " +
               howToStart(ui, action("tool/add-muscle")) + " and drag on the skin.")
                  .c_str());
  } else {
    mutedText(("Nothing selected. Click a muscle, or " + howToStart(ui, action("tool/add-muscle")) +
               " and drag on the skin to add one.")
                  .c_str());
  }
  ImGui::PopTextWrapPos();
}

}  // namespace

void drawInspector(PanelUi& ui) {
  const int active = ui.state.document.activePrimitive();
  if (active < 0) {
    nothingSelected(ui);
    return;
  }
  Subjects subjects{ui.state.document.commands.sharedRig(), selectedIndices(ui.state.document), active, -1};
  subjects.bone = ui.state.character().skeleton.findBone(subjects.shown().bone).value_or(-1);
  ImGui::PushID(subjects.several() ? "several" : subjects.shown().name.c_str());
  nameRow(ui, subjects);
  boneRow(ui, subjects);
  groupRow(ui, subjects);
  drawTwinRow(ui, subjects);
  drawLineRows(ui, subjects);
  drawPlacementRows(ui, subjects);
  drawShapeRows(ui, subjects);
  if (section(ui, kEffectSection, "Effect")) {
    reachRow(ui, subjects);
    amountRow(ui, subjects);
    signRow(ui, subjects);
  }
  drawLineNumbers(ui);
  drawAnimationRows(ui, subjects);
  drawTerritoryRows(ui, subjects);
  ImGui::PopID();
}

}  // namespace sinew::app
