// tests/support/surface/fine_reference.cpp: a uniform refinement that is marked as following the heights.

#include "tests/support/surface/fine_reference.h"

#include <optional>
#include <utility>

#include "core/surface/adaptive_levels.h"
#include "core/surface/smooth.h"

namespace sinew::test {

struct FineReference::State {
  std::shared_ptr<const Preparation> preparation;
  PosedRig rig;
  SmoothingMemory memory;
  Surface surface;
};

FineReference::FineReference(const std::shared_ptr<const Character>& character, Rig rig, int depth)
    : state_(std::make_unique<State>()) {
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = depth;
  BlendingGraphMemo graphs;
  auto own = std::make_shared<Preparation>(*prepare(characterTables(character), rig, {}, nullptr, graphs).value());
  own->detail = std::make_shared<const AdaptiveLevels>();
  state_->preparation = std::move(own);
}

FineReference::~FineReference() = default;

const Surface& FineReference::at(const Pose& pose) {
  State& state = *state_;
  state.preparation->poser->pose(pose, state.rig);
  smooth(state.preparation, state.rig, pose, std::nullopt, state.memory, state.surface);
  return state.surface;
}

}  // namespace sinew::test
