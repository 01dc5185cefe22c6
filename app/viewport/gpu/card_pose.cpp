// app/viewport/gpu/card_pose.cpp: the rig is posed on the processor, which takes microseconds.

#include "app/viewport/gpu/card_pose.h"

#include <algorithm>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "core/surface/posed_field.h"

namespace sinew::app {
namespace {

void fillShape(const UnitShape& shape, card::Primitive& out) {
  out.bendCurve = {shape.bend.x, shape.bend.y, shape.curve.x, shape.curve.y};
  out.section = {shape.lateral, shape.taper, shape.core, shape.inverseEnd};
  out.low = glm::vec4(shape.low, 1.0f);
  out.high = glm::vec4(shape.high, out.high.w);
}

}  // namespace

std::optional<std::string> poseMuscles(const std::shared_ptr<const Preparation>& preparation, const Pose& pose,
                                       PosedMuscles& out) {
  preparation->poser->pose(pose, out.rig);
  placeMuscles(preparation, out.rig, out.field);
  if (!preparation->character().morphTargets.empty()) {
    morph(preparation->character(), out.rig.morphWeights, out.field.control.morphed);
  }
  const bool plain =
      std::ranges::all_of(out.field.primitives, [](const PosedPrimitive& one) { return one.influence.isPlain(); });
  if (plain) return std::nullopt;
  if (!preparation->swells()) return "in replace, a muscle is not a plain ellipsoid";
  return std::nullopt;
}

void fillMatrices(const Preparation& preparation, const Pose& pose, std::span<glm::mat4> out) {
  const std::vector<Binding>& bindings = preparation.character().skeleton.bindings;
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    out[i] = at(pose.boneInWorld, bindings[i].bone) * bindings[i].inverseBind;
  }
}

void fillPrimitives(const Preparation& preparation, const PosedField& field, std::span<card::Primitive> out) {
  const float blendWidth = swellSettings(preparation, field.rig->numbers.skinBlend).blendWidth;
  for (std::size_t i = 0; i < field.primitives.size(); ++i) {
    const PosedPrimitive& muscle = field.primitives[i];
    const UnitBallMap& ball = muscle.influence;
    out[i] = {
        {glm::vec4(ball.toUnit[0], muscle.strength), glm::vec4(ball.toUnit[1], std::min(blendWidth, muscle.meanRadius)),
         glm::vec4(ball.toUnit[2], ball.inverseRadius)},
        glm::vec4(ball.center, ball.boundingRadius),
        {},
        {},
        {},
        {0.0f, 0.0f, 0.0f, muscle.meanRadius}};
    if (!ball.isPlain()) fillShape(ball.shape, out[i]);
  }
}

}  // namespace sinew::app
