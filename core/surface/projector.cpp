// core/surface/projector.cpp: poses the input of both modes, then runs swell or replace, by scalars or in vectors.
#include "core/surface/projector.h"

#include <array>

#include "core/geometry/instruction_set.h"
#include "core/surface/patches/patch.h"
#include "core/surface/projection/tile_projection.h"

namespace sinew {
namespace {

RiseView poseRise(const Projection& projection, Workspace& workspace) {
  const Preparation& p = projection.preparation;
  skinDirections(p.character(), p.tables->riseInBind, projection.posed.control, workspace.controlRise);
  workspace.rise.resize(toIndex(p.refinement().vertexCount));
  interpolateDirections(p.mesh(), p.refinement(), workspace.controlRise, workspace.rise);
  return {workspace.rise, p.refined->inverseLimits};
}

FlatVertices poseFlat(const Projection& projection, const Pose& pose, Workspace& workspace) {
  const Preparation& p = projection.preparation;
  const SkinnedMesh& control = projection.posed.control;
  evaluatePatch(p, PatchKind::kFlat, control.positions, control.normals, workspace.flatPositions,
                workspace.flatNormals);
  poseAnchors(*p.anchors, pose, workspace.anchorsInWorld);
  return {workspace.flatPositions, workspace.flatNormals, workspace.anchorsInWorld, p.refined->inverseLimits};
}

void projectScalar(const Projection& projection, const Pose& pose, Workspace& workspace, Surface& surface) {
  const Preparation& p = projection.preparation;
  if (p.swells()) {
    swell(p.mesh(), projection.field, swellSettings(p, projection.posed.rig->numbers.skinBlend),
          poseRise(projection, workspace), surface, workspace.projection);
  } else {
    replace(p.mesh(), projection.field, replaceSettings(p), poseFlat(projection, pose, workspace),
            projection.posed.bind->weights, surface, workspace.projection);
  }
}

void projectInVectors(const Projection& projection, const Pose& pose, Workspace& workspace, Surface& surface) {
  const Preparation& p = projection.preparation;
  if (p.swells()) {
    swellInTiles(p.mesh(), projection.field, swellSettings(p, projection.posed.rig->numbers.skinBlend),
                 poseRise(projection, workspace), *p.tiles, surface, workspace.projection);
  } else {
    replaceInTiles(p.mesh(), projection.field, replaceSettings(p), poseFlat(projection, pose, workspace),
                   projection.posed.bind->weights, *p.tiles, surface, workspace.projection);
  }
}

constexpr std::array kProjectors{Projector{"scalar", projectScalar}, Projector{"vectors", projectInVectors}};

}  // namespace

std::span<const Projector> projectors() { return kProjectors; }

const Projector& chosenProjector(const Preparation& preparation) {
  const bool vectors =
      chosenInstructionSet() != InstructionSet::kScalar && preparation.projection == ProjectionKind::kNewton;
  return kProjectors[vectors ? 1 : 0];
}

}  // namespace sinew
