// app/panels/bone_list.cpp: bones in the order of their distance in the tree, without those that are hidden.
#include "app/panels/bone_list.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <numeric>

#include "app/document/shown_names.h"
#include "app/editor/outliner.h"
#include "app/editor/visibility_commands.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

/// Steps through the tree from one bone to each.
std::vector<int> stepsFrom(const Skeleton& skeleton, int from) {
  const auto count = skeleton.bones.size();
  std::vector<int> steps(count, static_cast<int>(count));
  if (from < 0) return steps;
  int up = 0;
  for (int bone = from; bone >= 0; bone = at(skeleton.bones, bone).parent) at(steps, bone) = up++;
  // Parents stand before their children.
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
