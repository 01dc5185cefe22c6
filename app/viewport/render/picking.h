// app/viewport/render/picking.h: hits of rays and pixels, without OpenGL.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"
#include "core/character/bone_segments.h"

namespace sinew::app {

struct SurfaceHit {
  float distance = 0.0f;  ///< Along the ray, > 0.
  int refinedTriangle = -1;
  int controlTriangle = -1;
  glm::vec3 barycentric{0.0f};         ///< In the refined triangle.
  glm::vec3 controlBarycentric{0.0f};  ///< In the control triangle.
  glm::vec3 position{0.0f};            ///< World.
  glm::vec3 normal{0.0f};              ///< World, unit, smooth.
};

/// Nearest hit from the front, or from both sides of double-sided materials. The surface must come from this mesh.
/// @param materials  of the character; empty: all single-sided
[[nodiscard]] std::optional<SurfaceHit> pickSurface(const Ray& ray, const Surface& surface, const ControlMesh& mesh,
                                                    std::span<const Material> materials);

/// A ray crosses the surface, whatever the material; `front`: into the body.
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
/// The first part, if a bent primitive is entered twice. nullopt: it misses, or the primitive lies behind the start or
/// is flattened.
[[nodiscard]] std::optional<ShellSpan> crossShell(const Ray& ray, const glm::mat4& unitBallInWorld,
                                                  const Shape& shape = {});

/// Distance from a point to a segment, and the fraction along it.
[[nodiscard]] std::pair<float, float> segmentDistance(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b);

struct BoneHit {
  int bone = -1;
  float pixels = 0.0f;  ///< Distance on screen.
};

/// The bone with the nearest segment or joint on screen; of equally near ones that nearest to the eye.
[[nodiscard]] std::optional<BoneHit> pickBone(const glm::vec2& pixel, const View& view, const Skeleton& skeleton,
                                              const Pose& pose, float withinPixels,
                                              const std::vector<bool>& hidden = {});

}  // namespace sinew::app
