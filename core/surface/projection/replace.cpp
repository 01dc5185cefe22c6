// core/surface/projection/replace.cpp: projection onto F = T along the normal or towards the anchor (paper 4.1, 4.2).
#include "core/surface/projection/replace.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/character/bone_segments.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/potential.h"
#include "core/surface/projection/rise.h"
#include "core/surface/roots/ray_field.h"

namespace sinew {

std::vector<Anchor> findAnchors(const Skeleton& skeleton, std::span<const glm::vec3> points) {
  const std::vector<BoneSegment> segments = boneSegments(skeleton, bindPose(skeleton));
  std::vector<Anchor> anchors;
  anchors.reserve(points.size());
  for (const glm::vec3& point : points) {
    Anchor anchor;
    float nearest = std::numeric_limits<float>::infinity();
    for (const BoneSegment& bones : segments) {
      const Segment segment = bones.segment();
      const float along = segment.closestTo(point);
      const glm::vec3 candidate = segment.from + segment.along * along;
      const glm::vec3 apart = candidate - point;
      const float squared = glm::dot(apart, apart);
      if (!(squared < nearest)) continue;
      nearest = squared;
      const int carrier = along == 1.0f ? bones.endBone : bones.bone;
      const Bone& bone = at(skeleton.bones, carrier);
      anchor = {carrier, glm::vec3(bone.inverseBindInWorld * glm::vec4(candidate, 1.0f))};
    }
    anchors.push_back(anchor);
  }
  return anchors;
}

void poseAnchors(std::span<const Anchor> anchors, const Pose& pose, std::vector<glm::vec3>& out) {
  out.resize(anchors.size());
  std::ranges::transform(anchors, out.begin(), [&pose](const Anchor& anchor) {
    return glm::vec3(at(pose.boneInWorld, anchor.bone) * glm::vec4(anchor.pointInBone, 1.0f));
  });
}

namespace {

constexpr float kWrapped = 0.7f;  ///< Fraction of anchors inside from which muscles count as wrapping the body.
constexpr std::size_t kVerticesInShare = 512;  ///< Fewer are not worth another thread.
constexpr std::size_t kSharesOfThread = 4;     ///< So that idle threads can help.

struct Projected : Replaced {
  double residual = 0.0;
  bool found = false;  ///< There is a root, of any weight, within the search length.

  [[nodiscard]] float left() const { return 1.0f - weight; }
};

class VertexReplacer {
 public:
  VertexReplacer(const FieldView& field, const ReplaceSettings& settings, VertexScratch& scratch)
      : field_(field), settings_(settings), scratch_(scratch) {}

  /// Reads the candidates of a vertex. False if none has weight.
  bool gatherCandidates(const CarriedVertex& vertex, std::span<const CarrierCandidate> near) {
    sinew::gatherCandidates(vertex, near, scratch_);
    cliques_ = field_.cliquesOf(vertex.carrier);
    return !scratch_.candidates.empty();
  }

  /// Whether some f_i != 0 at the point.
  bool insideInfluence(const glm::vec3& point) const {
    return std::ranges::any_of(scratch_.candidates, [&](const Candidate& candidate) {
      return at(field_.primitives, candidate.primitive).influence.holds(point);
    });
  }

  bool isInside(const glm::vec3& point) const { return fieldAt(point) > settings_.iso; }

  /// @param inwards  also search inwards; otherwise only along the normal.
  Projected project(const FlatVertices& flat, std::size_t index, bool inwards) {
    looksInwards_ = inwards;
    const glm::vec3 p = flat.positions[index];
    const glm::vec3 n = flat.normals[index];
    const bool inside = isInside(p);
    Projected result;
    if (!inwards || settings_.alongNormals || settings_.projection == ProjectionKind::kAnalytic) {
      compositeLine(p, -n, static_cast<double>(settings_.searchLength), inside, n, result);
      return result;
    }
    const glm::vec3 q = flat.anchors[index];
    compositeLine(p, normalizeOr(q - p, -n), static_cast<double>(glm::length(q - p)), inside, n, result);
    if (!inside && result.left() > 0.0f) {
      ++scratch_.counts.anchorFallbacks;  // The anchor is not always inside.
      compositeLine(p, -n, static_cast<double>(settings_.searchLength), inside, n, result);
    }
    return result;
  }

 private:
  float fieldAt(const glm::vec3& point) const {
    return sampleField(field_.primitives, scratch_.candidates, cliques_, point, scratch_.field).value;
  }

  void gatherTerms(const glm::vec3& p, const glm::vec3& direction) {
    scratch_.ray.reset(static_cast<double>(settings_.iso), cliques_);
    for (const Candidate& candidate : scratch_.candidates) {
      scratch_.ray.addPrimitive(at(field_.primitives, candidate.primitive), candidate.weight, candidate.slot, p,
                                direction);
    }
  }

  std::optional<double> findChange(double begin, double end, bool fromPositive) {
    return firstChange(scratch_.ray, begin, end, fromPositive, settings_.projection, settings_.tolerance,
                       scratch_.roots);
  }

  /// Largest sampled phi of an interval, or enough for full weight: continuous in its ends, 0 as it vanishes.
  double prominence(double begin, double end) {
    const double whole = static_cast<double>(kFullProminence * settings_.iso);
    double largest = 0.0;
    for (const int tenths : kProminenceSamples) {
      largest = std::max(largest, scratch_.ray.sample(begin + (end - begin) * tenths / 10.0, scratch_.roots).value);
      if (largest >= whole) break;
    }
    return largest;
  }

  /// The line through p: from inside, first outwards to the end of p's own interval, then the intervals inwards.
  void compositeLine(const glm::vec3& p, const glm::vec3& inwards, double inwardLength, bool inside, const glm::vec3& n,
                     Projected& result) {
    double ownEnd = 0.0;
    if (inside) {
      gatherTerms(p, -inwards);
      const std::optional<double> root = findChange(0.0, static_cast<double>(settings_.searchLength), true);
      const double prominenceOutside = root ? prominence(0.0, *root) : 0.0;
      const double residual = root ? std::abs(scratch_.ray.sample(*root, scratch_.roots).value) : 0.0;
      gatherTerms(p, inwards);
      ownEnd = findChange(0.0, inwardLength, true).value_or(inwardLength);
      if (root) {
        const double largest =
            std::max({prominenceOutside, prominence(0.0, ownEnd), scratch_.ray.sample(0.0, scratch_.roots).value});
        compositeRoot(p - static_cast<float>(*root) * inwards, *root, largest, residual, n, result);
      }
    } else {
      gatherTerms(p, inwards);
    }
    compositeIntervals(p, inwards, inside ? ownEnd : 0.0, inwardLength, n, result);
  }

  void compositeIntervals(const glm::vec3& p, const glm::vec3& inwards, double begin, double end, const glm::vec3& n,
                          Projected& result) {
    if (!looksInwards_) return;
    const double reachable = std::min(end, static_cast<double>(settings_.searchLength));
    const double nudge = 4.0 * settings_.tolerance;  // Off a root, where rounding decides the sign.
    double t = begin > 0.0 ? begin + nudge : 0.0;
    for (int i = 0; i < kMostIntervals && t < reachable && result.left() > 0.0f; ++i) {
      const std::optional<double> in = findChange(t, reachable, false);
      if (!in) return;
      const double out = *in + nudge < end ? findChange(*in + nudge, end, true).value_or(end) : end;
      const double residual = std::abs(scratch_.ray.sample(*in, scratch_.roots).value);
      compositeRoot(p + static_cast<float>(*in) * inwards, *in, prominence(*in, out), residual, n, result);
      t = out + nudge;
    }
  }

  void compositeRoot(const glm::vec3& position, double distance, double prominent, double residual, const glm::vec3& n,
                     Projected& result) {
    constexpr double kBegin = static_cast<double>(kFadeBegin);
    const double far = (distance / static_cast<double>(settings_.searchLength) - kBegin) / (1.0 - kBegin);
    const double share = prominent / static_cast<double>(kFullProminence * settings_.iso);
    const float own =
        smoothstep(0.0f, 1.0f, static_cast<float>(share)) * (1.0f - smoothstep(0.0f, 1.0f, static_cast<float>(far)));
    const float weight = own == 1.0f ? result.left() : own * result.left();
    result.found = true;
    result.residual = std::max(result.residual, residual);
    if (weight <= 0.0f) return;
    const glm::vec3 gradient =
        sampleField(field_.primitives, scratch_.candidates, cliques_, position, scratch_.field).gradient;
    result.position += weight * position;
    result.normal += weight * normalizeOr(-gradient, n);
    result.weight = own == 1.0f ? 1.0f : result.weight + weight;
  }

  const FieldView& field_;
  const ReplaceSettings& settings_;
  VertexScratch& scratch_;
  CliqueLevelsView cliques_;
  bool looksInwards_ = true;
};

float omegaAt(const CarriedVertex& vertex, std::span<const float> omega) {
  float sum = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) sum += vertex.barycentric[i] * at(omega, vertex.corners[i]);
  return sum;
}

void blendWithPatch(Surface& surface, std::size_t index, const Replaced& projected, float omega) {
  const glm::vec3 patch = surface.positions[index];
  const glm::vec3 n = surface.normals[index];
  const float patchShare = 1.0f - omega * projected.weight;
  // At full weight the projection itself, not a sum that rounds.
  surface.positions[index] = patchShare == 0.0f ? projected.position : projected.position * omega + patch * patchShare;
  surface.normals[index] = normalizeOr(projected.normal * omega + n * patchShare, n);
  surface.displacement[index] = glm::dot(surface.positions[index] - patch, n);
}

/// Keeps skin on both sides of a gap filled by a muscle from moving through each other to its far sides.
/// @param patch, n  position and normal of the vertex before it moved.
void limitRise(Surface& surface, std::size_t index, const glm::vec3& patch, const glm::vec3& n, float inverseLimit) {
  const glm::vec3 way = surface.positions[index] - patch;
  const float rise = glm::length(way);
  const float limited = in_float::limitedRise(rise, inverseLimit);
  if (limited == rise) return;
  const float share = limited / rise;
  surface.positions[index] = patch + share * way;
  surface.normals[index] = normalizeOr(n + share * (surface.normals[index] - n), n);
  surface.displacement[index] *= share;
}

void moveVertex(const CarriedVertex& vertex, std::span<const CarrierCandidate> near, VertexReplacer& projector,
                const FlatVertices& flat, const ImplicitWeights& weights, Surface& surface, VertexCounts& counts) {
  const float weight = omegaAt(vertex, weights.omega);
  if (weight <= 0.0f || !projector.gatherCandidates(vertex, near)) return;
  const auto index = static_cast<std::size_t>(vertex.index);
  if (!weights.wraps && !projector.isInside(flat.positions[index])) return;
  ++counts.projected;
  const Projected projected = projector.project(flat, index, weights.wraps);
  if (!projected.found) {
    ++counts.unresolved;
    return;
  }
  counts.residualMax = std::max(counts.residualMax, projected.residual);
  if (!(projected.weight > 0.0f)) return;
  const bool limits = !weights.wraps && !flat.inverseLimits.empty();
  placeReplaced(projected, weight, limits ? flat.inverseLimits[index] : 0.0f, index, surface);
}

}  // namespace

void placeReplaced(const Replaced& replaced, float omega, float inverseLimit, std::size_t vertex, Surface& surface) {
  const glm::vec3 patch = surface.positions[vertex];
  const glm::vec3 n = surface.normals[vertex];
  blendWithPatch(surface, vertex, replaced, omega);
  if (inverseLimit > 0.0f) limitRise(surface, vertex, patch, n, inverseLimit);
}

void replaceVertex(const CarriedVertex& vertex, const FieldView& field, const ReplaceSettings& settings,
                   const FlatVertices& flat, const ImplicitWeights& weights, Surface& surface, VertexScratch& scratch) {
  VertexReplacer projector(field, settings, scratch);
  moveVertex(vertex, field.lists->of(vertex.carrier), projector, flat, weights, surface, scratch.counts);
}

void implicitWeights(const ControlMesh& mesh, const FieldView& bindField, const ReplaceSettings& settings,
                     const FlatVertices& flat, ProjectionScratch& scratch, ImplicitWeights& weights) {
  weights.omega.assign(mesh.positions.size(), 0.0f);
  weights.unwrapped = 0;
  VertexReplacer projector(bindField, settings, scratch);
  const auto eachInRegion = [&](auto&& visit) {
    for (int v = 0; v < static_cast<int>(mesh.positions.size()); ++v) {
      const auto index = static_cast<std::size_t>(v);
      if (!projector.gatherCandidates(controlCarried(v), bindField.lists->of(v))) continue;
      if (projector.insideInfluence(flat.positions[index])) visit(index);
    }
  };
  int inRegion = 0;
  int anchored = 0;
  eachInRegion([&](std::size_t v) {
    ++inRegion;
    anchored += projector.isInside(flat.anchors[v]) ? 1 : 0;
  });
  weights.wraps = static_cast<float>(anchored) >= kWrapped * static_cast<float>(inRegion);
  eachInRegion([&](std::size_t v) {
    if (!weights.wraps && !projector.isInside(flat.positions[v])) ++weights.unwrapped;
    else if (projector.project(flat, v, weights.wraps).found) weights.omega[v] = 1.0f;
  });
}

void replace(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings, const FlatVertices& flat,
             const ImplicitWeights& weights, Surface& surface, ProjectionScratch& scratch) {
  const std::size_t shares = std::clamp(surface.positions.size() / kVerticesInShare, std::size_t{1},
                                        kSharesOfThread * static_cast<std::size_t>(threadCount()));
  scratch.shares.resize(std::max(scratch.shares.size(), shares));
  forEachIndex(shares, 1, [&](std::size_t index) {
    VertexScratch& own = scratch.shares[index];
    own.counts = {};
    VertexReplacer projector(field, settings, own);
    const auto move = [&](const CarriedVertex& vertex, std::span<const CarrierCandidate> near) {
      moveVertex(vertex, near, projector, flat, weights, surface, own.counts);
    };
    // All candidates, because the anchor may lie anywhere on the skeleton.
    forEachReachable(mesh, *surface.refinement, field, flat.positions, Reach::kAll, {index, shares}, own.walk, move);
  });
  scratch.counts = {};
  for (const VertexScratch& share : std::span(scratch.shares).first(shares)) add(share.counts, scratch.counts);
  addToReport(scratch.counts, surface.report);
}

}  // namespace sinew
