// tests/support/oracle/replace.cpp: the paper's method (docs/design.md, `replace`): anchors, omegas, projection on F =
// T.

#include <algorithm>
#include <cmath>

#include "tests/support/oracle/oracle.h"
#include "tests/support/oracle/rise.h"
#include "tests/support/oracle/triangles.h"

namespace sinew::oracle {
namespace {

constexpr int kLineSteps = 2400;  ///< Steps of the brute-force search.
constexpr int kStretches = 8;     ///< More than any test lays behind each other.
// docs/design.md, "Replace: the paper's method"; the number is that of the step there.
constexpr double kWrapped = 0.7;             ///< 0: "for 70 % of the control vertices inside the region of influence".
constexpr double kSearchLength = 0.2;        ///< 2: "the search length L = 0.2 H".
constexpr int kProminenceSamples = 9;        ///< 3: "at nine points spaced evenly in it".
constexpr double kWholeProminence = 0.25;    ///< 3: "from 0 to T/4".
constexpr double kFadingLength = 1.0 / 5.0;  ///< 3: "a smooth fade over the last fifth of L".

double smooth(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// Share before others are laid over it: by the largest F - T of the stretch and by how far its beginning is.
double ownShare(double prominence, double iso, double t, double searchLength) {
  const double toTheEnd = 1.0 - std::abs(t) / searchLength;
  return smooth(prominence / (kWholeProminence * iso)) * smooth(toTheEnd / kFadingLength);
}

/// The largest of the samples inside a stretch.
double prominence(const Function& phi, double from, double to) {
  double most = 0.0;
  for (int i = 1; i <= kProminenceSamples; ++i)
    most = std::max(most, phi(from + (to - from) * i / (kProminenceSamples + 1)));
  return most;
}

/// Share of the way from a to b.
double closestOnSegment(const Vec& a, const Vec& b, const Vec& point) {
  const Vec along = b - a;
  const double squared = dot(along, along);
  return squared > 0.0 ? std::clamp(dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace

Oracle::Anchor Oracle::anchorOf(const Vec& bindPoint) const {
  const auto& bones = character_.skeleton.bones;
  const auto originOf = [](const Bone& bone) { return affine(bone.bindInWorld).offset; };
  Anchor best;
  double bestDistance = 1e300;
  // A segment rides on the bone it starts at, but its end, where another bone begins, on that one.
  const auto offer = [&](std::size_t startBone, std::size_t endBone, const Vec& end) {
    const Vec start = originOf(bones[startBone]);
    const double t = closestOnSegment(start, end, bindPoint);
    const Vec closest = t < 1.0 ? start + t * (end - start) : end;
    const std::size_t bone = t < 1.0 ? startBone : endBone;
    const double distance = length(closest - bindPoint);
    if (distance >= bestDistance) return;
    bestDistance = distance;
    const Affine bind = affine(bones[bone].bindInWorld);
    if (determinant(bind.linear) == 0.0) return;
    best = {static_cast<int>(bone), inverse(bind.linear) * (closest - bind.offset)};
  };
  for (std::size_t b = 0; b < bones.size(); ++b) {
    bool childless = true;
    for (std::size_t c = 0; c < bones.size(); ++c) {
      if (bones[c].parent != static_cast<int>(b)) continue;
      childless = false;
      offer(b, c, originOf(bones[c]));
    }
    if (childless) offer(b, b, apply(affine(bones[b].bindInWorld), vec(bones[b].tip)));
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

bool Oracle::findWhetherWrapped() const {
  int inRegion = 0;
  int wrapped = 0;
  for (std::size_t v = 0; v < vertexWeights_.size(); ++v) {
    const int vertex = static_cast<int>(v);
    if (!field_.inRegion(vec(character_.mesh.positions[v]), vertexWeights_[v])) continue;
    ++inRegion;
    const Vec anchor = anchorInWorld({{vertex, vertex, vertex}, {1.0, 0.0, 0.0}});
    if (field_.value(anchor, vertexWeights_[v]) > field_.iso()) ++wrapped;
  }
  return wrapped >= kWrapped * inRegion;
}

void Oracle::findOmegas() {
  Pose bind;
  for (const Bone& bone : character_.skeleton.bones) bind.boneInWorld.push_back(bone.bindInWorld);
  pose(bind);
  wraps_ = findWhetherWrapped();
  omega_.assign(character_.mesh.positions.size(), 0.0);
  for (std::size_t v = 0; v < omega_.size(); ++v) {
    const int vertex = static_cast<int>(v);
    const Site site{{vertex, vertex, vertex}, {1.0, 0.0, 0.0}};
    const PatchPoint at{vec(character_.mesh.positions[v]), vec(character_.mesh.normals[v])};
    if (!field_.inRegion(at.position, vertexWeights_[v])) continue;
    const bool counts = wraps_ ? project(at, anchorInWorld(site), vertexWeights_[v]).found()
                               : field_.value(at.position, vertexWeights_[v]) > field_.iso();
    if (counts) omega_[v] = 1.0;
  }
}

void Oracle::lay(const Line& line, const std::vector<double>& weights, Hit& hit, bool outwardsAlone) const {
  const Field::Ray ray = field_.along(line.origin, line.inwards, weights);
  if (ray.isEmpty()) return;
  const double searchLength = kSearchLength * height_;
  const Function phi = [&](double t) { return ray.value(t) - field_.iso(); };
  const auto add = [&](double t, double prominent) {
    hit.layers.push_back({line.origin + t * line.inwards, t, ownShare(prominent, field_.iso(), t, searchLength)});
  };
  double begin = 0.0;
  if (line.inside) {
    const std::vector<double> ends = signChanges(phi, 0.0, line.length, kLineSteps, 1);
    begin = ends.empty() ? line.length : ends.front();
    const std::vector<double> outer = signChanges(phi, 0.0, -searchLength, kLineSteps, 1);
    if (!outer.empty()) {
      add(outer.front(), std::max({prominence(phi, outer.front(), 0.0), prominence(phi, 0.0, begin), phi(0.0)}));
    }
  }
  if (outwardsAlone || begin >= line.length) return;
  const double start = line.inside ? begin + 1e-7 * height_ : 0.0;
  const std::vector<double> changes = signChanges(phi, start, line.length, kLineSteps, 2 * kStretches);
  for (std::size_t i = 0; i < changes.size() && changes[i] < searchLength && hit.left() > 0.0; i += 2) {
    add(changes[i], prominence(phi, changes[i], i + 1 < changes.size() ? changes[i + 1] : line.length));
  }
}

double Oracle::Hit::left() const { return leftBehind(layers.size()); }

double Oracle::Hit::leftBehind(std::size_t count) const {
  double product = 1.0;
  for (std::size_t i = 0; i < count; ++i) product *= 1.0 - layers[i].own;
  return product;
}

Oracle::Hit Oracle::project(const PatchPoint& flat, const Vec& anchor, const std::vector<double>& weights) const {
  const bool inside = field_.value(flat.position, weights) > field_.iso();
  const double searchLength = kSearchLength * height_;
  const Line alongNormal{flat.position, -1.0 * flat.normal, searchLength, inside};
  Hit hit;
  if (rig_.smoothing.alongNormals || projection_ == ProjectionKind::kAnalytic) {
    hit.line = alongNormal;
    lay(hit.line, weights, hit);
    return hit;
  }
  // Paper 4.2: the anchor ends the bracket of a point outside; from inside only its direction counts.
  const double distance = length(anchor - flat.position);
  hit.line = {flat.position, unitOr(anchor - flat.position, -1.0 * flat.normal), distance, inside};
  lay(hit.line, weights, hit);
  hit.fellBack = !inside && hit.left() > 0.0;
  if (hit.fellBack) lay(alongNormal, weights, hit);
  return hit;
}

Oracle::Hit Oracle::projectOutwards(const PatchPoint& flat, const std::vector<double>& weights) const {
  Hit hit;
  hit.line = {flat.position, -1.0 * flat.normal, kSearchLength * height_, true};
  lay(hit.line, weights, hit, true);
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
  out.field = field_.value(flat.position, weights);
  if (!wraps_ && out.field <= field_.iso()) return out;
  const Hit hit = wraps_ ? project(flat, anchorInWorld(site), weights) : projectOutwards(flat, weights);
  out.sought = true;
  out.resolved = hit.found();
  out.rayOrigin = hit.line.origin;
  out.rayDirection = hit.line.inwards;
  out.fellBack = hit.fellBack;
  if (!hit.found()) return out;
  out.offset = hit.layers.front().t;
  const double omega = out.weight;
  out.weight = 0.0;
  Vec position;
  Vec normal;
  for (std::size_t i = 0; i < hit.layers.size(); ++i) {
    const Layer& layer = hit.layers[i];
    const double share = layer.own * hit.leftBehind(i);
    out.shares.push_back(share);
    if (!hit.fellBack) out.roots.push_back(layer.t);
    const Vec outward = unitOr(-1.0 * field_.gradient(layer.point, weights), flat.normal);
    position = position + share * layer.point;
    normal = normal + share * outward;
    out.weight += omega * share;
    if (share > 0.0) {
      const double lead = field_.lead(layer.point, weights);
      out.lead = out.lead == 0.0 ? lead : std::min(out.lead, lead);
    }
  }
  out.position = omega * position + (1.0 - out.weight) * out.patch.position;
  out.normal = unitOr(omega * normal + (1.0 - out.weight) * out.patch.normal, out.patch.normal);
  if (wraps_) return out;
  // Among other skin it stays below the limit of its rise.
  const double rise = length(out.position - out.patch.position);
  const double limited = heightWithin(rise, inverseLimitAt(site));
  out.limited = limited != rise;
  if (!out.limited) return out;
  out.position = out.patch.position + (limited / rise) * (out.position - out.patch.position);
  out.normal = unitOr(out.patch.normal + (limited / rise) * (out.normal - out.patch.normal), out.patch.normal);
  return out;
}

}  // namespace sinew::oracle
