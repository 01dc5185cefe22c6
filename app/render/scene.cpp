// app/render/scene.cpp: ellipsoids as they are drawn.
#include "app/render/scene.h"

#include "app/document/group_colors.h"
#include "app/document/visibility.h"

namespace sinew::app {

std::vector<PrimitiveShape> shapesOf(const Rig& rig, const Skeleton& skeleton, const Pose& pose) {
  std::vector<PrimitiveShape> shapes;
  const std::vector<int> bones = boneOfEach(rig, skeleton);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    const int bone = bones[i];
    if (bone < 0) continue;
    PrimitiveShape shape;
    shape.rigIndex = static_cast<int>(i);
    shape.unitBallInWorld = shapeInWorld(primitive.placement, 1.0f, pose.boneInWorld[static_cast<std::size_t>(bone)]);
    shape.reach = primitive.reach;
    shape.sign = primitive.sign;
    shape.color = toLinear(groupColor(rig, primitive.group));
    shapes.push_back(shape);
  }
  return shapes;
}

}  // namespace sinew::app
