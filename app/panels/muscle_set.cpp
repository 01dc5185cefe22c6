// app/panels/muscle_set.cpp: the panel of the muscle set that was added last: set, Mass and Definition.

#include <imgui_internal.h>  // GetItemID, which 1.86 keeps to itself.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>

#include "app/editor/muscle_set_commands.h"
#include "app/panels/overlay.h"
#include "app/ui/number_field.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kMuscleSetWidth = 300.0f;  // Design pixels, as all here.
constexpr float kMuscleSetLabel = 84.0f;
constexpr float kRows = 4.0f;  // Besides a line of text.

std::string counted(std::size_t count, const char* one, const char* several) {
  return std::to_string(count) + ' ' + (count == 1 ? one : several);
}

std::string summaryOf(const MuscleSetState& set) {
  std::string text = counted(set.muscles.size(), "muscle a side", "muscles a side");
  if (!set.leftOut.empty()) text += " \xc2\xb7 " + std::to_string(set.leftOut.size()) + " left out";
  if (!set.mended.empty()) text += " \xc2\xb7 " + std::to_string(set.mended.size()) + " mended";
  return text;
}

std::string detailsOf(const MuscleSetState& set) {
  std::string text;
  for (const auto& [name, why] : set.leftOut) text += name + " is left out: " + why + '\n';
  for (const std::string& line : set.mended) text += "Mended " + line + '\n';
  if (!text.empty()) text.pop_back();
  return text;
}

void muscleSetLabel(PanelUi& ui, const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(ui.px(kMuscleSetLabel));
  ImGui::SetNextItemWidth(-1.0f);
}

void drawSets(PanelUi& ui) {
  const MuscleSetState& set = ui.state.open.muscleSet;
  muscleSetLabel(ui, "Set");
  int chosen = set.chosen;
  if (ImGui::BeginCombo("##set", inReadingOrder(at(set.sets, set.chosen).title).c_str())) {
    for (int i = 0; i < static_cast<int>(set.sets.size()); ++i) {
      ImGui::PushID(i);
      if (ImGui::Selectable(inReadingOrder(at(set.sets, i).title).c_str(), i == set.chosen)) chosen = i;
      ImGui::PopID();
      ui.widgets.note("muscle-set/sets/" + std::to_string(i));
    }
    ImGui::EndCombo();
  }
  ui.widgets.note("muscle-set/sets");
  if (chosen != set.chosen) chooseSet(ui.state, chosen);
}

/// The set follows a drag at once and is mended at its end; Esc cancels the change.
void slider(PanelUi& ui, const char* text, const char* id, float value, const NumberLook& look, const char* hint,
            PresetTuning (*with)(PresetTuning, float)) {
  EditorState& state = ui.state;
  muscleSetLabel(ui, text);
  const bool edited = numberSlider(ui, (std::string("##") + id).c_str(), value, look);
  ui.widgets.note(id);
  tooltip(ui, hint);
  if (edited) {
    previewSet(state, with(state.open.muscleSet.tuning, value));
    state.open.gestureItem = ImGui::GetItemID();
  }
  if (!previewsSet(state) || state.open.gestureItem != ImGui::GetItemID()) return;
  const bool escaped = ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false);
  if (!escaped && !ImGui::IsItemDeactivated()) return;
  state.open.gestureItem = 0;
  if (!escaped) return keepSet(state);
  dropPreview(state);
  if (ImGui::IsItemActive()) ImGui::ClearActiveID();  // The button is still down.
}

PresetTuning withMass(PresetTuning tuning, float mass) {
  tuning.mass = mass;
  return tuning;
}
PresetTuning withDefinition(PresetTuning tuning, float definition) {
  tuning.definition = definition;
  return tuning;
}

void drawSliders(PanelUi& ui) {
  const PresetTuning tuning = ui.state.open.muscleSet.tuning;
  NumberLook mass{"%.2f", 0.01f, kLeastMass, kMostMass, 0.1f};
  mass.logarithmic = true;
  slider(ui, "Mass", "muscle-set/mass", tuning.mass, mass, "Girth of all muscles", withMass);
  slider(ui, "Definition", "muscle-set/definition", tuning.definition.value_or(0.0f),
         {"%.2f", 0.01f, 0.0f, 1.0f, 0.05f}, "How far muscles stand out of the flesh", withDefinition);
}

}  // namespace

void drawMuscleSet(PanelUi& ui) {
  EditorState& state = ui.state;
  if (state.open.muscleSet.shown && !setIsTunable(state)) closeSet(state);
  if (!state.open.muscleSet.shown) return;
  const float width = widthInPicture(ui, kMuscleSetWidth);
  const float height = kRows * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() + ui.px(12);
  beginInPicture(ui, "muscle-set", {ui.px(kBesideTools), std::max(lowestInPicture(ui) - height, 0.0f)}, {width, height},
                 0.94f, {10, 8}, ImGuiWindowFlags_NoScrollbar);
  drawSets(ui);
  drawSliders(ui);
  const std::string summary = summaryOf(state.open.muscleSet);
  mutedText(fitted(summary, ImGui::GetContentRegionAvail().x).c_str());
  ui.widgets.note("muscle-set/summary");
  if (const std::string details = detailsOf(state.open.muscleSet); !details.empty()) tooltip(ui, details);
  const bool done = textButton(ui, "muscle-set/done", "Done", {}, "Keep the muscles as they are");
  ImGui::SameLine();
  const bool removed = textButton(ui, "muscle-set/remove", "Remove", {}, "Remove the set");
  endInPicture();
  if (removed) removeSet(state);
  else if (done) closeSet(state);
}

}  // namespace sinew::app
