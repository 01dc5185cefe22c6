// app/panels/panel_ui.cpp: the controls that panels share.
#include "app/panels/panel_ui.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include <imgui_stdlib.h>

#include "app/document/shown_names.h"
#include "app/editor/outliner.h"
#include "app/editor/visibility_commands.h"
#include "app/ui/reading_order.h"
#include "app/viewport/render/thumbnails.h"
#include "core/geometry/at.h"

namespace sinew::app {

void drawModal(PanelUi& ui, const char* title, const std::function<bool()>& draw) {
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    if (draw()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  popDialogStyle();
}

bool textButton(Ui& ui, const std::string& id, const char* label, const ImVec2& size, const std::string& hint) {
  const bool pressed = ImGui::Button(label, size);
  ui.widgets.note(id);
  tooltip(ui, hint);
  return pressed;
}

int chooseWord(Ui& ui, const char* id, std::initializer_list<const char*> words, int chosen) {
  return segmented(ui, id, words.begin(), static_cast<int>(words.size()), chosen, ImGui::GetContentRegionAvail().x);
}

bool contextItem(Ui& ui, const char* label, const std::string& id, bool enabled) {
  const bool chosen = ImGui::MenuItem(label, nullptr, false, enabled);
  ui.widgets.note("context/" + id);
  return chosen;
}

bool accentButton(Ui& ui, const std::string& id, const char* label, const ImVec2& size) {
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.45f));
  const bool pressed = textButton(ui, id, label, size);
  ImGui::PopStyleColor();
  return pressed;
}

void dialogLabel(Ui& ui, const char* text, float width) {
  ImGui::AlignTextToFramePadding();
  mutedText(text);
  ImGui::SameLine(ui.px(width));
}

void dialogExplain(Ui& ui, const char* text, float width) {
  ImGui::SetCursorPosX(ui.px(width));
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted.faded(0.8f));
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::Dummy({0.0f, ui.px(6)});
}

void mutedParagraph(const std::string& text) {
  ImGui::PushTextWrapPos(0.0f);
  mutedText(text.c_str());
  ImGui::PopTextWrapPos();
}

float buttonWidth(const char* label) { return ImGui::CalcTextSize(label).x + 2.0f * ImGui::GetStyle().FramePadding.x; }

namespace {

template <class Test>
bool anyKey(const PanelUi& ui, const Action& action, Test holds) {
  return std::ranges::any_of(shortcutsOf(action, ui.state.session.preferences),
                             [&](const Shortcut& shortcut) { return shortcut.key > 0 && holds(shortcut); });
}

}  // namespace

bool keyPressed(const PanelUi& ui, const Action& action) {
  const ImGuiIO& io = ImGui::GetIO();
  return anyKey(ui, action, [&](const Shortcut& shortcut) {
    const bool modified = shortcut.control == io.KeyCtrl && shortcut.shift == io.KeyShift && shortcut.alt == io.KeyAlt;
    return modified && ImGui::IsKeyPressed(shortcut.key, false);
  });
}

bool keyHeld(const PanelUi& ui, const Action& action) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return false;
  return anyKey(ui, action, [&](const Shortcut& shortcut) {
    const bool modified =
        (!shortcut.control || io.KeyCtrl) && (!shortcut.shift || io.KeyShift) && (!shortcut.alt || io.KeyAlt);
    return modified && ImGui::IsKeyDown(shortcut.key);
  });
}

std::string howToStart(const PanelUi& ui, const Action& action) {
  const std::string keys = keyText(action, ui.state);
  return keys.empty() ? std::string("choose ") + action.label : "press " + keys;
}

std::string tooltipOf(const PanelUi& ui, const Action& action) {
  std::string text = action.label;
  if (const std::string keys = keyText(action, ui.state); !keys.empty()) text += "  (" + keys + ")";
  return text + "\n" + hintOf(ui, action);
}

std::string hintOf(const PanelUi& ui, const Action& action) {
  const Possible possible = action.enabled(ui.state);
  return possible ? action.hint : std::string(action.hint) + "\nNot available: " + possible.reason();
}

void actionButton(PanelUi& ui, const std::string& id, const Action& action, Icon icon, float size) {
  const bool enabled = action.enabled(ui.state);
  const bool active = enabled && action.checked != nullptr && action.checked(ui.state);
  ImGui::BeginDisabled(!enabled);
  const bool pressed = iconButton(ui, id, icon, active, size);
  ImGui::EndDisabled();
  tooltip(ui, tooltipOf(ui, action));
  if (pressed) run(action, ui.state);
}

void actionPill(PanelUi& ui, const std::string& id, const Action& action) {
  const bool active = action.checked != nullptr && action.checked(ui.state);
  const bool pressed = pillButton(ui, id, action.label, active);
  tooltip(ui, tooltipOf(ui, action));
  if (pressed) run(action, ui.state);
}

ImTextureID thumbnailOf(const PanelUi& ui, const std::filesystem::path& document,
                        std::filesystem::file_time_type changed) {
  Thumbnails* const thumbnails = ui.state.session.thumbnails;
  const std::uintptr_t texture = thumbnails != nullptr ? thumbnails->texture(document, changed) : 0;
  return reinterpret_cast<ImTextureID>(texture);
}

namespace {

/// Steps through the tree from a bone to each bone.
std::vector<int> stepsFrom(const Skeleton& skeleton, int from) {
  const auto count = skeleton.bones.size();
  std::vector<int> steps(count, static_cast<int>(count));
  if (from < 0) return steps;
  int up = 0;
  for (int bone = from; bone >= 0; bone = at(skeleton.bones, bone).parent) at(steps, bone) = up++;
  // Parents come before their children.
  for (std::size_t b = 0; b < count; ++b) {
    const int parent = skeleton.bones[b].parent;
    if (parent >= 0) steps[b] = std::min(steps[b], at(steps, parent) + 1);
  }
  return steps;
}

std::vector<int> bonesByNearness(const Skeleton& skeleton, int from) {
  std::vector<int> order(skeleton.bones.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<int> steps = stepsFrom(skeleton, from);
  std::ranges::stable_sort(order, {}, [&](int bone) { return at(steps, bone); });
  return order;
}

}  // namespace

int boneList(PanelUi& ui, const std::string& id, int near, int chosen, const std::function<bool(int)>& isOffered,
             const std::function<void()>& drawOthers) {
  std::string& filter = ui.state.view.inspector.boneFilter;
  if (ImGui::IsWindowAppearing()) {
    filter.clear();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered =
      ImGui::InputTextWithHint("##bone-filter", "Search", &filter, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note(id + "-search");
  if (drawOthers) drawOthers();
  const Skeleton& skeleton = ui.state.character().skeleton;
  const std::vector<std::string> names = shownFileNames(skeleton);
  const std::vector<bool> hidden = hiddenBones(ui.state);
  int taken = -1;
  int first = -1;
  for (const int bone : bonesByNearness(skeleton, near)) {
    const std::string& name = skeleton.fileName(bone);
    const std::string& label = at(names, bone);
    if (isHidden(hidden, bone) || !isOffered(bone)) continue;
    if (!containsText(label, filter) && !containsText(name, filter)) continue;
    if (first < 0) first = bone;
    const bool pressed = ImGui::Selectable(inReadingOrder(label).c_str(), bone == chosen);
    ui.widgets.note(id + "/" + name);
    if (label != name) tooltip(ui, name);
    if (pressed) taken = bone;
  }
  if (first < 0) mutedText("No such bone");
  if (!entered || filter.empty() || first < 0) return taken;
  ImGui::CloseCurrentPopup();
  return first;
}

}  // namespace sinew::app
