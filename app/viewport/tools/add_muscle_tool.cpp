// app/viewport/tools/add_muscle_tool.cpp: the tool that draws muscles on the skin.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/document/shown_names.h"
#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app {
namespace {

bool pressOnSkin(ToolFrame& frame) {
  if (!frame.tools.hover.skin) return false;
  const Result<void> begun = beginAddMuscle(frame.tools.addMuscle, frame.context, frame.tools.hover, frame.input.mouse);
  if (!begun) frame.result.refusal = begun.error();
  return begun.ok();
}

bool drawOnSkin(ToolFrame& frame, const ViewportInput& input) {
  AddMuscleState& state = frame.tools.addMuscle;
  if (!frame.document().commands.inGesture()) state.drag.reset();  // An undo may have ended the gesture.
  else updateAddMuscle(state, input, frame.context, frame.view);
  return state.drag.has_value();
}

std::string describeDrawing(const ToolFrame& frame) {
  const ViewportTools& tools = frame.tools;
  if (tools.addMuscle.drag) {
    return statusLine("New muscle, the pose is held while you draw",
                      {"Release keeps", "Wheel thickens or thins", "Esc cancels"});
  }
  if (!tools.hover.skin || tools.hover.bone < 0) {
    return statusLine("Background",
                      {"Drag orbits", "Drag on the skin adds a muscle", "Right+drag pans", "Wheel zooms"});
  }
  const std::string name = shownBoneName(frame.document().character->skeleton, tools.hover.bone);
  return statusLine("Skin", {"Drag adds a muscle on " + name, "Alt+drag orbits", "Right+drag pans", "Wheel zooms"});
}

}  // namespace

constinit const Tool kAddMuscleTool{
    .id = "tool/add-muscle",
    .label = "Add muscle",
    .hint = "Press on the skin and drag to add a muscle",
    .key = GLFW_KEY_M,
    .icon = Icon::kAddMuscle,
    .onSkin = true,
    .hover = hoverAt,
    .press = pressOnSkin,
    .drag = drawOnSkin,
    .cancel = [](ViewportTools& tools, Document& document) { cancelAddMuscle(tools.addMuscle, document); },
    .describe = describeDrawing,
};

}  // namespace sinew::app
