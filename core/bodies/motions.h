// core/bodies/motions.h: poses of all clips of a character, and places on its skin in each of them.
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

/// A place on the control mesh.
struct SkinSpot {
  int triangle = 0;
  glm::vec3 shares{0.0f};  ///< Barycentric.
};

/// The frame of the triangle at a spot. World.
struct SkinFrame {
  glm::vec3 origin{0.0f};
  glm::mat3 axes{1.0f};  ///< Orthonormal columns: two in the triangle's plane, then its normal.

  [[nodiscard]] const glm::vec3& normal() const { return axes[2]; }
};

/// Bounding boxes of consecutive triangles, which mostly are neighbors, to skip distant ones. The mesh must outlive it.
class SkinRuns {
 public:
  explicit SkinRuns(const ControlMesh& mesh);

  struct Run {
    int begin = 0;
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

/// The nearest place in the bind pose on skin that faces outwards, or on any skin if none does.
/// @param outwards  unit  @return nullopt: every triangle is degenerate
[[nodiscard]] std::optional<SkinSpot> spotOver(const SkinRuns& skin, const glm::vec3& point, const glm::vec3& outwards);

/// A control vertex in a pose, world.
[[nodiscard]] glm::vec3 skinnedVertex(const Character& character, int vertex, const Pose& pose);

/// nullopt: the triangle is degenerate in the pose.
[[nodiscard]] std::optional<SkinFrame> frameAt(const Character& character, const SkinSpot& spot, const Pose& pose);

/// Bones with a weight of at least 0.1 at a spot, at most four, the largest weight first.
[[nodiscard]] std::vector<int> bonesAt(const Character& character, const SkinSpot& spot);

/// Lines from `first` on learn their full contraction from all clips (withLearned), twins from the side that gets
/// shorter; a line that never shortens keeps its setting. @param character  with the range of motion as a clip
[[nodiscard]] Rig withLearnedLengths(Rig rig, std::size_t first, const Character& character);

/// Poses of all clips of a character and its range of motion, fifteen per second, each with its clip and time.
class Motions {
 public:
  explicit Motions(std::shared_ptr<const Character> character);

  /// With the range of motion among its clips, if its joints can turn.
  [[nodiscard]] const Character& character() const { return *character_; }
  [[nodiscard]] const std::shared_ptr<const Character>& sharedCharacter() const { return character_; }
  [[nodiscard]] const SkinRuns& skin() const { return skin_; }
  [[nodiscard]] std::span<const Pose> poses() const { return poses_; }

  /// Weight of a pose: 0.5 in the range of motion, which goes farther than any clip; else 1.
  [[nodiscard]] float shareOf(std::size_t pose) const { return poses_[pose].clip == kRangeOfMotionName ? 0.5f : 1.0f; }

  /// [poses * spots] frameAt() for each pose and spot.
  [[nodiscard]] std::vector<std::optional<SkinFrame>> framesOf(std::span<const SkinSpot> spots) const;
  [[nodiscard]] std::vector<glm::vec3> placesOf(int vertex) const;  ///< [poses] positions of a control vertex, world.

 private:
  std::shared_ptr<const Character> character_;
  SkinRuns skin_;
  std::vector<Pose> poses_;
};

/// Sets full contraction to the 2nd percentile of the line's lengths. A line that never shortens keeps its setting.
void learnFull(MuscleLine& line, const Motions& motions);

}  // namespace sinew
