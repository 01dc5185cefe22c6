// app/command/anchor_segments.cpp: anchors of the control vertices, found in the bind pose, carried by their bones.
#include "app/command/anchor_segments.h"

#include "core/character/skinning.h"
#include "core/surface/projection/anchors.h"

namespace sinew::app {
namespace {

std::vector<bool> cornersOfImplicitTriangles(const ControlMesh& mesh, const Surface& surface) {
  std::vector<bool> held(mesh.positions.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (surface.classes[t] != TriangleClass::kImplicit) continue;
    for (const int v : mesh.triangles[t].vertices) held[static_cast<std::size_t>(v)] = true;
  }
  return held;
}

}  // namespace

std::vector<SceneSegment> anchorSegments(const Character& character, const Pose& pose,
                                         std::span<const float> morphWeights, const Surface& surface) {
  SkinnedMesh skinned;
  skin(character, pose, morphWeights, skinned);
  std::vector<glm::vec3> anchors;
  poseAnchors(findAnchors(character.skeleton, character.mesh.positions), pose, anchors);
  const std::vector<bool> held = cornersOfImplicitTriangles(character.mesh, surface);
  std::vector<SceneSegment> segments;
  for (std::size_t v = 0; v < anchors.size(); ++v) {
    if (!held[v]) continue;
    const bool moved = surface.positions[v] != skinned.positions[v];
    segments.push_back({skinned.positions[v], anchors[v], moved ? SegmentClass::kFound : SegmentClass::kLost});
  }
  return segments;
}

}  // namespace sinew::app
