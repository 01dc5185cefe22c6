// core/bodies/height_model.h: heights of the skin over its muscles in the bind pose, and how they change with the
// muscles' numbers.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/surface/posed_field.h"
#include "core/surface/preparation.h"
#include "core/surface/workspace.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Numbers of a muscle that a fit changes, in this order: center (3, world), rotation about the muscle's own axes (3,
/// radians), logarithms of the radii (3) and of the amount (1).
inline constexpr std::size_t kFitNumbers = 10;
using FitVector = std::array<float, kFitNumbers>;

/// How the height of a point changes with the numbers of a muscle.
struct HeightChange {
  int primitive = 0;  ///< Index into Rig::primitives.
  FitVector by{};
};

/// Points of the skin between which nothing is left out: the vertices of the refined mesh. World, bind pose.
struct SkinPoints {
  std::vector<glm::vec3> positions;       ///< [P] of the smoothed character without muscles.
  std::vector<glm::vec3> normals;         ///< [P] unit
  std::vector<glm::vec3> directions;      ///< [P] unit; along which the skin rises.
  std::vector<float> areas;               ///< [P] a third of the triangles around.
  std::vector<std::uint8_t> movable;      ///< [P] 1: in the territory of some muscle.
  std::vector<std::array<int, 2>> edges;  ///< Smaller point first, each once.
  std::vector<std::array<int, 3>> triangles;
  int controlVertices = 0;  ///< The first points are the control vertices.

  [[nodiscard]] std::size_t size() const { return positions.size(); }
};

/// The surface of the product in the mode swell, from the patch to the projection; without the stages after it, which
/// need a mesh: slopes, filter and folds. Its points are about 1 % of H apart. Several rigs in turn, which differ in
/// shapes alone.
class HeightModel {
 public:
  /// Error: the rig is refused, or its mode is replace.
  [[nodiscard]] static Result<HeightModel> create(std::shared_ptr<const Character> character, const Rig& rig);

  [[nodiscard]] const SkinPoints& points() const { return points_; }
  /// Makes heights() those of a rig with other shapes and amounts.  Error: the rig is refused.
  [[nodiscard]] Result<void> raise(const Rig& rig);
  [[nodiscard]] std::span<const float> heights() const { return surface_.displacement; }  ///< [P] along the directions.
  /// [P] Changes of the heights of the last raise(); those of blend widths are left out, which are small.
  [[nodiscard]] std::vector<std::vector<HeightChange>> changes() const;

 private:
  HeightModel() = default;
  void findPoints();

  std::shared_ptr<const CharacterTables> tables_;
  int depth_ = 1;
  BlendingGraphMemo graphs_;
  std::shared_ptr<const Preparation> preparation_;
  PosedRig rig_;
  PosedField posed_;
  Workspace workspace_;
  Surface surface_;
  SkinPoints points_;
};

}  // namespace sinew
