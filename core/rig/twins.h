// core/rig/twins.h: twins, pairs of muscles that are linked as mirror images (Primitive::mirror): making and linking
// them, and keeping them mirrored. Pure functions rig -> rig; indices must be in range (asserted).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/character/bone_names.h"
#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Mirror images of keys and drivers. docs/muscles.md.

/// Takes counterparts of bones, reverses a twist; lines and channels stay. nullopt: a bone has no counterpart.
[[nodiscard]] std::optional<Driver> mirroredDriver(const MirrorPlan& plan, const Driver& driver);

/// Keys and drivers of a primitive's image, with numbers along an axis moved to the image of that axis. Without those
/// that have no exact counterpart (an axis that is not along one of the other bone's) and drivers by bones without
/// counterpart.
[[nodiscard]] std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const Primitive& primitive);
/// Keys and drivers of a line's image.
[[nodiscard]] std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const MuscleLine& line);
/// The same of a link whose muscles are mirrored.
[[nodiscard]] std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const Link& link);

// Mirror images of muscle lines.

[[nodiscard]] Result<LineAnchor> mirroredAnchor(const MirrorPlan& plan, const LineAnchor& anchor);  ///< See twinBone.

/// The mirror image of a line, named by imageName(), with the same settings and `mirror` empty. Error: see twinBone.
[[nodiscard]] Result<MuscleLine> mirroredLine(const MirrorPlan& plan, const MuscleLine& line);

/// The line is its own image: every anchor is on a center bone and within `tolerance` (fraction of H) of the plane.
[[nodiscard]] bool liesInPlane(const MirrorPlan& plan, const MuscleLine& line, float tolerance);

/// Puts a primitive's twin on its line's twin, which is made if there is none. Unchanged without twin, line or image of
/// the line.
[[nodiscard]] Rig withTwinOnLine(Rig rig, int primitive, const MirrorPlan& plan);

/// Makes linked twins in `edited` follow changes of one of them since `shown`: of bone, placement, reach, sign, group,
/// line and territory, each by itself, so that an edit of the reach does not change an inexact pair otherwise. Within
/// the placement, too, only what changed follows, so that centers stay bit for bit while radii change. If both changed
/// and are no longer images, the one that differs from `atStart` (before the gesture) leads; if both do, the first in
/// the rig. Bones and placements without counterpart are not followed; the link stays. New muscles and links are
/// ignored. Items of the rigs are matched by identity, so that renaming has no effect.
[[nodiscard]] Rig keepTwins(const Rig& atStart, const Rig& shown, Rig edited, const MirrorPlan& plan);

[[nodiscard]] int twinOf(const Rig& rig, int index);  ///< Index of the twin, or -1.
/// The indices with their twins, ascending, each once.
[[nodiscard]] std::vector<int> withTwins(const Rig& rig, std::span<const int> indices);

/// Adds a primitive and its linked mirror image, or only the primitive if it is its own image: on a center bone, in the
/// plane within 1e-4 H. If the name has no side, both get one: "belly L", "belly R". Error: see twinBone, addPrimitive.
[[nodiscard]] Result<Rig> addPair(Rig rig, Primitive primitive, const MirrorPlan& plan);
/// Makes the twin of a primitive its image, or adds one, named as by addPair(). Error: in the plane, or see twinBone.
[[nodiscard]] Result<Rig> mirrorToOtherSide(Rig rig, int index, const MirrorPlan& plan);
/// Links two different primitives and makes the second the image of the first, except for its name. Former twins are
/// unlinked. Error: see twinBone.
[[nodiscard]] Result<Rig> linkTwins(Rig rig, int leader, int follower, const MirrorPlan& plan);
/// Replaces primitives and twins by their images, with names and links kept. Error: the first one without counterpart.
[[nodiscard]] Result<Rig> flipPrimitives(Rig rig, std::span<const int> indices, const MirrorPlan& plan);

/// Appends copies in rig order, the first at rig.primitives.size(), with free names; copies of twins are linked. Stops
/// at kMaxPrimitives.
[[nodiscard]] Rig duplicatePairs(Rig rig, std::span<const int> indices);

/// Renames a primitive, and its twin if mirroredName() of the new name exists and is free. Error: see renamePrimitive.
[[nodiscard]] Result<Rig> renameWithTwin(Rig rig, int index, const std::string& name);

/// Side of the plane of a muscle's center in the bind pose. Left is from the names of bones, else +X, as in glTF.
[[nodiscard]] Side sideOf(const MirrorPlan& plan, const Primitive& primitive);

/// mirroredName() of a name if that is free, else a similar free name.
[[nodiscard]] std::string twinName(const Rig& rig, const std::string& name);

}  // namespace sinew
