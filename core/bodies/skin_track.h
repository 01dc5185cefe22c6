// core/bodies/skin_track.h: points inside a body, followed by the skin over them.
#pragma once

#include <optional>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

/// A place on the control mesh.
struct SkinSpot {
  int triangle = 0;
  glm::vec3 shares{0.0f};  ///< Barycentric.
};

/// A frame that rides the triangle there. World.
struct SkinFrame {
  glm::vec3 origin{0.0f};
  glm::mat3 axes{1.0f};  ///< Orthonormal columns: two in the triangle's plane, its outer normal.

  [[nodiscard]] const glm::vec3& normal() const { return axes[2]; }
};

/// Boxes round runs of triangles, so that what is far away is passed over at once. Neighbors in a file mostly lie
/// beside each other. The mesh must outlive it.
class SkinRuns {
 public:
  explicit SkinRuns(const ControlMesh& mesh);

  struct Run {
    int begin = 0;  ///< First triangle, and the one after the last.
    int end = 0;
    glm::vec3 low{0.0f};
    glm::vec3 high{0.0f};
  };
  [[nodiscard]] const ControlMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }

 private:
  const ControlMesh* mesh_;
  std::vector<Run> runs_;
};

/// The nearest place of the skin that faces away from the point's own side, bind pose; any place if none faces so.
/// @param outwards  unit, from the body's inside  @return nullopt: the mesh has no triangle with an area
[[nodiscard]] std::optional<SkinSpot> spotOver(const SkinRuns& skin, const glm::vec3& point, const glm::vec3& outwards);

/// A control vertex in a pose, world.
[[nodiscard]] glm::vec3 skinnedVertex(const Character& character, int vertex, const Pose& pose);

/// nullopt where the triangle has no area in the pose.
[[nodiscard]] std::optional<SkinFrame> frameAt(const Character& character, const SkinSpot& spot, const Pose& pose);

/// The bone with the largest weight at a spot, and the others of at least a tenth; the largest first, at most four.
[[nodiscard]] std::vector<int> bonesAt(const Character& character, const SkinSpot& spot);

}  // namespace sinew
