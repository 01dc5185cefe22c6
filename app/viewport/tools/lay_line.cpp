// app/viewport/tools/lay_line.cpp: anchors under the skin, a belly between them.

#include "app/viewport/tools/lay_line.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "app/document/shown_names.h"
#include "app/viewport/render/picking.h"
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

constexpr float kMostBulge = 0.03f;         ///< How far the belly stands out of the skin at most, fraction of H.
constexpr float kLayLineNearPlane = 0.01f;  ///< Fraction of H, as for muscles on one bone.

const Bone& boneOf(const Character& character, int bone) { return at(character.skeleton.bones, bone); }

Result<LineAnchor> anchorUnder(const Character& character, const SkinAnchor& place) {
  const int bone = boneAt(character, place);
  const Bone& own = boneOf(character, bone);
  if (!isFinite(own.bindInWorld) || isFlat(glm::dmat3(glm::mat3(own.bindInWorld)))) {
    return errorAt(character.skeleton.fileName(bone), "this bone has a scale of zero in the bind pose");
  }
  const glm::vec3 skin = skinPointAt(character, bindPose(character.skeleton), place).point;
  const glm::vec3 under = halfWayToAxis(own, skin);
  return anchorOn(character.skeleton, bone, under);
}

/// From a point inside the body outwards to the skin; 0 if there is none.
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

/// Every anchor in the mirror plane, if they are near it and on center bones.
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

}  // namespace sinew::app
