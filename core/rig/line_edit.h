// core/rig/line_edit.h: edits of muscle lines as pure functions rig -> rig. Indices must be in range (asserted).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/rig/line_rest.h"
#include "sinew/character/character.h"
#include "sinew/character/skeleton.h"
#include "sinew/geometry/geometry.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Lines fitted to a character.

/// Line stretches (lambda) over poses.
struct LineLengths {
  float least = 1.0f;
  float secondPercentile = 1.0f;  ///< From which full contraction is learned, since shorter is rare.
  float most = 1.0f;
  std::string longestIn;  ///< Clips in which the line is longest and shortest.
  std::string shortestIn;
  int poses = 0;  ///< Number of poses; 0: the other members are not valid.
};

/// Over clips, sampled 15 times per second; if there are hours of clips, 60,000 times in all.
[[nodiscard]] LineLengths lengthsOver(const LineRest& rest, const Character& character,
                                      std::span<const AnimationClip> clips);

/// Over clips for several lines, sampling each pose once.  @return [rests]
[[nodiscard]] std::vector<LineLengths> lengthsOver(std::span<const LineRest> rests, const Character& character,
                                                   std::span<const AnimationClip> clips);

/// Over poses.
[[nodiscard]] LineLengths lengthsOver(const LineRest& rest, const Skeleton& skeleton, std::span<const Pose> poses);

// Stretches outside of which a straight line probably passes through a joint.
inline constexpr float kPlausibleLeast = 0.6f;
inline constexpr float kPlausibleMost = 1.4f;

/// Makes the length in a pose the rest length. @param stretch  lambda in the pose
[[nodiscard]] Result<Rig> withRestNow(Rig rig, int line, float stretch);
/// Makes the length in a pose that of full contraction. Error: the line is not shorter than at rest.
[[nodiscard]] Result<Rig> withFullNow(Rig rig, int line, float stretch);

/// The joint that the line crosses: the origin of the lower of its two bones, in the bind pose.
[[nodiscard]] glm::vec3 jointBetween(const LineRest& rest, const Character& character);

struct Learned {
  Rig rig;
  std::string said;     ///< "Full contraction at 74 %: shortest in Range of motion"
  std::string warning;  ///< Empty, or why the line probably passes through a joint.
};
/// Full contraction from the 2nd percentile of the lengths. Error: the muscle never shortens.
[[nodiscard]] Result<Learned> withLearned(Rig rig, int line, const LineLengths& lengths);

/// A via point on the origin's bone, beside the joint between the two bones, on the side where the line passes it.
/// Error: the line's bones are not there.
[[nodiscard]] Result<Rig> withViaPoint(Rig rig, int line, const Character& character);
[[nodiscard]] Result<Rig> withoutViaPoint(Rig rig, int line);

/// Puts a muscle without a line on a new line to another bone; its place in the bind pose stays. The line begins at the
/// muscle's far end and ends a short distance along the other bone, both half way between skin and axis. Its twin is
/// not changed (see withTwinOnLine). Error: a bone is missing, or the ends would coincide.
[[nodiscard]] Result<Rig> withOtherEnd(Rig rig, int primitive, int bone, const Character& character);

// Muscles that move to another bone.

/// The placement on bone `to` of the same ellipsoid in the world, despite scale and shear; unchanged for a flat bone.
[[nodiscard]] Placement carryToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld);

/// The primitive at the same place along another bone, scaled with the length of the bone, keyed and driven lengths
/// included, with the default territory. Not scaled if its own bone is missing.
[[nodiscard]] Primitive scaleToBone(Primitive primitive, const Skeleton& skeleton, int bone);

// Lines of a rig.

/// Appends a line and makes its name unique. If `mirror` names a line of the rig, the two become twins.
[[nodiscard]] Result<Rig> addLine(Rig rig, MuscleLine line);
[[nodiscard]] Result<void> append(Rig& rig, MuscleLine line);  ///< The same in place. Error: the rig is not changed.
/// `change` must not change name and mirror (asserted).
[[nodiscard]] Result<Rig> editLine(Rig rig, int line, const std::function<void(MuscleLine&)>& change);
[[nodiscard]] Result<Rig> renameLine(Rig rig, int line, const std::string& name);
/// Puts primitives on a line, or with -1 on none. Removes lines that lose their last primitive.
[[nodiscard]] Rig setLineOfSeveral(Rig rig, std::span<const int> primitives, int line);
/// Makes two different lines twins; former twins are unlinked.
[[nodiscard]] Rig setLineMirror(Rig rig, int line, int twin);

/// Removes those of `lines` that carry no primitive.
[[nodiscard]] Rig withoutIdleLines(Rig rig, std::unordered_set<std::string> lines);

/// Rig indices of the primitives on a line, ascending.
[[nodiscard]] std::vector<int> primitivesOn(const Rig& rig, const std::string& line);

}  // namespace sinew
