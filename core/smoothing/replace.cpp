// core/smoothing/replace.cpp: projection onto F = T along the normal or towards the anchor (paper 4.1, 4.2, Fig. 5).
#include "core/smoothing/replace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/smoothing/root_finding.h"

namespace sinew {
namespace {

constexpr float kFadeBegin = 0.8f;  ///< Fraction of the search length from where a projection loses weight.

/// No culling against the vertices' box: the anchor may lie anywhere on the skeleton.
constexpr float kEverywhere = std::numeric_limits<float>::infinity();

struct Projected {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};
  float distance = 0.0f;  ///< From p, world units.
  double residual = 0.0;
};

class Projector {
 public:
  Projector(const FieldView& field, const ReplaceSettings& settings) : field_(field), settings_(settings) {}

  int anchorFallbacks() const { return anchorFallbacks_; }

  /// Reads the candidates of a vertex; false where none has weight.
  bool look(const CarriedVertex& vertex, std::span<const CarrierCandidate> near) {
    candidates_.clear();
    for (const CarrierCandidate& candidate : near) {
      const float weight = candidate.weightAt(vertex.barycentric);
      if (weight > 0.0f) candidates_.push_back({candidate.primitive, weight, candidate.slot});
    }
    cliques_ = &field_.lists->cliquesOf(vertex.carrier);
    return !candidates_.empty();
  }

  /// Some f_i != 0 at the point.
  bool insideInfluence(const glm::vec3& point) const {
    return std::ranges::any_of(candidates_, [&](const Candidate& candidate) {
      const UnitBallMap& ball = field_.primitives[static_cast<std::size_t>(candidate.primitive)].influence;
      const glm::vec3 y = ball.toUnit * (point - ball.center);
      return ball.boundingRadius > 0.0f && glm::dot(y, y) < 1.0f;
    });
  }

  std::optional<Projected> project(const FlatVertices& flat, std::size_t index) {
    const glm::vec3 p = flat.positions[index];
    const glm::vec3 n = flat.normals[index];
    const bool inside = fieldAt(p) > settings_.iso;
    if (settings_.projection == ProjectionKind::kAnalytic) return along(p, inside ? n : -n, settings_.searchLength, n);
    const glm::vec3 q = flat.anchors[index];
    const float length = glm::length(q - p);
    const glm::vec3 towards = normalizeOr(q - p, -n);
    if (inside) return along(p, -towards, settings_.searchLength, n);
    if (fieldAt(q) > settings_.iso) return along(p, towards, length, n);
    ++anchorFallbacks_;  // PERFORMANCE pitfall 1: the anchor is not always inside
    return along(p, -n, settings_.searchLength, n);
  }

 private:
  float fieldAt(const glm::vec3& point) const {
    return sampleField(field_.primitives, candidates_, *cliques_, point).value;
  }

  std::optional<Projected> along(const glm::vec3& p, const glm::vec3& direction, float length, const glm::vec3& n) {
    ray_.reset(static_cast<double>(settings_.iso), *cliques_);
    for (const Candidate& candidate : candidates_) {
      ray_.addPrimitive(field_.primitives[static_cast<std::size_t>(candidate.primitive)], candidate.weight,
                        candidate.slot, p, direction);
    }
    const double end = std::min(length, settings_.searchLength);
    const std::optional<double> t = firstRoot(ray_, end, settings_.projection, settings_.tolerance);
    if (!t) return std::nullopt;
    Projected result;
    result.distance = static_cast<float>(*t);
    result.position = p + result.distance * direction;
    result.normal =
        normalizeOr(-sampleField(field_.primitives, candidates_, *cliques_, result.position).gradient, n);
    result.residual = std::abs(ray_.sample(*t).value);
    return result;
  }

  const FieldView& field_;
  const ReplaceSettings& settings_;
  const CliqueLists* cliques_ = nullptr;
  std::vector<Candidate> candidates_;
  RayField ray_;
  int anchorFallbacks_ = 0;
};

float fade(float distance, float searchLength) {
  const float t = std::clamp((distance / searchLength - kFadeBegin) / (1.0f - kFadeBegin), 0.0f, 1.0f);
  return 1.0f - t * t * (3.0f - 2.0f * t);
}

float omegaAt(const CarriedVertex& vertex, std::span<const float> omega) {
  float sum = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) sum += vertex.barycentric[i] * omega[static_cast<std::size_t>(vertex.corners[i])];
  return sum;
}

void mix(Surface& surface, std::size_t index, const Projected& projected, float weight) {
  const glm::vec3 patch = surface.positions[index];
  const glm::vec3 n = surface.normals[index];
  // At full weight the projection itself, not a sum that rounds.
  surface.positions[index] =
      weight == 1.0f ? projected.position : projected.position * weight + patch * (1.0f - weight);
  surface.normals[index] = normalizeOr(projected.normal * weight + n * (1.0f - weight), n);
  surface.displacement[index] = glm::dot(surface.positions[index] - patch, n);
}

}  // namespace

std::vector<float> implicitWeights(const ControlMesh& mesh, const FieldView& bindField, const ReplaceSettings& settings,
                                   const FlatVertices& flat) {
  std::vector<float> omega(mesh.positions.size(), 0.0f);
  Projector projector(bindField, settings);
  for (int v = 0; v < static_cast<int>(mesh.positions.size()); ++v) {
    const auto index = static_cast<std::size_t>(v);
    if (!projector.look(CarriedVertex{v, v, {v, v, v}, {1.0f, 0.0f, 0.0f}}, bindField.lists->of(v))) continue;
    if (projector.insideInfluence(flat.positions[index]) && projector.project(flat, index)) omega[index] = 1.0f;
  }
  return omega;
}

void replace(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings, const FlatVertices& flat,
             std::span<const float> omega, Surface& surface) {
  Projector projector(field, settings);
  const auto move = [&](const CarriedVertex& vertex, std::span<const CarrierCandidate> near) {
    const float weight = omegaAt(vertex, omega);
    if (weight <= 0.0f || !projector.look(vertex, near)) return;
    const auto index = static_cast<std::size_t>(vertex.index);
    ++surface.report.projected;
    const std::optional<Projected> projected = projector.project(flat, index);
    if (!projected) {
      ++surface.report.unresolved;
      return;
    }
    surface.report.residualMax = std::max(surface.report.residualMax, projected->residual);
    const float faded = weight * fade(projected->distance, settings.searchLength);
    if (faded > 0.0f) mix(surface, index, *projected, faded);
  };
  forEachReachable(mesh, *surface.refinement, field, flat.positions, kEverywhere, move);
  surface.report.anchorFallbacks = projector.anchorFallbacks();
}

}  // namespace sinew
