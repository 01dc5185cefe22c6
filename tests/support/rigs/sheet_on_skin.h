// tests/support/rigs/sheet_on_skin.h: sheets on the skin of any character.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "core/bodies/sheets/sheet_skin.h"
#include "core/rig/line_rest.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::test {

/// The skin nearest to a point of the bind pose, on its strongest bone.
inline LineAnchor anchorAt(const SheetSkin& skin, const glm::vec3& near) {
  const glm::vec3 point = skin.nearest(near);
  int strongest = 0;
  float most = -1.0f;
  for (const auto& [bone, weight] : skin.weightsAt(point)) {
    if (weight > most) strongest = bone;
    most = std::max(most, weight);
  }
  return anchorOn(skin.character().skeleton, strongest, point);
}

/// Three points on the front (+z) of a bone, from its -x to its +x side.
inline SheetEdge edgeAcross(const SheetSkin& skin, const std::string& bone, float share) {
  const Skeleton& skeleton = skin.character().skeleton;
  const Bone& own = skeleton.bones[static_cast<std::size_t>(*skeleton.findBone(bone))];
  const glm::vec3 middle(own.bindInWorld * glm::vec4(share * own.tip, 1.0f));
  SheetEdge edge;
  for (const float side : {-0.6f, 0.0f, 0.6f}) {
    edge.points.push_back(anchorAt(skin, middle + 0.15f * skin.height() * glm::normalize(glm::vec3(side, 0.0f, 1.0f))));
  }
  return edge;
}

/// From the front of one bone to that of another, 3 strips of 3 bellies, in the group "sheets".
inline MuscleSheet sheetBetweenBones(const std::shared_ptr<const Character>& character, const std::string& name,
                                     const std::string& from, const std::string& to) {
  const SheetSkin skin(character, Rig{});
  MuscleSheet sheet;
  sheet.name = name;
  sheet.group = "sheets";
  sheet.edges = {edgeAcross(skin, from, 0.4f), edgeAcross(skin, to, 0.6f)};
  return sheet;
}

}  // namespace sinew::test
