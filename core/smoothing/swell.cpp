// core/smoothing/swell.cpp: a field of the skin itself, summed with the muscles'.
#include "core/smoothing/swell.h"

#include <algorithm>
#include <cmath>

#include "core/smoothing/root_finding.h"

namespace sinew {
namespace {

/// f_skin(s) = g(max(0, s/W + r_T)), s along the patch normal: T on the skin, 0 from s = h on, 1 from s = -r_T W
/// inwards.
struct SkinField {
  double isoRadius;  ///< r_T
  double width;      ///< W = h / (1 - r_T)
  double blendWidth; ///< h

  SkinField(double iso, double h)
      : isoRadius(std::sqrt(1.0 - std::sqrt(iso))), width(h / (1.0 - isoRadius)), blendWidth(h) {}

  double plateau() const { return isoRadius * width; }

  /// As a term of a ray that starts on the skin; outward: along the normal.
  RayTerm term(bool outward) const {
    RayTerm skin;
    skin.a = 1.0 / (width * width);
    skin.b = (outward ? isoRadius : -isoRadius) / width;
    skin.c = isoRadius * isoRadius;
    skin.factor = 1.0;
    skin.enter = outward ? -plateau() : -blendWidth;
    skin.leave = outward ? blendWidth : plateau();
    return skin;
  }

  double slope(double s) const {
    const double r = std::max(0.0, s / width + isoRadius);
    return r < 1.0 ? -4.0 * r * (1.0 - r * r) / width : 0.0;
  }
};

/// Projects vertex after vertex; holds what is reused from one to the next.
class Sweller {
 public:
  Sweller(const FieldView& field, const SwellSettings& settings, Surface& surface)
      : field_(field), settings_(settings), surface_(surface),
        skin_(static_cast<double>(settings.iso), static_cast<double>(settings.blendWidth)) {}

  void move(const CarriedVertex& vertex, std::span<const CarrierCandidate> near) {
    weigh(vertex, near);
    if (candidates_.empty()) return;
    const auto index = static_cast<std::size_t>(vertex.index);
    const glm::vec3 p = surface_.positions[index];
    const CliqueLists& cliques = field_.lists->cliquesOf(vertex.carrier);
    const float onSkin = sampleField(field_.primitives, candidates_, cliques, p).value;
    if (onSkin == 0.0f) return;
    ++surface_.report.projected;
    const double s = root(p, surface_.normals[index], onSkin > 0.0f, cliques);
    if (s == 0.0) return;
    place(index, static_cast<float>(s), cliques);
  }

  const Evaluations& evaluations() const { return ray_.evaluations(); }

 private:
  void weigh(const CarriedVertex& vertex, std::span<const CarrierCandidate> near) {
    candidates_.clear();
    for (const CarrierCandidate& candidate : near) {
      const float weight = candidate.weightAt(vertex.barycentric);
      if (weight > 0.0f) candidates_.push_back({candidate.primitive, weight, candidate.slot});
    }
  }

  /// s*, signed along the normal.
  double root(const glm::vec3& p, const glm::vec3& normal, bool outward, const CliqueLists& cliques) {
    ray_.reset(static_cast<double>(settings_.iso), cliques);
    ray_.addTerm(skin_.term(outward));
    const glm::vec3 direction = outward ? normal : -normal;
    for (const Candidate& candidate : candidates_) {
      ray_.addPrimitive(field_.primitives[static_cast<std::size_t>(candidate.primitive)], candidate.weight,
                        candidate.slot, p, direction);
    }
    const double end = outward ? ray_.lastLeave() : skin_.plateau();
    // The direction and the sign of phi must be one decision: where F is all but 0, rounding may see it otherwise along
    // the ray, and a search for the wrong change would run to its end.
    const std::optional<double> found =
        firstChange(ray_, 0.0, end, outward, settings_.projection, settings_.tolerance);
    // Outwards only -T is left beyond the last term, so `end` is a root there; inwards a carve deeper than the skin's
    // own field stops at the plateau, continuously.
    const double t = found.value_or(end);
    if (found) surface_.report.residualMax = std::max(surface_.report.residualMax, std::abs(ray_.sample(t).value));
    return outward ? t : -t;
  }

  void place(std::size_t index, float s, const CliqueLists& cliques) {
    const glm::vec3 n = surface_.normals[index];
    const glm::vec3 moved = surface_.positions[index] + s * n;
    const glm::vec3 gradient = sampleField(field_.primitives, candidates_, cliques, moved).gradient;
    const glm::vec3 outwards = -(static_cast<float>(skin_.slope(static_cast<double>(s))) * n + gradient);
    surface_.positions[index] = moved;
    surface_.normals[index] = normalizeOr(outwards, n);
    surface_.displacement[index] = s;
  }

  const FieldView& field_;
  const SwellSettings& settings_;
  Surface& surface_;
  SkinField skin_;
  RayField ray_;
  std::vector<Candidate> candidates_;
};

}  // namespace

void swell(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, Surface& surface) {
  Sweller sweller(field, settings, surface);
  forEachReachable(
      mesh, *surface.refinement, field, surface.positions, Reach::kOverlapping,
      [&](const CarriedVertex& vertex, std::span<const CarrierCandidate> near) { sweller.move(vertex, near); });
  surface.report.evaluations = sweller.evaluations();
}

}  // namespace sinew
