// tests/support/oracle/oracle.cpp: skinning, sites and the two modes of docs/design.md.

#include "tests/support/oracle/oracle.h"

#include <algorithm>
#include <cmath>

#include "tests/support/oracle/rise.h"
#include "tests/support/oracle/triangles.h"

namespace sinew::oracle {
namespace {

constexpr int kSteps = 2400;
constexpr int kOtherRoots = 8;
constexpr double kRise = 0.1;         ///< Fraction of H that an edge should allow.
constexpr double kLeastCosine = 0.2;  ///< n . d counts as at least this.

Pose bindPoseOf(const Skeleton& skeleton) {
  Pose out;
  for (const Bone& bone : skeleton.bones) out.boneInWorld.push_back(bone.bindInWorld);
  return out;
}

}  // namespace

Site siteOf(const ControlMesh& mesh, const Refinement& refinement, int vertex) {
  const auto pieceOf = [&](const std::vector<int>& begin) {
    std::size_t piece = 0;
    while (begin[piece + 1] <= vertex) ++piece;
    return piece;
  };
  Site site;
  if (vertex < refinement.controlVertices) {
    site.vertices = {vertex, vertex, vertex};
    site.barycentric = {1.0, 0.0, 0.0};
  } else if (vertex < refinement.edgeBegin.back()) {
    const std::size_t e = pieceOf(refinement.edgeBegin);
    const Edge& edge = mesh.edges[e];
    const int n = refinement.edgeBegin[e + 1] - refinement.edgeBegin[e] + 1;
    const int step = vertex - refinement.edgeBegin[e] + 1;
    const double even = static_cast<double>(step) / n;
    const double share =
        refinement.onEdges.empty() ? even : refinement.onEdges[index(vertex - refinement.edgeBegin.front())];
    site.vertices = {edge.vertices[0], edge.vertices[1], edge.vertices[0]};
    site.barycentric = {1.0 - share, share, 0.0};
  } else {
    const glm::dvec2 place = refinement.inside[index(vertex - refinement.edgeBegin.back())];
    site.vertices = mesh.triangles[pieceOf(refinement.insideBegin)].vertices;
    site.barycentric = {1.0 - place.x - place.y, place.x, place.y};
  }
  return site;
}

Oracle::Oracle(const Character& character, const Rig& rig, ProjectionKind projection)
    : character_(character),
      rig_(rig),
      projection_(projection),
      field_(character, rig),
      height_(static_cast<double>(character.height)),
      riseInBind_(relaxedDirections(character.mesh, kRise * height_)) {
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    vertexWeights_.push_back(field_.territoryWeights(static_cast<int>(v)));
  }
  inverseLimits_ = inverseLimits(character.mesh, riseInBind_, kRise * height_);
  if (rig.surface.mode == SurfaceMode::kReplace) findOmegas();
  pose(bindPoseOf(character.skeleton));
}

void Oracle::pose(const Pose& pose) {
  field_.pose(pose);
  bones_.clear();
  for (const glm::mat4& bone : pose.boneInWorld) bones_.push_back(affine(bone));
  const ControlMesh& mesh = character_.mesh;
  positions_.clear();
  normals_.clear();
  rise_.clear();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Affine sum = zeroAffine();
    for (const Influence& influence : mesh.influencesOf(static_cast<int>(v))) {
      const Binding& binding = character_.skeleton.bindings[index(influence.binding)];
      sum = scaledSum(sum, static_cast<double>(influence.weight),
                      compose(bones_[index(binding.bone)], affine(binding.inverseBind)));
    }
    positions_.push_back(apply(sum, vec(mesh.positions[v])));
    const double side = determinant(sum.linear) < 0.0 ? -1.0 : 1.0;
    const auto carried = [&](const Vec& bind) { return unitOr(side * (cofactors(sum.linear) * bind), bind); };
    normals_.push_back(carried(vec(mesh.normals[v])));
    rise_.push_back(carried(riseInBind_[v]));
  }
}

double Oracle::inverseLimitAt(const Site& site) const {
  double out = 0.0;
  for (std::size_t i = 0; i < 3; ++i) out += site.barycentric[i] * inverseLimits_[index(site.vertices[i])];
  return out;
}

Corners Oracle::cornersOf(const Site& site) const {
  Corners out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.position[i] = positions_[index(site.vertices[i])];
    out.normal[i] = normals_[index(site.vertices[i])];
  }
  return out;
}

std::vector<double> Oracle::weightsAt(const Site& site) const {
  std::vector<double> out(index(field_.count()), 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& corner = vertexWeights_[index(site.vertices[i])];
    for (std::size_t p = 0; p < out.size(); ++p) out[p] += site.barycentric[i] * corner[p];
  }
  return out;
}

Vec Oracle::riseAt(const Site& site) const {
  Vec sum;
  for (std::size_t i = 0; i < 3; ++i) sum = sum + site.barycentric[i] * rise_[index(site.vertices[i])];
  return unitOr(sum, rise_[index(site.vertices[0])]);
}

double Oracle::isoRadius() const { return std::sqrt(1.0 - std::sqrt(field_.iso())); }

double Oracle::skinRadius(double s, double blendWidth) const {
  return std::max(0.0, s * (1.0 - isoRadius()) / blendWidth + isoRadius());
}

double Oracle::phiAt(const Answer& answer, double t) const {
  const double field = field_.value(answer.rayOrigin + t * answer.rayDirection, answer.fieldWeights) - field_.iso();
  return rig_.surface.mode == SurfaceMode::kSwell ? field + g(skinRadius(t, answer.blendWidth)) : field;
}

Answer Oracle::evaluate(const Site& site) const {
  return rig_.surface.mode == SurfaceMode::kSwell ? swell(site) : replace(site);
}

Answer Oracle::swell(const Site& site) const {
  Answer out;
  out.patch = patchPoint(rig_.smoothing.patch, cornersOf(site), site.barycentric);
  out.position = out.rayOrigin = out.patch.position;
  out.normal = out.patch.normal;
  out.rayDirection = riseAt(site);
  const std::vector<double> weights = weightsAt(site);
  out.field = field_.value(out.position, weights);
  out.nearest = field_.nearest(out.position, weights);
  out.lead = field_.lead(out.position, weights);
  out.fieldWeights = weights;
  out.blendWidth = field_.blendWidth(out.position, weights, static_cast<double>(rig_.surface.skinBlend) * height_);
  if (out.field == 0.0) return out;

  const double width = out.blendWidth / (1.0 - isoRadius());
  const Field::Ray ray = field_.along(out.rayOrigin, out.rayDirection, weights);
  const Function phi = [&](double s) { return g(skinRadius(s, out.blendWidth)) + ray.value(s) - field_.iso(); };

  out.sought = true;
  const double outermost = 1.0001 * std::max(out.blendWidth, ray.end());
  const double innermost = -isoRadius() * width;
  const double atStart = phi(0.0);
  if (atStart > 0.0) {
    out.roots = signChanges(phi, 0.0, outermost, kSteps, kOtherRoots);
  } else if (atStart < 0.0) {
    out.roots = signChanges(phi, 0.0, innermost, kSteps, kOtherRoots);
    out.roots.push_back(innermost);
  }
  // A field too faint to move phi(0) off zero leaves the skin where it is.
  if (out.roots.empty() || (atStart < 0.0) != (out.field < 0.0)) out.roots.insert(out.roots.begin(), 0.0);
  out.offset = out.roots.front();
  out.resolved = true;
  const Vec onField = out.rayOrigin + out.offset * out.rayDirection;
  // What the skin only touches moves it twice as far as an unchanging field would, at most.
  double inverseLimit = out.offset > 0.0 ? inverseLimitAt(site) : 0.0;
  if (out.field < field_.iso()) {
    const double iso = field_.iso();
    const double left = std::sqrt(std::min(1.0, iso - out.field));
    const double natural = width * std::abs(std::sqrt(1.0 - left) - isoRadius());
    const double inside = std::clamp((out.field - iso / 2.0) / (iso / 2.0), 0.0, 1.0);
    const double fades = 1.0 - inside * inside * (3.0 - 2.0 * inside);
    inverseLimit = std::max(inverseLimit, fades / (2.0 * std::max(natural, 1e-300)));
  }
  const double sense = out.offset < 0.0 ? -1.0 : 1.0;
  const auto psi = [&](double t) { return sense * phi(sense * t); };
  const auto psiSlope = [&](double t) {
    const Vec at = out.rayOrigin + sense * t * out.rayDirection;
    return gSlope(skinRadius(sense * t, out.blendWidth)) / width + dot(field_.gradient(at, weights), out.rayDirection);
  };
  // As if the skin's field were as wide as the muscles are thick.
  const double radius = field_.blendWidth(out.rayOrigin, weights, 1e30);
  const double sigma = -0.5 * gSlope(isoRadius()) * (1.0 - isoRadius()) / radius;
  const double below = heightBelowOverhangs(std::abs(out.offset), sigma, out.blendWidth / 4.0, psi, psiSlope);
  const double size = heightWithin(below, inverseLimit);
  const double height = out.offset < 0.0 ? -size : size;
  out.position = out.rayOrigin + height * out.rayDirection;
  out.lead = field_.lead(onField, weights);
  // Heights grow by 1 along d and not at all along the skin.
  const double skinSlope = gSlope(skinRadius(out.offset, out.blendWidth)) / width;
  const double cosine = std::max(kLeastCosine, dot(out.patch.normal, out.rayDirection));
  const Vec gradient = (skinSlope / cosine) * out.patch.normal + field_.gradient(onField, weights);
  const Vec ofField = unitOr(-1.0 * gradient, out.patch.normal);
  const double share = out.offset != 0.0 ? height / out.offset : 1.0;
  out.normal = unitOr(out.patch.normal + share * (ofField - out.patch.normal), out.patch.normal);
  return out;
}

}  // namespace sinew::oracle
