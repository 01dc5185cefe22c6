// core/character/bindings.cpp: which bones carry the skin.
#include "core/character/bindings.h"

#include "core/character/joint_roles.h"
#include "core/geometry/at.h"

namespace sinew {

std::vector<bool> bonesWithSkin(const Character& character) {
  std::vector<bool> result(character.skeleton.bones.size(), false);
  for (const Influence& influence : character.mesh.influences) {
    if (influence.weight > 0.0f) at(result, at(character.skeleton.bindings, influence.binding).bone) = true;
  }
  return result;
}

std::vector<bool> helperBones(const Character& character) {
  return helperBones(character.skeleton, bonesWithSkin(character));
}

}  // namespace sinew
