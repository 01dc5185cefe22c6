// app/panels/inspector.cpp: the selected muscles: name, bone, group, placement, effect, territory.

#include "app/panels/inspector.h"

#include <algorithm>
#include <span>
#include <string>

#include <imgui_stdlib.h>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/outliner.h"
#include "app/editor/symmetry_commands.h"
#include "app/ui/code_points.h"
#include "app/ui/number_field.h"
#include "app/ui/reading_order.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/rig/twins.h"

namespace sinew::app {
namespace {

const Control kMuscleName{"inspector/name", "Name", "of the muscle rename"};
const Control kMuscleBone{"inspector/bone", "Bone", "of the muscle parent reparent joint", withSingleMuscle};
const Control kMuscleGroup{"inspector/group", "Group", "of the muscle blend"};
const Control kEffectSection{"inspector/section/effect", "Section Effect", "reach amount", withSingleMuscle};
const Control kMuscleReach{"inspector/reach", "Reach", "influence falloff softness", withSingleMuscle,
                           kEffectSection.id};
const Control kAmount{"inspector/amount", "Amount", "strength weight opacity", withSingleMuscle, kEffectSection.id};
const Control kSign{"inspector/adds", "Effect", "adds or carves sign subtract negative positive", nullptr,
                    kEffectSection.id};

/// The text cut to the room in a drop-down list beside its arrow.
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
  std::string text = muscleName(*subjects.rig, subjects.active);
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

/// Also reduces shape numbers that the new reach does not allow, and reports it.
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
  NumberField field{kMuscleReach.id, "Reach of", "%.3f", 0.005f, 1.01f, 8.0f};
  field.initial = kNewReach;
  field.hint = "How far the muscle's influence reaches, in radii. A larger reach fades out more softly.";
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
  NumberField field{kAmount.id, "Amount of", "%.0f %%", 0.5f, 0.0f, kPercent * kMostAmount};
  field.initial = kPercent;
  field.hint = "How strongly the muscle works: at 0 % it is not there, at 200 % twice as strong where it blends.";
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
  const int now = differ ? -1 : (subjects.shown().sign > 0 ? 0 : 1);
  const int chosen = chooseWord(ui, "inspector", {"Adds", "Carves"}, now);
  if (chosen < 0 || chosen == now) return;
  const int sign = chosen == 0 ? 1 : -1;
  editSubjects(ui, subjects, sign > 0 ? "Add with" : "Carve with", [sign](Primitive& p) { p.sign = sign; });
}

void nothingSelected(PanelUi& ui) {
  const int bone = ui.state.document.selection.bone;
  const std::string start = howToStart(ui, action("tool/add-muscle"));
  mutedParagraph(bone < 0 ? "Nothing selected. Click a muscle, or " + start + " and drag on the skin to add one."
                          : "Bone " + shownBoneName(ui.state.character().skeleton, bone) +
                                ". Add a muscle on it with + in the list, or " + start + " and drag on the skin.");
}

}  // namespace

void drawInspector(PanelUi& ui) {
  const int active = ui.state.document.activePrimitive();
  if (active < 0) {
    nothingSelected(ui);
    return;
  }
  Subjects subjects{ui.state.document.commands.sharedRig(), selectedIndices(ui.state.document), active, -1};
  subjects.indices = leadsOf(*subjects.rig, subjects.indices);
  subjects.bone = ui.state.character().skeleton.findBone(subjects.shown().bone).value_or(-1);
  ImGui::PushID(subjects.several() ? "several" : subjects.shown().name.c_str());
  nameRow(ui, subjects);
  if (isBelly(*subjects.rig, active)) {
    groupRow(ui, subjects);
    drawTwinRow(ui, subjects);
    signRow(ui, subjects);
    drawSheetRows(ui);
    ImGui::PopID();
    return;
  }
  const Subjects all = subjects;
  subjects.indices = withoutSheets(*subjects.rig, std::move(subjects.indices));
  boneRow(ui, subjects);
  groupRow(ui, all);
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

// The numbers that turn an ellipsoid into a capsule, an egg or a bent spindle.

namespace {

const Control kShapeRow{"inspector/shape", "Shape", "of the muscle ellipsoid capsule egg spindle form",
                        withSingleMuscle};
/// In the order of shapeKeys().
const Control kShapeRows[] = {
    {"inspector/core", "Straight", "capsule cylinder core shape", withSingleMuscle, kShapeRow.id},
    {"inspector/belly", "Belly", "egg cone shape thicker end", withSingleMuscle, kShapeRow.id},
    {"inspector/bend.x", "Bend", "curve spindle shape sideways", withSingleMuscle, kShapeRow.id},
};

/// Sets one number of the shape. Makes the longest axis of an ellipsoid its y first, because shapes lie along y.
void reshape(Primitive& primitive, const ShapeNumber& number, float value) {
  primitive.placement = withLongAxisY(primitive.placement);
  Shape& shape = primitive.placement.shape;
  number.member(shape) = value;
  shape = legalShape(shape, primitive.reach);
}

void shapeField(PanelUi& ui, const Subjects& subjects, int index) {
  const ShapeNumber& number = shapeNumbers()[static_cast<std::size_t>(index)];
  const Primitive& shown = subjects.shown();
  const auto [low, high] = number.range(shown.placement.shape, shown.reach);
  NumberField field{std::string("inspector/") + number.name, number.change, "%.2f", 0.005f, low, high};
  field.initial = 0.0f;
  field.hint = number.hint;
  field.get = [&number](const Primitive& p) { return number.of(p.placement.shape); };
  field.set = [&number](Primitive& p, float value) { reshape(p, number, value); };
  field.step = 0.1f;
  field.name = number.words;
  field.parameter = shapeParameter(index);
  drawNumberField(ui, subjects, field);
}

/// The numbers of one key side by side.
void shapeRow(PanelUi& ui, const Subjects& subjects, std::span<const ShapeNumber> key, const Control& control) {
  beginRow(ui, control);
  const float gap = ui.px(4);
  const auto count = static_cast<float>(key.size());
  const float width = (ImGui::GetContentRegionAvail().x - gap * (count - 1.0f)) / count;
  for (const ShapeNumber& number : key) {
    if (&number != &key.front()) ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(width);
    shapeField(ui, subjects, static_cast<int>(&number - shapeNumbers().data()));
  }
}

/// "ellipsoid" or "shaped", "mixed" where the muscles differ; also says if all of them ride one bone.
std::string shapeText(const Subjects& subjects, bool anyRigid) {
  const bool mixed = subjects.differ([](const Primitive& p) { return p.placement.shape; });
  const char* shape = mixed ? "mixed" : (subjects.shown().placement.shape.isPlain() ? "ellipsoid" : "shaped");
  const bool onLines = subjects.differ([](const Primitive& p) { return p.line.empty(); });
  if (!anyRigid || onLines) return shape;
  return std::string(shape) + (subjects.several() ? ", each on one bone" : ", on one bone");
}

/// The row that shows or hides the rows of the shape. @return whether they are shown
bool foldRow(PanelUi& ui, const Subjects& subjects) {
  bool& open = ui.state.view.inspector.shapeOpen;
  const bool anyRigid = std::ranges::any_of(
      subjects.indices, [&](int index) { return at(subjects.rig->primitives, index).line.empty(); });
  beginRow(ui, kShapeRow);
  const std::string text = shapeText(subjects, anyRigid);
  if (ImGui::Button(fitted(text, ImGui::GetContentRegionAvail().x - ui.px(12)).c_str(), {-1.0f, 0.0f})) open = !open;
  ui.widgets.note(kShapeRow.id);
  tooltip(ui, text + "\nShow or hide the numbers that make it differ from an ellipsoid" +
                  (!anyRigid ? "." : ", and the bone that the other end is attached to."));
  return open;
}

}  // namespace

void drawShapeRows(PanelUi& ui, const Subjects& subjects) {
  if (!foldRow(ui, subjects)) return;
  const Control* control = kShapeRows;
  for (const std::span<const ShapeNumber> key : shapeKeys()) shapeRow(ui, subjects, key, *control++);
  drawOtherEndRow(ui, subjects);
}

// The muscle on the other side, and the link to it.

namespace {

Possible withTwin(const EditorState& state) {
  const int active = state.document.activePrimitive();
  return withMuscle(state)
      .also(leadsOf(state.document.rig(), selectedIndices(state.document)).size() == 1, "Select one muscle")
      .also(active >= 0 && !at(state.document.rig().primitives, active).mirror.empty(), "The muscle has no twin");
}

const Control kTwin{"inspector/twin", "Twin", "mirror other side linked", withTwin};

}  // namespace

void rowButton(PanelUi& ui, const char* text, const std::string& id, const char* actionId, float width) {
  const Action& item = action(actionId);
  const bool enabled = item.enabled(ui.state);
  ImGui::BeginDisabled(!enabled);
  const float room = width - 2.0f * ImGui::GetStyle().FramePadding.x;
  const bool pressed = textButton(ui, id, (fitted(text, room) + "##" + id).c_str(), {width, 0.0f});
  ImGui::EndDisabled();
  tooltip(ui, tooltipOf(ui, item));
  if (pressed && enabled) run(item, ui.state);
}

void drawTwinRow(PanelUi& ui, const Subjects& subjects) {
  if (subjects.several() || (!canMirror(ui.state.document) && subjects.shown().mirror.empty())) return;
  beginRow(ui, kTwin);
  const float room = ImGui::GetContentRegionAvail().x;
  const int other = twinOf(*subjects.rig, subjects.active);
  const std::string twin = other < 0 ? subjects.shown().mirror : muscleName(*subjects.rig, other);
  if (twin.empty()) {
    rowButton(ui, "Mirror to other side", "inspector/mirror", "edit/mirror", room);
    return;
  }
  const float gap = ui.px(4);
  const float unlink = buttonWidth("Unlink");
  const std::string why = whyTwinStays(ui.state.document);
  if (!why.empty()) ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0f, 0.5f});
  const float width = std::max(room - unlink - gap, ui.px(24));
  const std::string shown = fitted(twin, width - 2.0f * ImGui::GetStyle().FramePadding.x);
  const bool chosen = ImGui::Button((shown + "##twin").c_str(), {width, 0.0f});
  ImGui::PopStyleVar();
  if (!why.empty()) ImGui::PopStyleColor();
  ui.widgets.note(kTwin.id);
  tooltip(ui, why.empty() ? twin + "\nThe linked twin follows every edit, mirrored. Click to select it."
                          : twin + "\nThe twin stays where it is: " + why + ".");
  ImGui::SameLine(0.0f, gap);
  rowButton(ui, "Unlink", "inspector/unlink", "edit/unlink-twin", unlink);
  if (chosen) selectTwins(ui.state.document);
}

}  // namespace sinew::app
