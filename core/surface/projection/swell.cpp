// core/surface/projection/swell.cpp: the sum of the muscles' fields and a field of the skin itself, vertex by vertex.
#include "core/surface/projection/swell.h"

#include <cmath>

#include "core/geometry/at.h"
#include "core/geometry/potential.h"
#include "core/surface/projection/rise.h"
#include "core/surface/roots/ray_field.h"

namespace sinew {
namespace {

/// f_skin(s) = g(max(0, s/W + r_T)), s along the rise direction: T on the skin, 0 for s >= h, 1 for s <= -r_T W.
struct SkinField {
  double isoRadius;   ///< r_T
  double isoRoot;     ///< w of T
  double width;       ///< W = h / (1 - r_T)
  double blendWidth;  ///< h

  SkinField(double rT, double root, double h) : isoRadius(rT), isoRoot(root), width(h / (1.0 - rT)), blendWidth(h) {}

  double plateau() const { return isoRadius * width; }

  /// A term for a ray from the skin. @param outward  along the normal
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

  in_double::SkinRay ray(bool outward) const {
    return {outward ? 1.0 : -1.0, 1.0 / width, isoRadius, isoRoot, outward ? isoRoot : 1e30};
  }
  /// Of f_skin by s.
  double slope(double s) const { return -4.0 * in_double::skinSlope(ray(s >= 0.0), std::abs(s)); }
};

/// Signed along the direction.
struct Root {
  float s;
  float below;  ///< s, or less below an overhang.
};

/// Means over the muscles at a point of the skin, weighted by their parts of the field.
struct MeanSizes {
  double blendWidth;  ///< h
  double radius;
};

class Sweller {
 public:
  Sweller(const FieldView& field, const SwellSettings& settings, const RiseView& rise, Surface* surface,
          VertexScratch& scratch)
      : field_(field),
        settings_(settings),
        rise_(rise),
        surface_(surface),
        scratch_(scratch),
        isoRadius_(isoRadius(static_cast<double>(settings.iso))),
        isoRoot_(in_double::potentialInverse(static_cast<double>(settings.iso))) {}

  void move(const CarriedVertex& vertex, std::span<const CarrierCandidate> near) {
    gatherCandidates(vertex, near, scratch_);
    if (scratch_.candidates.empty()) return;
    const auto index = static_cast<std::size_t>(vertex.index);
    const glm::vec3 p = surface_->positions[index];
    const CliqueLevelsView cliques = field_.cliquesOf(vertex.carrier);
    const float onSkin = sampleField(field_.primitives, scratch_.candidates, cliques, p, scratch_.field).value;
    if (onSkin == 0.0f) return;
    ++scratch_.counts.projected;
    const MeanSizes sizes = meanSizesAt(p);
    const SkinField skin(isoRadius_, isoRoot_, sizes.blendWidth);
    const double s = findRoot(skin, p, rise_.directions[index], onSkin > 0.0f, cliques);
    if (s == 0.0) return;
    place(skin, onSkin, index, {static_cast<float>(s), belowOverhangs(skin, s, sizes.radius)}, cliques);
  }

  /// The implicit function of the root: psi(s, f) = 0, so ds / df_i = -(d psi / d f_i) / (d psi / d s).
  void slopes(const CarriedVertex& vertex, const glm::vec3& p, float height, HeightSlopes& out) {
    gatherCandidates(vertex, field_.lists->of(vertex.carrier), scratch_);
    const auto index = static_cast<std::size_t>(vertex.index);
    const glm::vec3& d = rise_.directions[index];
    const CliqueLevelsView cliques = field_.cliquesOf(vertex.carrier);
    const float onSkin = sampleField(field_.primitives, scratch_.candidates, cliques, p, scratch_.field).value;
    if (onSkin == 0.0f) return;
    const MeanSizes sizes = meanSizesAt(p);
    const SkinField skin(isoRadius_, isoRoot_, sizes.blendWidth);
    const UnlimitedRise rise = unlimited(skin, onSkin, index, height);
    const float sign = height > 0.0f ? 1.0f : -1.0f;
    const double s = static_cast<double>(sign * rise.s);
    out.top = p + sign * rise.s * d;
    const glm::vec3 gradient =
        sampleField(field_.primitives, scratch_.candidates, cliques, out.top, scratch_.field).gradient;
    using Overhangs = in_double::Overhangs<double (*)(double)>;
    const double sigma = Overhangs::overhangSlope(skin.ray(height > 0.0f), skin.blendWidth, sizes.radius);
    const double fall = std::min(skin.slope(s) + static_cast<double>(glm::dot(gradient, d)), -sigma);
    const bool atEnd = height < 0.0f && static_cast<double>(rise.s) > 0.999 * skin.plateau();
    const float byRoot = atEnd ? 0.0f : rise.byRoot / static_cast<float>(-fall);
    fieldShares(field_.primitives, scratch_.candidates, cliques, out.top, scratch_.field, topShares_);
    fieldShares(field_.primitives, scratch_.candidates, cliques, p, scratch_.field, skinShares_);
    for (std::size_t i = 0; i < scratch_.candidates.size(); ++i) {
      const auto& [primitive, weight, slot] = scratch_.candidates[i];
      out.of.push_back({primitive, weight * topShares_[i] * byRoot, weight * skinShares_[i] * sign * rise.byOnSkin});
    }
  }

 private:
  /// What limitedHeight() was made from; sizes, not signed.
  struct UnlimitedRise {
    float s = 0.0f;
    float byRoot = 1.0f;    ///< d height / d s
    float byOnSkin = 0.0f;  ///< d height / d F on the skin
  };
  UnlimitedRise unlimited(const SkinField& skin, float onSkin, std::size_t index, float height) const {
    const auto touchAt = [&](float value) {
      return in_float::inverseTouchLimit(value, settings_.iso, static_cast<float>(isoRoot_),
                                         static_cast<float>(isoRadius_), static_cast<float>(1.0 / skin.width));
    };
    const float touch = touchAt(onSkin);
    const float inverse = height > 0.0f ? std::max(rise_.inverseLimits[index], touch) : touch;
    const float size = std::abs(height);
    if (!(size * inverse > 0.5f)) return {size};
    const float limit = 1.0f / inverse;
    UnlimitedRise out;
    out.s = 0.25f * limit * limit / std::max(limit - size, 1e-6f * limit);
    out.byRoot = 0.25f * limit * limit / (out.s * out.s);
    if (touch < inverse) return out;
    const float step = 0.01f * onSkin;
    const float next = touchAt(onSkin + step);
    if (next > 0.0f) out.byOnSkin = (1.0f - 0.5f * limit / out.s) * (1.0f / next - limit) / step;
    return out;
  }

  /// h at a point of the skin: the mean over its muscles, weighted by their parts of the field, of the lesser of the
  /// rig's blend width and the muscle's mean radius. With a larger h the skin would rise as a whole and drop off a
  /// cliff at the end of the muscle's influence.
  MeanSizes meanSizesAt(const glm::vec3& p) const {
    double sum = 0.0;
    double radii = 0.0;
    double whole = 0.0;
    for (const Candidate& candidate : scratch_.candidates) {
      const PosedPrimitive& primitive = at(field_.primitives, candidate.primitive);
      const float rSquared = primitive.influence.rSquared(p);
      if (!(primitive.influence.boundingRadius > 0.0f && rSquared < 1.0f)) continue;
      const float share = std::abs(primitive.strength) * candidate.weight * potential(rSquared);
      sum += static_cast<double>(share) * static_cast<double>(std::min(settings_.blendWidth, primitive.meanRadius));
      radii += static_cast<double>(share) * static_cast<double>(primitive.meanRadius);
      whole += static_cast<double>(share);
    }
    const double most = static_cast<double>(settings_.blendWidth);
    return whole > 0.0 ? MeanSizes{sum / whole, radii / whole} : MeanSizes{most, most};
  }

  /// s*, signed along the direction.
  double findRoot(const SkinField& skin, const glm::vec3& p, const glm::vec3& outwards, bool outward,
                  CliqueLevelsView cliques) {
    scratch_.ray.reset(static_cast<double>(settings_.iso), cliques);
    scratch_.ray.addTerm(skin.term(outward));
    const glm::vec3 direction = outward ? outwards : -outwards;
    for (const Candidate& candidate : scratch_.candidates) {
      scratch_.ray.addPrimitive(at(field_.primitives, candidate.primitive), candidate.weight, candidate.slot, p,
                                direction);
    }
    const double end = outward ? scratch_.ray.lastLeave() : skin.plateau();
    // `outward` decides both the direction and the sign of phi: where F is nearly 0, rounding may give phi the other
    // sign along the ray, and a search for the wrong change of sign would run to its end.
    const std::optional<double> found =
        firstChange(scratch_.ray, 0.0, end, outward, settings_.projection, settings_.tolerance, scratch_.roots);
    // Outwards, phi is -T beyond the last term, so `end` is a root; inwards, a carve deeper than the skin's own field
    // stops at the plateau, continuously.
    const double t = found.value_or(end);
    if (found)
      scratch_.counts.residualMax =
          std::max(scratch_.counts.residualMax, std::abs(scratch_.ray.sample(t, scratch_.roots).value));
    return outward ? t : -t;
  }

  /// The root, or less if psi falls slowly before it.
  float belowOverhangs(const SkinField& skin, double s, double radius) {
    const double sign = s > 0.0 ? 1.0 : -1.0;
    const auto psi = [&](double t) {
      const ValueAndSlope sample = scratch_.ray.sample(t, scratch_.roots);
      return in_double::Sample{sign * sample.value, sign * sample.slope};
    };
    using Overhangs = in_double::Overhangs<decltype(psi)>;
    const double sigma = Overhangs::overhangSlope(skin.ray(s > 0.0), skin.blendWidth, radius);
    return static_cast<float>(sign * Overhangs::heightBelowOverhangs(psi, std::abs(s), sigma, skin.blendWidth, true));
  }

  /// A height within the limits of other skin and of muscles that are only touched.
  float limitedHeight(const SkinField& skin, float onSkin, std::size_t index, float s) const {
    const float touch =
        in_float::inverseTouchLimit(onSkin, settings_.iso, static_cast<float>(isoRoot_), static_cast<float>(isoRadius_),
                                    static_cast<float>(1.0 / skin.width));
    return s > 0.0f ? in_float::limitedRise(s, std::max(rise_.inverseLimits[index], touch))
                    : -in_float::limitedRise(-s, touch);
  }

  void place(const SkinField& skin, float onSkin, std::size_t index, const Root& root, CliqueLevelsView cliques) {
    const float s = root.s;
    const glm::vec3 n = surface_->normals[index];
    const glm::vec3 d = rise_.directions[index];
    const glm::vec3 p = surface_->positions[index];
    const glm::vec3 gradient =
        sampleField(field_.primitives, scratch_.candidates, cliques, p + s * d, scratch_.field).gradient;
    // s grows by 1 along d and is constant along the skin: its gradient is n / (n.d).
    const float slope = static_cast<float>(skin.slope(static_cast<double>(s))) / std::max(glm::dot(n, d), kLeastAlong);
    const float height = limitedHeight(skin, onSkin, index, root.below);
    surface_->positions[index] = p + height * d;
    const glm::vec3 ofField = normalizeOr(-(slope * n + gradient), n);
    // A limit flattens the skin below it.
    surface_->normals[index] = height == s ? ofField : normalizeOr(n + (height / s) * (ofField - n), n);
    surface_->displacement[index] = height;
  }

  const FieldView& field_;
  const SwellSettings& settings_;
  RiseView rise_;
  Surface* surface_;  ///< Null: only for slopes().
  VertexScratch& scratch_;
  double isoRadius_;  ///< r_T
  double isoRoot_;
  std::vector<float> topShares_;  ///< [candidates], as the next.
  std::vector<float> skinShares_;
};

}  // namespace

void swellVertex(const CarriedVertex& vertex, const FieldView& field, const SwellSettings& settings,
                 const RiseView& rise, Surface& surface, VertexScratch& scratch) {
  Sweller(field, settings, rise, &surface, scratch).move(vertex, field.lists->of(vertex.carrier));
}

void swell(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
           Surface& surface, ProjectionScratch& scratch) {
  scratch.counts = {};
  Sweller sweller(field, settings, rise, &surface, scratch);
  forEachReachable(
      mesh, *surface.refinement, field, surface.positions, Reach::kOverlapping, {}, scratch.walk,
      [&](const CarriedVertex& vertex, std::span<const CarrierCandidate> near) { sweller.move(vertex, near); });
  addToReport(scratch.counts, surface.report);
}

void heightSlopes(const CarriedVertex& vertex, const FieldView& field, const SwellSettings& settings,
                  const RiseView& rise, const glm::vec3& patch, float height, VertexScratch& scratch,
                  HeightSlopes& out) {
  out.of.clear();
  if (height != 0.0f) Sweller(field, settings, rise, nullptr, scratch).slopes(vertex, patch, height, out);
}

}  // namespace sinew
