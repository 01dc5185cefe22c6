// core/surface/stages.cpp: patch -> project -> folds -> cloth -> normals, each on the result of the one before.
#include "core/surface/stages.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/surface/patches/patch.h"
#include "core/surface/projector.h"
#include "sinew/geometry/geometry.h"

namespace sinew {
namespace {

/// Creased wedges have normals of their own, which later stages change with the surface.
void shadeCreases(const Preparation& preparation, const PosedField& posed, Workspace& workspace, Surface& out) {
  out.shadingNormals.clear();
  const ControlMesh* creased = preparation.refined->creased.get();
  if (!creased) return;
  skinWedgeNormals(preparation.character(), creased->wedges, posed.control, workspace.wedgeNormals);
  out.shadingNormals.resize(out.refinement->drawVertex.size());
  evaluateShading(preparation.smoothing.patch, *creased, *out.refinement, posed.control.positions,
                  workspace.wedgeNormals, out.normals, out.shadingNormals);
}

void startReport(const Preparation& p, const PosedField& posed, SmoothingReport& report) {
  const std::vector<TriangleClass>& classes = posed.bind->classes;
  report = reportOf(p);
  report.implicitTriangles = static_cast<int>(std::ranges::count(classes, TriangleClass::kImplicit));
  report.straddlingTriangles = static_cast<int>(std::ranges::count(classes, TriangleClass::kStraddling));
  report.normalTriangles = static_cast<int>(std::ranges::count(classes, TriangleClass::kNormal));
  report.unwrapped = posed.bind->weights.unwrapped;
}

/// Updates vertices whose heights were lowered: lower skin is flatter.  @param raw [V'] heights before.
void placeLowered(std::span<const int> lifted, std::span<const float> raw, const Workspace& w, Surface& out) {
  constexpr std::size_t kFew = 2048;  // For one thread.
  forEachIndex(lifted.size(), kFew, [&](std::size_t i) {
    const std::size_t v = toIndex(lifted[i]);
    if (out.displacement[v] == raw[v]) return;
    const float share = out.displacement[v] / raw[v];
    out.positions[v] = w.patchPositions[v] + share * (out.positions[v] - w.patchPositions[v]);
    const glm::vec3& n = w.patchNormals[v];
    out.normals[v] = normalizeOr(n + share * (out.normals[v] - n), n);
  });
}

/// Lowers heights in the creases of the posed skin, and wherever they are steeper than the bound.
void boundHeights(const Preparation& preparation, const SkinnedMesh& control, Workspace& w, Surface& out) {
  const RefinedMesh& refined = *preparation.refined;
  const std::span<float> heights = out.displacement;
  w.rawHeights.assign(heights.begin(), heights.end());
  w.creaseLift.lower({preparation.mesh(), preparation.tables->perBindFront, control.positions, control.normals,
                      *refined.refinement, refined.rings},
                     w.movedTriangles, heights);
  w.liftedHeights.start(refined.rings, w.movedTriangles, w.patchPositions, out.positions, heights);
  for (const int vertex : w.slopeBound.lower(w.liftedHeights)) at(heights, vertex) = w.liftedHeights.height(vertex);
  placeLowered(w.liftedHeights.lifted(), w.rawHeights, w, out);
}

}  // namespace

SmoothingReport reportOf(const Preparation& p) {
  SmoothingReport report;
  report.mode = p.mode;
  report.patch = p.smoothing.patch;
  report.projection = p.projection;
  report.depth = p.refinement().depth;
  report.controlTriangles = static_cast<int>(p.mesh().triangles.size());
  report.refinedTriangles = static_cast<int>(p.refinement().triangles.size());
  report.refinedVertices = p.refinement().vertexCount;
  report.primitives = p.shownPrimitives;
  report.cliques = static_cast<int>(p.attached->attachment.graph.levels.front().cliques.size());
  return report;
}

void layPatch(const Preparation& preparation, const PosedField& posed, Workspace& workspace, Surface& out) {
  out.refinement = preparation.refined->refinement;
  out.classes = posed.bind->classes;
  evaluatePatch(preparation, preparation.smoothing.patch, posed.control.positions, posed.control.normals, out.positions,
                out.normals);
  out.displacement.assign(out.positions.size(), 0.0f);
  workspace.patchPositions = out.positions;
  workspace.patchNormals = out.normals;
  shadeCreases(preparation, posed, workspace, out);
  startReport(preparation, posed, out.report);
}

void project(const Preparation& preparation, const PosedField& posed, const Pose& pose,
             const std::optional<glm::vec3>& eye, Workspace& workspace, Surface& out) {
  FieldView field = posed.view(preparation);
  if (eye) {
    cullFaces(preparation.mesh(), preparation.refinement(), posed.control, *eye, workspace.culling);
    out.report.culledTriangles = workspace.culling.culled;
    field.skipped = workspace.culling.carriers;
  }
  if (preparation.shownPrimitives == 0) return;
  chosenProjector(preparation).project({preparation, posed, field}, pose, workspace, out);
}

bool findMoved(const Preparation& preparation, const PosedField& posed, Workspace& workspace, const Surface& out) {
  // Where muscles wrap the body the surface may lie across its patch; it keeps the paper's normals.
  if (!preparation.swells() && posed.bind->weights.wraps) return false;
  MovedTriangles& moved = workspace.movedTriangles;
  moved.find(preparation.refinement(), workspace.patchPositions, out.positions);
  return !moved.refined.empty();
}

void unfold(const Preparation& preparation, const PosedField& posed, Workspace& w, Surface& out) {
  const RefinedMesh& refined = *preparation.refined;
  const PatchView patch{w.patchPositions, w.patchNormals, *preparation.bindFronts};
  boundHeights(preparation, posed.control, w, out);
  w.filtered = {};
  if (preparation.filtersHeights()) {
    w.filtered = w.liftFilter.apply(w.liftedHeights, w.patchPositions, out.positions, out.displacement);
  }
  w.pairs.fill(w.movedTriangles.corners, w.patchPositions, out.positions);
  w.foldRegion.find(preparation.mesh(), preparation.refinement(), refined.rings, w.movedTriangles, patch, w.pairs,
                    out.positions, FoldSpread::kLeastArea);
  w.foldMesh.start(w.foldRegion, refined.isBorder, w.patchPositions, out.positions);
  w.foldSpread.apply(w.foldMesh);
  const std::span<const FoldMove> moves = w.foldMesh.finish(out.positions);
  for (const auto& [vertex, from] : moves) {
    const std::size_t v = toIndex(vertex);
    w.pairs.moveTo(vertex, out.positions[v]);
    const glm::vec3 lift = from - w.patchPositions[v];
    out.displacement[v] *= glm::dot(out.positions[v] - w.patchPositions[v], lift) / glm::dot(lift, lift);
  }
  out.report.guarded = static_cast<int>(moves.size());
}

void drape(const Preparation& preparation, bool moved, Workspace& w, Surface& out) {
  if (!preparation.cloth) return;
  const ClothView view{
      preparation.refined->rings,    preparation.layered->layers, *preparation.cloth, w.patchPositions, w.patchNormals,
      preparation.character().height};
  if (!w.clothLift.apply(view, out) || !moved) return;
  // Cloth needs new normals as skin does.
  w.movedTriangles.find(preparation.refinement(), w.patchPositions, out.positions);
  w.pairs.fill(w.movedTriangles.corners, w.patchPositions, out.positions);
}

void shade(const Preparation& preparation, bool moved, Workspace& workspace, Surface& out) {
  if (moved) {
    workspace.shadingNormals.apply(preparation.refinement(), preparation.refined->rings, workspace.movedTriangles,
                                   workspace.pairs, workspace.patchNormals, workspace.filtered,
                                   preparation.softensRims(), out.normals);
  }
  if (!out.shadingNormals.empty()) turnWithSurface(out, workspace.patchNormals, out.shadingNormals);
}

}  // namespace sinew
