// app/viewport/tools/sheet_tool.cpp: the tool that draws sheets: a stroke for the origin, a second for the insertion.
#include "app/viewport/tools/sheet_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/viewport/render/picking.h"
#include "app/viewport/tools/sheet_handles.h"
#include "app/viewport/tools/sheet_stroke.h"
#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/viewport_tools.h"
#include "core/geometry/at.h"
#include "core/rig/sheet_edit.h"

namespace sinew::app {
namespace {

constexpr float kStrokeStep = 8.0f;    ///< Design pixels between points of a stroke.
constexpr int kMostPicks = 8;          ///< Points that one frame adds.
constexpr float kPerWheel = 1.12f;     ///< Factor on the heights.
constexpr float kLeastThicker = 0.3f;  ///< Of SheetDrag::thicker.
constexpr float kMostThicker = 3.0f;

const MirrorPlan* planOfSheet(const Document& document) { return document.symmetry ? document.mirror.get() : nullptr; }

/// Follows the pointer over the skin; what is beside the body is left out.
void extendStroke(SheetDrag& drag, const ToolFrame& frame, const glm::vec2& pixel) {
  const glm::vec2 way = pixel - drag.lastPixel;
  const int steps = std::min(static_cast<int>(glm::length(way) / (kStrokeStep * frame.context.uiScale)), kMostPicks);
  const Character& character = *frame.document().character;
  for (int i = 1; i <= steps; ++i) {
    const glm::vec2 at = drag.lastPixel + way * static_cast<float>(i) / static_cast<float>(steps);
    const auto hit = pickSurface(frame.view.rayThrough(at), drag.skin, character.mesh, character.materials);
    if (hit) drag.stroke.push_back({hit->controlTriangle, hit->controlBarycentric, 0.0f});
  }
  if (steps > 0) drag.lastPixel = pixel;
}

Result<Rig> withSheetOf(const SheetDrag& drag, const SheetEdge& origin, const Document& document) {
  Result<SheetEdge> insertion = edgeAlong(*document.character, drag.stroke);
  if (!insertion) return insertion.error();
  Result<MuscleSheet> sheet = sheetBetween(*document.character, origin, std::move(insertion).value(), drag.thicker);
  if (!sheet) return sheet.error();
  return withDrawnSheet(*drag.rigBefore, std::move(sheet).value(), planOfSheet(document));
}

/// Shows the sheet as the state of the gesture, or the rig before it if there can be none.
void showSheet(SheetDrag& drag, const SheetEdge& origin, Document& document) {
  Result<Rig> rig = withSheetOf(drag, origin, document);
  drag.why = rig ? "" : rig.error().reason;
  drag.shown = false;
  if (rig) {
    document.commands.updateGesture(std::move(rig).value());
    const std::string name = at(document.rig().sheets, static_cast<int>(drag.rigBefore->sheets.size())).name;
    const std::vector<int> laid = bellies(document.rig(), name);
    drag.shown = !laid.empty();
    if (drag.shown) return selectMuscle(document, laid.front());
    drag.why = "no sheet can be laid here";
  }
  document.commands.updateGesture(*drag.rigBefore);
  document.selection = drag.selectionBefore;
}

bool pressSheet(ToolFrame& frame) {
  const std::optional<SkinAnchor>& skin = frame.tools.hover.skin;
  if (!skin || !frame.context.surface) return false;
  SheetToolState& state = frame.tools.sheet;
  Document& document = frame.document();
  SheetDrag drag;
  drag.skin = *frame.context.surface;
  drag.stroke.push_back({skin->triangle, skin->barycentric, 0.0f});
  drag.lastPixel = frame.input.mouse;
  drag.selectionBefore = document.selection;
  drag.rigBefore = document.commands.sharedRig();
  if (state.origin) document.commands.beginGesture("Add sheet");
  state.drag = std::move(drag);
  return true;
}

/// Cancels the stroke; the origin stays.
void dropSheetStroke(SheetToolState& state, Document& document) {
  if (state.drag && state.origin) {
    if (document.commands.inGesture()) document.commands.cancelGesture();
    document.selection = state.drag->selectionBefore;
  }
  state.drag.reset();
}

void endOrigin(ToolFrame& frame) {
  SheetToolState& state = frame.tools.sheet;
  Result<SheetEdge> origin = edgeAlong(*frame.document().character, state.drag->stroke);
  state.drag.reset();
  if (origin) state.origin = std::move(origin).value();
  else frame.result.refusal = origin.error();
}

void endInsertion(ToolFrame& frame) {
  SheetToolState& state = frame.tools.sheet;
  Document& document = frame.document();
  showSheet(*state.drag, *state.origin, document);
  if (!state.drag->shown) {
    frame.result.refusal = errorAt("", state.drag->why);
    return dropSheetStroke(state, document);
  }
  document.commands.endGesture("Add " + document.activeName());
  state = {};
}

bool drawSheetStroke(ToolFrame& frame, const ViewportInput& input) {
  SheetToolState& state = frame.tools.sheet;
  if (state.origin && !frame.document().commands.inGesture()) state.drag.reset();  // An undo may have ended it.
  if (!state.drag) return false;
  if (input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed) {
    dropSheetStroke(state, frame.document());
    return false;
  }
  const float thicker = state.drag->thicker;
  const std::size_t points = state.drag->stroke.size();
  state.drag->thicker = std::clamp(thicker * std::pow(kPerWheel, input.wheel), kLeastThicker, kMostThicker);
  extendStroke(*state.drag, frame, input.mouse);
  if (input.button(MouseButton::kLeft).released) {
    if (state.origin) endInsertion(frame);
    else endOrigin(frame);
    return false;
  }
  const bool changed = state.drag->thicker != thicker || state.drag->stroke.size() != points;
  if (state.origin && changed) showSheet(*state.drag, *state.origin, frame.document());
  return true;
}

std::string describeSheetStroke(const ToolFrame& frame) {
  const SheetToolState& state = frame.tools.sheet;
  const Document& document = frame.document();
  if (!state.origin) {
    return statusLine("Origin of a new sheet", {"Release keeps it; then draw its insertion", "Esc cancels"});
  }
  const int sheet = activeSheet(document);
  if (!state.drag->shown || sheet < 0) {
    return statusLine("Insertion of the new sheet", {"Release keeps the sheet", "Esc cancels"});
  }
  const MuscleSheet& shown = at(document.rig().sheets, sheet);
  return statusLine("New sheet, " + withCount(static_cast<std::size_t>(shown.strips), "strip"),
                    {"Release keeps", "Wheel raises or lowers", "Esc cancels"});
}

std::string describeSheetTool(const ToolFrame& frame) {
  const SheetToolState& state = frame.tools.sheet;
  if (state.drag) return describeSheetStroke(frame);
  if (!frame.tools.hover.skin) {
    const char* acts =
        state.origin ? "Drag on the skin draws the sheet's insertion" : "Drag on the skin draws a sheet's origin";
    return statusLine("Background", {"Drag orbits", acts, "Right+drag pans", "Wheel zooms"});
  }
  if (state.origin) {
    return statusLine("Sheet, second stroke", {"Click lets it converge there", "Drag draws its insertion",
                                               "Alt+drag orbits", "Wheel zooms", "Esc drops its origin"});
  }
  return statusLine("Sheet, first stroke",
                    {"Click lets it fan out from there", "Drag draws its origin", "Alt+drag orbits", "Wheel zooms"});
}

}  // namespace

std::vector<std::vector<glm::vec3>> drawnEdges(const SheetToolState& state, const Character& character,
                                               const Pose& pose) {
  std::vector<std::vector<glm::vec3>> edges;
  if (state.origin) edges.push_back(edgeInPose(*state.origin, character.skeleton, pose));
  if (!state.drag || state.drag->shown) return edges;
  std::vector<glm::vec3>& stroke = edges.emplace_back();
  for (const SkinAnchor& place : state.drag->stroke) stroke.push_back(skinPointAt(character, pose, place).point);
  return edges;
}

constinit const Tool kSheetTool{
    .id = "tool/sheet",
    .label = "Add sheet",
    .hint = "Draw a broad muscle with two strokes on the skin: where it begins, then where it ends",
    .key = GLFW_KEY_D,
    .icon = Icon::kSheet,
    .onSkin = true,
    .hover = hoverAt,
    .press = pressSheet,
    .drag = drawSheetStroke,
    .cancel =
        [](ViewportTools& tools, Document& document) {
          dropSheetStroke(tools.sheet, document);
          tools.sheet = {};
        },
    .describe = describeSheetTool,
};

}  // namespace sinew::app
