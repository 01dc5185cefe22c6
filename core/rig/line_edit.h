// core/rig/line_edit.h: changes of muscle lines, as pure functions rig -> rig.
//
// As in rig_edit.h: a rig is taken by value; indices must be in range (asserted).
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

// Muscle lines fitted to a character: rest and contraction from poses and clips, via points,
// a second end. As in rig_edit.h: a rig is taken by value; indices must be in range.

// How long a muscle line gets in what a character does.

/// Line stretches (lambda) over clips.
struct LineLengths {
  float least = 1.0f;
  float secondPercentile = 1.0f;  ///< Shorter is rare: what full contraction is learned from.
  float most = 1.0f;
  std::string longestIn;  ///< Names of the clips in which it is longest and shortest.
  std::string shortestIn;
  int poses = 0;  ///< Looked at; 0: the rest says nothing.
};

/// Samples 15 times a second; of more than an hour of clips, 60,000 times in all.
[[nodiscard]] LineLengths lengthsOver(const LineRest& rest, const Character& character,
                                      std::span<const AnimationClip> clips);

/// The same of several lines, for the price of one: each pose is sampled once.  @return [rests]
[[nodiscard]] std::vector<LineLengths> lengthsOver(std::span<const LineRest> rests, const Character& character,
                                                   std::span<const AnimationClip> clips);

/// The same over poses.
[[nodiscard]] LineLengths lengthsOver(const LineRest& rest, const Skeleton& skeleton, std::span<const Pose> poses);

// Outside of these a straight line probably passes through a joint.
inline constexpr float kPlausibleLeast = 0.6f;
inline constexpr float kPlausibleMost = 1.4f;

/// The pose's length becomes the rest length. @param stretch  lambda in the pose
[[nodiscard]] Result<Rig> withRestNow(Rig rig, int line, float stretch);
/// The pose's length becomes that of full contraction. Error: the line is not shorter than at rest.
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

/// Puts a muscle that rides its bone on a new line to another bone; it stays where it is in the bind pose. The line
/// begins at the muscle's far end and ends a little way along the other bone, both half way between skin and axis. Its
/// twin stays as it is (core/rig/twins.h: withTwinOnLine). Error: a bone is not there, or the ends would
/// meet.
[[nodiscard]] Result<Rig> withOtherEnd(Rig rig, int primitive, int bone, const Character& character);

// What becomes of a muscle that moves to another bone.

/// The placement in `to` that looks as `inFrom` does in `from`, in one pose: the same ellipsoid in the world, whatever
/// the bones' scale and shear (affine_image.h). A flattened bone: the placement as it was.
[[nodiscard]] Placement carryToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld);

/// The primitive at the same place along another bone, as much larger as that bone is longer (keyed and driven lengths
/// too), with its default territory. From a bone that is not there: as large as it was.
[[nodiscard]] Primitive scaleToBone(Primitive primitive, const Skeleton& skeleton, int bone);

/// Appends; the name is made unique. If `mirror` names a line of the rig, the two become each other's twins.
[[nodiscard]] Result<Rig> addLine(Rig rig, MuscleLine line);
/// The same in place. Error: the rig is as it was.
[[nodiscard]] Result<void> append(Rig& rig, MuscleLine line);
/// `change` must leave name and mirror alone (asserted).
[[nodiscard]] Result<Rig> editLine(Rig rig, int line, const std::function<void(MuscleLine&)>& change);
[[nodiscard]] Result<Rig> renameLine(Rig rig, int line, const std::string& name);
/// Puts primitives on a line, or with -1 on their bones alone. Lines that lose their last primitive go.
[[nodiscard]] Rig setLineOfSeveral(Rig rig, std::span<const int> primitives, int line);
/// Makes two different lines each other's twins; former twins are unlinked.
[[nodiscard]] Rig setLineMirror(Rig rig, int line, int twin);

/// Without those of `lines` that carry no primitive.
[[nodiscard]] Rig withoutIdleLines(Rig rig, std::unordered_set<std::string> lines);

/// Rig indices of the primitives on a line, ascending.
[[nodiscard]] std::vector<int> primitivesOn(const Rig& rig, const std::string& line);

}  // namespace sinew
