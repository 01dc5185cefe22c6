// core/surface/face_culling.h: control triangles that are invisible from an eye (paper 4.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/projection/candidates.h"
#include "sinew/character/character.h"
#include "sinew/surface/refinement.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// One pose, after the patches and before projection. Spans are used only during the call.
struct CullingScene {
  const Character& character;
  const Refinement& refinement;
  const FieldView& field;
  std::span<const TriangleClass> classes;     ///< [T] in `replace`: all but normal triangles move. Empty: `swell`.
  std::span<const glm::vec3> patchPositions;  ///< [V'] world.
  std::span<const SkinLayer> layers{};        ///< [T] cloth may follow moving skin. Empty: all is skin.
};

/// Marks of one pose and eye; 1: skipped.
struct FaceCulling {
  std::vector<std::uint8_t> triangles;  ///< [T] neither projected nor drawn.
  std::vector<std::uint8_t> carriers;   ///< [V+E+T] not projected: only at culled triangles.
  int culled = 0;                       ///< Triangles.

  void clear();  ///< Skips nothing; keeps its memory.
};

/// Marks control triangles without a pixel in a picture from the eye: the material is one-sided, all refined triangles
/// of the patch face away, by slightly more than rounding to 1/256 pixel could change, and no primitive moves any of
/// their vertices. The paper tests only three vertex normals, which removes visible pixels where a patch curves, where
/// a muscle tilts the skin, and where backs are drawn.
void cullFaces(const CullingScene& scene, const glm::vec3& eye, FaceCulling& out);

}  // namespace sinew
