// core/smoothing/finish/normals_kernel.h: the faces around vertices, and normals for shading, by instruction set.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/lanes/instruction_set.h"
#include "core/smoothing/finish/moved_triangles.h"
#include "core/smoothing/finish/vertex_pairs.h"
#include "core/smoothing/finish/vertex_rings.h"

namespace sinew {

/// Scratch of one vertex.
struct alignas(64) NormalsVertex {
  /// 0 before and after. delta, held to the faces, and (M - 1) delta, each with a fourth number.
  std::array<float, 8> pair{};
  /// First the sums of the unit normals around, times their angles; then in [0] the larger of the squared turns that
  /// the field and the faces show.
  std::array<float, 8> faces{};
};

/// What shading_normals.h passes to the kernel. Spans and arrays are [V']; all but `rings` are read and written at
/// moved.corners alone. Nothing is allocated.
struct NormalsFrame {
  const Refinement* refinement = nullptr;
  const VertexRings* rings = nullptr;
  const MovedTriangles* moved = nullptr;
  const VertexPair* pairs = nullptr;
  std::span<const glm::vec3> patchNormals;
  std::span<const float> filtered;  ///< Empty: all are 0.
  std::span<glm::vec3> normals;     ///< In and out: as ShadingNormals::apply.
  NormalsVertex* work = nullptr;
  int* teeth = nullptr;      ///< Scratch: vertices, as many as moved.corners.
  float* weights = nullptr;  ///< Scratch: theirs.
};

using NormalsKernel = void (*)(NormalsFrame& frame);

/// All give the same bits.
[[nodiscard]] NormalsKernel normalsKernel(InstructionSet set);

}  // namespace sinew
