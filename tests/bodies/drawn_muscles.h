// tests/bodies/drawn_muscles.h: muscles between random places of a character's skin, across one joint.
#pragma once

#include <filesystem>
#include <memory>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "core/bodies/check.h"
#include "core/character/bindings.h"
#include "core/character/bone_segments.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/rig/line_pose.h"
#include "core/rig/line_rest.h"
#include "sinew/files/gltf_import.h"

namespace sinew::test {

inline std::shared_ptr<const Character> bundledCharacter(const char* file) {
  return importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / file).value();
}

/// A point under random skin of a bone, halfway to its axis.
inline std::optional<LineAnchor> randomAnchor(const Character& character, int bone, std::mt19937& random) {
  std::vector<int> own;
  for (int v = 0; v < static_cast<int>(character.mesh.positions.size()); ++v) {
    if (strongestBone(character, v) == bone) own.push_back(v);
  }
  if (own.empty()) return std::nullopt;
  const glm::vec3 skin = at(character.mesh.positions, own[random() % own.size()]);
  return anchorOn(character.skeleton, bone, halfWayToAxis(at(character.skeleton.bones, bone), skin));
}

/// One from each bone's parent to the bone, `rounds` times; those without a direction are omitted. @param joints
/// number spanned: 2, from the parent's parent
inline std::vector<BellyChoice> drawnMuscles(const Character& character, int rounds, unsigned seed, int joints = 1) {
  std::mt19937 random(seed);
  std::vector<BellyChoice> out;
  const auto& bones = character.skeleton.bones;
  for (int i = 0; i < rounds * static_cast<int>(bones.size()); ++i) {
    const int bone = i % static_cast<int>(bones.size());
    int parent = bone;
    for (int joint = 0; joint < joints && parent >= 0; ++joint) parent = at(bones, parent).parent;
    const auto from = parent < 0 ? std::nullopt : randomAnchor(character, parent, random);
    const auto to = randomAnchor(character, bone, random);
    if (!from || !to) continue;
    MuscleLine line;
    line.name = "drawn";
    line.origin = *from;
    line.insertion = *to;
    const auto rest = lineRest(line, character);
    if (!rest || rest->length < 0.02 * static_cast<double>(character.height)) continue;
    const auto length = static_cast<float>(rest->length);
    const float half = 0.36f * length;
    const glm::vec3 middle = glm::vec3(rest->origin.inBind) + 0.49f * length * glm::vec3(rest->direction);
    const glm::vec3 out3(rest->frame[2]);
    BellyChoice choice;
    choice.line = line;
    choice.primitive.name = choice.primitive.line = line.name;
    choice.primitive.bone = line.origin.bone;
    const glm::dmat4 toBone(at(bones, parent).inverseBindInWorld);
    choice.primitive.placement = imageOf(bellyOnLine(middle, glm::vec3(rest->direction), out3, 0.4f * half, half),
                                         {glm::dmat3(toBone), glm::dvec3(toBone[3])});
    out.push_back(std::move(choice));
  }
  return out;
}

/// A rig with this muscle only.
inline Rig rigOf(const BellyChoice& choice) {
  Rig rig;
  rig.primitives = {choice.primitive};
  if (choice.line) rig.lines = {*choice.line};
  return rig;
}

}  // namespace sinew::test
