// app/viewport/tools/line_handles.cpp: finds and drags anchors and via points.

#include "app/viewport/tools/line_handles.h"

#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "app/viewport/tools/status_line.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/line_pose.h"

namespace sinew::app {
namespace {

constexpr float kReach = 9.0f;  ///< Design pixels.
constexpr std::array kEnds{LineEnd::kOrigin, LineEnd::kInsertion, LineEnd::kVia};

LineAnchor* anchorOf(MuscleLine& line, LineEnd end) {
  if (end == LineEnd::kOrigin) return &line.origin;
  if (end == LineEnd::kInsertion) return &line.insertion;
  return line.via ? &*line.via : nullptr;
}

/// The point under a pixel at the depth of another.
glm::vec3 pointAt(const View& view, const glm::vec2& pixel, const glm::vec3& asFarAs) {
  const Ray ray = view.rayThrough(pixel);
  const glm::vec3 forward = view.forwardInWorld();
  return ray.origin + glm::dot(asFarAs - ray.origin, forward) / glm::dot(ray.direction, forward) * ray.direction;
}

/// The rig with the anchor under the pointer, in the pose of the frame.
Result<Rig> moved(const LineEndDrag& drag, int index, const ViewportContext& context, const View& view,
                  const glm::vec2& pixel) {
  const Rig& rig = context.document.rig();
  MuscleLine line = rig.lines[static_cast<std::size_t>(index)];
  LineAnchor* const anchor = anchorOf(line, drag.end);
  const Skeleton& skeleton = context.document.character->skeleton;
  const std::optional<int> bone = anchor ? skeleton.findBone(anchor->bone) : std::nullopt;
  if (!bone) return errorAt("", "this character lacks the bone of this end");
  const glm::mat4& inWorld = context.pose.boneInWorld[static_cast<std::size_t>(*bone)];
  const glm::vec3 now(inWorld * glm::vec4(anchor->point, 1.0f));
  const glm::vec3 wanted = pointAt(view, pixel - drag.grip, now);
  const glm::vec3 inBone(glm::inverse(glm::dmat4(inWorld)) * glm::dvec4(glm::dvec3(wanted), 1.0));
  if (!isFinite(inBone)) return errorAt("", "this bone is flattened in this pose");
  anchor->point = inBone;
  // Refused where the ends meet in the bind pose.
  if (const Result<LineRest> rest = lineRest(line, *context.document.character); !rest) return rest.error();
  return editLine(rig, index, [&](MuscleLine& edited) { *anchorOf(edited, drag.end) = *anchor; });
}

}  // namespace

const char* nameOf(LineEnd end) {
  constexpr std::array<const char*, 4> kNames{"", "origin", "insertion", "via point"};
  return kNames[static_cast<std::size_t>(end)];
}

std::optional<ShownLine> activeLine(const Document& document, const Pose& pose) {
  const int active = document.character ? document.activePrimitive() : -1;
  if (active < 0 || isBelly(document.rig(), active)) return std::nullopt;
  const PosedRig& posed = document.posedRig(pose);
  const int index = at(posed.muscles, active).line;
  if (index < 0 || !at(posed.lines, index).usable) return std::nullopt;
  const PosedLine& line = at(posed.lines, index);
  return ShownLine{index,          line.origin,
                   line.insertion, at(document.rig().lines, index).via ? std::optional(line.via) : std::nullopt,
                   line.stretch,   line.activation};
}

std::optional<glm::vec3> endPoint(const ShownLine& line, LineEnd end) {
  if (end == LineEnd::kOrigin) return line.origin;
  if (end == LineEnd::kInsertion) return line.insertion;
  return end == LineEnd::kVia ? line.via : std::nullopt;
}

LineEnd lineEndUnder(const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  const std::optional<ShownLine> line = activeLine(context.document, context.pose);
  LineEnd found = LineEnd::kNone;
  float nearest = kReach * context.uiScale;
  for (const LineEnd end : kEnds) {
    const std::optional<glm::vec3> point = line ? endPoint(*line, end) : std::nullopt;
    if (!point) continue;
    const glm::vec3 at = view.toPixel(*point);
    const float distance = glm::length(glm::vec2(at) - pixel);
    if (at.z > 1.0f || distance > nearest) continue;
    nearest = distance;
    found = end;
  }
  return found;
}

void beginLineEnd(LineHandles& handles, const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  const std::optional<ShownLine> line = activeLine(context.document, context.pose);
  const std::optional<glm::vec3> point = line ? endPoint(*line, handles.hovered) : std::nullopt;
  if (!point) return;
  const MuscleLine& named = context.document.rig().lines[static_cast<std::size_t>(line->index)];
  context.document.commands.beginGesture(std::string("Move ") + nameOf(handles.hovered) + " of " + named.name);
  handles.drag = LineEndDrag{handles.hovered, named.id(), pixel - glm::vec2(view.toPixel(*point))};
}

bool continueLineEnd(LineHandles& handles, const ViewportInput& input, const ViewportContext& context,
                     const View& view) {
  CommandStack& commands = context.document.commands;
  const int index = handles.drag ? findLine(context.document.rig(), handles.drag->line) : -1;
  if (index < 0 || !commands.inGesture()) {
    handles.drag.reset();
    return false;
  }
  if (input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed) {
    commands.cancelGesture();
    handles.drag.reset();
    return false;
  }
  // A refused state is not shown.
  Result<Rig> rig = moved(*handles.drag, index, context, view, input.mouse);
  if (rig) commands.updateGesture(std::move(rig).value());
  if (!input.button(MouseButton::kLeft).released) return true;
  commands.endGesture();
  handles.drag.reset();
  return false;
}

std::string describe(const LineHandles& handles) {
  if (handles.drag) {
    return statusLine(std::string("Moving the ") + nameOf(handles.drag->end), {"Release keeps", "Esc cancels"});
  }
  if (handles.hovered == LineEnd::kNone) return {};
  return statusLine(std::string("The muscle's ") + nameOf(handles.hovered), {"Drag moves it"});
}

}  // namespace sinew::app
