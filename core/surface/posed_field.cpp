// core/surface/posed_field.cpp: places muscles by driven numbers and skins the mesh.
#include "core/surface/posed_field.h"

#include "core/geometry/at.h"

namespace sinew {
namespace {

void driveNumbers(const Preparation& preparation, const PosedRig& rig, std::vector<FieldPrimitive>& out) {
  out = preparation.primitives;
  setNumbers(rig.numbers, preparation.iso, preparation.attached->attachment, out);
}

/// The implicit triangles follow from the numbers; they are read again only if these have changed.
void readDriven(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, PosedField& out) {
  driveNumbers(*preparation, rig, out.driven);
  out.bind = &preparation->bind;
  const RigNumbers& drawn = preparation->poser->drawn();
  const bool reads = preparation->poser->drivesLinks() && !preparation->swells();  // Influences know no links.
  if (rig.numbers.primitives == drawn.primitives && (!reads || rig.numbers.links == drawn.links)) return;
  const bool sameLinks = !reads || out.readWithLinks == rig.numbers.links;
  if (!out.readFrom || out.readWith != rig.numbers.primitives || !sameLinks) {
    const PosedCliqueSets* sets = reads ? &out.cliqueSets : nullptr;
    readBindPose(*preparation, out.driven, sets, out.scratch, out.drivenBind);
    out.readWith = rig.numbers.primitives;
    out.readWithLinks = rig.numbers.links;
    out.readFrom = preparation;
  }
  out.bind = &out.drivenBind;
}

void placePrimitives(const Preparation& preparation, std::span<const FieldPrimitive> primitives, const PosedRig& rig,
                     std::vector<PosedPrimitive>& out) {
  const std::vector<int>& rigIndex = preparation.attached->attachment.rigIndex;
  const float grooves = rig.numbers.grooves * preparation.character().height;
  out.resize(primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const PosedMuscle& muscle = at(rig.muscles, rigIndex[i]);
    out[i] = posedPrimitive(primitives[i], muscle.carrier, grooves);
    // A muscle bent by its line keeps its blend width and its groove.
    if (muscle.isBent) out[i].influence = unitBallMap(muscle.body.placement, primitives[i].reach, muscle.body.carrier);
  }
}

}  // namespace

void placeMuscles(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, PosedField& out) {
  out.rig = &rig;
  if (out.skinnedFrom != preparation) out.control.morphed = {};
  out.skinnedFrom = preparation;
  if (out.readFrom != preparation) out.readFrom.reset();  // Does not keep a former preparation alive.
  out.bind = &preparation->bind;
  const bool relinked = preparation->poser->drivesLinks();
  if (relinked) out.cliqueSets.pose(*preparation->seen, rig.numbers.links);
  const bool driven = preparation->poser->drivesMuscles() || relinked;
  if (driven) readDriven(preparation, rig, out);
  placePrimitives(*preparation, driven ? out.driven : preparation->primitives, rig, out.primitives);
}

void posePrimitives(const Preparation& preparation, const PosedRig& rig, std::vector<FieldPrimitive>& numbers,
                    std::vector<PosedPrimitive>& out) {
  const bool driven = preparation.poser->drivesMuscles();
  if (driven) driveNumbers(preparation, rig, numbers);
  placePrimitives(preparation, driven ? numbers : preparation.primitives, rig, out);
}

void poseFieldAndSkin(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, const Pose& pose,
                      PosedField& out) {
  placeMuscles(preparation, rig, out);
  skin(preparation->character(), pose, rig.morphWeights, out.control);
  const ControlMesh* creased = preparation->refined->creased.get();
  if (creased && out.control.morphed.isMorphed) morphFans(*creased, out.control.morphed);
}

}  // namespace sinew
