// app/editor/first_steps.cpp: nothing is asked of the tools: what has changed tells what was done.
#include "app/editor/first_steps.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "app/editor/commands.h"
#include "app/editor/session.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kTurned = 0.15f;  ///< Radians.
constexpr float kScaled = 0.03f;  ///< Of a radius.

bool isScaled(const Rig& before, const Rig& now) {
  return std::ranges::any_of(now.primitives, [&](const Primitive& muscle) {
    const int index = findPrimitive(before, muscle.id());
    if (index < 0) return false;
    const glm::vec3 radii = at(before.primitives, index).placement.radii;
    return glm::any(glm::greaterThan(glm::abs(muscle.placement.radii - radii), kScaled * radii));
  });
}

}  // namespace

void toggleFirstSteps(EditorState& state) {
  FirstStepsState& steps = state.view.firstSteps;
  if (steps.shown) {
    steps.shown = false;
    return;
  }
  steps = {};
  steps.shown = true;
  if (const std::filesystem::path sample = firstSample(); !sample.empty())
    request(state, {IntentKind::kOpenFile, sample});
}

void followFirstSteps(EditorState& state) {
  FirstStepsState& steps = state.view.firstSteps;
  if (!steps.shown || !state.hasCharacter()) return;
  const Camera& camera = state.view.tools.camera;
  // The character is framed in the first frame.
  if (steps.document != state.session.documentsOpened || state.open.frameWanted) {
    steps.document = state.session.documentsOpened;
    steps.stand = camera.stand;
    steps.rig = std::make_shared<const Rig>(state.document.rig());
    return;
  }
  const auto tick = [&](FirstStep step, bool done) {
    bool& own = steps.done[static_cast<std::size_t>(step)];
    own = own || done;
  };
  const float turned =
      std::max(std::abs(camera.stand.yaw - steps.stand.yaw), std::abs(camera.stand.pitch - steps.stand.pitch));
  tick(FirstStep::kTurn, turned > kTurned && !camera.transition);
  tick(FirstStep::kSelect, !state.document.selection.primitives.empty());
  const Rig& rig = state.document.rig();
  const bool idle = !state.document.commands.inGesture();
  tick(FirstStep::kScale, idle && isScaled(*steps.rig, rig));
  tick(FirstStep::kAdd, idle && rig.primitives.size() > steps.rig->primitives.size());
  tick(FirstStep::kCompare, state.document.visibility.bare);
}

bool firstStepsDone(const FirstStepsState& steps) {
  return std::ranges::all_of(steps.done, [](bool done) { return done; });
}

}  // namespace sinew::app
