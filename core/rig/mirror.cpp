// core/rig/mirror.cpp: mirror images of placements and primitives.
#include "core/rig/mirror.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/character/bone_names.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/twins.h"

namespace sinew {
namespace {

constexpr double kTidy = 2e-7;  // Tolerance of maps that are permutations of axes with signs.

bool isFinite(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

glm::dmat4 reflectionMatrix(const MirrorPlane& plane) {
  glm::dmat4 m(1.0);
  const glm::dvec3& n = plane.normal;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) m[column][row] -= 2.0 * n[column] * n[row];
  }
  for (int row = 0; row < 3; ++row) m[3][row] = 2.0 * plane.offset * n[row];
  return m;
}

/// Rounds a map that is a permutation of axes with signs up to float precision.
void tidy(AffineMap& mirror) {
  glm::dmat3 rounded(0.0);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      rounded[column][row] = std::round(mirror.linear[column][row]);
      if (std::abs(rounded[column][row] - mirror.linear[column][row]) > kTidy) return;
    }
  }
  if (std::abs(std::abs(glm::determinant(rounded)) - 1.0) > 0.5) return;
  mirror.linear = rounded;
}

const Bone& boneAt(const MirrorPlan& plan, int bone) { return at(plan.skeleton.bones, bone); }

/// Whether equal ellipsoids have equal shapes: axis y and vectors of numbers along axes. @param allowed  world units
bool sameShape(const Placement& a, const Placement& b, const glm::dmat3& bone, double allowed) {
  if (a.shape.isPlain() && b.shape.isPlain()) return true;
  const auto axis = [&](const Placement& placement, int i) {
    return bone * glm::mat3_cast(glm::dquat(placement.rotation))[i] * static_cast<double>(placement.radii[i]);
  };
  const glm::dvec3 alongA = axis(a, 1);
  const glm::dvec3 alongB = axis(b, 1);
  const double apart = std::min(glm::length(alongA - alongB), glm::length(alongA + alongB));
  return apart <= 4.0 * allowed && std::ranges::all_of(shapeKeys(), [&](std::span<const ShapeNumber> key) {
           glm::dvec3 between(0.0);
           for (const ShapeNumber& number : key) {
             if (number.axis == ShapeNumber::kNoAxis) continue;
             between += axis(a, number.axis) * static_cast<double>(number.of(a.shape)) -
                        axis(b, number.axis) * static_cast<double>(number.of(b.shape));
           }
           return glm::length(between) <= 2.0 * allowed;
         });
}

}  // namespace

glm::dvec3 reflected(const MirrorPlane& plane, const glm::dvec3& pointInWorld) {
  return pointInWorld - 2.0 * distanceTo(plane, pointInWorld) * plane.normal;
}

double distanceTo(const MirrorPlane& plane, const glm::dvec3& pointInWorld) {
  return glm::dot(plane.normal, pointInWorld) - plane.offset;
}

/// Exporters usually make twin bones mirror images along their own axes. Then the map is a permutation of axes with
/// signs, and is rounded so that the image of an image equals the original bit for bit (mirror.h, Canonical form).
std::optional<AffineMap> boneMirror(const glm::mat4& boneInBind, const glm::mat4& twinBoneInBind,
                                    const MirrorPlane& plane) {
  const glm::dmat4 bone(boneInBind);
  const glm::dmat4 twin(twinBoneInBind);
  if (!isFinite(bone) || !isFinite(twin)) return std::nullopt;
  if (isFlat(glm::dmat3(bone)) || isFlat(glm::dmat3(twin))) return std::nullopt;
  const glm::dmat4 map = glm::inverse(twin) * reflectionMatrix(plane) * bone;
  if (!isFinite(map)) return std::nullopt;
  AffineMap mirror{glm::dmat3(map), glm::dvec3(map[3])};
  tidy(mirror);
  // Drops offsets below the rounding of centers.
  const double reach = glm::length(glm::dvec3(boneInBind[3])) / glm::length(glm::dvec3(twinBoneInBind[0]));
  for (int i = 0; i < 3; ++i) {
    if (std::abs(mirror.offset[i]) < kTidy * reach) mirror.offset[i] = 0.0;
  }
  return mirror;
}

int MirrorPlan::pairCount() const {
  int pairs = 0;
  for (std::size_t i = 0; i < twinOf.size(); ++i) pairs += twinOf[i] > static_cast<int>(i) ? 1 : 0;
  return pairs;
}

int MirrorPlan::centerCount() const {
  int centers = 0;
  for (std::size_t i = 0; i < twinOf.size(); ++i) centers += twinOf[i] == static_cast<int>(i) ? 1 : 0;
  return centers;
}

Result<std::string> twinBone(const MirrorPlan& plan, const std::string& bone) {
  const std::optional<int> found = plan.skeleton.findBone(bone);
  if (!found) return errorAt("", "this character has no bone \"" + bone + '"');
  const int twin = at(plan.twinOf, *found);
  if (twin < 0) return errorAt("", "the bone \"" + bone + "\" has no counterpart on the other side");
  return plan.skeleton.fileName(twin);
}

std::string imageName(const MirrorPlan& plan, const std::string& name, const std::string& boneName) {
  const int bone = *plan.skeleton.findBone(boneName);
  const std::string& own = boneAt(plan, bone).name;
  const std::string& twin = boneAt(plan, at(plan.twinOf, bone)).name;
  if (own != twin && name.starts_with(own)) return twin + name.substr(own.size());
  return mirroredName(name).value_or(name);
}

Result<Primitive> mirroredPrimitive(const MirrorPlan& plan, const Primitive& primitive) {
  Result<std::string> bone = twinBone(plan, primitive.bone);
  if (!bone) return bone.error();
  Primitive image = primitive;
  image.mirror.clear();
  image.bone = std::move(bone).value();
  const int from = *plan.skeleton.findBone(primitive.bone);
  image.name = imageName(plan, primitive.name, primitive.bone);
  image.placement = imageOf(primitive.placement, *at(plan.mirrors, from));
  image.animated = mirroredAnimation(plan, primitive);
  if (image.territory) {
    for (std::string& name : *image.territory) {
      if (Result<std::string> twin = twinBone(plan, name)) name = std::move(twin).value();
    }
  }
  return image;
}

/// Compares a primitive with its image. Since an ellipsoid has many placements, it compares quadratic forms, the sums
/// of the outer products of half axes in the world, and then shapes.
bool liesInPlane(const MirrorPlan& plan, const Primitive& primitive, float tolerance) {
  const std::optional<int> bone = plan.skeleton.findBone(primitive.bone);
  if (!bone || at(plan.twinOf, *bone) != *bone) return false;
  const Placement image = imageOf(primitive.placement, *at(plan.mirrors, *bone));
  const glm::dmat4 bind(boneAt(plan, *bone).bindInWorld);
  const double allowed = static_cast<double>(tolerance) * static_cast<double>(plan.characterHeight);
  const auto form = [&](const Placement& placement) {
    const glm::dmat3 axes = glm::dmat3(bind) * glm::mat3_cast(glm::dquat(placement.rotation));
    glm::dmat3 sum(0.0);
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 axis = axes[i] * static_cast<double>(placement.radii[i]);
      sum += glm::outerProduct(axis, axis);
    }
    return sum;
  };
  const glm::dvec3 moved = glm::dmat3(bind) * glm::dvec3(image.center - primitive.placement.center);
  if (glm::length(moved) > 2.0 * allowed) return false;
  const glm::dmat3 a = form(primitive.placement);
  const glm::dmat3 b = form(image);
  const double widest = std::sqrt(a[0][0] + a[1][1] + a[2][2]);
  for (int i = 0; i < 3; ++i) {
    if (glm::length(a[i] - b[i]) > 4.0 * allowed * widest) return false;
  }
  return sameShape(primitive.placement, image, glm::dmat3(bind), allowed);
}

std::optional<Placement> snappedToPlane(const MirrorPlan& plan, const Primitive& primitive, float tolerance) {
  const std::optional<int> bone = plan.skeleton.findBone(primitive.bone);
  if (!bone || at(plan.twinOf, *bone) != *bone) return std::nullopt;
  const glm::dmat4 bind(boneAt(plan, *bone).bindInWorld);
  const glm::dvec3 center(bind * glm::dvec4(glm::dvec3(primitive.placement.center), 1.0));
  const double off = distanceTo(plan.plane, center);
  if (std::abs(off) > static_cast<double>(tolerance) * static_cast<double>(plan.characterHeight)) return std::nullopt;
  const glm::dmat3 linear(bind);
  const glm::dmat3 back = glm::inverse(linear);
  Placement snapped = primitive.placement;
  snapped.center = glm::vec3(glm::dvec3(snapped.center) - back * (off * plan.plane.normal));
  // The axis nearest to the plane's normal becomes the normal; the others lie in the plane.
  const glm::dvec3 across = glm::normalize(glm::transpose(linear) * plan.plane.normal);
  const glm::dmat3 axes = glm::mat3_cast(glm::dquat(primitive.placement.rotation));
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(glm::dot(axes[i], across)) > std::abs(glm::dot(axes[nearest], across))) nearest = i;
  }
  const int second = (nearest + 1) % 3;
  const int third = (nearest + 2) % 3;
  glm::dmat3 laid;
  laid[nearest] = glm::dot(axes[nearest], across) < 0.0 ? -across : across;
  laid[second] = glm::normalize(axes[second] - glm::dot(axes[second], laid[nearest]) * laid[nearest]);
  laid[third] = glm::cross(laid[nearest], laid[second]);
  snapped.rotation = glm::quat(glm::normalize(glm::quat_cast(laid)));
  for (const ShapeNumber& number : shapeNumbers()) {
    if (number.axis == nearest) number.member(snapped.shape) = 0.0f;
  }
  return snapped;
}

}  // namespace sinew
