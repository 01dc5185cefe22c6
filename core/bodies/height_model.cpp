// core/bodies/height_model.cpp: the first stages of the surface, and derivatives of the field by each muscle's numbers.
#include "core/bodies/height_model.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/potential.h"
#include "core/surface/patches/patch.h"
#include "core/surface/projection/swell.h"
#include "core/surface/projector.h"
#include "core/surface/stages.h"

namespace sinew {
namespace {

constexpr float kPointsApart = 0.01f;  ///< Fraction of H.
constexpr int kMostFitDepth = 4;
constexpr std::size_t kFewPoints = 256;  ///< For one thread.

/// So that the middle one of the control edges is in pieces of at most kPointsApart.
int depthFor(const Character& character) {
  const ControlMesh& mesh = character.mesh;
  std::vector<float> lengths;
  for (const Edge& edge : mesh.edges) {
    lengths.push_back(glm::distance(at(mesh.positions, edge.vertices[0]), at(mesh.positions, edge.vertices[1])));
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  const float pieces = std::ceil(*middle / (kPointsApart * character.height));
  return static_cast<int>(std::clamp(pieces, 1.0f, static_cast<float>(kMostFitDepth)));
}

/// A muscle's influence in the bind pose, with the axes of its own that its numbers are about.
struct MuscleFrame {
  glm::dmat3 toUnit{0.0};  ///< World -> unit space, y = toUnit (x - center); zeros: no influence.
  glm::dvec3 center{0.0};
  glm::dvec3 radii{1.0};
  UnitShape shape;
  float strength = 1.0f;
};

MuscleFrame frameOf(const PosedMuscle& muscle, float reach, float strength) {
  MuscleFrame frame;
  const Placement& placement = muscle.body.placement;
  const glm::dmat4 carrier(muscle.body.carrier);
  const glm::dmat3 axes = glm::dmat3(carrier) * glm::dmat3(glm::mat3_cast(placement.rotation));
  frame.radii = static_cast<double>(reach) * glm::dvec3(placement.radii);
  frame.center = glm::dvec3(carrier * glm::dvec4(glm::dvec3(placement.center), 1.0));
  frame.shape = unitShape(placement.shape, reach);
  frame.strength = strength;
  glm::dmat3 out = axes;
  for (int i = 0; i < 3; ++i) out[i] *= frame.radii[i];
  if (muscle.usable && std::abs(glm::determinant(out)) > 0.0) frame.toUnit = glm::inverse(out);
  return frame;
}

/// Adds factor * d f / d numbers at a point.
void addChange(const MuscleFrame& muscle, const glm::vec3& point, float factor, FitVector& by) {
  if (factor == 0.0f) return;
  const glm::dvec3 y = muscle.toUnit * (glm::dvec3(point) - muscle.center);
  const double rSquared = muscle.shape.rSquared(y);
  if (!(rSquared < 1.0)) return;
  const auto scale = static_cast<double>(factor * muscle.strength);
  const double slope = scale * static_cast<double>(potentialSlope(static_cast<float>(rSquared)));
  const glm::dvec3 bySpot = slope * muscle.shape.rSquaredSlope(y);
  const glm::dvec3 byCenter = -(glm::transpose(muscle.toUnit) * bySpot);
  const glm::dvec3 byTurn = glm::cross(bySpot / muscle.radii, y * muscle.radii);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    by[k] += static_cast<float>(byCenter[i]);
    by[3 + k] += static_cast<float>(byTurn[i]);
    by[6 + k] -= static_cast<float>(bySpot[i] * y[i]);
  }
  by[9] += static_cast<float>(scale) * potential(static_cast<float>(rSquared));
}

}  // namespace

Result<HeightModel> HeightModel::create(std::shared_ptr<const Character> character, const Rig& rig) {
  if (rig.surface.mode != SurfaceMode::kSwell)
    return errorAt("surface.mode", "muscles are fitted under skin that rises over them: expected the mode swell");
  HeightModel model;
  model.depth_ = depthFor(*character);
  model.tables_ = characterTables(std::move(character));
  if (Result<void> raised = model.raise(rig); !raised) return raised.error();
  model.findPoints();
  return model;
}

Result<void> HeightModel::raise(const Rig& rig) {
  PreparationOptions options;
  options.depth = depth_;
  auto prepared = prepare(tables_, rig, options, preparation_.get(), graphs_);
  if (!prepared) return prepared.error();
  preparation_ = std::move(prepared).value();
  preparation_->poser->pose(tables_->bind, rig_);
  std::ranges::fill(rig_.morphWeights, 0.0f);
  poseFieldAndSkin(preparation_, rig_, tables_->bind, posed_);
  layPatch(*preparation_, posed_, workspace_, surface_);
  project(*preparation_, posed_, tables_->bind, std::nullopt, workspace_, surface_);
  return {};
}

void HeightModel::findPoints() {
  const Refinement& refinement = preparation_->refinement();
  const ControlMesh& mesh = preparation_->mesh();
  points_.positions = workspace_.patchPositions;
  points_.normals = workspace_.patchNormals;
  points_.directions.resize(points_.size());
  interpolateDirections(mesh, refinement, tables_->riseInBind, points_.directions);
  points_.triangles = refinement.triangles;
  points_.controlVertices = refinement.controlVertices;
  points_.areas.assign(points_.size(), 0.0f);
  for (const auto& [a, b, c] : points_.triangles) {
    const glm::vec3& from = at(points_.positions, a);
    const float area = 0.5f * glm::length(glm::cross(at(points_.positions, b) - from, at(points_.positions, c) - from));
    for (const int v : {a, b, c}) at(points_.areas, v) += area / 3.0f;
    for (const auto& [u, v] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      points_.edges.push_back({std::min(u, v), std::max(u, v)});
    }
  }
  std::ranges::sort(points_.edges);
  points_.edges.erase(std::unique(points_.edges.begin(), points_.edges.end()), points_.edges.end());
  for (std::size_t v = 0; v < points_.size(); ++v) {
    const CarriedVertex vertex = carriedVertex(mesh, refinement, static_cast<int>(v));
    const auto seen = preparation_->seen->of(vertex.carrier);
    points_.movable.push_back(std::ranges::any_of(
        seen, [&](const CarrierCandidate& candidate) { return candidate.weightAt(vertex.barycentric) > 0.0f; }));
  }
}

std::vector<std::vector<HeightChange>> HeightModel::changes() const {
  const std::vector<int>& rigIndex = preparation_->attached->attachment.rigIndex;
  std::vector<MuscleFrame> muscles;
  for (std::size_t i = 0; i < rigIndex.size(); ++i) {
    const FieldPrimitive& own = preparation_->primitives[i];
    muscles.push_back(frameOf(at(rig_.muscles, rigIndex[i]), own.reach, own.strength));
  }
  const FieldView field = posed_.view(*preparation_);
  const SwellSettings settings = swellSettings(*preparation_, rig_.numbers.skinBlend);
  const RiseView rise{points_.directions, preparation_->refined->inverseLimits};
  std::vector<std::vector<HeightChange>> out(points_.size());
  forRanges(points_.size(), kFewPoints, [&](std::size_t begin, std::size_t end) {
    VertexScratch scratch;
    HeightSlopes slopes;
    for (std::size_t v = begin; v < end; ++v) {
      const CarriedVertex vertex = carriedVertex(preparation_->mesh(), preparation_->refinement(), static_cast<int>(v));
      heightSlopes(vertex, field, settings, rise, points_.positions[v], surface_.displacement[v], scratch, slopes);
      for (const auto& [primitive, atTop, onSkin] : slopes.of) {
        HeightChange change{at(rigIndex, primitive), {}};
        addChange(at(muscles, primitive), slopes.top, atTop, change.by);
        addChange(at(muscles, primitive), points_.positions[v], onSkin, change.by);
        if (std::ranges::any_of(change.by, [](float x) { return x != 0.0f; })) out[v].push_back(change);
      }
    }
  });
  return out;
}

}  // namespace sinew
