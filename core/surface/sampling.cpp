// core/surface/sampling.cpp: parts of a mesh with renumbered tables, and the first stages on them.
#include "core/surface/sampling.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "core/geometry/at.h"
#include "core/surface/projector.h"
#include "core/surface/stages.h"

namespace sinew {

namespace {

constexpr std::size_t kMostOfPiece = 1'500;
constexpr std::size_t kFewOfPiece = 200;  ///< So few stay together.

/// Makes an even number of equal pieces, as the number of cores is usually even.
std::size_t sizeOfPieces(std::size_t asked) {
  if (asked <= kFewOfPiece) return kFewOfPiece;
  const std::size_t pairs = (asked + 2 * kMostOfPiece - 1) / (2 * kMostOfPiece);
  return (asked + 2 * pairs - 1) / (2 * pairs);
}

struct Numbering {
  std::vector<int> kept;  ///< Old numbers, ascending.

  /// @param old  in any order, also repeated
  explicit Numbering(std::vector<int> old) : kept(std::move(old)) {
    std::ranges::sort(kept);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  }
  static Numbering ofAll(std::size_t count) {
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return Numbering(std::move(all));
  }
  /// The new number of one that is kept.
  [[nodiscard]] int newOf(int old) const {
    return static_cast<int>(std::ranges::lower_bound(kept, old) - kept.begin());
  }
};

struct PartNumbers {
  Numbering vertices;
  Numbering edges;
  Numbering triangles;
};

PartNumbers numbersOf(const ControlMesh& mesh, const SampledPiece& piece) {
  std::vector<int> vertices;
  std::vector<int> edges;
  for (const int t : piece) {
    const ControlTriangle& triangle = at(mesh.triangles, t);
    vertices.insert(vertices.end(), triangle.vertices.begin(), triangle.vertices.end());
    edges.insert(edges.end(), triangle.edges.begin(), triangle.edges.end());
  }
  return {Numbering(std::move(vertices)), Numbering(std::move(edges)), Numbering(piece)};
}

PartNumbers allNumbers(const ControlMesh& mesh) {
  return {Numbering::ofAll(mesh.positions.size()), Numbering::ofAll(mesh.edges.size()),
          Numbering::ofAll(mesh.triangles.size())};
}

/// Has a wedge per vertex, as nothing is drawn.
ControlMesh meshOf(const ControlMesh& whole, const PartNumbers& numbers) {
  ControlMesh out;
  out.influenceBegin.push_back(0);
  for (const int v : numbers.vertices.kept) {
    out.positions.push_back(at(whole.positions, v));
    out.normals.push_back(at(whole.normals, v));
    const std::span<const Influence> influences = whole.influencesOf(v);
    out.influences.insert(out.influences.end(), influences.begin(), influences.end());
    out.influenceBegin.push_back(static_cast<int>(out.influences.size()));
    out.wedges.push_back({static_cast<int>(out.wedges.size())});
  }
  const auto vertexOf = [&](int v) { return numbers.vertices.newOf(v); };
  for (const int e : numbers.edges.kept) {
    Edge edge = at(whole.edges, e);
    edge.vertices = {vertexOf(edge.vertices[0]), vertexOf(edge.vertices[1])};
    out.edges.push_back(edge);
  }
  for (const int t : numbers.triangles.kept) {
    ControlTriangle triangle = at(whole.triangles, t);
    for (int& v : triangle.vertices) v = vertexOf(v);
    for (int& e : triangle.edges) e = numbers.edges.newOf(e);
    triangle.wedges = triangle.vertices;
    out.triangles.push_back(triangle);
  }
  return out;
}

CandidateLists candidatesOf(const Preparation& next, const PartNumbers& numbers) {
  const CandidateLists& whole = *next.seen;
  CandidateLists out;
  out.cliqueSets = whole.cliqueSets;
  out.most = whole.most;
  const std::size_t firstEdge = next.mesh().positions.size();
  const std::size_t firstTriangle = firstEdge + next.mesh().edges.size();
  const auto forEachCarrier = [&](const auto& visit) {
    for (const int v : numbers.vertices.kept) visit(v);
    for (const int e : numbers.edges.kept) visit(static_cast<int>(firstEdge) + e);
    for (const int t : numbers.triangles.kept) visit(static_cast<int>(firstTriangle) + t);
  };
  std::size_t items = 0;
  forEachCarrier([&](int carrier) { items += whole.of(carrier).size(); });
  out.items.reserve(items);
  out.begin.push_back(0);
  forEachCarrier([&](int carrier) {
    const std::span<const CarrierCandidate> own = whole.of(carrier);
    out.items.insert(out.items.end(), own.begin(), own.end());
    out.begin.push_back(static_cast<int>(out.items.size()));
    out.cliqueSet.push_back(at(whole.cliqueSet, carrier));
  });
  return out;
}

std::shared_ptr<const CharacterTables> tablesOf(const Preparation& next, const PartNumbers& numbers) {
  auto character = std::make_shared<Character>();
  character->mesh = meshOf(next.mesh(), numbers);
  character->skeleton = next.character().skeleton;
  character->height = next.character().height;
  auto out = std::make_shared<CharacterTables>();
  out->bind = next.tables->bind;
  out->character = std::move(character);
  for (const int v : numbers.vertices.kept) {
    out->riseInBind.push_back(at(next.tables->riseInBind, v));
    out->inverseLimitsInBind.push_back(at(next.inverseLimitsInBind(), v));
  }
  return out;
}

}  // namespace

std::vector<SampledPiece> sampledPieces(const Preparation& next, const std::vector<std::uint8_t>& triangles) {
  const std::size_t asked = triangles.size() - static_cast<std::size_t>(std::ranges::count(triangles, 0));
  const std::size_t most = next.swells() ? sizeOfPieces(asked) : std::numeric_limits<std::size_t>::max();
  std::vector<SampledPiece> out;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (triangles[t] == 0) continue;
    if (out.empty() || out.back().size() >= most) out.emplace_back();
    out.back().push_back(static_cast<int>(t));
  }
  return out;
}

SampledPart sampledPart(const Preparation& next, const SampledPiece& piece) {
  SampledPart out;
  const PartNumbers numbers = next.swells() ? numbersOf(next.mesh(), piece) : allNumbers(next.mesh());
  auto own = std::make_shared<Preparation>(next);
  own->tables = tablesOf(next, numbers);
  own->layered = nullptr;
  own->region.clear();
  own->seen = std::make_shared<const CandidateLists>(candidatesOf(next, numbers));
  out.preparation = std::move(own);
  out.edges = numbers.edges.kept;
  for (const int t : piece) out.asked.push_back(numbers.triangles.newOf(t));
  out.triangles = numbers.triangles.kept;
  return out;
}

SurfaceSampler::SurfaceSampler(const SampledPart& part, Refinement points)
    : preparation_(prepareSamples(*part.preparation, std::move(points))) {}

const Surface& SurfaceSampler::sample(const Pose& pose, std::span<const int> triangles) {
  preparation_->poser->pose(pose, rig_);
  std::ranges::fill(rig_.morphWeights, 0.0f);  // Tables of the bind pose are without morph targets.
  poseFieldAndSkin(preparation_, rig_, pose, posed_);
  layPatch(*preparation_, posed_, workspace_, surface_);
  if (preparation_->shownPrimitives > 0) {
    skipAllBut(triangles);
    FieldView field = posed_.view(*preparation_);
    field.skipped = skipped_;
    chosenProjector(*preparation_).project({*preparation_, posed_, field}, pose, workspace_, surface_);
  }
  return surface_;
}

void SurfaceSampler::skipAllBut(std::span<const int> triangles) {
  const ControlMesh& mesh = preparation_->mesh();
  const std::size_t firstEdge = mesh.positions.size();
  const std::size_t firstTriangle = firstEdge + mesh.edges.size();
  skipped_.clear();
  if (triangles.size() == mesh.triangles.size()) return;
  skipped_.assign(firstTriangle + mesh.triangles.size(), 1);
  for (const int t : triangles) {
    const ControlTriangle& triangle = at(mesh.triangles, t);
    skipped_[firstTriangle + toIndex(t)] = 0;
    for (const int e : triangle.edges) skipped_[firstEdge + toIndex(e)] = 0;
    for (const int v : triangle.vertices) at(skipped_, v) = 0;
  }
}

}  // namespace sinew
