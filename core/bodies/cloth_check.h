// core/bodies/cloth_check.h: how much cloth is below the skin while a character moves. docs/characters.md.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/geometry/triangle_tree.h"
#include "core/rig/mesh_layers.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// Visibility from outside: any of 256 rays leaves the place without hitting a triangle.
/// @param normal  any length: directions below it do not count  @param off  distance along it to begin at
[[nodiscard]] bool isSeen(const TriangleTree& triangles, const glm::vec3& place, const glm::vec3& normal, float off);

// Depths under the nearest skin between which cloth counts as below it, fractions of H.
inline constexpr float kClothBelow = 1e-4f;
inline constexpr float kClothSunk = 0.05f;

struct ClothSunk {
  float depth = 0.0f;  ///< Along the normal at the nearest point, units of the character; 0: above it, or far from it.
  glm::vec3 place{0.0f};   ///< That point.
  glm::vec3 normal{0.0f};  ///< Its normal, of any length.
};

/// Measures how far cloth vertices are below their skin: the skin within kClothReach of the vertex in the bind pose
/// that faces the same way as the nearest skin. Where two limbs press into each other, cloth cannot be above both.
class ClothMeter {
 public:
  /// @param bind  in the bind pose, without muscles.  @param height  H
  ClothMeter(const ControlMesh& mesh, const MeshLayers& layers, const Surface& bind, float height);

  [[nodiscard]] std::span<const int> cloth() const { return cloth_; }  ///< Refined vertices of cloth.
  [[nodiscard]] std::span<const int> skin() const { return skin_; }    ///< Refined triangles of skin.
  /// [cloth]  @param surface  of the same refinement
  [[nodiscard]] std::vector<ClothSunk> below(const Surface& surface) const;

 private:
  float height_;
  std::vector<int> cloth_;
  std::vector<glm::vec3> under_;  ///< [cloth] normal of the nearest skin in the bind pose.
  std::vector<int> skin_;
  std::vector<glm::vec3> bind_;             ///< [V']
  std::vector<glm::vec3> bindFaces_;        ///< [T'] unit normals in the bind pose.
  std::vector<std::array<int, 3>> across_;  ///< [T'] skin triangle across the edge from each corner, or -1.
};

/// Cloth vertices below the skin, summed over all poses.
struct ClothCount {
  int vertices = 0;        ///< Refined cloth vertices of the surface.
  std::int64_t bare = 0;   ///< Below the skin without muscles: already so in the file.
  std::int64_t below = 0;  ///< Below the skin with muscles.
  std::int64_t more = 0;   ///< Below only because of muscles.
  float deepest = 0.0f;    ///< Largest depth among `more`, fraction of H.
  int worst = -1;          ///< Pose of `deepest`.
  std::int64_t seen = 0;   ///< Vertices of `more` inside the body under visible skin.
  int lastSeen = -1;       ///< Pose of the last one.
};

/// Error: the rig is invalid or its surface too large.
[[nodiscard]] Result<ClothCount> countClothBelow(const std::shared_ptr<const Character>& character, const Rig& rig,
                                                 std::span<const Pose> poses);

}  // namespace sinew
