// app/panels/field_edit.cpp: undo steps for edits of fields; colors, tooltips and driven keys of animated numbers.
#include "app/panels/field_edit.h"

#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>  // GetItemID; TempInputIsActive: whether a number is typed or dragged.

#include "app/document/shown_names.h"
#include "app/editor/animate.h"

namespace sinew::app {
namespace {

constexpr float kStrong = 0.42f;  // The color's fraction in the background.
constexpr float kFaint = 0.16f;
constexpr float kMark = 3.0f;  // Design pixels: half the mark of a key.

Tint mixed(const Tint& ground, const Tint& color, float fraction) {
  const auto of = [&](float a, float b) { return a + fraction * (b - a); };
  return {of(ground.r, color.r), of(ground.g, color.g), of(ground.b, color.b), 1.0f};
}

bool isColored(const AnimatedLook& look) { return look.driven || look.keyedHere || look.keyedElsewhere; }

/// "2 drivers", "3 keys in Walk", "keys in other clips"
std::string causesOf(const AnimatedNumber& number, const KeyTrack* track) {
  std::string causes;
  if (!number.drivers.empty()) causes = withCount(number.drivers.size(), "driver");
  if (track != nullptr) {
    causes += (causes.empty() ? "" : ", ") + withCount(track->curve.points.size(), "key") + " in " +
              (track->clip.empty() ? "every clip" : track->clip);
  } else if (!number.keys.empty()) {
    causes += std::string(causes.empty() ? "" : ", ") + "keys in other clips";
  }
  return causes;
}

/// A drag keeps differences, or ratios of radii; a typed number is assigned to all.
std::vector<float> valuesFor(const PanelUi& ui, const AnimatedField& field, float from, float to, bool same) {
  std::vector<float> values;
  for (std::size_t i = 0; i < field.refs.size(); ++i) {
    const float own = drivenKeyValue(ui.state, field.refs[i]) * field.scales[i];
    const bool factor = isRadius(field.refs[i].parameter) && from != 0.0f;
    const float moved = factor ? own * to / from : own + (to - from);
    values.push_back((same || i == 0 ? to : moved) / field.scales[i]);
  }
  return values;
}

/// The numbers of the field whose driven keys are being set.
AnimatedField beingSet(const PanelUi& ui, const AnimatedField& field) {
  AnimatedField set{{}, {}, field.format};
  const std::vector<HeldNumber>& numbers = ui.state.open.animate.drivenKey.numbers;
  for (std::size_t i = 0; i < field.refs.size(); ++i) {
    const HeldNumber own = held(ui.state.document.rig(), field.refs[i]);
    if (std::ranges::find(numbers, own) == numbers.end()) continue;
    set.refs.push_back(field.refs[i]);
    set.scales.push_back(field.scales[i]);
  }
  return set;
}

}  // namespace

AnimatedLook lookOf(PanelUi& ui, const AnimatedField& field) {
  AnimatedLook look;
  if (field.refs.empty()) return look;
  const NumberRef& ref = field.refs.front();
  const std::vector<HeldNumber>& numbers = ui.state.open.animate.drivenKey.numbers;
  look.beingSet = !numbers.empty() && std::ranges::find(numbers, held(ui.state.document.rig(), ref)) != numbers.end();
  const AnimatedNumber* number = animationOf(ui.state.document.rig(), ref);
  if (number == nullptr) return look;
  const KeyTrack* track = trackNow(ui.state, ref);
  look.driven = !number->drivers.empty();
  look.keyedHere = track != nullptr;
  look.keyedElsewhere = track == nullptr && !number->keys.empty();
  look.keyNow = track != nullptr && app::keyNow(ui.state, *track) >= 0;
  const auto text = [&](float value) { return numberText(field.format, value * field.scales.front()); };
  look.words = "Drawn " + text(numberOf(ui.state.document.rig(), ref)) + ", now " + text(numberNow(ui.state, ref)) +
               ": " + causesOf(*number, track) + "\n";
  if (look.keyedHere) {
    look.words += "In this clip its keys replace the number. To change a key: set the number, then " +
                  howToStart(ui, action("edit/key")) + "\n";
  }
  return look;
}

void pushAnimatedColors(const AnimatedLook& look) {
  if (!isColored(look)) return;
  const Tint color = look.driven ? palette::kDriven : palette::kKeyed;
  const float share = look.driven || look.keyedHere ? kStrong : kFaint;
  ImGui::PushStyleColor(ImGuiCol_FrameBg, mixed(palette::kRaised, color, share));
  ImGui::PushStyleColor(ImGuiCol_FrameBgHovered, mixed(palette::kRaised, color, share + 0.08f));
  ImGui::PushStyleColor(ImGuiCol_FrameBgActive, mixed(palette::kRaised, color, share + 0.12f));
}

void popAnimatedColors(PanelUi& ui, const AnimatedLook& look) {
  if (isColored(look)) ImGui::PopStyleColor(3);
  if (look.driven && (look.keyedHere || look.keyedElsewhere)) {
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        palette::kKeyed.faded(look.keyedHere ? 0.9f : 0.4f).packed(),
                                        ImGui::GetStyle().FrameRounding);
  }
  if (!look.keyNow) return;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const float half = ui.px(kMark);
  const ImVec2 at{high.x - half - 1.0f, low.y + half + 1.0f};
  ImGui::GetWindowDrawList()->AddQuadFilled({at.x - half, at.y}, {at.x, at.y - half}, {at.x + half, at.y},
                                            {at.x, at.y + half}, palette::kKeyed.packed());
}

void notePointed(PanelUi& ui, const AnimatedField& field) {
  if (field.refs.empty() || !ImGui::IsItemHovered()) return;
  std::vector<HeldNumber>& pointed = ui.state.open.animate.pointed;
  pointed.clear();
  for (const NumberRef& ref : field.refs) pointed.push_back(held(ui.state.document.rig(), ref));
}

void drawDrivenKeyField(PanelUi& ui, const std::string& id, const AnimatedField& all, NumberLook look) {
  const AnimatedField field = beingSet(ui, all);
  const std::string label = "##" + id;
  const bool typed = ImGui::TempInputIsActive(ImGui::GetID(label.c_str()));
  const float before = drivenKeyValue(ui.state, field.refs.front()) * field.scales.front();
  float value = before;
  Typing typing;
  look.typing = &typing;
  look.clampTyped = true;
  look.format = field.format;
  pushAnimatedColors({true, false, false, false, true, {}});
  const bool edited = numberField(label.c_str(), value, look);
  ImGui::PopStyleColor(3);
  ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), palette::kDriven.packed(),
                                      ImGui::GetStyle().FrameRounding, 0, ui.px(1.5f));
  if (ImGui::IsItemActivated()) ui.state.open.transport.playing = false;  // The input stands still.
  const std::string step = drivenKeyLabel(ui.state, field.refs);
  editField(ui, id, step.c_str(), edited, [&] {
    const bool same = typed && !typing.relative;
    return withDrivenKeys(ui.state, field.refs, valuesFor(ui, field, before, value, same));
  });
  if (!typing.refusal.empty()) refuse(ui.state, errorAt({}, typing.refusal));
  notePointed(ui, all);
  if (!ImGui::IsItemActive()) {
    tooltip(ui, "Driven keys are being set: drag, or double-click to type the number at " +
                    wordsFor(ui.state.open.animate.drivenKey.input, ui.state.character().skeleton) +
                    " as it is now. Pose the joint, then set the next one. Esc ends");
  }
}

void drawSharedField(PanelUi& ui, const std::string& id, const AnimatedField& field, const AnimatedLook& animation,
                     const SharedNumber& number, NumberLook look,
                     const std::function<void(const SharedEdit&)>& change) {
  const std::string label = "##" + id;
  const ImGuiID item = ImGui::GetID(label.c_str());
  const bool typed = ImGui::TempInputIsActive(item);
  const bool mixed = number.differ && ImGui::GetActiveID() != item;
  const bool muted = mixed && !animation.driven && !animation.keyedHere;  // Unreadable on amber and violet.
  Typing typing;
  if (mixed) look.format = "mixed";
  look.clampTyped = false;
  look.typing = &typing;
  float value = number.shown;
  if (muted) ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted);
  pushAnimatedColors(animation);
  const bool edited = numberField(label.c_str(), value, look);
  popAnimatedColors(ui, animation);
  if (muted) ImGui::PopStyleColor();
  notePointed(ui, field);
  beginFieldEdit(ui, id, number.step);
  if (edited) change({typed && !typing.relative, typing.relative, value});
  if (!typing.refusal.empty()) refuse(ui.state, errorAt({}, typing.refusal));
}

void beginFieldEdit(PanelUi& ui, const std::string& id, const char* label) {
  ui.widgets.note(id);
  if (!ImGui::IsItemActivated()) return;
  ui.state.document.commands.beginGesture(label);
  ui.state.open.gestureItem = ImGui::GetItemID();
}

void endFieldEdit(PanelUi& ui, const std::string& label) {
  if (!ImGui::IsItemDeactivated() || ui.state.open.gestureItem != ImGui::GetItemID()) return;
  // Esc restores the text that the field began with, which is a rounded value: restore the value itself.
  if (ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) {
    ui.state.document.commands.cancelGesture();
  } else {
    if (label.empty()) ui.state.document.commands.endGesture();
    else ui.state.document.commands.endGesture(label);
    sayRefusedField(ui.state);
  }
  ui.state.open.gestureItem = 0;
  ui.state.open.refusal.clear();
}

void endAbandonedEdit(EditorState& state) {
  if (state.open.gestureItem == 0 || ImGui::IsAnyItemActive()) return;
  state.document.commands.endGesture();
  state.open.gestureItem = 0;
}

}  // namespace sinew::app
