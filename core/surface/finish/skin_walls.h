// core/surface/finish/skin_walls.h: distances from the skin above and below a place in a pose. docs/characters.md.
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

/// @param of  [V'] positions or normals
[[nodiscard]] inline TriangleCorners refinedCorners(const Refinement& refinement, int triangle,
                                                    std::span<const glm::vec3> of) {
  const std::array<int, 3>& t = at(refinement.triangles, triangle);
  return {at(of, t[0]), at(of, t[1]), at(of, t[2])};
}

/// Unit normal; 0 for a triangle without area.
[[nodiscard]] inline glm::vec3 faceOf(const TriangleCorners& c) {
  return normalizeOr(glm::cross(c[1] - c[0], c[2] - c[0]), glm::vec3(0.0f));
}

/// Refined triangles of skin in a tree that stays the same as they move. Made once per refinement.
struct WallTree {
  struct Node {
    int first = 0;  ///< First triangle, or first of two children.
    int count = 0;  ///< Number of triangles; 0: it has children.
  };
  std::vector<Node> nodes;            ///< Children after their parents.
  std::vector<int> triangles;         ///< Leaf by leaf.
  std::vector<int> placeOf;           ///< [T'] index of each refined triangle in `triangles`; -1: none.
  std::vector<glm::vec3> bindPlaces;  ///< [triangles] a corner of each in the bind pose.
  std::vector<glm::vec3> bindFaces;   ///< [triangles] unit normals there.
};

/// @param triangles  refined triangles of skin  @param positions [V'] in the bind pose
[[nodiscard]] WallTree wallTree(const Refinement& refinement, std::span<const int> triangles,
                                std::span<const glm::vec3> positions);

/// The skin under a vertex of cloth: near it in the bind pose, and facing like the nearest skin.
struct WallsUnder {
  glm::vec3 bindPlace{0.0f};
  glm::vec3 bindFace{0.0f};  ///< Unit normal of the nearest skin.
};

struct Walls {
  float above = std::numeric_limits<float>::infinity();  ///< Distance of the nearest skin that the place is above.
  float below = std::numeric_limits<float>::infinity();  ///< The same for skin that it is below, increased if seen at
                                                         ///< an angle, so that no skin appears suddenly.
  // The skin that the place is below:
  float depth = 0.0f;  ///< Distance.
  int triangle = -1;
  glm::vec3 shares{0.0f};  ///< Barycentric.
  glm::vec3 normal{0.0f};  ///< Unit.
};

inline constexpr int kMostInWallLeaf = 6;

/// Box of a node; for a leaf, bounds that prove a place in front of all its triangles.
struct WallNode {
  Bounds box;
  // Leaves only:
  glm::vec3 center{0.0f};  ///< Of the box.
  float radius = 0.0f;     ///< Distance from the center that holds all triangles.
  glm::vec3 axis{0.0f};    ///< Mean of the faces' normals.
  float cosine = -1.0f;    ///< Least cosine between a normal and the axis,
  float sine = 0.0f;       ///< and the sine for it.
  float most = 0.0f;       ///< Largest distance of a face from the center along its own normal.
  std::array<glm::vec4, kMostInWallLeaf> planes{};  ///< Unit normals, and distances along them.

  /// Whether a place may be behind the plane of a triangle of this leaf that is nearer than `within`.
  [[nodiscard]] bool mayBeBehind(const glm::vec3& p, float within) const;
};

/// The skin of one pose. All must outlive it.
class SkinWalls {
 public:
  /// @param layers [T] of the control triangles  @param positions [V']  @param nodes  memory
  SkinWalls(const WallTree& tree, const Refinement& refinement, const VertexRings& rings,
            std::span<const SkinLayer> layers, std::span<const glm::vec3> positions, float reach,
            std::vector<WallNode>& nodes);

  /// Considers skin up to `within` and up to kWallsApart times the distance of the nearest.
  [[nodiscard]] Walls around(const glm::vec3& p, const WallsUnder& under, float within) const;

  using NearNodes = std::array<int, 128>;  ///< Parts of the tree for several places close together.
  /// Parts nearer to a box than `within`. @param out  memory for the result
  [[nodiscard]] std::span<const int> nearTo(const Bounds& box, float within, NearNodes& out) const;
  /// Whether a place may be below skin nearer than `within`. If not, much faster than around().
  /// @param among  nearTo(a box around p, at least `within`)
  [[nodiscard]] bool isBelowAny(const glm::vec3& p, const WallsUnder& under, float within,
                                std::span<const int> among) const;
  /// The triangle nearest to a place, facing anywhere; -1: none within the distance.
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
  /// Calls visit(place in the tree) for triangles below `root` in boxes nearer than `within`, which visit may reduce.
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
