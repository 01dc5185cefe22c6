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

// What of a surface an eye can see from anywhere outside of it.

/// Whether any of 256 directions leads away from a place without meeting a triangle.
/// @param normal  any length: directions below it do not count  @param off  distance along it to begin at
[[nodiscard]] bool isSeen(const TriangleTree& triangles, const glm::vec3& place, const glm::vec3& normal, float off);

/// More than this below the nearest skin is below, fraction of H; farther below than kClothSunk it is elsewhere.
inline constexpr float kClothBelow = 1e-4f;
inline constexpr float kClothSunk = 0.05f;

/// Where a vertex of cloth is below the skin.
struct ClothSunk {
  float depth = 0.0f;  ///< Along the normal at the nearest point, units of the character; 0: above it, or far from it.
  glm::vec3 place{0.0f};   ///< That point of the skin,
  glm::vec3 normal{0.0f};  ///< and its normal, of any length.
};

/// Measures how far vertices of cloth are below the skin under them: that which is within kClothReach of the vertex in
/// the bind pose and faces as the nearest skin does there. Where two limbs press into each other no cloth can be above
/// both.
class ClothMeter {
 public:
  /// @param bind  in the bind pose, without muscles.  @param height  H
  ClothMeter(const ControlMesh& mesh, const MeshLayers& layers, const Surface& bind, float height);

  /// Refined vertices of cloth.
  [[nodiscard]] std::span<const int> cloth() const { return cloth_; }
  /// Refined triangles of skin.
  [[nodiscard]] std::span<const int> skin() const { return skin_; }
  /// [cloth]  @param surface  of the same refinement
  [[nodiscard]] std::vector<ClothSunk> below(const Surface& surface) const;

 private:
  float height_;
  std::vector<int> cloth_;
  std::vector<glm::vec3> under_;  ///< [cloth] normal of the nearest skin in the bind pose.
  std::vector<int> skin_;
  std::vector<glm::vec3> bind_;       ///< [V']
  std::vector<glm::vec3> bindFaces_;  ///< [T'] unit normals in the bind pose.
  std::vector<std::array<int, 3>>
      across_;  ///< [T'] the triangle of skin across the edge that begins at a corner, or -1.
};

/// Over all poses.
struct ClothCount {
  int vertices = 0;        ///< Refined ones of cloth in a surface.
  std::int64_t bare = 0;   ///< Below the skin without muscles: the file's own.
  std::int64_t below = 0;  ///< Below it with muscles.
  std::int64_t more = 0;   ///< Of these, those that are not without.
  float deepest = 0.0f;    ///< Of these, fraction of H.
  int worst = -1;          ///< Pose where that is.
  std::int64_t seen = 0;   ///< Of these, those inside of the body where the skin over them is in sight.
  int lastSeen = -1;       ///< Pose where the last of them is.
};

/// Error: the rig is invalid or its surface too large.
[[nodiscard]] Result<ClothCount> countClothBelow(const std::shared_ptr<const Character>& character, const Rig& rig,
                                                 std::span<const Pose> poses);

}  // namespace sinew
