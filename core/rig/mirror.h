// core/rig/mirror.h: a character's symmetry plane, its bones in pairs, and placements on the other side.
//
// Everything is measured in the bind pose: two muscles are mirrored if their ellipsoids are, there. What the plane
// makes of a bone's space is an affine map to the twin bone's space (boneMirror); a muscle's mirror image is that map
// applied to its ellipsoid, exact for every bone matrix, uneven scale included.
//
// Canonical form. An ellipsoid has many placements (each axis may be turned round, equal axes may be turned). The one
// taken keeps what the designer sees: radii stay in their order, axes keep their numbers, and the identity goes to a
// rotation as near to the identity as there is. The image of the image is the original: to the bit where the two bones'
// frames are mirror images along their own axes (as exporters make them, and as maps that are so within 2e-7 are taken
// to be), to a few units in the last place where the map is a turn-over with even scale. Where it stretches unevenly it
// is the same ellipsoid still, but which of its axes is called x may change.
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

/// Bone space -> twin bone's space by the plane, of negative determinant where both bones turn the same way. Nothing if
/// a bone is flattened or not finite in the bind pose.
[[nodiscard]] std::optional<AffineMap> boneMirror(const glm::mat4& boneInBind, const glm::mat4& twinBoneInBind,
                                                  const MirrorPlane& plane);

/// How a bone came to its counterpart.
enum class PairedBy { kNothing, kName, kPlace, kCenter };  ///< kCenter: it lies in the plane, its own counterpart.

/// What is needed to mirror anything on a character. A plan without bones mirrors nothing.
struct MirrorPlan {
  MirrorPlane plane;
  std::vector<int> twinOf;         ///< [bones] the counterpart, itself for center bones, -1: none. Its own inverse.
  std::vector<PairedBy> pairedBy;  ///< [bones]
  std::vector<std::optional<AffineMap>> mirrors;  ///< [bones] into the counterpart's space; none: no counterpart.
  Skeleton skeleton;                              ///< The character's, for names.
  float characterHeight = 1.0f;                   ///< H.

  /// Number of bones that have another bone as counterpart, halved.
  [[nodiscard]] int pairCount() const;
  [[nodiscard]] int centerCount() const;
  /// Something can be mirrored: a pair, or a bone in the plane.
  [[nodiscard]] bool usable() const { return pairCount() + centerCount() > 0; }
};

/// Finds the plane and the pairs. Names say which bones belong together (side_names.h; numbers at the end may differ, a
/// marker may stand in a parent's name); the plane is, among those across the paired bones and those across the three
/// axes, the one in which skin and bones are mirrored best; bones without a clear name are paired by where they lie,
/// parents before children, a pair's children among themselves first. One to one always. Never fails: what finds no
/// counterpart stays alone, and an unsymmetric character has none but what its names say.
[[nodiscard]] MirrorPlan makeMirrorPlan(const Character& character);

/// The pairing alone, in a given plane.
[[nodiscard]] MirrorPlan pairBones(const Skeleton& skeleton, const MirrorPlane& plane, float characterHeight);

/// The bone that a bone (Primitive::bone) has on the other side, as a rig file calls it. Error: the character has no
/// such bone, or it has no counterpart.
[[nodiscard]] Result<std::string> twinBone(const MirrorPlan& plan, const std::string& bone);

/// The muscle on the other side: bone, placement and territory mirrored (bones of a territory without counterpart
/// stay), reach, sign, group and unknown keys as they are, name by mirroredName where that is clear or by the bone's
/// where it begins with that, `mirror` empty, `line` as it is (line_twins.h). Error: see twinBone.
[[nodiscard]] Result<Primitive> mirroredPrimitive(const MirrorPlan& plan, const Primitive& primitive);

/// What the image of something on a bone is called: a name that begins with its bone's takes the other bone's; else by
/// the side it says; else the name itself.
/// @param bone  with a counterpart
[[nodiscard]] std::string imageName(const MirrorPlan& plan, const std::string& name, const std::string& bone);

/// On a center bone: the ellipsoid is its own mirror image within `tolerance` (fraction of H).
[[nodiscard]] bool liesInPlane(const MirrorPlan& plan, const Primitive& primitive, float tolerance);

/// For a muscle on a center bone whose center lies within `tolerance` (fraction of H) of the plane: the placement with
/// the center in the plane and axes along and across it, radii kept. Nothing elsewhere.
[[nodiscard]] std::optional<Placement> snappedToPlane(const MirrorPlan& plan, const Primitive& primitive,
                                                      float tolerance);

}  // namespace sinew
