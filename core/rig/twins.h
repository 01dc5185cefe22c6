// core/rig/twins.h: muscles linked across the plane: made, linked, and kept each other's image.
//
// A link (Primitive::mirror) says that two muscles are mirror images; keepTwins makes what is edited on one happen on
// the other. As all of rig_edit.h these are pure: rigs by value, indices in range (asserted).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/character/bone_names.h"
#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Keys and drivers on the other side of the mirror plane. docs/muscles.md.

/// The same motion seen in the mirror: bones by their counterparts, a twist the other way round. Lines and channels are
/// named as they are. nullopt: a bone has no counterpart.
[[nodiscard]] std::optional<Driver> mirroredDriver(const MirrorPlan& plan, const Driver& driver);

/// What drives a primitive's image: numbers along an axis go to the axis that it has become, with its sign and offset.
/// What has no exact counterpart there (an axis that is not along one of the other bone's) is left out, as are drivers
/// by bones without counterpart.
[[nodiscard]] std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const Primitive& primitive);
/// The same of a line's numbers, which are the same on both sides.
[[nodiscard]] std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const MuscleLine& line);

/// Lengths are read off the twins of lines that have one.
void readTwinLines(const Rig& rig, std::vector<AnimatedNumber>& animated);

// Muscle lines on the other side of the mirror plane.

/// On the other side. Error: see twinBone.
[[nodiscard]] Result<LineAnchor> mirroredAnchor(const MirrorPlan& plan, const LineAnchor& anchor);
/// Anchors mirrored, settings as they are, name by the other side's bone or by the side it says, `mirror` empty. Error:
/// see twinBone.
[[nodiscard]] Result<MuscleLine> mirroredLine(const MirrorPlan& plan, const MuscleLine& line);

/// Every anchor lies on a center bone and within `tolerance` (fraction of H) of the plane: the line is its own image.
[[nodiscard]] bool liesInPlane(const MirrorPlan& plan, const MuscleLine& line, float tolerance);

/// A rig, and what an image of a primitive of it names as its line.
struct TwinLine {
  Rig rig;
  std::string name;  ///< Empty for a primitive without a line.
};

/// The line on the other side: the linked twin, made and linked if there is none; the line itself if it lies in the
/// plane. Where the name says no side, both get theirs. Error: see mirroredLine.
[[nodiscard]] Result<TwinLine> withTwinLine(Rig rig, std::string line, const MirrorPlan& plan);

/// The twin of a primitive rides the twin line of its line (withTwinLine). The rig as it is: it has no twin, rides no
/// line, or its line has no image.
[[nodiscard]] Rig withTwinOnLine(Rig rig, int primitive, const MirrorPlan& plan);

/// The name of the line that an image of a primitive rides, of those that are there: the twin, or the line itself if it
/// has none.
[[nodiscard]] std::string twinLineName(const Rig& rig, const std::string& line);

/// Lines of a pair follow each other as primitives do (twins.h, keepTwins): anchors and settings of the one that was
/// edited go to the other.
void keepLineTwins(const Rig& atStart, const Rig& shown, Rig& edited, const MirrorPlan& plan);

/// `edited`, where linked twins follow what changed since `shown` on one of the two: bone, placement, reach, sign,
/// group, line and territory, each by itself, so that a pair that never was exact is not torn about by an edit of its
/// reach. Of the placement too only what changed follows, so that centers stay to the bit while radii are pulled.
/// Where both changed and are no longer images of each other, the one that differs from `atStart` (before the
/// gesture) leads; if both do, the first in the rig. A bone or placement without counterpart is not followed; the
/// link stays. Muscles and links that are new are left alone. What is the same in two of the rigs is told by identity,
/// where there is one, so that a new name changes nothing.
[[nodiscard]] Rig keepTwins(const Rig& atStart, const Rig& shown, Rig edited, const MirrorPlan& plan);

/// Index of the twin, or -1.
[[nodiscard]] int twinOf(const Rig& rig, int index);
/// The indices with their twins, ascending, each once.
[[nodiscard]] std::vector<int> withTwins(const Rig& rig, std::span<const int> indices);

/// A primitive and its mirror image, linked. A single one where the image would be itself: on a center bone, in the
/// plane within 1e-4 H. The image is named by the side; where the name says none, as on a center bone, both get theirs:
/// "belly L", "belly R". Error: see twinBone, addPrimitive.
[[nodiscard]] Result<Rig> addPair(Rig rig, Primitive primitive, const MirrorPlan& plan);
/// Appends the image of one that has no twin yet, linked to it and both named as by addPair; its twin, if it has one,
/// becomes its image. Error: it lies in the plane, or see twinBone.
[[nodiscard]] Result<Rig> mirrorToOtherSide(Rig rig, int index, const MirrorPlan& plan);
/// Links two different primitives; the second becomes the image of the first but for its name. Former twins are
/// unlinked. Error: see twinBone.
[[nodiscard]] Result<Rig> linkTwins(Rig rig, int leader, int follower, const MirrorPlan& plan);
/// Each becomes its own image, name and link kept; of a linked pair both, once. Error: the first that has no
/// counterpart.
[[nodiscard]] Result<Rig> flipPrimitives(Rig rig, std::span<const int> indices, const MirrorPlan& plan);

/// Copies, appended in rig order (the first at rig.primitives.size()), with free names; twins that are both copied are
/// linked as copies. Stops at kMaxPrimitives.
[[nodiscard]] Rig duplicatePairs(Rig rig, std::span<const int> indices);

/// Renames; if the new name says a side, clearly, and the same name of the other side is free, its twin gets that.
/// Error: see renamePrimitive.
[[nodiscard]] Result<Rig> renameWithTwin(Rig rig, int index, const std::string& name);

/// The side of the plane that a muscle's center is on, in the bind pose. Bones with names say which side is left; where
/// none does it is +X, as glTF has it.
[[nodiscard]] Side sideOf(const MirrorPlan& plan, const Primitive& primitive);

/// `name` with its other side if that is free, else a free name like it.
[[nodiscard]] std::string twinName(const Rig& rig, const std::string& name);

}  // namespace sinew
