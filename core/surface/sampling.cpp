// core/surface/sampling.cpp: a preparation of its own, and the first stages.
#include "core/surface/sampling.h"

#include <algorithm>
#include <utility>

#include "core/surface/projector.h"
#include "core/surface/stages.h"

namespace sinew {

SurfaceSampler::SurfaceSampler(const SampledPart& part, Refinement points)
    : preparation_(prepareSamples(*part.preparation, std::move(points))), skipped_(part.skipped) {}

const Surface& SurfaceSampler::sample(const Pose& pose) {
  preparation_->poser->pose(pose, rig_);
  std::ranges::fill(rig_.morphWeights, 0.0f);  // What is read off the bind pose is that of the base.
  poseFieldAndSkin(preparation_, rig_, pose, posed_);
  layPatch(*preparation_, posed_, workspace_, surface_);
  if (preparation_->shownPrimitives > 0) {
    const FieldView field{posed_.primitives, preparation_->seen.get(), skipped_};
    chosenProjector(*preparation_).project({*preparation_, posed_, field}, pose, workspace_, surface_);
  }
  return surface_;
}

}  // namespace sinew
