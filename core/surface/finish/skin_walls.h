// core/surface/finish/skin_walls.h: how far a place is above the skin around it in a pose, and how far below.
// docs/characters.md.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/triangle_tree.h"
#include "core/rig/mesh_layers.h"
#include "core/surface/finish/vertex_rings.h"
#include "sinew/geometry/geometry.h"
#include "sinew/surface/refinement.h"

namespace sinew {

// A refined triangle by its corners.

/// @param of  [V'] positions, or normals
[[nodiscard]] inline TriangleCorners refinedCorners(const Refinement& refinement, int triangle,
                                                    std::span<const glm::vec3> of) {
  const std::array<int, 3>& t = at(refinement.triangles, triangle);
  return {at(of, t[0]), at(of, t[1]), at(of, t[2])};
}

/// Unit normal; 0 of a triangle without area.
[[nodiscard]] inline glm::vec3 faceOf(const TriangleCorners& c) {
  return normalizeOr(glm::cross(c[1] - c[0], c[2] - c[0]), glm::vec3(0.0f));
}

/// Refined triangles of skin in a tree that stays while they move. Made once per refinement.
struct WallTree {
  struct Node {
    int first = 0;  ///< Of its triangles, or its first child, with the other after it.
    int count = 0;  ///< Of triangles; 0: it has children.
  };
  std::vector<Node> nodes;            ///< Children after their parents.
  std::vector<int> triangles;         ///< Leaf by leaf.
  std::vector<int> placeOf;           ///< [T'] of each refined triangle among these; -1: none.
  std::vector<glm::vec3> bindPlaces;  ///< [triangles] a corner of each in the bind pose.
  std::vector<glm::vec3> bindFaces;   ///< [triangles] unit normals there.
};

/// @param triangles  refined ones of skin  @param positions [V'] in the bind pose
[[nodiscard]] WallTree wallTree(const Refinement& refinement, std::span<const int> triangles,
                                std::span<const glm::vec3> positions);

/// Which skin is under a vertex of cloth: what is near it in the bind pose and faces as the nearest skin does there.
struct WallsUnder {
  glm::vec3 bindPlace{0.0f};
  glm::vec3 bindFace{0.0f};  ///< Unit normal of the skin nearest to it.
};

/// The skin around a place.
struct Walls {
  float above = std::numeric_limits<float>::infinity();  ///< Distance of the nearest that it is above,
  float below = std::numeric_limits<float>::infinity();  ///< and of the nearest that it is below: more where that is
                                                         ///< seen aslant, so that none comes or goes at once.
  float depth = 0.0f;                                    ///< Distance of the latter,
  int triangle = -1;                                     ///< where it is,
  glm::vec3 shares{0.0f};                                ///< barycentric,
  glm::vec3 normal{0.0f};                                ///< and its unit normal there.
};

inline constexpr int kMostInWallLeaf = 6;

/// Where the triangles of a node are, and for a leaf which places are in front of them all.
struct WallNode {
  Bounds box;
  glm::vec3 center{0.0f};  ///< Of a leaf: of its box,
  float radius = 0.0f;     ///< around which its triangles are,
  glm::vec3 axis{0.0f};    ///< the mean of its faces' normals,
  float cosine = -1.0f;    ///< the least cosine to it,
  float sine = 0.0f;       ///< the sine that belongs to that,
  float most = 0.0f;       ///< the farthest that a face lies out from the center, along its own normal,
  std::array<glm::vec4, kMostInWallLeaf> planes{};  ///< and their unit normals and how far along these they lie.

  /// Whether a place may be behind the plane of any triangle of this leaf that is nearer than `within`.
  [[nodiscard]] bool mayBeBehind(const glm::vec3& p, float within) const;
};

/// The skin of one pose. All must outlive it.
class SkinWalls {
 public:
  /// @param layers [T] of the control triangles  @param positions [V']  @param nodes  memory
  SkinWalls(const WallTree& tree, const Refinement& refinement, const VertexRings& rings,
            std::span<const SkinLayer> layers, std::span<const glm::vec3> positions, float reach,
            std::vector<WallNode>& nodes);

  /// Looks no farther than `within`, nor than kWallsApart times the nearest wall.
  [[nodiscard]] Walls around(const glm::vec3& p, const WallsUnder& under, float within) const;

  /// Parts of the tree for several places close together.
  using NearNodes = std::array<int, 128>;
  /// Those nearer to a box than `within`. @param out  memory for the answer
  [[nodiscard]] std::span<const int> nearTo(const Bounds& box, float within, NearNodes& out) const;
  /// Whether a place may be below any skin nearer than `within`. Much faster than around() where it is not.
  /// @param among  nearTo(a box around p, at least `within`)
  [[nodiscard]] bool isBelowAny(const glm::vec3& p, const WallsUnder& under, float within,
                                std::span<const int> among) const;
  /// The triangle nearest to a place, whatever faces where; -1: none within the distance.
  [[nodiscard]] int nearest(const glm::vec3& p, float within) const;

  static constexpr float kWallsApart = 1.03f;

 private:
  [[nodiscard]] TriangleCorners cornersOf(int triangle) const;
  void fitLeaf(const WallTree::Node& leaf, WallNode& out) const;
  [[nodiscard]] bool isUnder(int place, const WallsUnder& under) const;
  [[nodiscard]] bool isAnyUnderAround(int triangle, const WallsUnder& under) const;
  [[nodiscard]] bool isSkin(int triangle) const;
  [[nodiscard]] glm::vec3 normalAt(int triangle, const glm::vec3& shares) const;
  [[nodiscard]] glm::vec3 normalAtVertex(int vertex) const;
  [[nodiscard]] glm::vec3 normalAtEdge(int from, int to) const;
  /// Calls visit(place in the tree) for triangles of leaves whose boxes are nearer than `within`, which visit may
  /// lessen. @param root  node whose triangles are looked at
  template <class Visit>
  void forEachNear(int root, const glm::vec3& p, float& within, Visit visit) const;
  void look(int place, const glm::vec3& p, const WallsUnder& under, Walls& out, float& within) const;

  const WallTree& tree_;
  const Refinement& refinement_;
  const VertexRings& rings_;
  std::span<const SkinLayer> layers_;
  std::span<const glm::vec3> positions_;
  float reach_;
  const std::vector<WallNode>& nodes_;
};

}  // namespace sinew
