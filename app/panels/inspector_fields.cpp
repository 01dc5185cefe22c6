// app/panels/inspector_fields.cpp: number fields that change one muscle or many.

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "app/ui/number_field.h"
#include "core/geometry/at.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

float scaleOf(const NumberField& field, const Primitive& primitive) {
  const float scale = field.scale ? field.scale(primitive) : 1.0f;
  return std::isfinite(scale) && scale > 0.0f ? scale : 1.0f;
}

float shownValue(const NumberField& field, const Primitive& primitive) {
  return field.get(primitive) * scaleOf(field, primitive);
}

/// The muscle as it was before the current gesture.
const Primitive& atStart(const PanelUi& ui, const Primitive& primitive) {
  const Rig& rig = ui.state.document.commands.rigOfStep();
  const int index = findPrimitive(rig, primitive.id());
  return index < 0 ? primitive : at(rig.primitives, index);
}

/// The active muscle gets the number, the others the same one or the same change.
void applyEdit(PanelUi& ui, const Subjects& subjects, const NumberField& field, const SharedEdit& change) {
  const PrimitiveId active = subjects.shown().id();
  const auto own = [&](const Primitive& p) { return shownValue(field, change.fromStart ? atStart(ui, p) : p); };
  const float from = own(subjects.shown());
  const float factor = from != 0.0f ? change.to / from : 1.0f;
  editSubjects(ui, subjects, field.undoLabel, [&](Primitive& primitive) {
    const bool exact = change.same || primitive.id() == active;
    const float moved =
        field.together == Together::kMultiply ? own(primitive) * factor : own(primitive) + (change.to - from);
    const float shown = std::clamp(exact ? change.to : moved, field.least, field.most);
    field.set(primitive, shown / scaleOf(field, primitive));
  });
}

std::string textOf(const NumberField& field, float shown) { return numberText(field.format, shown); }

std::optional<float> numberIn(const char* text) {
  if (text == nullptr) return std::nullopt;
  const std::string all = text;
  const std::size_t start = all.find_first_not_of(" \t\n");
  if (start == std::string::npos) return std::nullopt;
  float value = 0.0f;
  const auto read = std::from_chars(all.data() + start, all.data() + all.size(), value);
  if (read.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// "Radius Y 0.12 to 0.15 on biceps L" if all muscles had the same number and have the same now; else `plain`.
std::string stepName(const PanelUi& ui, const Subjects& subjects, const NumberField& field, const std::string& plain) {
  std::string text;
  for (const int index : subjects.indices) {
    const Primitive& before = atStart(ui, at(subjects.rig->primitives, index));
    const int now = findPrimitive(ui.state.document.rig(), before.id());
    if (now < 0) return plain;
    const Primitive& after = at(ui.state.document.rig().primitives, now);
    const std::string from = textOf(field, shownValue(field, before));
    const std::string to = textOf(field, shownValue(field, after));
    const std::string own = from + " to " + to + " on ";
    if (from == to || (!text.empty() && text != own)) return plain;
    text = own;
  }
  return field.name + " " + text + namedMuscles(*subjects.rig, subjects.indices);
}

/// The numbers that keys and drivers may change, the active muscle's first.
AnimatedField animatedOf(const Subjects& subjects, const NumberField& field) {
  AnimatedField animated{{}, {}, field.format};
  if (!field.parameter) return animated;
  const auto add = [&](int index) {
    animated.refs.push_back({*field.parameter, index});
    animated.scales.push_back(scaleOf(field, at(subjects.rig->primitives, index)));
  };
  add(subjects.active);
  for (const int index : subjects.indices) {
    if (index != subjects.active) add(index);
  }
  return animated;
}

void fieldMenu(PanelUi& ui, const Subjects& subjects, const NumberField& field, const AnimatedField& animated,
               float shown) {
  if (!ImGui::BeginPopupContextItem(field.id.c_str())) return;
  const std::optional<float> chosen = numberMenu(ui, field.format, shown, field.initial);
  if (chosen) applyEdit(ui, subjects, field, {true, false, *chosen});
  if (!animated.refs.empty()) ImGui::Separator();
  animationMenu(ui, animated);
  ImGui::EndPopup();
}

}  // namespace

std::optional<float> numberMenu(PanelUi& ui, const char* format, float shown, std::optional<float> initial) {
  std::optional<float> chosen;
  const std::string reset = initial ? "Reset to " + numberText(format, *initial) : "Reset";
  if (contextItem(ui, reset.c_str(), "reset", initial.has_value())) chosen = initial;
  ImGui::Separator();
  char exact[32];
  const auto written = std::to_chars(exact, exact + sizeof exact - 1, shown);
  *written.ptr = '\0';
  if (contextItem(ui, "Copy", "copy")) ImGui::SetClipboardText(exact);
  const std::optional<float> pasted = numberIn(ImGui::GetClipboardText());
  if (contextItem(ui, "Paste", "paste", pasted.has_value())) chosen = pasted;
  return chosen;
}

void editSubjects(PanelUi& ui, const Subjects& subjects, const char* label,
                  const std::function<void(Primitive&)>& change) {
  edit(ui.state, std::string(label) + " " + namedMuscles(*subjects.rig, subjects.indices),
       editPrimitives(ui.state.document.rig(), subjects.indices, change));
}

void drawNumberField(PanelUi& ui, const Subjects& subjects, const NumberField& field) {
  const AnimatedField animated = animatedOf(subjects, field);
  const AnimatedLook animation = lookOf(ui, animated);
  const float shown = shownValue(field, subjects.shown());
  const NumberLook look{field.format, field.speed, field.least, field.most, field.step};
  if (animation.beingSet) {
    drawDrivenKeyField(ui, field.id, animated, look);
    fieldMenu(ui, subjects, field, animated, shown);
    return;
  }
  const bool differ = subjects.differ([&](const Primitive& p) { return shownValue(field, p); });
  const std::string step = std::string(field.undoLabel) + " " + namedMuscles(*subjects.rig, subjects.indices);
  drawSharedField(ui, field.id, animated, animation, {shown, differ, step.c_str()}, look,
                  [&](const SharedEdit& change) { applyEdit(ui, subjects, field, change); });
  if (ImGui::IsItemDeactivated()) endFieldEdit(ui, stepName(ui, subjects, field, step));
  if (!ImGui::IsItemActive()) {
    std::string hint = field.hint + (field.hint.empty() ? "" : "\n") + animation.words +
                       "Drag (Shift: precise, Ctrl: steps), or double-click to type: 0.3, 12/5, +=0.1";
    if (differ) hint += "; a drag keeps the differences, a typed number is for all";
    tooltip(ui, hint + (animated.refs.empty() ? ". Right click: reset, copy, paste."
                                              : ". Right click: reset, copy, key, drive."));
  }
  fieldMenu(ui, subjects, field, animated, shown);
}

bool section(PanelUi& ui, const Control& control, const char* title, float room) {
  const char* const id = control.id;
  ImGui::Dummy({0.0f, ui.px(1)});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x - ui.px(room);
  const float mark = ui.px(14);
  const ImVec2 text = ImGui::CalcTextSize(title);
  const float height = room > 0.0f ? ImGui::GetFrameHeight() : text.y;
  const float y = at.y + 0.5f * height;
  std::vector<std::string>& folded = ui.state.view.layout.folded;
  const auto found = std::ranges::find(folded, id);
  const bool open = found == folded.end();
  const bool pressed = ImGui::InvisibleButton(id, {std::max(right - at.x, 1.0f), height});
  ui.widgets.note(id);
  const Tint tint = ImGui::IsItemHovered() ? palette::kText : palette::kMuted;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  drawIcon(list, open ? Icon::kFoldOpen : Icon::kFoldClosed, {at.x - ui.px(3), y - 0.5f * mark}, mark, tint.packed());
  list.AddText({at.x + mark, y - 0.5f * text.y}, tint.packed(), title);
  list.AddLine({at.x + mark + text.x + ui.px(8), y}, {right, y}, palette::kLine.packed(), 1.0f);
  if (pressed && open) folded.emplace_back(id);
  if (pressed && !open) folded.erase(found);
  return open;
}

}  // namespace sinew::app
