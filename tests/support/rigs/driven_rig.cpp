// tests/support/rigs/driven_rig.cpp: replaces every parameter by its value in a pose.
#include "tests/support/rigs/driven_rig.h"

namespace sinew::test {

Rig withNumbers(Rig rig, const RigNumbers& numbers) {
  rig.surface.skinBlend = numbers.skinBlend;
  rig.surface.grooves = numbers.grooves;
  for (std::size_t i = 0; i < rig.lines.size(); ++i) rig.lines[i].settings = numbers.lines[i];
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    rig.primitives[i].placement = numbers.primitives[i].placement;
    rig.primitives[i].reach = numbers.primitives[i].reach;
    rig.primitives[i].amount = numbers.primitives[i].amount;
  }
  for (std::size_t i = 0; i < rig.links.size(); ++i) rig.links[i].amount = numbers.links[i];
  std::erase_if(rig.links, [](const Link& link) { return link.amount == 0.0f; });
  return rig;
}

Rig drivenRig(const Rig& rig, const Character& character, const Pose& pose) {
  return withNumbers(rig, RigPoser(rig, character).pose(pose).numbers);
}

}  // namespace sinew::test
