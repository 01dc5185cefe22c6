// core/rig/mirror.h: a character's mirror plane, its pairs of bones, and mirror images of muscles.
//
// Two muscles are mirror images if their ellipsoids are so in the bind pose. The reflection is an affine map from a
// bone's space to its twin's (boneMirror), which is applied to the ellipsoid; exact for every bone matrix.
//
// Canonical form. Of the many placements of an ellipsoid, the image keeps the order of radii and axes and has a
// rotation as near to the original's as possible (imageOf). The image of the image is the original: bit for bit if the
// frames of the bones are mirror images along their own axes (to 2e-7, as exporters make them); to a few units in the
// last place if the map is a reflection with uniform scale. With non-uniform scale it is the same ellipsoid, but the
// order of its axes may change.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/affine_image.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Points x with dot(normal, x) = offset; bind pose, world.
struct MirrorPlane {
  glm::dvec3 normal{1.0, 0.0, 0.0};  ///< Unit.
  double offset = 0.0;               ///< Character units.
};

[[nodiscard]] glm::dvec3 reflected(const MirrorPlane& plane, const glm::dvec3& pointInWorld);
[[nodiscard]] double distanceTo(const MirrorPlane& plane, const glm::dvec3& pointInWorld);

/// Bone space -> twin bone's space by the reflection. Nothing: a bone is flat or not finite in the bind pose.
[[nodiscard]] std::optional<AffineMap> boneMirror(const glm::mat4& boneInBind, const glm::mat4& twinBoneInBind,
                                                  const MirrorPlane& plane);

enum class PairedBy { kNothing, kName, kPlace, kCenter };  ///< kCenter: it lies in the plane, its own counterpart.

struct MirrorPlan {
  MirrorPlane plane;
  std::vector<int> twinOf;         ///< [bones] counterpart, itself for center bones; -1: none. Its own inverse.
  std::vector<PairedBy> pairedBy;  ///< [bones]
  std::vector<std::optional<AffineMap>> mirrors;  ///< [bones] into the counterpart's space; none: no counterpart.
  Skeleton skeleton;                              ///< The character's, for names.
  float characterHeight = 1.0f;                   ///< H.

  [[nodiscard]] int pairCount() const;
  [[nodiscard]] int centerCount() const;
  /// There is a pair, or a bone in the plane.
  [[nodiscard]] bool usable() const { return pairCount() + centerCount() > 0; }
};

/// Finds the plane and the pairs. Bones are paired by the sides in their names (core/character/bone_names.h), with
/// numbers at the end ignored and markers in names of parents allowed. The plane is the one, among those normal to the
/// directions between pairs or to an axis, in which skin and bones are mirrored best. Other bones are paired by their
/// places, parents before children, children of a pair first. Bones without counterpart stay alone; an asymmetric
/// character only has pairs by name.
[[nodiscard]] MirrorPlan makeMirrorPlan(const Character& character);

/// Finds the pairs for a given plane.
[[nodiscard]] MirrorPlan pairBones(const Skeleton& skeleton, const MirrorPlane& plane, float characterHeight);

/// The counterpart of a bone (Primitive::bone) by its name in files. Error: no such bone, or it has no counterpart.
[[nodiscard]] Result<std::string> twinBone(const MirrorPlan& plan, const std::string& bone);

/// The mirror image of a muscle: bone, placement, animation and territory (bones without counterpart stay) are
/// mirrored, the name is imageName(), `mirror` is empty, and the rest, `line` included, is unchanged. Error: see
/// twinBone.
[[nodiscard]] Result<Primitive> mirroredPrimitive(const MirrorPlan& plan, const Primitive& primitive);

/// Name of the image of something on a bone: with the other bone's name if it begins with the bone's; else
/// mirroredName(); else the name itself. @param bone  with a counterpart
[[nodiscard]] std::string imageName(const MirrorPlan& plan, const std::string& name, const std::string& bone);

/// The muscle is on a center bone and its own mirror image within `tolerance` (fraction of H).
[[nodiscard]] bool liesInPlane(const MirrorPlan& plan, const Primitive& primitive, float tolerance);

/// Moves the center into the plane and aligns the axes with it, if the muscle is on a center bone and its center within
/// `tolerance` (fraction of H) of the plane; else nothing.
[[nodiscard]] std::optional<Placement> snappedToPlane(const MirrorPlan& plan, const Primitive& primitive,
                                                      float tolerance);

}  // namespace sinew
