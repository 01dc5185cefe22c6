// app/bench/animation.h: what muscle lines and drivers cost, beside skinning the character that they belong to.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"

namespace sinew::app {

/// Medians of the rounds; the ratio is to skinning within one round.
struct AnimationCost {
  std::string what;
  int count = 0;
  double seconds = 0.0;  ///< Of all of them in one pose.
  double ratio = 1.0;    ///< To skinning.
};

/// Skinning comes first; then 4,000 lines between joints and their parents, and 1,000 drivers of every input. A pose of
/// the first clip a round. The character has bones with parents.
[[nodiscard]] std::vector<AnimationCost> measureAnimation(const Character& character, int rounds);

[[nodiscard]] std::string animationTable(const std::vector<AnimationCost>& costs);

}  // namespace sinew::app
