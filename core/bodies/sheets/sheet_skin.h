// core/bodies/sheets/sheet_skin.h: the smooth skin of a character in the bind pose, without muscles, for laying sheets.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/geometry/triangle_tree.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Curved patches, finer where the mesh is coarse, so that a sheet follows the surface that is drawn. Rigid parts are
/// no skin; cloth is where there is no skin near. World.
class SheetSkin {
 public:
  /// @param rig  its layers and its patches count
  SheetSkin(std::shared_ptr<const Character> character, const Rig& rig);

  [[nodiscard]] const Character& character() const { return *character_; }
  [[nodiscard]] float height() const { return character_->height; }

  /// The nearest point of the skin that looks along `outwards`, or of any skin if none does.
  [[nodiscard]] glm::vec3 nearest(const glm::vec3& point, const glm::vec3& outwards) const;
  [[nodiscard]] glm::vec3 nearest(const glm::vec3& point) const;

  /// Mean normal of the skin within a radius that looks the same way as the nearest, unit.
  [[nodiscard]] glm::vec3 normalAround(const glm::vec3& point, float radius) const;

  /// Weights of bones at the nearest skin; their sum is 1.
  [[nodiscard]] std::map<int, float> weightsAt(const glm::vec3& point) const;

 private:
  struct Sample {
    glm::vec3 position{0.0f};
    glm::vec3 areaNormal{0.0f};  ///< Normal times a third of the area of its triangles.
  };
  [[nodiscard]] int nearestTriangle(const glm::vec3& point, const glm::vec3* outwards) const;
  [[nodiscard]] std::uint64_t cellOf(const glm::ivec3& cell) const;
  [[nodiscard]] glm::ivec3 cellAt(const glm::vec3& point) const;

  std::shared_ptr<const Character> character_;
  std::vector<TriangleCorners> corners_;  ///< Of the refined surface.
  std::vector<int> control_;              ///< Control triangle of each.
  std::vector<bool> cloth_;
  std::vector<glm::vec3> normals_;  ///< Of the triangles.
  std::optional<TriangleTree> tree_;
  float cell_ = 1.0f;
  std::unordered_map<std::uint64_t, std::vector<Sample>> samples_;  ///< By cell of a grid.
};

}  // namespace sinew
