// core/surface/smoother.cpp: the public pipeline: a preparation and memory for one thread.
#include "sinew/surface/smoother.h"

#include <algorithm>
#include <cassert>

#include "core/geometry/stopwatch.h"
#include "core/surface/preparation.h"
#include "core/surface/smooth.h"
#include "sinew/character/pose_check.h"

namespace sinew {

struct Smoother::State {
  std::shared_ptr<const CharacterTables> tables;
  ProjectionKind projection = ProjectionKind::kNewton;
  std::shared_ptr<const Preparation> preparation;  ///< Null until prepare() has succeeded.
  BlendingGraphMemo graphs;
  std::vector<int> unattached;
  PosedRig rig;
  SmoothingMemory memory;
};

Smoother::Smoother(std::shared_ptr<const Character> character, ProjectionKind projection)
    : state_(std::make_unique<State>()) {
  assert(character);
  state_->tables = characterTables(std::move(character));
  state_->projection = projection;
}

Smoother::Smoother(std::unique_ptr<State> state) : state_(std::move(state)) {}
Smoother::~Smoother() = default;
Smoother::Smoother(Smoother&&) noexcept = default;
Smoother& Smoother::operator=(Smoother&&) noexcept = default;

Smoother Smoother::twin() const {
  auto state = std::make_unique<State>();
  state->tables = state_->tables;
  state->projection = state_->projection;
  state->preparation = state_->preparation;
  state->graphs = state_->graphs;
  state->unattached = state_->unattached;
  return Smoother(std::move(state));
}

Result<void> Smoother::prepare(const Rig& rig, std::span<const int> hidden, const Region& region) {
  assert(std::ranges::is_sorted(hidden));
  const Preparation* former = state_->preparation.get();
  PreparationOptions options;
  options.hidden = hidden;
  options.region = region;
  options.projection = state_->projection;
  auto prepared = sinew::prepare(state_->tables, rig, options, former, state_->graphs);
  if (!prepared) return prepared.error();
  state_->preparation = std::move(prepared).value();
  state_->unattached = state_->preparation->attached->attachment.unattached;
  return {};
}

bool Smoother::smooth(const Pose& pose, Surface& out, const std::optional<glm::vec3>& eye) {
  assert(state_->preparation && "prepare() first");
  if (!isSoundPose(character(), pose)) return false;
  Stopwatch watch;
  state_->preparation->poser->pose(pose, state_->rig);
  sinew::smooth(state_->preparation, state_->rig, pose, eye, state_->memory, out, watch.lap());
  return true;
}

const Character& Smoother::character() const { return *state_->tables->character; }

const std::vector<int>& Smoother::unattached() const { return state_->unattached; }

}  // namespace sinew
