// core/surface/finish/cloth_lift.h: cloth moves with the skin under it and does not sink in. docs/characters.md.
#pragma once

#include <span>
#include <vector>

#include "core/surface/finish/cloth_binding.h"
#include "sinew/surface/surface.h"

namespace sinew {

struct ClothView {
  const VertexRings& rings;
  const MeshLayers& layers;
  const ClothBinding& binding;
  std::span<const glm::vec3> patchPositions;  ///< [V'] world; cloth and skin before muscles.
  std::span<const glm::vec3> patchNormals;    ///< [V'] unit.
  float height = 1.0f;                        ///< H
};

/// Moves cloth on a surface with finished skin. A vertex follows its foot, the nearest point on the skin's patch in the
/// bind pose, and keeps its gap along the skin's normal. Where the skin has moved, the gap is at least 0.1 % of H,
/// unless the file has the cloth below the skin. Cloth far off the skin moves less, as far as the gap allows. Then
/// corners of cloth make room for vertices of skin that would come through between them. Last, vertices below another
/// wall of a fold than their own are moved out of it.
class ClothLift {
 public:
  /// Sets positions, normals and displacement of cloth. @return false: nothing has moved
  bool apply(const ClothView& view, Surface& surface);

 private:
  void follow(const ClothView& view, Surface& surface);
  void makeRoom(const ClothView& view, Surface& surface);
  [[nodiscard]] bool findBelow(const ClothView& view, const SkinWalls& walls, const Surface& surface);
  void clearWalls(const ClothView& view, Surface& surface);

  std::vector<glm::vec3> up_;         ///< [cloth] the skin's normal at the foot.
  std::vector<float> raise_;          ///< [cloth]
  std::vector<float> lack_;           ///< [under] height that the cloth over it lacks.
  std::vector<int> over_;             ///< [under] the triangle over it, where lack_ is not 0.
  std::vector<WallNode> walls_;       ///< Of the skin.
  std::vector<WallNode> patchWalls_;  ///< Of its patch.
  std::vector<float> gap_;            ///< [cloth] distance of the foot; 0 below it.
};

}  // namespace sinew
