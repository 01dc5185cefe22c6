// app/viewport/render/scene.cpp: primitives of a rig in a pose.
#include "app/viewport/render/scene.h"

#include "app/viewport/render/color_scales.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

std::optional<ShapeLine> shapeLine(const Rig& rig, const PosedRig& posed, int index) {
  if (index < 0) return std::nullopt;
  const PosedLine& line = at(posed.lines, index);
  const std::optional<glm::vec3> via = at(rig.lines, index).via ? std::optional(line.via) : std::nullopt;
  return ShapeLine{{line.origin, via, line.insertion}, line.activation, line.stretch};
}

/// A strip has a tendon at each end.
void addToSheet(PrimitiveShape& shape, const Rig& rig) {
  const Primitive& belly = at(rig.primitives, shape.rigIndex);
  shape.sheet = findSheet(rig, belly.sheet);
  const auto isBeside = [&](std::size_t other) {
    return other < rig.primitives.size() && rig.primitives[other].sheet == belly.sheet &&
           rig.primitives[other].line == belly.line;
  };
  const std::size_t own = toIndex(shape.rigIndex);
  shape.tendons = {own == 0 || !isBeside(own - 1), !isBeside(own + 1)};
}

}  // namespace

std::vector<PrimitiveShape> shapesOf(const Rig& rig, const PosedRig& posed) {
  std::vector<PrimitiveShape> shapes;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const PosedMuscle& muscle = posed.muscles[i];
    if (!muscle.usable) continue;
    const Placement& placement = muscle.body.placement;
    PrimitiveShape shape;
    shape.rigIndex = static_cast<int>(i);
    shape.unitBallInWorld = shapeInWorld(placement, 1.0f, muscle.body.carrier);
    shape.shape = placement.shape;
    shape.reach = posed.numbers.primitives[i].reach;
    shape.sign = rig.primitives[i].sign;
    shape.radii = placement.radii;
    shape.line = shapeLine(rig, posed, muscle.line);
    if (!rig.primitives[i].sheet.empty()) addToSheet(shape, rig);
    shape.color = toLinear(groupColor(rig, rig.primitives[i].group));
    shapes.push_back(shape);
  }
  return shapes;
}

std::array<glm::vec3, 6> extremesOf(const PrimitiveShape& shape, float scale) {
  std::array<glm::vec3, 6> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    glm::vec3 axis(0.0f);
    axis[static_cast<int>(i / 2)] = i % 2 == 0 ? 1.0f : -1.0f;
    points[i] = glm::vec3(shape.unitBallInWorld * glm::vec4(onShape(shape.shape, scale, axis), 1.0f));
  }
  return points;
}

}  // namespace sinew::app
