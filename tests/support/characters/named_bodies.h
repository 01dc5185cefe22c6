// tests/support/characters/named_bodies.h: skeletons with the names that well-known programs use, and their body parts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sinew/character/character.h"

namespace sinew::test {

/// A bone of a skeleton in some style. Bones of the right side are made from those of the left.
struct NamedBone {
  std::string name;
  std::string parent;     ///< Empty: a root.
  std::string place;      ///< Which joint of the body it is at: "elbow", "hip"; see placesOf.
  std::string slot = {};  ///< What it is: "upperArm"; empty: no part.
};

struct NamedBody {
  std::string style;
  std::string left;   ///< In names of bones of the left side.
  std::string right;  ///< Its replacement on the right side.
  std::vector<NamedBone> bones;
  bool quadruped = false;
};

/// All styles.
[[nodiscard]] std::vector<NamedBody> namedBodies();

/// Quadrupeds; namedBodies() includes them.
[[nodiscard]] std::vector<NamedBody> namedAnimals();

enum class Stance { kArmsLevel, kArmsDown };

/// A character without skin: bones alone, all of which count as carrying skin. Slots -> names of bones in `expected`.
[[nodiscard]] Character characterOf(const NamedBody& body, Stance stance, std::map<std::string, std::string>& expected);

}  // namespace sinew::test
