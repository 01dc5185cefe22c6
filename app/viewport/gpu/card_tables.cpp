// app/viewport/gpu/card_tables.cpp: nested lists flattened into one list with starts.
#include "app/viewport/gpu/card_tables.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "core/geometry/potential.h"
#include "core/surface/posed_field.h"

namespace sinew::app {

namespace {

void fillShape(const UnitShape& shape, card::Primitive& out) {
  out.bendCurve = {shape.bend.x, shape.bend.y, shape.curve.x, shape.curve.y};
  out.section = {shape.lateral, shape.taper, shape.core, shape.inverseEnd};
  out.low = glm::vec4(shape.low, 1.0f);
  out.high = glm::vec4(shape.high, out.high.w);
}

}  // namespace

std::optional<std::string> poseMuscles(const std::shared_ptr<const Preparation>& preparation, const Pose& pose,
                                       PosedMuscles& out) {
  preparation->poser->pose(pose, out.rig);
  placeMuscles(preparation, out.rig, out.field);
  if (!preparation->character().morphTargets.empty()) {
    morph(preparation->character(), out.rig.morphWeights, out.field.control.morphed);
  }
  const bool plain =
      std::ranges::all_of(out.field.primitives, [](const PosedPrimitive& one) { return one.influence.isPlain(); });
  if (!plain && !preparation->swells()) return "in replace, a muscle is not a plain ellipsoid";
  if (haveSoftGrooves(out.field.primitives) && !preparation->swells()) return kSoftInReplace;
  if (!preparation->poser->drivesLinks()) return std::nullopt;
  return tooManyWays(*preparation->seen, &out.field.cliqueSets);
}

void fillMatrices(const Preparation& preparation, const Pose& pose, std::span<glm::mat4> out) {
  const std::vector<Binding>& bindings = preparation.character().skeleton.bindings;
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    out[i] = at(pose.boneInWorld, bindings[i].bone) * bindings[i].inverseBind;
  }
}

void fillPrimitives(const Preparation& preparation, const PosedField& field, std::span<card::Primitive> out) {
  const float blendWidth = swellSettings(preparation, field.rig->numbers.skinBlend).blendWidth;
  const bool soft = haveSoftGrooves(field.primitives);
  for (std::size_t i = 0; i < field.primitives.size(); ++i) {
    const PosedPrimitive& muscle = field.primitives[i];
    const UnitBallMap& ball = muscle.influence;
    out[i] = {
        {glm::vec4(ball.toUnit[0], muscle.strength), glm::vec4(ball.toUnit[1], std::min(blendWidth, muscle.meanRadius)),
         glm::vec4(ball.toUnit[2], ball.inverseRadius)},
        glm::vec4(ball.center, ball.boundingRadius),
        {},
        {},
        {},
        {0.0f, 0.0f, 0.0f, muscle.meanRadius},
        {muscle.groove, soft ? 1.0f : 0.0f, 0.0f, 0.0f}};
    if (!ball.isPlain()) fillShape(ball.shape, out[i]);
  }
}

namespace {

void fillControls(const Preparation& preparation, CardTables& out) {
  const ControlMesh& mesh = preparation.mesh();
  out.influenceBegin.assign(mesh.influenceBegin.begin(), mesh.influenceBegin.end());
  for (const Influence& influence : mesh.influences) out.influences.push_back({influence.binding, influence.weight});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    out.controls.push_back({glm::vec4(mesh.positions[v], 1.0f), glm::vec4(mesh.normals[v], 0.0f),
                            glm::vec4(preparation.tables->riseInBind[v], 0.0f)});
  }
}

/// Input of creases.
void fillFans(const Preparation& preparation, CardTables& out) {
  const ControlMesh& mesh = preparation.mesh();
  std::vector<std::vector<std::int32_t>> around(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<int, 3>& corners = mesh.triangles[t].vertices;
    for (const int v : corners) at(around, v).push_back(static_cast<std::int32_t>(t));
    out.controlTriangles.push_back({corners, preparation.tables->perBindFront[t]});
  }
  auto begin = static_cast<std::int32_t>(around.size() + 1);
  for (const auto& fan : around) {
    out.fans.push_back(begin);
    begin += static_cast<std::int32_t>(fan.size());
  }
  out.fans.push_back(begin);
  for (const auto& fan : around) out.fans.insert(out.fans.end(), fan.begin(), fan.end());
}

void fillRefined(const Preparation& preparation, CardTables& out) {
  const Refinement& refinement = preparation.refinement();
  const std::vector<float>& limits = preparation.refined->inverseLimits;
  out.refined.reserve(limits.size());
  const auto add = [&](const CarriedVertex& v) {
    out.refined.push_back({{v.carrier, v.corners[0], v.corners[1], v.corners[2]},
                           glm::vec4(v.barycentric[0], v.barycentric[1], v.barycentric[2], at(limits, v.index))});
  };
  for (int v = 0; v < refinement.controlVertices; ++v) add({v, v, {v, v, v}, {1.0f, 0.0f, 0.0f}});
  for (int e = 0; e < refinement.controlEdges; ++e) {
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      add(edgeCarried(preparation.mesh(), refinement, e, refinement.edgeVertex(e, step)));
    }
  }
  for (int t = 0; t < static_cast<int>(preparation.mesh().triangles.size()); ++t) {
    for (int v = at(refinement.insideBegin, t); v < at(refinement.insideBegin, t + 1); ++v) {
      add(insideCarried(preparation.mesh(), refinement, t, v));
    }
  }
}

void fillCandidates(const CandidateLists& lists, CardTables& out) {
  for (const CarrierCandidate& one : lists.items) {
    out.candidates.push_back({one.primitive, static_cast<std::uint32_t>(one.slot), one.weights});
  }
}

CliqueLevelsView levelsOf(const CandidateLists& lists, const PosedCliqueSets* posed, std::size_t set) {
  return posed ? posed->of(static_cast<int>(set)) : CliqueLevelsView(lists.cliqueSets[set].drawn);
}

std::uint64_t bitsOf(std::span<const int> clique) {
  std::uint64_t bits = 0;
  for (const int slot : clique) bits |= std::uint64_t{1} << static_cast<unsigned>(slot);
  return bits;
}

void fillMesh(const Preparation& preparation, CardTables& out) {
  const Refinement& refinement = preparation.refinement();
  const VertexRings& rings = preparation.refined->rings;
  out.neighbors = rings.neighbors;
  const auto firstAcross = static_cast<std::int32_t>(out.neighbors.size());
  out.neighbors.insert(out.neighbors.end(), rings.across.begin(), rings.across.end());
  out.corners = rings.corners;
  for (std::size_t v = 0; v < rings.share.size(); ++v) {
    out.rings.push_back({rings.begin[v], rings.begin[v + 1], rings.cornersBegin[v], rings.cornersBegin[v + 1],
                         firstAcross + rings.acrossBegin[v], firstAcross + rings.acrossBegin[v + 1], rings.share[v],
                         preparation.refined->isBorder[v]});
  }
  for (std::size_t t = 0; t < refinement.triangles.size(); ++t) {
    out.triangles.push_back({refinement.triangles[t], (*preparation.bindFronts)[t]});
  }
  out.drawVertices.assign(refinement.drawVertex.begin(), refinement.drawVertex.end());
}

void fillReplaced(const Preparation& preparation, CardTables& out) {
  for (const Anchor& anchor : *preparation.anchors) {
    const glm::vec3& point = anchor.pointInBone;
    out.anchors.push_back({{point.x, point.y, point.z}, anchor.bone});
  }
  const std::vector<float>& omega = preparation.bind.weights.omega;
  for (const card::Refined& vertex : out.refined) {
    float sum = 0.0f;
    for (int i = 0; i < 3; ++i) sum += vertex.weights[i] * at(omega, at(vertex.place, i + 1));
    out.omegas.push_back(sum);
  }
}

card::Making makingOf(const Preparation& preparation) {
  const Refinement& refinement = preparation.refinement();
  card::Making making;
  making.controlVertices = refinement.controlVertices;
  making.controlEdges = refinement.controlEdges;
  making.refinedVertices = refinement.vertexCount;
  making.refinedTriangles = static_cast<std::int32_t>(refinement.triangles.size());
  making.drawnVertices = static_cast<std::int32_t>(refinement.drawVertex.size());
  making.primitives = static_cast<std::int32_t>(preparation.primitives.size());
  making.bindings = static_cast<std::int32_t>(preparation.character().skeleton.bindings.size());
  making.patchKind = static_cast<std::int32_t>(preparation.smoothing.patch);
  making.carriers = static_cast<std::int32_t>(preparation.seen->cliqueSet.size());
  making.cliqueSets = static_cast<std::int32_t>(preparation.seen->cliqueSets.size());
  making.iso = preparation.iso;
  making.isoRoot = isoRoot(preparation.iso);
  making.isoRadius = static_cast<float>(isoRadius(static_cast<double>(preparation.iso)));
  making.tolerance = static_cast<float>(swellSettings(preparation, 1.0f).tolerance);
  making.searchLength = replaceSettings(preparation).searchLength;
  making.bones = static_cast<std::int32_t>(preparation.character().skeleton.bones.size());
  making.wraps = preparation.bind.weights.wraps ? 1 : 0;
  making.toAnchors = making.wraps != 0 && !preparation.smoothing.alongNormals ? 1 : 0;
  return making;
}

}  // namespace

CardTables cardTables(const Preparation& preparation) {
  CardTables tables;
  fillControls(preparation, tables);
  fillFans(preparation, tables);
  fillRefined(preparation, tables);
  fillCandidates(*preparation.seen, tables);
  seenOf(*preparation.seen, nullptr, tables.seen);
  fillMesh(preparation, tables);
  if (!preparation.swells()) fillReplaced(preparation, tables);
  tables.making = makingOf(preparation);
  return tables;
}

void seenOf(const CandidateLists& lists, const PosedCliqueSets* posed, std::vector<std::int32_t>& out) {
  constexpr std::uint64_t kEverything = ~std::uint64_t{0};
  out.assign(lists.begin.begin(), lists.begin.end());
  out.insert(out.end(), lists.cliqueSet.begin(), lists.cliqueSet.end());
  std::vector<std::int32_t> levels;
  std::vector<std::uint64_t> cliques;
  const auto addLevel = [&](double weight) {
    levels.push_back(static_cast<std::int32_t>(cliques.size()));
    levels.push_back(std::bit_cast<std::int32_t>(static_cast<float>(weight)));
  };
  for (std::size_t set = 0; set < lists.cliqueSets.size(); ++set) {
    out.push_back(static_cast<std::int32_t>(levels.size() / 2));
    const CliqueLevelsView all = levelsOf(lists, posed, set);
    for (const CliqueLevel& level : all) {
      addLevel(level.weight);
      for (const std::span<const int> clique : level.cliques) cliques.push_back(bitsOf(clique));
    }
    if (!all.empty()) continue;
    addLevel(1.0);
    cliques.push_back(kEverything);
  }
  out.push_back(static_cast<std::int32_t>(levels.size() / 2));
  addLevel(0.0);
  out.insert(out.end(), levels.begin(), levels.end());
  for (const std::uint64_t bits : cliques) {
    out.push_back(static_cast<std::int32_t>(bits));
    out.push_back(static_cast<std::int32_t>(bits >> 32u));
  }
}

std::optional<std::string> tooManyWays(const CandidateLists& lists, const PosedCliqueSets* posed) {
  std::size_t most = 0;
  for (std::size_t set = 0; set < lists.cliqueSets.size(); ++set) {
    std::size_t ways = 0;
    for (const CliqueLevel& level : levelsOf(lists, posed, set)) ways += level.cliques.size();
    most = std::max(most, ways);
  }
  if (most <= card::kMostCliques) return std::nullopt;
  return "groups blend in " + std::to_string(most) + " ways at one place of the skin, at most " +
         std::to_string(card::kMostCliques);
}

}  // namespace sinew::app
