// app/viewport/tools/sheet_handles.cpp: finds and drags points of a sheet's edges.
#include "app/viewport/tools/sheet_handles.h"

#include <utility>

#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "app/viewport/tools/select.h"
#include "app/viewport/tools/sheet_stroke.h"
#include "app/viewport/tools/status_line.h"
#include "core/geometry/at.h"
#include "core/rig/sheet_edit.h"

namespace sinew::app {
namespace {

constexpr float kEdgePointReach = 9.0f;  ///< Design pixels.

/// The rig with the point at the skin under a pixel; nullopt: there is no skin.
std::optional<Result<Rig>> withPointAt(const EdgePointDrag& drag, int sheet, const ViewportContext& context,
                                       const View& view, const glm::vec2& pixel) {
  const std::optional<SkinAnchor> skin = skinUnder(context, view, pixel);
  if (!skin) return std::nullopt;
  const Result<LineAnchor> place = edgePointAt(*context.document.character, *skin);
  if (!place) return place.error();
  return editSheet(context.document.rig(), sheet, [&](MuscleSheet& edited) {
    LineAnchor& point = at(at(edited.edges, drag.point.edge).points, drag.point.point);
    point.bone = place->bone;
    point.point = place->point;
  });
}

bool hasPoint(const MuscleSheet& sheet, const EdgePoint& point) {
  return toIndex(point.edge) < sheet.edges.size() && toIndex(point.point) < at(sheet.edges, point.edge).points.size();
}

}  // namespace

std::string nameOfEdge(const MuscleSheet& sheet, int edge) {
  if (edge == 0) return "origin";
  return toIndex(edge) + 1 == sheet.edges.size() ? "insertion" : "edge " + std::to_string(edge + 1);
}

std::vector<glm::vec3> edgeInPose(const SheetEdge& edge, const Skeleton& skeleton, const Pose& pose) {
  std::vector<glm::vec3> points;
  for (const LineAnchor& anchor : edge.points) {
    if (const std::optional<int> bone = skeleton.findBone(anchor.bone)) {
      points.emplace_back(at(pose.boneInWorld, *bone) * glm::vec4(anchor.point, 1.0f));
    }
  }
  return points;
}

std::optional<ShownSheet> shownSheet(const Document& document, const Pose& pose) {
  if (!document.character) return std::nullopt;
  ShownSheet shown{activeSheet(document), {}};
  if (shown.index < 0) return std::nullopt;
  const Skeleton& skeleton = document.character->skeleton;
  if (!isPickable(document.visibility, document.rig(), skeleton, document.activePrimitive())) return std::nullopt;
  for (const SheetEdge& edge : at(document.rig().sheets, shown.index).edges) {
    shown.edges.push_back(edgeInPose(edge, skeleton, pose));
    if (shown.edges.back().size() != edge.points.size()) return std::nullopt;
  }
  return shown;
}

std::optional<EdgePoint> edgePointUnder(const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  const std::optional<ShownSheet> sheet = shownSheet(context.document, context.pose);
  std::optional<EdgePoint> found;
  float nearest = kEdgePointReach * context.uiScale;
  for (std::size_t e = 0; sheet && e < sheet->edges.size(); ++e) {
    for (std::size_t p = 0; p < sheet->edges[e].size(); ++p) {
      const glm::vec3 at = view.toPixel(sheet->edges[e][p]);
      const float distance = glm::length(glm::vec2(at) - pixel);
      if (at.z > 1.0f || distance > nearest) continue;
      nearest = distance;
      found = EdgePoint{static_cast<int>(e), static_cast<int>(p)};
    }
  }
  return found;
}

void beginEdgePoint(SheetHandles& handles, const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  const std::optional<ShownSheet> shown = shownSheet(context.document, context.pose);
  if (!shown || !handles.hovered) return;
  const MuscleSheet& sheet = at(context.document.rig().sheets, shown->index);
  if (!hasPoint(sheet, *handles.hovered)) return;
  const auto [edge, point] = *handles.hovered;
  context.document.commands.beginGesture("Move " + nameOfEdge(sheet, edge) + " of " + sheet.name);
  handles.drag =
      EdgePointDrag{*handles.hovered, sheet.name, pixel - glm::vec2(view.toPixel(at(at(shown->edges, edge), point)))};
}

bool continueEdgePoint(SheetHandles& handles, const ViewportInput& input, const ViewportContext& context,
                       const View& view) {
  CommandStack& commands = context.document.commands;
  const int index = handles.drag ? findSheet(context.document.rig(), handles.drag->sheet) : -1;
  const bool there = index >= 0 && hasPoint(at(context.document.rig().sheets, index), handles.drag->point);
  if (!there || !commands.inGesture()) {
    handles.drag.reset();
    return false;
  }
  if (input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed) {
    commands.cancelGesture();
    handles.drag.reset();
    return false;
  }
  // A refused state is not shown, and beside the body the point stays where it was.
  auto rig = withPointAt(*handles.drag, index, context, view, input.mouse - handles.drag->grip);
  if (rig && *rig) {
    commands.updateGesture(std::move(*rig).value());
    completeSheets(context.document);
  }
  if (!input.button(MouseButton::kLeft).released) return true;
  commands.endGesture();
  handles.drag.reset();
  return false;
}

std::string describe(const SheetHandles& handles, const Document& document) {
  const std::optional<EdgePoint> point = handles.drag ? handles.drag->point : handles.hovered;
  const int index = activeSheet(document);
  if (!point || index < 0) return {};
  const MuscleSheet& sheet = at(document.rig().sheets, index);
  const std::string name = nameOfEdge(sheet, point->edge) + " of " + sheet.name;
  if (handles.drag) return statusLine("Moving the " + name, {"Release keeps", "Esc cancels"});
  return statusLine("The " + name, {"Drag moves this point along the skin"});
}

}  // namespace sinew::app
