// core/rig/mesh_layers.cpp: layers of parts handed on to what they share; nearest triangles by a tree.
#include "core/rig/mesh_layers.h"

#include <algorithm>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/triangle_tree.h"

namespace sinew {
namespace {

/// The layer that wins where parts meet: the enumerators' order.
static_assert(SkinLayer::kSkin < SkinLayer::kCloth && SkinLayer::kCloth < SkinLayer::kRigid);

TriangleCorners controlCorners(const ControlMesh& mesh, int triangle) {
  const auto& v = at(mesh.triangles, triangle).vertices;
  return {at(mesh.positions, v[0]), at(mesh.positions, v[1]), at(mesh.positions, v[2])};
}

/// 0..1: how much of a vertex's weight is on bones that a triangle's corners follow as much.
float weightLikeness(const Character& character, int vertex, int triangle) {
  float shared = 0.0f;
  for (const int corner : at(character.mesh.triangles, triangle).vertices) {
    for (const WeightedBinding& own : bindingsOf(character, vertex)) {
      float other = 0.0f;
      for (const WeightedBinding& follows : bindingsOf(character, corner)) {
        if (follows.bone() == own.bone()) other += follows.weight;
      }
      shared += std::min(own.weight, other);
    }
  }
  return std::min(shared / 3.0f, 1.0f);
}

class LayerFinder {
 public:
  LayerFinder(const Character& character, MeshLayers& out)
      : character_(character),
        mesh_(character.mesh),
        firstEdge_(mesh_.positions.size()),
        firstTriangle_(firstEdge_ + mesh_.edges.size()),
        out_(out) {}

  void run() {
    out_.carriers.assign(firstTriangle_ + mesh_.triangles.size(), SkinLayer::kRigid);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const ControlTriangle& triangle = mesh_.triangles[t];
      const SkinLayer layer = at(out_.parts, triangle.part);
      out_.carriers[firstTriangle_ + t] = layer;
      for (const int v : triangle.vertices) take(toIndex(v), layer);
      for (const int e : triangle.edges) take(firstEdge_ + toIndex(e), layer);
    }
    const auto first = out_.carriers.begin() + static_cast<std::ptrdiff_t>(firstTriangle_);
    const bool both = std::find(first, out_.carriers.end(), SkinLayer::kSkin) != out_.carriers.end() &&
                      std::find(first, out_.carriers.end(), SkinLayer::kCloth) != out_.carriers.end();
    if (!both) return;
    findNearest(SkinLayer::kCloth, SkinLayer::kSkin, out_.skinUnder);
    findNearest(SkinLayer::kSkin, SkinLayer::kCloth, out_.clothOver);
  }

 private:
  void take(std::size_t carrier, SkinLayer layer) { out_.carriers[carrier] = std::min(out_.carriers[carrier], layer); }

  void findNearest(SkinLayer from, SkinLayer to, std::vector<int>& out) const {
    std::vector<TriangleCorners> corners;
    std::vector<int> numbers;
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      if (out_.carriers[firstTriangle_ + toIndex(t)] != to) continue;
      corners.push_back(controlCorners(mesh_, t));
      numbers.push_back(t);
    }
    const TriangleTree tree(corners, numbers);
    const float reach = kClothReach * character_.height;
    out.assign(mesh_.positions.size(), -1);
    forEachIndex(out.size(), 64, [&](std::size_t v) {
      if (out_.carriers[v] != from) return;
      const int vertex = static_cast<int>(v);
      const auto cost = [&](int t) { return 0.5f * reach * (1.0f - weightLikeness(character_, vertex, t)); };
      out[v] = tree.nearest(mesh_.positions[v], 1.5f * reach, cost).triangle;
    });
  }

  const Character& character_;
  const ControlMesh& mesh_;
  std::size_t firstEdge_;
  std::size_t firstTriangle_;
  MeshLayers& out_;
};

}  // namespace

MeshLayers meshLayers(const Character& character, std::span<const SkinLayer> layers) {
  MeshLayers out;
  out.parts.assign(layers.begin(), layers.end());
  LayerFinder(character, out).run();
  return out;
}

SkinMesh skinOf(const ControlMesh& mesh, const MeshLayers& layers) {
  SkinMesh skin;
  std::vector<int> number(mesh.positions.size(), -1);
  const std::size_t firstTriangle = mesh.positions.size() + mesh.edges.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (layers.carriers[firstTriangle + t] != SkinLayer::kSkin) continue;
    ControlTriangle triangle = mesh.triangles[t];
    for (int& v : triangle.vertices) {
      int& own = at(number, v);
      if (own < 0) {
        own = static_cast<int>(skin.vertices.size());
        skin.vertices.push_back(v);
        skin.mesh.positions.push_back(at(mesh.positions, v));
      }
      v = own;
    }
    skin.mesh.triangles.push_back(triangle);
  }
  return skin;
}

}  // namespace sinew
