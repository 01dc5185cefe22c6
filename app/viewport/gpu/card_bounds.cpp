// app/viewport/gpu/card_bounds.cpp: boxes that follow the bones.
#include "app/viewport/gpu/card_bounds.h"

#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kBulge = 0.02f;  ///< Of the height: how far patches may stand out of the control mesh's box.

glm::vec3 corner(const Bounds& box, unsigned i) {
  return {(i & 1u) != 0 ? box.high.x : box.low.x, (i & 2u) != 0 ? box.high.y : box.low.y,
          (i & 4u) != 0 ? box.high.z : box.low.z};
}

}  // namespace

CarriedBounds::CarriedBounds(const Character& character)
    : boxes_(character.skeleton.bindings.size()), bulge_(kBulge * character.height) {
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    for (const Influence& influence : character.mesh.influencesOf(static_cast<int>(v))) {
      if (influence.weight > 0.0f) sinew::at(boxes_, influence.binding).add(character.mesh.positions[v]);
    }
  }
}

Bounds CarriedBounds::at(std::span<const glm::mat4> matrices, std::span<const PosedPrimitive> muscles) const {
  Bounds around;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (boxes_[i].isEmpty()) continue;
    for (unsigned c = 0; c < 8; ++c) around.add(glm::vec3(matrices[i] * glm::vec4(corner(boxes_[i], c), 1.0f)));
  }
  for (const PosedPrimitive& muscle : muscles) {
    around.add(muscle.influence.center - muscle.influence.boundingRadius);
    around.add(muscle.influence.center + muscle.influence.boundingRadius);
  }
  around.low -= bulge_;
  around.high += bulge_;
  return around;
}

}  // namespace sinew::app
