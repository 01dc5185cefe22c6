// app/viewport/tools/line_tool.cpp: places anchors and bellies, and the tool that draws them.
#include "app/viewport/tools/line_tool.h"

#include <algorithm>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/viewport/render/picking.h"
#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/viewport_tools.h"
#include "core/bodies/mend.h"
#include "core/character/bone_segments.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/line_edit.h"
#include "core/rig/line_pose.h"
#include "core/rig/line_rest.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {
namespace {

constexpr float kMostBulge = 0.03f;         ///< Largest protrusion of the belly from the skin, fraction of H.
constexpr float kLayLineNearPlane = 0.01f;  ///< Fraction of H, as for muscles on one bone.

const Bone& boneOf(const Character& character, int bone) { return at(character.skeleton.bones, bone); }

Result<LineAnchor> anchorUnder(const Character& character, const SkinAnchor& place) {
  const int bone = boneAt(character, place);
  const Bone& own = boneOf(character, bone);
  if (!isFinite(own.bindInWorld) || isFlat(glm::dmat3(glm::mat3(own.bindInWorld)))) {
    return errorAt(character.skeleton.fileName(bone), "this bone has a scale of zero in the bind pose");
  }
  const glm::vec3 skin = skinPointAt(character, bindPose(character.skeleton), place).point;
  return anchorOn(character.skeleton, bone, halfWayToAxis(own, skin));
}

/// Distance from a point inside the body outwards to the skin, or 0.
float depthUnder(const Surface& skin, const glm::vec3& point, const glm::vec3& outwards) {
  for (const SurfaceCrossing& crossing : crossSurface({point, outwards}, skin)) {
    if (!crossing.front) return crossing.distance;
  }
  return 0.0f;
}

/// World of the bind pose.
Placement bellyInWorld(const LineRest& rest, const Surface& skin, float height) {
  const glm::vec3 along(rest.direction);
  const glm::vec3 out(rest.frame * glm::dvec3(0.0, 0.0, 1.0));
  const float straight = static_cast<float>(glm::distance(rest.origin.inBind, rest.insertion.inBind));
  const auto restLength = static_cast<float>(rest.length) * rest.settings.rest;
  const glm::vec2 tendons = rest.settings.tendons * restLength;
  const float half = std::max(0.5f * (straight - tendons.x - tendons.y), 0.1f * straight);
  const glm::vec3 middle = glm::vec3(rest.origin.inBind) + (tendons.x + half) * along;
  const float top = depthUnder(skin, middle, out) + std::min(kBellyBulge * half, kMostBulge * height);
  return bellyOnLine(middle, along, out, top, half);
}

/// Moves all anchors into the mirror plane, if they are near it and on center bones.
void snapToPlane(const MirrorPlan& plan, MuscleLine& line) {
  if (!liesInPlane(plan, line, kLayLineNearPlane)) return;
  for (LineAnchor* anchor : {&line.origin, &line.insertion, line.via ? &*line.via : nullptr}) {
    if (anchor == nullptr) continue;
    const Bone& bone = at(plan.skeleton.bones, *plan.skeleton.findBone(anchor->bone));
    glm::dvec3 point(bone.bindInWorld * glm::vec4(anchor->point, 1.0f));
    point -= distanceTo(plan.plane, point) * plan.plane.normal;
    anchor->point = glm::vec3(bone.inverseBindInWorld * glm::vec4(glm::vec3(point), 1.0f));
  }
}

}  // namespace

Surface bindSkin(const Character& character) {
  Surface skin;
  skin.refinement = std::make_shared<const Refinement>(refine(character.mesh, 1));
  skin.positions = character.mesh.positions;
  skin.normals = character.mesh.normals;
  return skin;
}

Result<LaidLine> layLine(const Character& character, const Surface& skin, const SkinAnchor& from,
                         const SkinAnchor& to) {
  Result<LineAnchor> origin = anchorUnder(character, from);
  if (!origin) return origin.error();
  Result<LineAnchor> insertion = anchorUnder(character, to);
  if (!insertion) return insertion.error();
  LaidLine laid;
  laid.line.name = defaultMuscleName(character.skeleton, boneAt(character, from));
  laid.line.origin = std::move(origin).value();
  laid.line.insertion = std::move(insertion).value();
  const Result<LineRest> rest = lineRest(laid.line, character);
  if (!rest) return rest.error();
  laid.belly.name = laid.line.name;
  laid.belly.bone = laid.line.origin.bone;
  laid.belly.line = laid.line.name;
  laid.belly.reach = kNewReach;
  const glm::dmat4 toBone(boneOf(character, rest->origin.bone).inverseBindInWorld);
  const Placement belly = bellyInWorld(rest.value(), skin, character.height);
  laid.belly.placement = imageOf(belly, {glm::dmat3(toBone), glm::dvec3(toBone[3])});
  return laid;
}

Result<MendedLaidLine> mended(const LaidLine& laid, const Motions& motions) {
  Result<Rig> alone = addLine(Rig{}, laid.line);
  if (!alone) return alone.error();
  Primitive belly = laid.belly;
  belly.line = alone->lines.back().name;
  alone = addPrimitive(std::move(alone).value(), std::move(belly));
  if (!alone) return alone.error();
  Result<Mended> done = withMendedLine(std::move(alone).value(), 0, motions, MadeLine::kDrawn);
  if (!done) return done.error();
  MendedLaidLine out{laid, {}};
  if (!done->said.empty()) out.said = laid.line.name + ": " + done->said;
  out.laid.belly.bone = done->rig.primitives[0].bone;
  out.laid.belly.placement = done->rig.primitives[0].placement;
  if (done->isRigid) {
    out.laid.belly.line.clear();
  } else {
    const std::string name = out.laid.line.name;
    out.laid.line = done->rig.lines[0];
    out.laid.line.name = name;
  }
  return out;
}

Result<Rig> withLaidLine(const Rig& rig, const LaidLine& laid, const MirrorPlan* plan) {
  if (laid.belly.line.empty()) {
    if (plan && !snappedToPlane(*plan, laid.belly, kLayLineNearPlane)) return addPair(rig, laid.belly, *plan);
    return addPrimitive(rig, laid.belly);
  }
  MuscleLine line = laid.line;
  const bool mirrored = plan && mirroredLine(*plan, line).ok();
  if (mirrored) snapToPlane(*plan, line);
  Result<Rig> lined = addLine(rig, line);
  if (!lined) return lined;
  Primitive belly = laid.belly;
  belly.line = lined->lines.back().name;
  if (!mirrored) return addPrimitive(std::move(lined).value(), std::move(belly));
  if (const auto snapped = snappedToPlane(*plan, belly, kLayLineNearPlane)) {
    belly.placement = *snapped;
    return addPrimitive(std::move(lined).value(), std::move(belly));
  }
  return addPair(std::move(lined).value(), std::move(belly), *plan);
}

namespace {

std::optional<SkinAnchor> skinUnder(const LineDrag& drag, const Character& character, const View& view,
                                    const glm::vec2& pixel) {
  const auto hit = pickSurface(view.rayThrough(pixel), drag.skin, character.mesh, character.materials);
  if (!hit) return std::nullopt;
  return SkinAnchor{hit->controlTriangle, hit->controlBarycentric, 0.0f};
}

/// Shows the muscle as the state of the gesture, or the rig before it if there can be none.
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
      document.selection.set(document.idAt(nextIndex(*drag.rigBefore)));
      drag.laid = laid.value();
    }
  }
  if (drag.laid) return;
  document.commands.updateGesture(*drag.rigBefore);
  document.selection = drag.selectionBefore;
}

/// Mends the shown muscle where it leaves the flesh in a clip. @return the changes, for the user
std::string finish(const LineDrag& drag, Document& document) {
  const Result<MendedLaidLine> kept = mended(*drag.laid, Motions(document.character));
  if (!kept) return {};
  const MirrorPlan* const plan = document.symmetry ? document.mirror.get() : nullptr;
  Result<Rig> rig = withLaidLine(*drag.rigBefore, kept->laid, plan);
  if (!rig) return {};
  document.commands.updateGesture(std::move(rig).value());
  document.selection.set(document.idAt(nextIndex(*drag.rigBefore)));
  return kept->said;
}

bool press(ToolFrame& frame) {
  const std::optional<SkinAnchor>& skin = frame.tools.hover.skin;
  if (!skin) return false;
  if (!frame.context.surface) {
    frame.result.refusal = errorAt("", "a muscle is added by pressing on the skin");
    return false;
  }
  Document& document = frame.document();
  LineDrag drag;
  drag.skin = *frame.context.surface;
  drag.bindSkin = bindSkin(*document.character);
  drag.start = {skin->triangle, skin->barycentric, 0.0f};
  drag.startBone = boneAt(*document.character, *skin);
  drag.pressPixel = frame.input.mouse;
  drag.selectionBefore = document.selection;
  drag.rigBefore = document.commands.sharedRig();
  document.commands.beginGesture("Add " + shownBoneName(document.character->skeleton, drag.startBone) + " muscle");
  frame.tools.line.drag = std::move(drag);
  return true;
}

void cancel(ViewportTools& tools, Document& document) {
  if (!tools.line.drag) return;
  document.commands.cancelGesture();
  document.selection = tools.line.drag->selectionBefore;
  tools.line.drag.reset();
}

/// Ends on release, as one undo step, or canceled by Esc and the right button.
bool draw(ToolFrame& frame, const ViewportInput& input) {
  std::optional<LineDrag>& drag = frame.tools.line.drag;
  Document& document = frame.document();
  if (!document.commands.inGesture()) drag.reset();  // An undo may have ended the gesture.
  if (!drag) return false;
  const bool canceled = input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed;
  const bool dragged = glm::length(input.mouse - drag->pressPixel) > kDragThreshold * frame.context.uiScale;
  if (!canceled && (dragged || drag->laid)) {
    show(*drag, skinUnder(*drag, *document.character, frame.view, input.mouse), document);
  }
  if (!canceled && !input.button(MouseButton::kLeft).released) return true;
  if (canceled || !drag->laid) {
    cancel(frame.tools, document);
    return false;
  }
  frame.result.said = finish(*drag, document);
  document.commands.endGesture();
  drag.reset();
  return false;
}

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

constinit const Tool kMuscleLineTool{
    .id = "tool/muscle-line",
    .label = "Add flexing muscle",
    .hint =
        "Press on the skin of one bone and release on another's to add a muscle that stretches and flexes between them",
    .key = GLFW_KEY_M,
    .shift = true,
    .icon = Icon::kMuscleLine,
    .onSkin = true,
    .hover = hoverAt,
    .press = press,
    .drag = draw,
    .cancel = cancel,
    .describe = describeTool,
};

}  // namespace sinew::app
