// app/bench/scene.cpp: a character with muscles in one surface mode: what `sinew bench` measures.
#include "app/bench/scene.h"

#include <utility>

namespace sinew::app {

Rig rigAt(const BenchScene& scene, int depth, ProjectionKind projection) {
  Rig rig = scene.rig;
  rig.smoothing.depth = depth;
  rig.smoothing.autoDepth = false;
  rig.smoothing.projection = projection;
  return rig;
}

Result<Smoother> preparedSmoother(const BenchScene& scene, const Rig& rig) {
  Smoother smoother(scene.character);
  if (const Result<void> prepared = smoother.prepare(rig); !prepared) return prepared.error();
  return smoother;
}

}  // namespace sinew::app
