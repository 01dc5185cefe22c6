// core/surface/sampling.cpp: parts of a mesh with renumbered tables, and the first stages on them.
#include "core/surface/sampling.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "core/geometry/at.h"
#include "core/surface/projector.h"
#include "core/surface/stages.h"

namespace sinew {

namespace {

constexpr std::size_t kMostOfPiece = 4'000;
constexpr std::size_t kFewOfPiece = 500;  ///< So few stay together.

/// Makes an even number of equal pieces, as the number of cores is usually even.
std::size_t sizeOfPieces(std::size_t asked) {
  if (asked <= kFewOfPiece) return kFewOfPiece;
  const std::size_t pairs = (asked + 2 * kMostOfPiece - 1) / (2 * kMostOfPiece);
  return (asked + 2 * pairs - 1) / (2 * pairs);
}

struct Numbering {
  std::vector<int> kept;   ///< Ascending.
  std::vector<int> newOf;  ///< New number by old number; valid only for kept items.

  explicit Numbering(const std::vector<std::uint8_t>& asked) : newOf(asked.size()) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (asked[i] == 0) continue;
      newOf[i] = static_cast<int>(kept.size());
      kept.push_back(static_cast<int>(i));
    }
  }
};

struct PartNumbers {
  Numbering vertices;
  Numbering edges;
  Numbering triangles;
};

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
  const auto vertexOf = [&](int v) { return at(numbers.vertices.newOf, v); };
  for (const int e : numbers.edges.kept) {
    Edge edge = at(whole.edges, e);
    edge.vertices = {vertexOf(edge.vertices[0]), vertexOf(edge.vertices[1])};
    out.edges.push_back(edge);
  }
  for (const int t : numbers.triangles.kept) {
    ControlTriangle triangle = at(whole.triangles, t);
    for (int& v : triangle.vertices) v = vertexOf(v);
    for (int& e : triangle.edges) e = at(numbers.edges.newOf, e);
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

std::vector<int> placesIn(const std::vector<int>& inWhole, const std::vector<int>& asked) {
  std::vector<int> out;
  std::size_t place = 0;
  for (const int one : asked) {
    while (inWhole[place] < one) ++place;
    out.push_back(static_cast<int>(place));
  }
  return out;
}

std::vector<SampledPiece> sampledPieces(const Preparation& next, std::vector<std::uint8_t> edges,
                                        const std::vector<std::uint8_t>& triangles) {
  const auto asked = static_cast<std::size_t>(std::ranges::count(edges, 1) + std::ranges::count(triangles, 1));
  const std::size_t most = next.swells() ? sizeOfPieces(asked) : std::numeric_limits<std::size_t>::max();
  std::vector<SampledPiece> out;
  const auto room = [&]() -> SampledPiece& {
    if (out.empty() || out.back().triangles.size() + out.back().edges.size() >= most) out.emplace_back();
    return out.back();
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (triangles[t] == 0) continue;
    SampledPiece& piece = room();
    piece.triangles.push_back(static_cast<int>(t));
    for (const int e : next.mesh().triangles[t].edges) {
      if (std::exchange(at(edges, e), std::uint8_t{0}) != 0) piece.edges.push_back(e);
    }
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e] != 0) room().edges.push_back(static_cast<int>(e));
  }
  for (SampledPiece& piece : out) std::ranges::sort(piece.edges);
  return out;
}

SampledPart sampledPart(const Preparation& next, const SampledPiece& piece) {
  const ControlMesh& mesh = next.mesh();
  std::vector<std::uint8_t> vertices(mesh.positions.size(), 0);
  std::vector<std::uint8_t> edges(mesh.edges.size(), 0);
  std::vector<std::uint8_t> triangles(mesh.triangles.size(), 0);
  for (const int e : piece.edges) at(edges, e) = 1;
  for (const int t : piece.triangles) {
    at(triangles, t) = 1;
    for (const int e : at(mesh.triangles, t).edges) at(edges, e) = 1;
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e] == 0) continue;
    for (const int v : mesh.edges[e].vertices) at(vertices, v) = 1;
  }
  SampledPart out;
  if (!next.swells()) {
    for (std::vector<std::uint8_t>* asked : {&vertices, &edges, &triangles}) {
      for (std::uint8_t& flag : *asked) out.skipped.push_back(std::exchange(flag, std::uint8_t{1}) == 0 ? 1 : 0);
    }
  }
  PartNumbers numbers{Numbering(vertices), Numbering(edges), Numbering(triangles)};
  auto own = std::make_shared<Preparation>(next);
  own->tables = tablesOf(next, numbers);
  own->layered = nullptr;
  own->region.clear();
  own->seen = std::make_shared<const CandidateLists>(candidatesOf(next, numbers));
  out.preparation = std::move(own);
  out.edges = std::move(numbers.edges.kept);
  out.triangles = std::move(numbers.triangles.kept);
  return out;
}

SurfaceSampler::SurfaceSampler(const SampledPart& part, Refinement points)
    : preparation_(prepareSamples(*part.preparation, std::move(points))), skipped_(part.skipped) {}

const Surface& SurfaceSampler::sample(const Pose& pose) {
  preparation_->poser->pose(pose, rig_);
  std::ranges::fill(rig_.morphWeights, 0.0f);  // Tables of the bind pose are without morph targets.
  poseFieldAndSkin(preparation_, rig_, pose, posed_);
  layPatch(*preparation_, posed_, workspace_, surface_);
  if (preparation_->shownPrimitives > 0) {
    FieldView field = posed_.view(*preparation_);
    field.skipped = skipped_;
    chosenProjector(*preparation_).project({*preparation_, posed_, field}, pose, workspace_, surface_);
  }
  return surface_;
}

}  // namespace sinew
