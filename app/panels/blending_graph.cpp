// app/panels/blending_graph.cpp: the blending graph: nodes to drag and edges to click.

#include <imgui_internal.h>  // NoNav: for the mouse alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "app/editor/blending_edit.h"
#include "app/panels/blending.h"
#include "app/ui/code_points.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

constexpr float kDiscRadius = 15.0f;  // Design pixels at zoom 1, as all here.
constexpr float kRimRadius = 23.0f;
constexpr float kEdgeReach = 6.0f;
constexpr float kLeastZoom = 0.1f;
constexpr float kMostZoom = 2.0f;

enum class Part { kNone, kDisc, kRim, kEdge };

struct Hit {
  Part part = Part::kNone;
  int group = -1;  ///< kDisc, kRim.
  int edge = -1;   ///< kEdge: index into Graph::edges.
};

struct Graph {
  PanelUi& ui;
  std::shared_ptr<const Rig> rig;
  std::vector<std::array<int, 2>> edges;
  std::vector<float> amounts;  ///< [edges]
  std::vector<glm::vec2> at;   ///< [groups] screen.
  glm::vec2 low{0.0f};         ///< The canvas's, screen.
  glm::vec2 size{0.0f};
  float scale = 1.0f;  ///< Screen units per design pixel of the graph.
  Hit hit;

  [[nodiscard]] BlendingState& state() const { return ui.state.open.blending; }
  [[nodiscard]] const std::string& name(int group) const { return rig->groups[static_cast<std::size_t>(group)].name; }
  [[nodiscard]] GroupId id(int group) const { return rig->groups[static_cast<std::size_t>(group)].id(); }
  [[nodiscard]] glm::vec2 place(int group) const { return at[static_cast<std::size_t>(group)]; }
  [[nodiscard]] float disc() const { return std::max(kDiscRadius * scale, ui.px(7)); }
  [[nodiscard]] float rim() const { return std::max(kRimRadius * scale, ui.px(12)); }
};

ImVec2 point(const glm::vec2& p) { return {p.x, p.y}; }

// Places -----------------------------------------------------------------------------------------------------------

/// Gives every group a place: lays out all groups if none has one, else puts new ones where there is room.
void settlePlaces(Graph& graph) {
  BlendingState& state = graph.state();
  const bool none =
      std::ranges::none_of(graph.rig->groups, [&](const Group& group) { return state.places.contains(group.id()); });
  if (none) {
    const std::vector<glm::vec2> laid = layoutGraph(static_cast<int>(graph.rig->groups.size()), graph.edges);
    for (std::size_t i = 0; i < laid.size(); ++i) state.places[graph.rig->groups[i].id()] = laid[i];
    return;
  }
  for (const Group& group : graph.rig->groups) {
    if (state.places.contains(group.id())) continue;
    std::vector<glm::vec2> taken;
    for (const Group& other : graph.rig->groups) {
      if (const auto found = state.places.find(other.id()); found != state.places.end()) taken.push_back(found->second);
    }
    state.places[group.id()] = freePlace(taken);
  }
}

/// Fits all nodes and their names into the canvas, without enlarging them.
void fit(Graph& graph) {
  BlendingState& state = graph.state();
  glm::vec2 low(1e9f);
  glm::vec2 high(-1e9f);
  for (const Group& group : graph.rig->groups) {
    const glm::vec2 place = state.places.at(group.id());
    low = {std::min(low.x, place.x), std::min(low.y, place.y)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }
  const glm::vec2 wanted = high - low + glm::vec2(84.0f, 92.0f);
  const glm::vec2 room = graph.size / graph.ui.scale;
  state.zoom = std::clamp(std::min({room.x / wanted.x, room.y / wanted.y, 1.0f}), kLeastZoom, kMostZoom);
  state.pan = -0.5f * (low + high) - glm::vec2(0.0f, 6.0f);
  state.fitWanted = false;
}

void projectPlaces(Graph& graph) {
  const BlendingState& state = graph.state();
  graph.scale = state.zoom * graph.ui.scale;
  graph.at.clear();
  for (const Group& group : graph.rig->groups) {
    graph.at.push_back(graph.low + 0.5f * graph.size + (state.places.at(group.id()) + state.pan) * graph.scale);
  }
}

// Picking -----------------------------------------------------------------------------------------------------------

float distanceToSegment(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b) {
  const glm::vec2 along = b - a;
  const float square = glm::dot(along, along);
  const float t = square > 0.0f ? std::clamp(glm::dot(p - a, along) / square, 0.0f, 1.0f) : 0.0f;
  return glm::length(p - a - t * along);
}

using LinkCurve = std::array<glm::vec2, 17>;

/// A straight line, or a curve around a third node that would hide part of the line.
LinkCurve curveOf(const Graph& graph, const std::array<int, 2>& edge) {
  const glm::vec2 a = graph.place(edge[0]);
  const glm::vec2 b = graph.place(edge[1]);
  const glm::vec2 along = b - a;
  const glm::vec2 across = glm::vec2(-along.y, along.x) / std::max(glm::length(along), 1.0f);
  glm::vec2 bend(0.0f);
  for (int group = 0; group < static_cast<int>(graph.at.size()); ++group) {
    if (group == edge[0] || group == edge[1]) continue;
    if (distanceToSegment(graph.place(group), a, b) >= graph.rim()) continue;
    bend = across * (glm::dot(graph.place(group) - a, across) > 0.0f ? -8.0f : 8.0f) * graph.rim();
  }
  LinkCurve curve;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(curve.size() - 1);
    curve[i] = a + t * along + t * (1.0f - t) * bend;
  }
  return curve;
}

Hit hitAt(const Graph& graph, const glm::vec2& mouse) {
  Hit hit;
  for (int group = static_cast<int>(graph.at.size()) - 1; group >= 0; --group) {
    const float distance = glm::length(mouse - graph.place(group));
    if (distance > graph.rim()) continue;
    return {distance <= graph.disc() ? Part::kDisc : Part::kRim, group, -1};
  }
  float nearest = graph.ui.px(kEdgeReach);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const LinkCurve curve = curveOf(graph, graph.edges[e]);
    float distance = nearest;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      distance = std::min(distance, distanceToSegment(mouse, curve[i - 1], curve[i]));
    }
    if (distance >= nearest) continue;
    nearest = distance;
    hit = {Part::kEdge, -1, static_cast<int>(e)};
  }
  return hit;
}

/// The numbers of the edge under the pointer.
AnimatedField pointedField(const Graph& graph) {
  if (graph.hit.part != Part::kEdge) return {};
  const auto& [a, b] = graph.edges[static_cast<std::size_t>(graph.hit.edge)];
  return fieldOfLink(*graph.rig, a, b);
}

std::string hintOf(const Graph& graph) {
  const Hit& hit = graph.hit;
  if (hit.part == Part::kDisc) return groupText(*graph.rig, hit.group) + "\nDrag moves the node; drop muscles here.";
  if (hit.part == Part::kRim) return "Drag from the rim to another group to link the two.";
  if (hit.part != Part::kEdge) return "";
  const auto& [a, b] = graph.edges[static_cast<std::size_t>(hit.edge)];
  return lookOf(graph.ui, pointedField(graph)).words +
         linkText(graph.name(a), graph.name(b), graph.amounts[static_cast<std::size_t>(hit.edge)]) +
         "\nRight click: set how much, key, drive.";
}

// Dragging ----------------------------------------------------------------------------------------------------------

/// The drag that a press on the canvas began; kept in the window's storage while the button is held.
enum class Grip { kNone, kNode, kLink, kEdge, kCanvas };

Grip grip() { return static_cast<Grip>(ImGui::GetStateStorage()->GetInt(ImGui::GetID("grip"), 0)); }
void setGrip(Grip grip) { ImGui::GetStateStorage()->SetInt(ImGui::GetID("grip"), static_cast<int>(grip)); }

void begin(Graph& graph) {
  switch (graph.hit.part) {
    case Part::kDisc:
      graph.state().group = graph.id(graph.hit.group);
      setGrip(Grip::kNode);
      if (ImGui::IsMouseDoubleClicked(0)) startGroupRename(graph.ui.state, graph.state().group);
      break;
    case Part::kRim:
      graph.state().linkFrom = graph.id(graph.hit.group);
      setGrip(Grip::kLink);
      break;
    case Part::kEdge:
      setGrip(Grip::kEdge);
      break;
    case Part::kNone:
      setGrip(Grip::kCanvas);
      if (ImGui::IsMouseDoubleClicked(0)) graph.state().fitWanted = true;
      break;
  }
}

void drag(Graph& graph) {
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  const glm::vec2 moved = glm::vec2(delta.x, delta.y) / graph.scale;
  BlendingState& state = graph.state();
  if (grip() == Grip::kCanvas) state.pan += moved;
  const auto place = state.places.find(state.group);
  const bool away = ImGui::IsMouseDragging(0, graph.ui.px(3));
  if (grip() == Grip::kNode && place != state.places.end() && away) place->second += moved;
}

void end(Graph& graph) {
  const Hit& hit = graph.hit;
  BlendingState& state = graph.state();
  if (grip() == Grip::kLink) {
    const int from = findGroup(*graph.rig, state.linkFrom);
    const bool other = from >= 0 && hit.group >= 0 && hit.group != from;
    if (other && linkAmount(*graph.rig, graph.name(from), graph.name(hit.group)) == 0.0f) {
      toggleLink(graph.ui.state, from, hit.group);
    } else if (hit.group == from && from >= 0) {
      state.group = state.linkFrom;
    }
  } else if (grip() == Grip::kEdge && hit.part == Part::kEdge) {
    const auto& [a, b] = graph.edges[static_cast<std::size_t>(hit.edge)];
    toggleLink(graph.ui.state, a, b);
  }
  state.linkFrom = {};
  setGrip(Grip::kNone);
}

void zoom(Graph& graph, const glm::vec2& mouse) {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel == 0.0f) return;
  BlendingState& state = graph.state();
  const float before = state.zoom;
  state.zoom = std::clamp(before * std::pow(1.15f, wheel), kLeastZoom, kMostZoom);
  const glm::vec2 offset = (mouse - graph.low - 0.5f * graph.size) / graph.ui.scale;
  state.pan += offset / state.zoom - offset / before;
}

void openMenu(Graph& graph) {
  if (graph.hit.group >= 0) {
    graph.state().group = graph.id(graph.hit.group);
    ImGui::OpenPopup("node-menu");
  } else if (graph.hit.part == Part::kEdge) {
    const auto& [a, b] = graph.edges[static_cast<std::size_t>(graph.hit.edge)];
    graph.state().shownLink = {graph.id(a), graph.id(b)};
    ImGui::OpenPopup("link-menu");
  }
}

void drawMenus(Graph& graph) {
  const Rig& rig = graph.ui.state.document.rig();
  if (ImGui::BeginPopup("node-menu")) {
    const int group = findGroup(rig, graph.state().group);
    if (group >= 0) groupMenu(graph.ui, group);
    ImGui::EndPopup();
  }
  if (ImGui::BeginPopup("link-menu")) {
    const int a = findGroup(rig, graph.state().shownLink[0]);
    const int b = findGroup(rig, graph.state().shownLink[1]);
    if (a >= 0 && b >= 0) linkMenu(graph.ui, a, b);
    ImGui::EndPopup();
  }
}

void takeInput(Graph& graph) {
  ImGui::SetCursorScreenPos(point(graph.low));
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  ImGui::InvisibleButton("canvas", {graph.size.x, graph.size.y});
  ImGui::PopItemFlag();
  ImGui::SetItemAllowOverlap();
  graph.ui.widgets.note("blending/canvas");
  const glm::vec2 mouse{ImGui::GetMousePos().x, ImGui::GetMousePos().y};
  const bool over = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (over || ImGui::IsItemActive()) graph.hit = hitAt(graph, mouse);
  notePointed(graph.ui, pointedField(graph));
  if (ImGui::IsItemActivated()) begin(graph);
  if (ImGui::IsItemActive()) drag(graph);
  if (ImGui::IsItemDeactivated()) end(graph);
  if (over) zoom(graph, mouse);
  if (over && grip() == Grip::kNone) tooltip(graph.ui, hintOf(graph));
  if (ImGui::BeginDragDropTarget()) {
    if (graph.hit.group >= 0) takeDroppedMuscles(graph.ui, graph.name(graph.hit.group));
    ImGui::EndDragDropTarget();
  }
  if (over && ImGui::IsMouseReleased(1)) openMenu(graph);
  drawMenus(graph);
}

// Drawing -----------------------------------------------------------------------------------------------------------

void drawDots(const Graph& graph, ImDrawList& list) {
  const float step = 24.0f * graph.scale;
  if (step < graph.ui.px(9)) return;
  const glm::vec2 origin = graph.low + 0.5f * graph.size + graph.state().pan * graph.scale;
  const float left = origin.x - std::ceil((origin.x - graph.low.x) / step) * step;
  const float top = origin.y - std::ceil((origin.y - graph.low.y) / step) * step;
  for (float y = top; y < graph.low.y + graph.size.y; y += step) {
    for (float x = left; x < graph.low.x + graph.size.x; x += step) {
      list.AddRectFilled({x, y}, {x + graph.ui.px(1), y + graph.ui.px(1)}, palette::kLine.packed());
    }
  }
}

void drawEdges(const Graph& graph, ImDrawList& list) {
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto& [a, b] = graph.edges[e];
    const bool hovered = graph.hit.part == Part::kEdge && graph.hit.edge == static_cast<int>(e);
    const float amount = graph.amounts[e];
    const Tint color = hovered ? palette::kError : palette::kMuted.faded(0.25f + 0.5f * amount);
    const LinkCurve curve = curveOf(graph, graph.edges[e]);
    for (const glm::vec2& place : curve) list.PathLineTo(point(place));
    list.PathStroke(color.packed(), ImDrawFlags_None, graph.ui.px((hovered ? 1.5f : 0.5f) + 1.5f * amount));
    const glm::vec2 middle = curve[curve.size() / 2];
    const float half = graph.ui.px(4);
    if (hovered) list.AddCircleFilled(point(middle), half, color.packed(), 12);
    if (const Link* link = animatedLink(*graph.rig, a, b)) {
      list.AddCircle(point(middle), half, animationTint(*link).packed(), 12, graph.ui.px(1.5f));
    }
    graph.ui.widgets.note("blending/edge/" + graph.name(a) + "/" + graph.name(b),
                          {middle.x - half, middle.y - half, 2.0f * half, 2.0f * half});
  }
  const int from = findGroup(*graph.rig, graph.state().linkFrom);
  if (from < 0 || grip() != Grip::kLink) return;
  const bool landing = graph.hit.group >= 0 && graph.hit.group != from;
  const ImVec2 to = landing ? point(graph.place(graph.hit.group)) : ImGui::GetMousePos();
  list.AddLine(point(graph.place(from)), to, palette::kAccent.packed(), graph.ui.px(2.5f));
}

void noteNode(const Graph& graph, int group) {
  const glm::vec2 at = graph.place(group);
  const glm::vec2 high = graph.low + graph.size;
  if (at.x < graph.low.x || at.y < graph.low.y || at.x > high.x || at.y > high.y) return;
  const float half = 0.5f * graph.disc();
  graph.ui.widgets.note("blending/node/" + graph.name(group), {at.x - half, at.y - half, 2.0f * half, 2.0f * half});
  const float ring = 0.5f * (graph.disc() + graph.rim());
  const float band = 0.5f * (graph.rim() - graph.disc());
  if (at.x + graph.rim() > high.x) return;
  graph.ui.widgets.note("blending/rim/" + graph.name(group),
                        {at.x + ring - band, at.y - band, 2.0f * band, 2.0f * band});
}

void drawNode(const Graph& graph, ImDrawList& list, int group) {
  noteNode(graph, group);
  const glm::vec2 at = graph.place(group);
  const Tint tint = groupTint(*graph.rig, group);
  const bool hovered = graph.hit.group == group;
  const bool rimmed = hovered && (graph.hit.part == Part::kRim || grip() == Grip::kLink);
  const bool chosen = graph.state().group == graph.id(group);
  list.AddCircleFilled(point(at), graph.rim(), palette::kPanel.packed(), 32);
  const Tint ring = rimmed ? palette::kAccent : (chosen ? palette::kText : tint.faded(hovered ? 0.9f : 0.45f));
  list.AddCircle(point(at), graph.rim() - graph.ui.px(1), ring.packed(), 32,
                 graph.ui.px(rimmed || chosen ? 2.5f : 1.5f));
  list.AddCircleFilled(point(at), graph.disc(), tint.packed(), 28);
  const std::string count = std::to_string(membersOf(*graph.rig, graph.name(group)).size());
  const float size = std::min(1.05f * graph.disc(), ImGui::GetFontSize());
  const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0.0f, count.c_str());
  list.AddText(ImGui::GetFont(), size, {at.x - 0.5f * extent.x, at.y - 0.5f * extent.y}, palette::kBackground.packed(),
               count.c_str());
  if (graph.state().rename.group == graph.id(group)) return;
  if (graph.state().zoom < 0.55f && !hovered && !chosen) return;
  const float margin = graph.ui.px(5);
  const float room = std::min(graph.ui.px(160), graph.size.x - 2.0f * margin);
  const std::string shown = fitted(shownGroupName(*graph.rig, group), room);
  const ImVec2 text = ImGui::CalcTextSize(shown.c_str());
  const float left = graph.low.x + margin;
  const float x = std::clamp(at.x - 0.5f * text.x, left, std::max(left, left + graph.size.x - 2.0f * margin - text.x));
  const float y = at.y + graph.rim() + graph.ui.px(1);
  list.AddRectFilled({x - graph.ui.px(3), y}, {x + text.x + graph.ui.px(3), y + text.y},
                     palette::kPanel.faded(0.8f).packed(), graph.ui.px(3));
  list.AddText({x, y}, (hovered || chosen ? palette::kText : palette::kText.faded(0.8f)).packed(), shown.c_str());
}

void drawRename(Graph& graph) {
  const int group = findGroup(*graph.rig, graph.state().rename.group);
  if (group < 0) return;
  const float width = std::min(graph.ui.px(120), graph.size.x);
  const glm::vec2 at = graph.place(group);
  const float x = std::clamp(at.x - 0.5f * width, graph.low.x, graph.low.x + graph.size.x - width);
  ImGui::SetCursorScreenPos({x, std::min(at.y + graph.rim(), graph.low.y + graph.size.y - graph.ui.px(24))});
  groupRenameField(graph.ui, width);
}

void lightUp(const Graph& graph) {
  EditorState& state = graph.ui.state;
  if (graph.hit.group >= 0) highlightGroup(state, graph.name(graph.hit.group));
  if (graph.hit.part != Part::kEdge) return;
  for (const int group : graph.edges[static_cast<std::size_t>(graph.hit.edge)]) {
    highlightGroup(state, graph.name(group));
  }
}

}  // namespace

void drawBlendingGraph(PanelUi& ui, float height) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kBackground);
  ImGui::BeginChild("blending-graph", {0.0f, height}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleColor();
  Graph graph{ui, ui.state.document.commands.sharedRig(), {}, {}, {}, {}, {}, 1.0f, {}};
  for (const Link& link : graph.rig->links) {
    const std::array<int, 2> edge{findGroup(*graph.rig, link.groups[0]), findGroup(*graph.rig, link.groups[1])};
    if (edge[0] < 0 || edge[1] < 0) continue;
    graph.edges.push_back(edge);
    graph.amounts.push_back(link.amount);
  }
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  graph.low = {corner.x, corner.y};
  graph.size = {std::max(room.x, 1.0f), std::max(room.y, 1.0f)};
  settlePlaces(graph);
  if (graph.state().fitWanted) fit(graph);
  projectPlaces(graph);
  takeInput(graph);
  projectPlaces(graph);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  drawDots(graph, list);
  drawEdges(graph, list);
  for (int group = 0; group < static_cast<int>(graph.at.size()); ++group) drawNode(graph, list, group);
  drawRename(graph);
  lightUp(graph);
  ImGui::EndChild();
}

}  // namespace sinew::app
