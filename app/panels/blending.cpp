// app/panels/blending.cpp: the tab Groups: its head, the chosen group, menu and name field; the layout of the graph.

#include "app/panels/blending.h"

#include <imgui_stdlib.h>
#include <cmath>

#include <algorithm>

#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "app/editor/animate.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/outliner.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "core/geometry/at.h"
#include "core/rig/blending_graph.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {

// The layout of the graph: springs and repulsion.

namespace {

constexpr int kBlendingLayoutSteps = 240;
constexpr float kGravity = 0.03f;  ///< Per node; keeps unlinked parts together against the repulsion of all nodes.
constexpr float kClosest = 0.62f;  ///< Fraction of kNodeSpacing: the least distance of two nodes.
constexpr int kPartings = 60;
constexpr float kTau = 6.2831853f;

std::vector<glm::vec2> circle(int count) {
  std::vector<glm::vec2> places;
  const float around = kNodeSpacing / kTau * static_cast<float>(count);
  const float radius = count < 2 ? 0.0f : std::max(around, 0.6f * kNodeSpacing);
  for (int i = 0; i < count; ++i) {
    const float angle = kTau * static_cast<float>(i) / static_cast<float>(count) - 0.25f * kTau;
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return places;
}

/// Unit vector from b to a; if they coincide, a direction that depends on the salt.
glm::vec2 apart(const glm::vec2& a, const glm::vec2& b, std::size_t salt) {
  const glm::vec2 offset = a - b;
  const float length = glm::length(offset);
  if (length > 1e-3f) return offset / length;
  const float angle = 2.4f * static_cast<float>(salt + 1);
  return {std::cos(angle), std::sin(angle)};
}

void step(std::vector<glm::vec2>& places, std::span<const std::array<int, 2>> links, float longest) {
  std::vector<glm::vec2> push(places.size(), glm::vec2(0.0f));
  for (std::size_t i = 0; i < places.size(); ++i) {
    push[i] -= kGravity * static_cast<float>(places.size()) * places[i];
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      const float distance = std::max(glm::length(places[i] - places[j]), 1.0f);
      const glm::vec2 way = apart(places[i], places[j], i) * (kNodeSpacing * kNodeSpacing / distance);
      push[i] += way;
      push[j] -= way;
    }
  }
  for (const auto& [a, b] : links) {
    if (a == b) continue;
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    const glm::vec2 way = places[i] - places[j];
    const glm::vec2 pull = way * (glm::length(way) / kNodeSpacing);
    push[i] -= pull;
    push[j] += pull;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const float length = glm::length(push[i]);
    if (length > 0.0f) places[i] += push[i] * (std::min(length, longest) / length);
  }
}

/// Moves nodes apart that are too close for their labels.
void partOverlaps(std::vector<glm::vec2>& places) {
  const float least = kClosest * kNodeSpacing;
  for (int round = 0; round < kPartings; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        const float lacking = least - glm::length(places[i] - places[j]);
        if (lacking <= 0.01f) continue;
        const glm::vec2 way = apart(places[i], places[j], i) * (0.5f * lacking);
        places[i] += way;
        places[j] -= way;
        moved = true;
      }
    }
    if (!moved) return;
  }
}

void center(std::vector<glm::vec2>& places) {
  glm::vec2 low = places.front();
  glm::vec2 high = low;
  for (const glm::vec2& place : places) {
    low = {std::min(low.x, place.x), std::min(low.y, place.y)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }
  for (glm::vec2& place : places) place -= 0.5f * (low + high);
}

}  // namespace

std::vector<glm::vec2> layoutGraph(int count, std::span<const std::array<int, 2>> links) {
  std::vector<glm::vec2> places = circle(count);
  if (count < 2) return places;
  for (int i = 0; i < kBlendingLayoutSteps; ++i) {
    const float left = 1.0f - static_cast<float>(i) / static_cast<float>(kBlendingLayoutSteps);
    step(places, links, 0.3f * kNodeSpacing * left + 0.2f);
  }
  partOverlaps(places);
  center(places);
  return places;
}

glm::vec2 freePlace(std::span<const glm::vec2> taken) {
  for (int i = 0;; ++i) {
    const float turn = 0.7f * std::sqrt(static_cast<float>(i)) * 2.4f;
    const float radius = 0.28f * kNodeSpacing * std::sqrt(static_cast<float>(i));
    const glm::vec2 place{radius * std::cos(turn), radius * std::sin(turn)};
    const bool free = std::ranges::all_of(
        taken, [&](const glm::vec2& other) { return glm::length(other - place) >= 0.8f * kNodeSpacing; });
    if (free) return place;
  }
}

namespace {

const Control kGroupsView{"blending/view/matrix", "Groups as matrix or graph", "blend links nodes table"};
Possible withGroup(const EditorState& state) {
  return withCharacter(state).also(findGroup(state.document.rig(), state.open.blending.group) >= 0,
                                   "Choose a group in the tab Groups first");
}

const Control kNewGroup{"blending/add", "New group", "blend create"};
const Control kSelectMembers{"blending/select-members", "Select the muscles of the group", "members", withGroup};
const Control kMoveHere{"blending/move-here", "Move muscles to the group", "selected members join", withGroup};

/// The switch of the view, a button for a new group, and one that arranges the graph.
void drawHead(PanelUi& ui) {
  BlendingState& blending = ui.state.open.blending;
  bool& asGraph = ui.state.view.groupsAsGraph;
  const float button = ImGui::GetFrameHeight();
  const float gap = ui.px(4);
  const float room = ImGui::GetContentRegionAvail().x - (asGraph ? 2.0f : 1.0f) * (button + gap);
  constexpr const char* kViews[] = {"Matrix", "Graph"};
  const int chosen = segmented(ui, "blending/view", kViews, 2, asGraph ? 1 : 0, room);
  if (chosen >= 0) asGraph = chosen == 1;
  if (asGraph) {
    ImGui::SameLine(0.0f, gap);
    if (iconButton(ui, "blending/arrange", Icon::kArrange, false, button, "Arrange all groups again")) {
      blending.places.clear();
      blending.fitWanted = true;
    }
  }
  ImGui::SameLine(0.0f, gap);
  if (iconButton(ui, kNewGroup.id, Icon::kPlus, false, button, kNewGroup.label)) addEmptyGroup(ui.state);
}

void drawCounts(PanelUi& ui) {
  const int groups = static_cast<int>(ui.state.document.rig().groups.size());
  const int cliques = ui.state.live->report().cliques;
  std::string text = std::to_string(groups) + (groups == 1 ? " group, " : " groups, ") + std::to_string(cliques) +
                     (cliques == 1 ? " blend" : " blends");
  mutedLine(ui, text);
  ui.widgets.note("blending/cliques");
  tooltip(ui,
          "Muscles of one group always add up; linked groups blend, wholly or in part. A blend is a set of groups that "
          "are all linked to one another (a clique of the graph); where several blends reach, the strongest counts. At "
          "most " +
              std::to_string(kMaxCliques) + ".");
}

/// A line about the chosen group, with buttons for its muscles and the selection.
void drawChosen(PanelUi& ui, int group) {
  const auto rig = ui.state.document.commands.sharedRig();
  const std::string name = at(rig->groups, group).name;
  ImGui::Separator();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight();
  list.AddCircleFilled({at.x + ui.px(6), at.y + 0.5f * line}, ui.px(5), groupTint(*rig, group).packed(), 16);
  const float room = ImGui::GetContentRegionAvail().x;
  const bool cut =
      clippedText(list, {at.x + ui.px(18), at.y}, room - ui.px(18), palette::kText.packed(), groupText(*rig, group));
  ImGui::Dummy({room, line});
  ui.widgets.note("blending/chosen");
  if (cut) tooltip(ui, groupText(*rig, group));
  const float half = 0.5f * (room - ui.px(4));
  if (textButton(ui, kSelectMembers.id, "Select", {half, 0.0f}, "Select the muscles of this group"))
    selectMembers(ui.state.document, name);
  ImGui::SameLine(0.0f, ui.px(4));
  const std::vector<int> selected = selectedIndices(ui.state.document);
  ImGui::BeginDisabled(selected.empty());
  if (textButton(ui, kMoveHere.id, "Move here", {half, 0.0f}, "Move the selected muscles to this group"))
    moveToGroup(ui.state, selected, name);
  ImGui::EndDisabled();
}

/// Deletes an empty group; for another, a menu of the groups that get its muscles.
void deleteItems(PanelUi& ui, const Rig& rig, int group, bool empty) {
  if (empty) {
    if (contextItem(ui, "Delete group", "group-delete")) removeGroupOf(ui.state, group, -1);
    return;
  }
  const bool open = ImGui::BeginMenu("Delete group, muscles go to", rig.groups.size() > 1);
  ui.widgets.note("context/group-delete");
  if (!open) return;
  for (int into = 0; into < static_cast<int>(rig.groups.size()); ++into) {
    if (into == group) continue;
    const std::string& name = at(rig.groups, into).name;
    if (contextItem(ui, name.c_str(), "group-delete/" + name)) removeGroupOf(ui.state, group, into);
  }
  ImGui::EndMenu();
}

}  // namespace

std::string groupText(const Rig& rig, int group) {
  const std::string& name = at(rig.groups, group).name;
  const std::size_t count = leadsOf(rig, membersOf(rig, name)).size();
  return name + ": " + (count == 1 ? "1 muscle" : std::to_string(count) + " muscles");
}

std::string linkText(const std::string& a, const std::string& b, float amount) {
  const std::string both = a + " and " + b;
  if (amount == 0.0f) return both + " do not blend: the stronger wins. Click to link.";
  return both + " blend" + (amount < 1.0f ? " by " + percentText(amount) : "") + ". Click to unlink.";
}

AnimatedField fieldOfLink(const Rig& rig, int a, int b) {
  AnimatedField field{{}, {}, "%.0f %%"};
  const int link = findLink(rig, at(rig.groups, a).name, at(rig.groups, b).name);
  if (link < 0) return field;
  field.refs.push_back({Parameter::kLinkAmount, link});
  field.scales.push_back(100.0f);
  return field;
}

void linkMenu(PanelUi& ui, int a, int b) {
  const auto shown = [&](const Rig& rig) {
    return 100.0f * linkAmount(rig, at(rig.groups, a).name, at(rig.groups, b).name);
  };
  const Rig& rig = ui.state.document.rig();
  const AnimatedField field = fieldOfLink(rig, a, b);
  const AnimatedLook animation = lookOf(ui, field);
  mutedText((at(rig.groups, a).name + " and " + at(rig.groups, b).name).c_str());
  float percent = shown(rig);
  Typing typing;
  NumberLook look;
  look.format = field.format;
  look.least = 0.0f;
  look.most = 100.0f;
  look.step = 10.0f;
  ImGui::SetNextItemWidth(ui.px(160));
  if (animation.beingSet) {
    drawDrivenKeyField(ui, "blending/amount", field, look);
  } else {
    look.typing = &typing;
    pushAnimatedColors(animation);
    const bool edited = numberSlider(ui, "##amount", percent, look);
    popAnimatedColors(ui, animation);
    notePointed(ui, field);
    beginFieldEdit(ui, "blending/amount", "Link");
    if (edited) setLinkAmount(ui.state, a, b, percent / 100.0f);
    if (!typing.refusal.empty()) refuse(ui.state, errorAt({}, typing.refusal));
    endFieldEdit(ui, linkLabel(rig, a, b, shown(ui.state.document.rig()) / 100.0f));
    tooltip(ui, animation.words +
                    "How much the two groups blend: 0 % is a groove between them, 100 % adds them up. Drag, or "
                    "double-click to type");
  }
  if (field.refs.empty()) return;
  ImGui::Separator();
  animationMenu(ui, field);
}

void startGroupRename(EditorState& state, GroupId group) {
  const int index = findGroup(state.document.rig(), group);
  if (index < 0) return;
  state.open.blending.rename = {group, at(state.document.rig().groups, index).name, true};
}

void groupRenameField(PanelUi& ui, float width) {
  GroupRename& typed = ui.state.open.blending.rename;
  if (typed.appearing) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(width);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(5), ui.px(2)});
  const bool entered = ImGui::InputText("##group-name", &typed.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleVar();
  ui.widgets.note("blending/rename");
  const bool left = !typed.appearing && ImGui::IsItemDeactivated();
  typed.appearing = false;
  if (entered) renameGroupTo(ui.state, typed.group, typed.text);
  if (entered || left) typed = {};
}

void takeDroppedMuscles(PanelUi& ui, const std::string& group) {
  if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kMusclePayload)) {
    moveToGroup(ui.state, draggedMuscles(ui.state.document, *static_cast<const int*>(payload->Data)), group);
  }
}

void groupMenu(PanelUi& ui, int group) {
  const auto rig = ui.state.document.commands.sharedRig();
  const std::string name = at(rig->groups, group).name;
  const GroupId id = at(rig->groups, group).id();
  ui.state.open.blending.group = id;
  const std::vector<int> members = leadsOf(*rig, membersOf(*rig, name));
  const std::vector<int> selected = selectedIndices(ui.state.document);
  if (contextItem(ui, "Select its muscles", "group-select", !members.empty())) selectMembers(ui.state.document, name);
  if (contextItem(ui, "Move selected muscles here", "group-move-here", !selected.empty())) {
    moveToGroup(ui.state, selected, name);
  }
  if (contextItem(ui, "Rename", "group-rename")) startGroupRename(ui.state, id);
  ImGui::Separator();
  const bool hidden = !members.empty() && std::ranges::all_of(members, [&](int i) {
    return ui.state.document.visibility.hidden.muscles.contains(at(rig->primitives, i).id());
  });
  if (contextItem(ui, hidden ? "Show its muscles" : "Hide its muscles", "group-hide", !members.empty())) {
    for (const int i : members) {
      ui.state.document.visibility.setMuscle(Mark::kHidden, at(rig->primitives, i).id(), !hidden);
    }
  }
  ImGui::Separator();
  deleteItems(ui, *rig, group, members.empty());
}

namespace {

/// The link whose keys and drivers are shown, or -1.
int shownAnimatedLink(PanelUi& ui) {
  AnimateState& animate = ui.state.open.animate;
  BlendingState& blending = ui.state.open.blending;
  if (animate.sectionWanted && ownerOf(animate.chosen.number.parameter) == ParameterOwner::kLink) {
    blending.animatedLink = animate.chosen.number.link;
    animate.sectionWanted = false;
  }
  const Rig& rig = ui.state.document.rig();
  const int link = findLinkBetween(rig, blending.animatedLink);
  return link < 0 || at(rig.links, link).animated.empty() ? -1 : link;
}

/// Keys and drivers of a link, with a button that closes them.
void drawAnimatedLink(PanelUi& ui, int link, float height) {
  ImGui::Separator();
  const std::array<std::string, 2> groups = at(ui.state.document.rig().links, link).groups;
  const float button = ImGui::GetFrameHeight();
  const float room = ImGui::GetContentRegionAvail().x - button - ui.px(4);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fitted(groups[0] + " and " + groups[1], room).c_str());
  ui.widgets.note("blending/animation");
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - button);
  const bool closed = iconButton(ui, "blending/animation/close", Icon::kClose, false, button, "Close");
  ImGui::BeginChild("link-animation", {0.0f, height - button});
  drawLinkAnimation(ui, link);
  ImGui::EndChild();
  if (closed) ui.state.open.blending.animatedLink = {};
}

}  // namespace

void drawBlending(PanelUi& ui) {
  drawHead(ui);
  drawCounts(ui);
  if (ui.state.document.rig().groups.empty()) {
    return mutedParagraph("No groups yet. The first muscle makes one; muscles of one group always blend.");
  }
  const float spacing = ImGui::GetStyle().ItemSpacing.y;
  // The same height with and without a chosen group, so that nothing moves under the pointer.
  const float below = ImGui::GetTextLineHeight() + ImGui::GetFrameHeight() + 4.0f * spacing;
  const int animated = shownAnimatedLink(ui);
  const float room = ImGui::GetContentRegionAvail().y;
  const float ofLink = animated < 0 ? 0.0f : 0.5f * room;
  const float height = std::max(room - below - ofLink, ui.px(60));
  if (ui.state.view.groupsAsGraph) drawBlendingGraph(ui, height);
  else drawBlendingMatrix(ui, height);
  if (animated >= 0 && shownAnimatedLink(ui) == animated) drawAnimatedLink(ui, animated, ofLink);
  // A click above may have changed the rig.
  const int still = findGroup(ui.state.document.rig(), ui.state.open.blending.group);
  if (still >= 0) {
    drawChosen(ui, still);
  } else {
    ImGui::Separator();
    mutedLine(ui, "Click a group to choose it.");
  }
}

}  // namespace sinew::app
