// tests/support/oracle_replace.cpp: the paper's method (DESIGN 5, `replace`): anchors, omegas, projection on F = T.

#include <algorithm>
#include <cmath>

#include "tests/support/oracle.h"

namespace sinew::oracle {
namespace {

constexpr int kSteps = 2400;
constexpr int kOtherRoots = 8;
constexpr double kSearchLength = 0.2;  ///< L as a fraction of H.

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double fade(double t, double limit) {
  const double x = std::clamp((std::abs(t) - 0.8 * limit) / (0.2 * limit), 0.0, 1.0);
  return 1.0 - x * x * (3.0 - 2.0 * x);
}

Vec closestOnSegment(const Vec& a, const Vec& b, const Vec& point) {
  const Vec along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0.0 ? std::clamp(dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
  return a + t * along;
}

}  // namespace

Oracle::Anchor Oracle::anchorOf(const Vec& bindPoint) const {
  const auto& bones = character_.skeleton.bones;
  const auto originOf = [](const Bone& bone) { return affine(bone.bindInWorld).offset; };
  Anchor best;
  double bestDistance = 1e300;
  const auto offer = [&](std::size_t bone, const Vec& end) {
    const Vec closest = closestOnSegment(originOf(bones[bone]), end, bindPoint);
    const double distance = length(closest - bindPoint);
    if (distance >= bestDistance) return;
    bestDistance = distance;
    const Affine bind = affine(bones[bone].bindInWorld);
    if (determinant(bind.linear) == 0.0) return;
    best = {static_cast<int>(bone), inverse(bind.linear) * (closest - bind.offset)};
  };
  for (std::size_t b = 0; b < bones.size(); ++b) {
    bool childless = true;
    for (const Bone& child : bones) {
      if (child.parent != static_cast<int>(b)) continue;
      childless = false;
      offer(b, originOf(child));
    }
    if (childless) offer(b, apply(affine(bones[b].bindInWorld), vec(bones[b].tip)));
  }
  return best;
}

Vec Oracle::anchorInWorld(const Site& site) const {
  Vec bindPoint;
  for (std::size_t i = 0; i < 3; ++i) {
    bindPoint = bindPoint + site.barycentric[i] * vec(character_.mesh.positions[index(site.vertices[i])]);
  }
  const Anchor anchor = anchorOf(bindPoint);
  return apply(bones_[index(anchor.bone)], anchor.inBone);
}

void Oracle::findOmegas() {
  Pose bind;
  for (const Bone& bone : character_.skeleton.bones) bind.boneInWorld.push_back(bone.bindInWorld);
  pose(bind);
  omega_.assign(character_.mesh.positions.size(), 0.0);
  for (std::size_t v = 0; v < omega_.size(); ++v) {
    const int vertex = static_cast<int>(v);
    const Site site{{vertex, vertex, vertex}, {1.0, 0.0, 0.0}};
    const PatchPoint at{vec(character_.mesh.positions[v]), vec(character_.mesh.normals[v])};
    if (!field_.inRegion(at.position, vertexWeights_[v])) continue;
    if (project(at, anchorInWorld(site), vertexWeights_[v]).found) omega_[v] = 1.0;
  }
}

Oracle::Hit Oracle::project(const PatchPoint& flat, const Vec& anchor, const std::vector<double>& weights) const {
  const double iso = field_.iso();
  double limit = kSearchLength * height_;
  const bool inside = field_.value(flat.position, weights) >= iso;
  const double anchorDistance = length(anchor - flat.position);
  // Paper 4.2: the anchor ends the bracket of a point outside, so it must be inside; from inside only its direction
  // counts.
  const bool anchorFails = anchorDistance == 0.0 || (!inside && field_.value(anchor, weights) < iso);
  const bool alongNormal = rig_.smoothing.projection == ProjectionKind::kAnalytic || anchorFails;
  Hit hit;
  hit.origin = flat.position;
  hit.direction = flat.normal;
  hit.fellBack = rig_.smoothing.projection != ProjectionKind::kAnalytic && anchorFails;
  if (!alongNormal) {
    hit.direction = (1.0 / anchorDistance) * (flat.position - anchor);
    if (!inside) limit = std::min(limit, anchorDistance);
  }
  const Field::Ray ray = field_.along(hit.origin, hit.direction, weights);
  if (ray.isEmpty()) return hit;
  // Outwards (away from the anchor, along the normal) from inside; inwards from outside.
  const Function phi = [&](double t) { return ray.value(t) - iso; };
  hit.roots = signChanges(phi, 0.0, inside ? limit : -limit, kSteps, kOtherRoots);
  hit.found = !hit.roots.empty();
  if (hit.found) hit.t = hit.roots.front();
  return hit;
}

Answer Oracle::replace(const Site& site) const {
  Answer out;
  const Corners corners = cornersOf(site);
  out.patch = patchPoint(rig_.smoothing.patch, corners, site.barycentric);
  out.position = out.patch.position;
  out.normal = out.patch.normal;
  out.weight = 0.0;
  for (std::size_t i = 0; i < 3; ++i) out.weight += site.barycentric[i] * omega_[index(site.vertices[i])];
  const std::vector<double> weights = weightsAt(site);
  out.nearest = field_.nearest(out.position, weights);
  out.fieldWeights = weights;
  if (out.weight == 0.0) return out;

  const PatchPoint flat = flatPoint(corners, site.barycentric);
  const Hit hit = project(flat, anchorInWorld(site), weights);
  out.field = field_.value(flat.position, weights);
  out.sought = true;
  out.resolved = hit.found;
  out.rayOrigin = hit.origin;
  out.rayDirection = hit.direction;
  out.fellBack = hit.fellBack;
  if (!hit.found) return out;
  out.offset = hit.t;
  out.roots = hit.roots;
  out.weight *= fade(hit.t, kSearchLength * height_);
  const Vec onSurface = hit.origin + hit.t * hit.direction;
  const Vec outward = unitOr(-1.0 * field_.gradient(onSurface, weights), out.patch.normal);
  out.lead = field_.lead(onSurface, weights);
  out.position = out.weight * onSurface + (1.0 - out.weight) * out.patch.position;
  out.normal = unitOr(out.weight * outward + (1.0 - out.weight) * out.patch.normal, out.patch.normal);
  return out;
}

}  // namespace sinew::oracle
