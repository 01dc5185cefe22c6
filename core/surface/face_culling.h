// core/surface/face_culling.h: control triangles that no picture from an eye shows (paper 4.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/projection/candidates.h"
#include "sinew/character/character.h"
#include "sinew/surface/refinement.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// One pose, after the patches and before projection. Spans need to live for the call only.
struct CullingScene {
  const Character& character;
  const Refinement& refinement;
  const FieldView& field;
  std::span<const TriangleClass> classes;     ///< [T] in `replace`: all but normal ones move. Empty: `swell`.
  std::span<const glm::vec3> patchPositions;  ///< [V'] world.
  std::span<const SkinLayer> layers{};        ///< [T] cloth may follow skin that moves. Empty: all is skin.
};

/// What the eye may skip in one pose. A mark of 1 means skipped.
struct FaceCulling {
  std::vector<std::uint8_t> triangles;  ///< [T] neither projected nor drawn.
  std::vector<std::uint8_t> carriers;   ///< [V+E+T] not projected: touched by culled triangles alone.
  int culled = 0;                       ///< Triangles.

  /// Nothing is skipped; keeps its memory.
  void clear();
};

/// Marks control triangles that leave no pixel in a picture from the eye: the material has one side, all small
/// triangles of the patch face away, by a hair more than rounding to a pixel's 256th could turn, and no primitive moves
/// any of their vertices. The paper asks three vertex normals alone; that removes visible pixels where a patch curves,
/// where a muscle tilts the skin, and where a back is drawn.
void cullFaces(const CullingScene& scene, const glm::vec3& eye, FaceCulling& out);

}  // namespace sinew
