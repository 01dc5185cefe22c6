// app/render/scene.cpp: ellipsoids as they are drawn.
#include "app/render/scene.h"

#include "app/document/group_colors.h"
#include "core/lines/carriers.h"

namespace sinew::app {

std::vector<PrimitiveShape> shapesOf(const Rig& rig, const Character& character, const Pose& pose) {
  std::vector<PrimitiveShape> shapes;
  const std::vector<std::optional<glm::mat4>> carriers = carriersOf(rig, character, pose);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    if (!carriers[i]) continue;
    PrimitiveShape shape;
    shape.rigIndex = static_cast<int>(i);
    shape.unitBallInWorld = shapeInWorld(primitive.placement, 1.0f, *carriers[i]);
    shape.reach = primitive.reach;
    shape.sign = primitive.sign;
    shape.color = toLinear(groupColor(rig, primitive.group));
    shapes.push_back(shape);
  }
  return shapes;
}

}  // namespace sinew::app
