// core/character/limb_chains.h: the limbs of one side, as chains of bones from the trunk outwards.
#pragma once

#include <vector>

#include "core/character/body_slots.h"
#include "core/character/bone_names.h"

namespace sinew {

/// A skeleton with all that the search for parts reads. Bind pose, world.
struct SlotSearch {
  const Skeleton& skeleton;
  std::vector<BoneName> names;    ///< [bones]
  std::vector<bool> active;       ///< [bones] moves skin.
  std::vector<int> twinOf;        ///< [bones] itself: center; -1: none.
  std::vector<glm::vec3> joints;  ///< [bones]
  glm::vec3 left{1.0f, 0.0f, 0.0f};
  float middle = 0.0f;  ///< Of the mirror plane, along `left`.
  float ground = 0.0f;  ///< y of the lowest joint.
  float height = 1.0f;

  [[nodiscard]] int parentOf(int bone) const;
  /// +1: on the left, -1: on the right, 0: neither.
  [[nodiscard]] int sideOf(int bone) const;
  [[nodiscard]] bool isAbove(int above, int bone) const;  ///< In the tree; a bone is above itself.
  [[nodiscard]] int commonAncestor(int a, int b) const;   ///< -1: none.
};

[[nodiscard]] SlotSearch makeSearch(const Skeleton& skeleton, const SlotHints& hints);

/// One limb: from the first bone on its side to the last.
struct LimbChain {
  std::vector<int> bones;       ///< Not empty.
  std::vector<glm::vec3> ends;  ///< [bones] where each one's segment ends.
  int attach = -1;              ///< The bone that carries it, or -1.
  float length = 0.0f;
  float lowest = 0.0f;  ///< y, over its joints and its tip.
  LimbWord word = LimbWord::kNone;

  [[nodiscard]] glm::vec3 segment(std::size_t i, const SlotSearch& search) const;
};

/// Those on the left that are long enough or named.
[[nodiscard]] std::vector<LimbChain> leftLimbs(const SlotSearch& search);

}  // namespace sinew
