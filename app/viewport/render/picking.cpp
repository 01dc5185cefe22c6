// app/viewport/render/picking.cpp: intersects rays with triangles and unit balls, pixels with bones.
#include "app/viewport/render/picking.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/matrix.hpp>

#include "core/surface/roots/shaped_ray.h"

namespace sinew::app {
namespace {

/// Axes across and along a ray. The ray hits triangles whose projection across contains the origin.
struct RayFrame {
  glm::vec3 origin, across, up, along;
};

RayFrame frameOf(const Ray& ray) {
  const glm::vec3 a = ray.direction;
  const glm::vec3 other = std::abs(a.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 across = glm::normalize(glm::cross(other, a));
  return {ray.origin, across, glm::cross(a, across), a};
}

/// Sides of the axes as bits; a triangle whose corners share one cannot contain the origin.
std::uint8_t sidesOf(const glm::vec2& p) {
  return static_cast<std::uint8_t>((p.x > 0.0f ? 1 : 0) | (p.x < 0.0f ? 2 : 0) | (p.y > 0.0f ? 4 : 0) |
                                   (p.y < 0.0f ? 8 : 0));
}

float crossOf(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

struct FlatHit {
  glm::vec3 barycentric{0.0f};
  bool front = false;
};

/// Where a projected triangle contains the origin. Shared edges use the same numbers, so that no ray passes between.
std::optional<FlatHit> holdsOrigin(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const glm::vec3 areas(crossOf(b, c), crossOf(c, a), crossOf(a, b));
  const bool anyBelow = areas.x < 0.0f || areas.y < 0.0f || areas.z < 0.0f;
  const bool anyAbove = areas.x > 0.0f || areas.y > 0.0f || areas.z > 0.0f;
  const float total = areas.x + areas.y + areas.z;
  if ((anyBelow && anyAbove) || total == 0.0f) return std::nullopt;
  // `along` points away from the eye: counter-clockwise for the eye is negative.
  return FlatHit{areas / total, total < 0.0f};
}

/// Calls take(refined triangle, hit, distance > 0) for every triangle that the ray hits, in their order.
template <class Take>
void forEachCrossing(const Ray& ray, const Surface& surface, const Take& take) {
  const Refinement& refinement = *surface.refinement;
  assert(surface.positions.size() >= static_cast<std::size_t>(refinement.vertexCount));
  const RayFrame frame = frameOf(ray);
  std::vector<glm::vec2> flat(surface.positions.size());
  std::vector<std::uint8_t> sides(surface.positions.size());
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const glm::vec3 from = surface.positions[i] - frame.origin;
    flat[i] = {glm::dot(from, frame.across), glm::dot(from, frame.up)};
    sides[i] = sidesOf(flat[i]);
  }
  for (std::size_t t = 0; t < refinement.triangles.size(); ++t) {
    const auto [ia, ib, ic] = refinement.triangles[t];
    const auto a = static_cast<std::size_t>(ia), b = static_cast<std::size_t>(ib), c = static_cast<std::size_t>(ic);
    if ((sides[a] & sides[b] & sides[c]) != 0) continue;
    const std::optional<FlatHit> held = holdsOrigin(flat[a], flat[b], flat[c]);
    if (!held) continue;
    const glm::vec3 point = held->barycentric.x * surface.positions[a] + held->barycentric.y * surface.positions[b] +
                            held->barycentric.z * surface.positions[c];
    if (const float distance = glm::dot(point - frame.origin, frame.along); distance > 0.0f) take(t, *held, distance);
  }
}

void complete(SurfaceHit& hit, const Ray& ray, const Surface& surface, const ControlMesh& mesh) {
  const Refinement& refinement = *surface.refinement;
  hit.controlTriangle = refinement.controlOf[static_cast<std::size_t>(hit.refinedTriangle)];
  hit.position = ray.origin + hit.distance * ray.direction;
  const auto& corners = refinement.triangles[static_cast<std::size_t>(hit.refinedTriangle)];
  glm::vec3 normal(0.0f);
  for (int i = 0; i < 3; ++i) {
    const int vertex = corners[static_cast<std::size_t>(i)];
    normal += hit.barycentric[i] * surface.normals[static_cast<std::size_t>(vertex)];
    hit.controlBarycentric +=
        hit.barycentric[i] * glm::vec3(controlCoordinates(mesh, refinement, hit.controlTriangle, vertex));
  }
  hit.normal = normalizeOr(normal, -ray.direction);
}

std::optional<ShellSpan> crossShape(const Ray& ray, const glm::mat3& toShape, const glm::vec3& center,
                                    const Shape& shape) {
  UnitBallMap visible;
  visible.toUnit = toShape;
  visible.center = center;
  visible.shape = unitShape(shape, 1.0f);
  const ShapedStretches stretches = ShapedRay(visible, ray.origin, ray.direction).stretches();
  if (stretches.items().empty()) return std::nullopt;
  const auto end = std::ranges::find(stretches.items(), false, &ShapedStretch::goesOn);
  return ShellSpan{static_cast<float>(stretches.items().front().enter), static_cast<float>(end->leave)};
}

}  // namespace

std::optional<SurfaceHit> pickSurface(const Ray& ray, const Surface& surface, const ControlMesh& mesh,
                                      std::span<const Material> materials) {
  if (surface.refinement == nullptr) return std::nullopt;
  std::optional<SurfaceHit> nearest;
  forEachCrossing(ray, surface, [&](std::size_t t, const FlatHit& held, float distance) {
    if (nearest && distance >= nearest->distance) return;
    const auto material =
        static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(surface.refinement->controlOf[t])].material);
    if (!held.front && !(material < materials.size() && materials[material].doubleSided)) return;
    nearest = SurfaceHit{};
    nearest->distance = distance;
    nearest->refinedTriangle = static_cast<int>(t);
    nearest->barycentric = held.barycentric;
  });
  if (nearest) complete(*nearest, ray, surface, mesh);
  return nearest;
}

std::vector<SurfaceCrossing> crossSurface(const Ray& ray, const Surface& surface) {
  std::vector<SurfaceCrossing> crossings;
  if (surface.refinement == nullptr) return crossings;
  forEachCrossing(ray, surface, [&](std::size_t, const FlatHit& held, float distance) {
    crossings.push_back({distance, held.front});
  });
  std::ranges::sort(crossings, {}, &SurfaceCrossing::distance);
  return crossings;
}

std::optional<ShellSpan> crossShell(const Ray& ray, const glm::mat4& unitBallInWorld, const Shape& shape) {
  const glm::mat3 linear(unitBallInWorld);
  const float largest = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
  if (!(std::abs(glm::determinant(linear)) > 1e-9f * largest * largest * largest)) return std::nullopt;
  const glm::mat3 toBall = glm::inverse(linear);
  if (!shape.isPlain()) return crossShape(ray, toBall, glm::vec3(unitBallInWorld[3]), shape);
  const glm::vec3 origin = toBall * (ray.origin - glm::vec3(unitBallInWorld[3]));
  const glm::vec3 direction = toBall * ray.direction;
  // From the nearest point on the ray, since |origin|^2 - 1 would cancel from afar.
  const float length2 = glm::dot(direction, direction);
  const float foot = -glm::dot(origin, direction) / length2;
  const glm::vec3 closest = origin + foot * direction;
  const float under = 1.0f - glm::dot(closest, closest);
  if (under < 0.0f) return std::nullopt;
  const float half = std::sqrt(under / length2);
  if (foot + half < 0.0f) return std::nullopt;
  return ShellSpan{std::max(foot - half, 0.0f), foot + half};
}

std::pair<float, float> segmentDistance(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b) {
  const glm::vec2 along = b - a;
  const float length2 = glm::dot(along, along);
  const float t = length2 > 0.0f ? std::clamp(glm::dot(p - a, along) / length2, 0.0f, 1.0f) : 0.0f;
  return {glm::length(p - (a + t * along)), t};
}

std::optional<BoneHit> pickBone(const glm::vec2& pixel, const View& view, const Skeleton& skeleton, const Pose& pose,
                                float withinPixels, const std::vector<bool>& hidden) {
  constexpr float kSamePixels = 0.5f;
  std::optional<BoneHit> best;
  float bestDepth = std::numeric_limits<float>::infinity();
  for (const BoneSegment& segment : boneSegments(skeleton, pose, hidden)) {
    const glm::vec3 head = view.toPixel(segment.head), tail = view.toPixel(segment.tail);
    if (head.z > 1.0f || tail.z > 1.0f) continue;
    const auto [distance, fraction] = segmentDistance(pixel, glm::vec2(head), glm::vec2(tail));
    if (distance > withinPixels) continue;
    // Where two bones meet, prefer the one that starts there.
    const float depth = glm::mix(head.z, tail.z, fraction) + 1e-6f * fraction;
    const bool nearer = !best || distance < best->pixels - kSamePixels;
    const bool asNear = best && distance < best->pixels + kSamePixels;
    if (!nearer && !(asNear && depth < bestDepth)) continue;
    best = BoneHit{segment.bone, distance};
    bestDepth = depth;
  }
  return best;
}

}  // namespace sinew::app
