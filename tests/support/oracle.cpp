// tests/support/oracle.cpp: skinning, sites and the two modes of docs/design.md.

#include "tests/support/oracle.h"

#include <algorithm>
#include <cmath>

namespace sinew::oracle {
namespace {

constexpr int kSteps = 2400;
constexpr int kOtherRoots = 8;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Pose bindPoseOf(const Skeleton& skeleton) {
  Pose out;
  for (const Bone& bone : skeleton.bones) out.boneInWorld.push_back(bone.bindInWorld);
  return out;
}

}  // namespace

Site siteOf(const ControlMesh& mesh, const Refinement& refinement, int vertex) {
  const int n = refinement.depth;
  const int edgeStart = refinement.controlVertices;
  const int interiorStart = edgeStart + refinement.controlEdges * (n - 1);
  Site site;
  if (vertex < edgeStart) {
    site.vertices = {vertex, vertex, vertex};
    site.barycentric = {1.0, 0.0, 0.0};
  } else if (vertex < interiorStart) {
    const Edge& edge = mesh.edges[index((vertex - edgeStart) / (n - 1))];
    const int step = (vertex - edgeStart) % (n - 1) + 1;
    site.vertices = {edge.vertices[0], edge.vertices[1], edge.vertices[0]};
    site.barycentric = {static_cast<double>(n - step) / n, static_cast<double>(step) / n, 0.0};
  } else {
    const int perTriangle = (n - 1) * (n - 2) / 2;
    const ControlTriangle& triangle = mesh.triangles[index((vertex - interiorStart) / perTriangle)];
    const auto [j, k] = refinement.interior[index((vertex - interiorStart) % perTriangle)];
    site.vertices = triangle.vertices;
    site.barycentric = {static_cast<double>(n - j - k) / n, static_cast<double>(j) / n, static_cast<double>(k) / n};
  }
  return site;
}

Oracle::Oracle(const Character& character, const Rig& rig)
    : character_(character), rig_(rig), field_(character, rig), height_(static_cast<double>(character.height)) {
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    vertexWeights_.push_back(field_.territoryWeights(static_cast<int>(v)));
  }
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
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Affine sum = zeroAffine();
    for (const Influence& influence : mesh.influencesOf(static_cast<int>(v))) {
      const Binding& binding = character_.skeleton.bindings[index(influence.binding)];
      sum = scaledSum(sum, static_cast<double>(influence.weight),
                      compose(bones_[index(binding.bone)], affine(binding.inverseBind)));
    }
    positions_.push_back(apply(sum, vec(mesh.positions[v])));
    const double side = determinant(sum.linear) < 0.0 ? -1.0 : 1.0;
    const Vec normal = vec(mesh.normals[v]);
    normals_.push_back(unitOr(side * (cofactors(sum.linear) * normal), normal));
  }
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

double Oracle::skinWidth() const {
  const double isoRadius = std::sqrt(1.0 - std::sqrt(field_.iso()));
  return static_cast<double>(rig_.surface.skinBlend) * height_ / (1.0 - isoRadius);
}

double Oracle::skinRadius(double s) const {
  return std::max(0.0, s / skinWidth() + std::sqrt(1.0 - std::sqrt(field_.iso())));
}

double Oracle::phiAt(const Answer& answer, double t) const {
  const double field = field_.value(answer.rayOrigin + t * answer.rayDirection, answer.fieldWeights) - field_.iso();
  return rig_.surface.mode == SurfaceMode::kSwell ? field + g(skinRadius(t)) : field;
}

Answer Oracle::evaluate(const Site& site) const {
  return rig_.surface.mode == SurfaceMode::kSwell ? swell(site) : replace(site);
}

Answer Oracle::swell(const Site& site) const {
  Answer out;
  out.patch = patchPoint(rig_.smoothing.patch, cornersOf(site), site.barycentric);
  out.position = out.rayOrigin = out.patch.position;
  out.normal = out.rayDirection = out.patch.normal;
  const std::vector<double> weights = weightsAt(site);
  out.field = field_.value(out.position, weights);
  out.nearest = field_.nearest(out.position, weights);
  out.lead = field_.lead(out.position, weights);
  out.fieldWeights = weights;
  if (out.field == 0.0) return out;

  const double blend = static_cast<double>(rig_.surface.skinBlend) * height_;
  const Field::Ray ray = field_.along(out.rayOrigin, out.rayDirection, weights);
  const Function phi = [&](double s) { return g(skinRadius(s)) + ray.value(s) - field_.iso(); };

  out.sought = true;
  const double outermost = 1.0001 * std::max(blend, ray.end());
  const double innermost = -skinRadius(0.0) * skinWidth();
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
  out.position = out.rayOrigin + out.offset * out.rayDirection;
  out.lead = field_.lead(out.position, weights);
  const double skinSlope = gSlope(skinRadius(out.offset)) / skinWidth();
  const Vec gradient = skinSlope * out.rayDirection + field_.gradient(out.position, weights);
  out.normal = unitOr(-1.0 * gradient, out.patch.normal);
  return out;
}

}  // namespace sinew::oracle
