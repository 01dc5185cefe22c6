// app/viewport/render/picking.h: what lies under the pointer. On the processor, without OpenGL.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"
#include "core/character/bone_segments.h"

namespace sinew::app {

/// A ray meets the surface.
struct SurfaceHit {
  float distance = 0.0f;  ///< Along the ray, > 0.
  int refinedTriangle = -1;
  int controlTriangle = -1;
  glm::vec3 barycentric{0.0f};         ///< In the refined triangle.
  glm::vec3 controlBarycentric{0.0f};  ///< In the control triangle: where the skin weights are interpolated.
  glm::vec3 position{0.0f};            ///< World.
  glm::vec3 normal{0.0f};              ///< World, unit, smooth.
};

/// Nearest hit from the front (both sides where the material is double-sided). surface must come from this mesh.
/// @param materials of the character; empty: every triangle is single-sided.
[[nodiscard]] std::optional<SurfaceHit> pickSurface(const Ray& ray, const Surface& surface, const ControlMesh& mesh,
                                                    std::span<const Material> materials);

/// The ray passes through the surface, whatever the material: into the body from the front, out of it from behind.
struct SurfaceCrossing {
  float distance = 0.0f;  ///< Along the ray, > 0.
  bool front = false;
};
/// All of them, nearest first.
[[nodiscard]] std::vector<SurfaceCrossing> crossSurface(const Ray& ray, const Surface& surface);

/// The part of a ray inside a primitive. Distances along the ray; `enter` is 0 if the ray starts inside.
struct ShellSpan {
  float enter = 0.0f;
  float leave = 0.0f;
};
/// Nullopt: it misses, the primitive lies behind the start, or it is flattened. Where a bent one is entered twice, the
/// first part.
[[nodiscard]] std::optional<ShellSpan> crossShell(const Ray& ray, const glm::mat4& unitBallInWorld,
                                                  const Shape& shape = {});

struct BoneHit {
  int bone = -1;
  float pixels = 0.0f;  ///< Distance on screen.
};

/// The bone whose segment (or joint) is nearest on screen within `withinPixels`; equally near ones: nearest to the eye.
[[nodiscard]] std::optional<BoneHit> pickBone(const glm::vec2& pixel, const View& view, const Skeleton& skeleton,
                                              const Pose& pose, float withinPixels,
                                              const std::vector<bool>& hidden = {});

}  // namespace sinew::app
