// core/bodies/motions.h: what a character does: poses of all its clips, and spots of its skin in each.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/character/range_of_motion.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/muscle_line.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Points inside a body, followed by the skin over them.

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

// What muscle lines do over all clips, learned for many at once.

/// Lines from `first` on learn their full contraction (withLearned). Twins learn alike: from whichever side gets
/// shorter. One that never shortens keeps what it has.
/// @param character  with the range of motion as a clip
[[nodiscard]] Rig withLearnedLengths(Rig rig, std::size_t first, const Character& character);

/// All clips of a character and its range of motion, fifteen poses a second, each with its clip and time.
class Motions {
 public:
  explicit Motions(std::shared_ptr<const Character> character);

  /// With the range of motion among its clips, if its joints can turn.
  [[nodiscard]] const Character& character() const { return *character_; }
  /// In the bind pose.
  [[nodiscard]] const SkinRuns& skin() const { return skin_; }
  [[nodiscard]] std::span<const Pose> poses() const { return poses_; }

  /// How much of what is seen in a pose counts: half in the range of motion, which goes farther than any clip does.
  [[nodiscard]] float shareOf(std::size_t pose) const { return poses_[pose].clip == kRangeOfMotionName ? 0.5f : 1.0f; }

  /// [poses * spots] frames of spots, pose after pose; nullopt as frameAt() has it.
  [[nodiscard]] std::vector<std::optional<SkinFrame>> framesOf(std::span<const SkinSpot> spots) const;
  /// [poses] places of a control vertex, world.
  [[nodiscard]] std::vector<glm::vec3> placesOf(int vertex) const;

 private:
  std::shared_ptr<const Character> character_;
  SkinRuns skin_;
  std::vector<Pose> poses_;
};

// How short a line gets in what its character does.

/// Full contraction from the 2nd percentile of its lengths. A line that never shortens keeps what it has.
void learnFull(MuscleLine& line, const Motions& motions);

}  // namespace sinew
