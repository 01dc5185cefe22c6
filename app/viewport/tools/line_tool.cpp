// app/viewport/tools/line_tool.cpp: the tool that draws muscles from bone to bone.

#include "app/viewport/tools/line_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cassert>
#include <utility>

#include <glm/geometric.hpp>

#include "app/document/shown_names.h"
#include "app/viewport/render/picking.h"
#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/tool.h"

namespace sinew::app {
namespace {

std::optional<SkinAnchor> skinUnder(const LineDrag& drag, const Character& character, const View& view,
                                    const glm::vec2& pixel) {
  const auto hit = pickSurface(view.rayThrough(pixel), drag.skin, character.mesh, character.materials);
  if (!hit) return std::nullopt;
  return SkinAnchor{hit->controlTriangle, hit->controlBarycentric, 0.0f};
}

/// Shows the muscle as one state of the gesture; where there can be none, the rig as it was.
void show(LineDrag& drag, const std::optional<SkinAnchor>& end, Document& document) {
  const Character& character = *document.character;
  drag.endBone = end ? boneAt(character, *end) : -1;
  drag.laid.reset();
  if (end) {
    const Result<LaidLine> laid = layLine(character, drag.bindSkin, drag.start, *end);
    const MirrorPlan* const plan = document.symmetry ? document.mirror.get() : nullptr;
    Result<Rig> rig = laid ? withLaidLine(*drag.rigBefore, laid.value(), plan) : Result<Rig>(laid.error());
    if (rig) {
      document.commands.updateGesture(std::move(rig).value());
      document.selection.set(document.idAt(static_cast<int>(drag.rigBefore->primitives.size())));
      drag.laid = laid.value();
    }
  }
  if (drag.laid) return;
  document.commands.updateGesture(*drag.rigBefore);
  document.selection = drag.selectionBefore;
}

/// The muscle that is kept: what the last state showed, mended where it would leave the flesh in a clip.
std::string finish(const LineDrag& drag, Document& document) {
  const Result<MendedLaidLine> kept = mended(*drag.laid, Motions(document.character));
  if (!kept) return {};
  const MirrorPlan* const plan = document.symmetry ? document.mirror.get() : nullptr;
  Result<Rig> rig = withLaidLine(*drag.rigBefore, kept->laid, plan);
  if (!rig) return {};
  document.commands.updateGesture(std::move(rig).value());
  document.selection.set(document.idAt(static_cast<int>(drag.rigBefore->primitives.size())));
  return kept->said;
}

bool press(ToolFrame& frame) {
  if (!frame.tools.hover.skin) return false;
  const Result<void> begun = beginLine(frame.tools.line, frame.context, frame.tools.hover, frame.input.mouse);
  if (!begun) frame.result.refusal = begun.error();
  return begun.ok();
}

bool draw(ToolFrame& frame, const ViewportInput& input) {
  LineToolState& state = frame.tools.line;
  // An undo from elsewhere has ended the gesture.
  if (!frame.document().commands.inGesture()) state.drag.reset();
  else frame.result.said = updateLine(state, input, frame.context, frame.view);
  return state.drag.has_value();
}

void cancel(ViewportTools& tools, Document& document) { cancelLine(tools.line, document); }

std::string describeDrag(const LineDrag& drag, const Skeleton& skeleton) {
  const std::string from = shownBoneName(skeleton, drag.startBone);
  if (drag.endBone < 0)
    return statusLine("From " + from, {"Release on the skin of another bone adds a muscle", "Esc cancels"});
  const std::string to = drag.endBone == drag.startBone ? "the same bone: it flexes, but no joint bends it"
                                                        : shownBoneName(skeleton, drag.endBone);
  return statusLine("From " + from + " to " + to, {"Release keeps", "Esc cancels"});
}

std::string describeTool(const ToolFrame& frame) {
  const ViewportTools& tools = frame.tools;
  const Skeleton& skeleton = frame.document().character->skeleton;
  if (tools.line.drag) return describeDrag(*tools.line.drag, skeleton);
  if (!tools.hover.skin || tools.hover.bone < 0) {
    return statusLine("Background", {"Drag orbits", "Drag from one bone's skin to another's adds a muscle that flexes",
                                     "Right+drag pans", "Wheel zooms"});
  }
  return statusLine("Skin", {"Drag from " + shownBoneName(skeleton, tools.hover.bone) + " to the bone that it pulls",
                             "Alt+drag orbits", "Right+drag pans", "Wheel zooms"});
}

}  // namespace

Result<void> beginLine(LineToolState& state, const ViewportContext& context, const ViewportHover& hover,
                       const glm::vec2& pixel) {
  if (!hover.skin || !context.surface) return errorAt("", "a muscle is added by pressing on the skin");
  Document& document = context.document;
  LineDrag drag;
  drag.skin = *context.surface;
  drag.bindSkin = bindSkin(*document.character);
  drag.start = {hover.skin->triangle, hover.skin->barycentric, 0.0f};
  drag.startBone = boneAt(*document.character, *hover.skin);
  drag.pressPixel = pixel;
  drag.selectionBefore = document.selection;
  drag.rigBefore = document.commands.sharedRig();
  document.commands.beginGesture("Add " + shownBoneName(document.character->skeleton, drag.startBone) + " muscle");
  state.drag = std::move(drag);
  return {};
}

std::string updateLine(LineToolState& state, const ViewportInput& input, const ViewportContext& context,
                       const View& view) {
  assert(state.drag);
  LineDrag& drag = *state.drag;
  if (input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed) {
    cancelLine(state, context.document);
    return {};
  }
  const bool dragged = glm::length(input.mouse - drag.pressPixel) > kDragThreshold * context.uiScale;
  if (dragged || drag.laid) {
    show(drag, skinUnder(drag, *context.document.character, view, input.mouse), context.document);
  }
  if (!input.button(MouseButton::kLeft).released) return {};
  if (!drag.laid) {
    cancelLine(state, context.document);
    return {};
  }
  const std::string said = finish(drag, context.document);
  context.document.commands.endGesture();
  state.drag.reset();
  return said;
}

void cancelLine(LineToolState& state, Document& document) {
  if (!state.drag) return;
  document.commands.cancelGesture();
  document.selection = state.drag->selectionBefore;
  state.drag.reset();
}

constinit const Tool kMuscleLineTool{
    .id = "tool/muscle-line",
    .label = "Add flexing muscle",
    .hint = "Press on the skin of one bone and release on another's: a muscle that stretches and flexes grows between",
    .key = GLFW_KEY_M,
    .shift = true,
    .icon = Icon::kMuscleLine,
    .handles = GizmoMode::kPoles,
    .whole = GizmoHandle::kNone,
    .onSkin = true,
    .picksMuscles = false,
    .target = nullptr,
    .beginHandle = nullptr,
    .continueHandle = nullptr,
    .hover = hoverAt,
    .press = press,
    .drag = draw,
    .cancel = cancel,
    .click = nullptr,
    .describe = describeTool,
};

}  // namespace sinew::app
