// core/surface/smooth.cpp: the stages in order: skin -> patch -> project -> folds -> cloth -> normals.
#include "core/surface/smooth.h"

#include "core/geometry/stopwatch.h"
#include "core/surface/stages.h"
#include "sinew/geometry/threads.h"

namespace sinew {
namespace {

// A surface with fewer refined vertices is done before other threads wake.
constexpr int kMinSharedSwell = 6'000;
constexpr int kMinSharedReplace = 1'000;

}  // namespace

void smooth(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, const Pose& pose,
            const std::optional<glm::vec3>& eye, SmoothingMemory& memory, Surface& out, double posingSeconds) {
  const Preparation& p = *preparation;
  std::optional<ThreadLimit> alone;
  if (p.refinement().vertexCount < (p.swells() ? kMinSharedSwell : kMinSharedReplace)) alone.emplace(1);
  StageSeconds seconds;
  Stopwatch watch;
  poseFieldAndSkin(preparation, rig, pose, memory.posed);
  seconds.skin = posingSeconds + watch.lap();
  layPatch(p, memory.posed, memory.workspace, out);
  seconds.patch = watch.lap();
  project(p, memory.posed, pose, eye, memory.workspace, out);
  seconds.project = watch.lap();
  const bool moved = findMoved(p, memory.posed, memory.workspace, out);
  if (moved) unfold(p, memory.posed, memory.workspace, out);
  drape(p, moved, memory.workspace, out);
  seconds.folds = watch.lap();
  shade(p, moved, memory.workspace, out);
  seconds.normals = watch.lap();
  out.report.seconds = seconds;
}

}  // namespace sinew
