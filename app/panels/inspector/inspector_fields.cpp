// app/panels/inspector/inspector_fields.cpp: number fields that change one muscle or many.

#include <imgui.h>
#include <imgui_internal.h>  // TempInputIsActive: whether a number is typed or dragged.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "app/document/muscle_names.h"
#include "app/editor/commands.h"
#include "app/panels/inspector/inspector.h"
#include "app/panels/shared/field_edit.h"
#include "app/ui/number_field.h"
#include "core/rig/rig_edit_several.h"

namespace sinew::app {
namespace {

float scaleOf(const NumberField& field, const Primitive& primitive) {
  const float scale = field.scale ? field.scale(primitive) : 1.0f;
  return std::isfinite(scale) && scale > 0.0f ? scale : 1.0f;
}

float shownValue(const NumberField& field, const Primitive& primitive) {
  return field.get(primitive) * scaleOf(field, primitive);
}

float clamped(const NumberField& field, float shown) { return std::clamp(shown, field.least, field.most); }

/// The same number for all.
void assign(PanelUi& ui, const Subjects& subjects, const NumberField& field, float shown) {
  editSubjects(ui, subjects, field.undoLabel,
               [&](Primitive& primitive) { field.set(primitive, clamped(field, shown) / scaleOf(field, primitive)); });
}

/// A drag from one shown number to the next: the active muscle gets the number, the others the same change.
void follow(PanelUi& ui, const Subjects& subjects, const NumberField& field, float from, float to) {
  const std::string active = subjects.shown().name;
  editSubjects(ui, subjects, field.undoLabel, [&](Primitive& primitive) {
    const float own = shownValue(field, primitive);
    const float factor = from != 0.0f ? to / from : 1.0f;
    const float moved = field.together == Together::kMultiply ? own * factor : own + (to - from);
    field.set(primitive, clamped(field, primitive.name == active ? to : moved) / scaleOf(field, primitive));
  });
}

std::string textOf(const NumberField& field, float shown) {
  char text[64];
  std::snprintf(text, sizeof text, field.format, static_cast<double>(shown));
  return text;
}

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

void fieldMenu(PanelUi& ui, const Subjects& subjects, const NumberField& field, float shown) {
  if (!ImGui::BeginPopupContextItem(field.id.c_str())) return;
  const std::string reset = field.initial ? "Reset to " + textOf(field, *field.initial) : "Reset";
  const bool wanted = ImGui::MenuItem(reset.c_str(), nullptr, false, field.initial.has_value());
  ui.widgets.note("context/reset");
  if (wanted) assign(ui, subjects, field, *field.initial);
  ImGui::Separator();
  char exact[32];
  const auto written = std::to_chars(exact, exact + sizeof exact - 1, shown);
  *written.ptr = '\0';
  if (ImGui::MenuItem("Copy", nullptr)) ImGui::SetClipboardText(exact);
  ui.widgets.note("context/copy");
  const std::optional<float> pasted = numberIn(ImGui::GetClipboardText());
  const bool pasting = ImGui::MenuItem("Paste", nullptr, false, pasted.has_value());
  ui.widgets.note("context/paste");
  if (pasting) assign(ui, subjects, field, *pasted);
  ImGui::EndPopup();
}

}  // namespace

void editSubjects(PanelUi& ui, const Subjects& subjects, const char* label,
                  const std::function<void(Primitive&)>& change) {
  edit(ui.state, std::string(label) + " " + namedMuscles(*subjects.rig, subjects.indices),
       editPrimitives(ui.state.document.rig(), subjects.indices, change));
}

void drawNumberField(PanelUi& ui, const Subjects& subjects, const NumberField& field) {
  const std::string label = "##" + field.id;
  const ImGuiID id = ImGui::GetID(label.c_str());
  const bool typing = ImGui::TempInputIsActive(id);
  const bool differ = subjects.differ([&](const Primitive& p) { return shownValue(field, p); });
  const bool mixed = differ && ImGui::GetActiveID() != id;
  const float before = shownValue(field, subjects.shown());
  float value = before;
  if (mixed) ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted);
  NumberLook look{mixed ? "mixed" : field.format, field.speed, field.least, field.most, field.step};
  look.clampTyped = false;  // What is out of range is refused with its reason.
  const bool edited = numberField(label.c_str(), value, look);
  if (mixed) ImGui::PopStyleColor();
  const std::string step = std::string(field.undoLabel) + " " + namedMuscles(*subjects.rig, subjects.indices);
  beginFieldEdit(ui, field.id, step.c_str());
  if (edited && typing) assign(ui, subjects, field, value);
  if (edited && !typing) follow(ui, subjects, field, before, value);
  endFieldEdit(ui);
  const bool quiet = ImGui::IsItemActive();
  if (!quiet) {
    std::string hint =
        field.hint + (field.hint.empty() ? "" : "\n") + "Drag (Shift: precise, Ctrl: steps), or double-click to type";
    if (differ) hint += "; a drag keeps the differences, a typed number is for all";
    tooltip(ui, hint + ". Right click: reset, copy, paste.");
  }
  fieldMenu(ui, subjects, field, before);
}

void section(PanelUi& ui, const char* title, float room) {
  ImGui::Dummy({0.0f, ui.px(1)});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x - ui.px(room);
  const ImVec2 text = ImGui::CalcTextSize(title);
  const float y = at.y + 0.5f * text.y + (room > 0.0f ? ImGui::GetStyle().FramePadding.y : 0.0f);
  ImGui::GetWindowDrawList()->AddLine({at.x + text.x + ui.px(8), y}, {right, y}, palette::kLine.packed(), 1.0f);
  if (room > 0.0f) ImGui::AlignTextToFramePadding();
  mutedText(title);
}

}  // namespace sinew::app
