// core/symmetry/mirror.cpp: what a plane makes of a placement, and of a primitive.
#include "core/symmetry/mirror.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/skeleton/side_names.h"

namespace sinew {
namespace {

constexpr double kTidy = 2e-7;     // Of a map's size: what differs less from a permutation of axes is one.
constexpr double kEven = 1e-6;     // Lengths and angles that differ less are equal: below what a float file can say.
constexpr double kFlat = 1e-9;     // |det| of unit columns below which a bone is flattened.
constexpr int kJacobiSweeps = 40;  // Of at most about eight that are needed.

bool isFinite(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

bool isFlattened(const glm::dmat3& m) {
  const double lengths = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
  return !(std::abs(glm::determinant(m)) > kFlat * lengths);
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

/// Rounds what is a permutation of axes with signs, but for the digits a file of floats loses, to exactly that.
void tidy(BoneMirror& mirror) {
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

// The canonical rotation ------------------------------------------------------------------------------------------

/// Rotation of the image, for `axes` = mirror * rotation of improper orthogonal columns: some axes must be turned
/// round, all three or one. Which, is said by the map itself, so that the map and its inverse agree.
glm::dquat properRotation(const glm::dmat3& linear, const glm::dquat& rotation) {
  // p = -linear as a rotation; near the unit quaternion: all three are turned round, near i, j or k: that axis.
  const glm::dquat p = glm::normalize(glm::quat_cast(-linear));
  const std::array<double, 4> parts{p.w, p.x, p.y, p.z};
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (std::abs(parts[i]) > std::abs(parts[largest]) + 1e-3) largest = i;
  }
  glm::dquat turned(0.0, 0.0, 0.0, 0.0);
  (largest == 0 ? turned.w : (largest == 1 ? turned.x : (largest == 2 ? turned.y : turned.z))) = 1.0;
  glm::dquat image = p * rotation * turned;
  // The identity's image has w > 0; so the way back undoes the sign as well.
  const double identityW = (p * turned).w;
  return identityW < 0.0 ? -image : image;
}

/// Cyclic one-sided Jacobi: turns the columns until they stand at right angles. Columns that already do stay.
void orthogonalise(glm::dmat3& columns) {
  for (int sweep = 0; sweep < kJacobiSweeps; ++sweep) {
    bool still = true;
    for (const auto& [a, b] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      const glm::dvec3 u = columns[a];
      const glm::dvec3 v = columns[b];
      const double inner = glm::dot(u, v);
      if (std::abs(inner) <= (sweep == 0 ? kEven : 1e-14) * glm::length(u) * glm::length(v)) continue;
      still = false;
      const double zeta = (glm::dot(v, v) - glm::dot(u, u)) / (2.0 * inner);
      const double t = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1.0 + zeta * zeta));
      const double c = 1.0 / std::sqrt(1.0 + t * t);
      columns[a] = c * (u - t * v);
      columns[b] = c * (v + t * u);
    }
    if (still) return;
  }
}

/// The linear part is a turn-over with even scale: lengths and angles of its columns, within what floats can say.
std::optional<double> evenScale(const glm::dmat3& m) {
  const double scale = std::cbrt(std::abs(glm::determinant(m)));
  for (int i = 0; i < 3; ++i) {
    if (std::abs(glm::length(m[i]) / scale - 1.0) > kEven) return std::nullopt;
    if (std::abs(glm::dot(m[i], m[(i + 1) % 3])) > kEven * scale * scale) return std::nullopt;
  }
  return std::abs(scale - 1.0) <= kEven ? 1.0 : scale;
}

/// Any affine map: the principal axes of the image, each nearest to the image of the axis of its number.
void placeByAxes(const Placement& from, const glm::dmat3& linear, Placement& image) {
  const glm::dmat3 axes = linear * glm::mat3_cast(glm::normalize(glm::dquat(from.rotation)));
  glm::dmat3 columns;
  for (int i = 0; i < 3; ++i) columns[i] = axes[i] * static_cast<double>(from.radii[i]);
  orthogonalise(columns);
  glm::dmat3 unit;
  for (int i = 0; i < 3; ++i) {
    const double length = glm::length(columns[i]);
    unit[i] = columns[i] / length;
    image.radii[i] = static_cast<float>(length);
  }
  // Columns of negative determinant are an improper map of the identity's axes.
  const bool improper = glm::determinant(unit) < 0.0;
  if (!improper) {
    image.rotation = glm::quat(glm::normalize(glm::quat_cast(unit)));
    return;
  }
  const glm::dmat3 start = glm::mat3_cast(glm::normalize(glm::dquat(from.rotation)));
  image.rotation = glm::quat(
      glm::normalize(properRotation(unit * glm::transpose(start), glm::normalize(glm::dquat(from.rotation)))));
}

const Bone& boneAt(const MirrorPlan& plan, int bone) { return plan.skeleton.bones[static_cast<std::size_t>(bone)]; }

/// A name that begins with its bone's takes the other bone's; else by the side it says.
std::string imageName(const MirrorPlan& plan, const std::string& name, int bone) {
  const std::string& own = boneAt(plan, bone).name;
  const std::string& twin = boneAt(plan, plan.twinOf[static_cast<std::size_t>(bone)]).name;
  if (own != twin && name.starts_with(own)) return twin + name.substr(own.size());
  return mirroredName(name).value_or(name);
}

}  // namespace

glm::dvec3 reflected(const MirrorPlane& plane, const glm::dvec3& pointInWorld) {
  return pointInWorld - 2.0 * distanceTo(plane, pointInWorld) * plane.normal;
}

double distanceTo(const MirrorPlane& plane, const glm::dvec3& pointInWorld) {
  return glm::dot(plane.normal, pointInWorld) - plane.offset;
}

std::optional<BoneMirror> boneMirror(const glm::mat4& boneInBind, const glm::mat4& twinBoneInBind,
                                     const MirrorPlane& plane) {
  const glm::dmat4 bone(boneInBind);
  const glm::dmat4 twin(twinBoneInBind);
  if (!isFinite(bone) || !isFinite(twin)) return std::nullopt;
  if (isFlattened(glm::dmat3(bone)) || isFlattened(glm::dmat3(twin))) return std::nullopt;
  const glm::dmat4 map = glm::inverse(twin) * reflectionMatrix(plane) * bone;
  if (!isFinite(map)) return std::nullopt;
  BoneMirror mirror{glm::dmat3(map), glm::dvec3(map[3])};
  tidy(mirror);
  // A centre that a tidy map moves by less than its own rounding is not moved.
  const double reach = glm::length(glm::dvec3(boneInBind[3])) / glm::length(glm::dvec3(twinBoneInBind[0]));
  for (int i = 0; i < 3; ++i) {
    if (std::abs(mirror.offset[i]) < kTidy * reach) mirror.offset[i] = 0.0;
  }
  return mirror;
}

Placement mirroredPlacement(const Placement& inBone, const BoneMirror& mirror) {
  Placement image;
  image.center = glm::vec3(mirror.linear * glm::dvec3(inBone.center) + mirror.offset);
  image.radii = inBone.radii;
  const std::optional<double> scale = evenScale(mirror.linear);
  if (!scale) {
    placeByAxes(inBone, mirror.linear, image);
    return image;
  }
  if (*scale != 1.0) image.radii = glm::vec3(glm::dvec3(inBone.radii) * *scale);
  const glm::dquat rotation(inBone.rotation);
  const glm::dmat3 turn = mirror.linear / *scale;
  // A bone that is itself mirrored against its twin turns nothing over.
  image.rotation = glm::quat(glm::determinant(turn) < 0.0 ? properRotation(turn, rotation)
                                                          : glm::normalize(glm::quat_cast(turn)) * rotation);
  return image;
}

Placement mirroredPlacement(const Placement& inBone, const glm::mat4& boneInBind, const glm::mat4& twinBoneInBind,
                            const MirrorPlane& plane) {
  const std::optional<BoneMirror> mirror = boneMirror(boneInBind, twinBoneInBind, plane);
  return mirror ? mirroredPlacement(inBone, *mirror) : inBone;
}

int MirrorPlan::pairCount() const {
  int pairs = 0;
  for (std::size_t i = 0; i < twinOf.size(); ++i) pairs += twinOf[i] > static_cast<int>(i) ? 1 : 0;
  return pairs;
}

int MirrorPlan::centreCount() const {
  int centres = 0;
  for (std::size_t i = 0; i < twinOf.size(); ++i) centres += twinOf[i] == static_cast<int>(i) ? 1 : 0;
  return centres;
}

Result<std::string> twinBone(const MirrorPlan& plan, const std::string& bone) {
  const std::optional<int> found = plan.skeleton.findBone(bone);
  if (!found) return errorAt("", "this character has no bone \"" + bone + '"');
  const int twin = plan.twinOf[static_cast<std::size_t>(*found)];
  if (twin < 0) return errorAt("", "the bone \"" + bone + "\" has no counterpart on the other side");
  return plan.skeleton.fileName(twin);
}

Result<Primitive> mirroredPrimitive(const MirrorPlan& plan, const Primitive& primitive) {
  Result<std::string> bone = twinBone(plan, primitive.bone);
  if (!bone) return bone.error();
  Primitive image = primitive;
  image.mirror.clear();
  image.bone = std::move(bone).value();
  const int from = *plan.skeleton.findBone(primitive.bone);
  image.name = imageName(plan, primitive.name, from);
  image.placement = mirroredPlacement(primitive.placement, *plan.mirrors[static_cast<std::size_t>(from)]);
  if (image.territory) {
    for (std::string& name : *image.territory) {
      if (Result<std::string> twin = twinBone(plan, name)) name = std::move(twin).value();
    }
  }
  return image;
}

bool liesInPlane(const MirrorPlan& plan, const Primitive& primitive, float tolerance) {
  const std::optional<int> bone = plan.skeleton.findBone(primitive.bone);
  if (!bone || plan.twinOf[static_cast<std::size_t>(*bone)] != *bone) return false;
  const Placement image = mirroredPlacement(primitive.placement, *plan.mirrors[static_cast<std::size_t>(*bone)]);
  // Two ellipsoids are equal if their quadratic forms are: six points of one against the other's half widths.
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
  return true;
}

std::optional<Placement> snappedToPlane(const MirrorPlan& plan, const Primitive& primitive, float tolerance) {
  const std::optional<int> bone = plan.skeleton.findBone(primitive.bone);
  if (!bone || plan.twinOf[static_cast<std::size_t>(*bone)] != *bone) return std::nullopt;
  const glm::dmat4 bind(boneAt(plan, *bone).bindInWorld);
  const glm::dvec3 center(bind * glm::dvec4(glm::dvec3(primitive.placement.center), 1.0));
  const double off = distanceTo(plan.plane, center);
  if (std::abs(off) > static_cast<double>(tolerance) * static_cast<double>(plan.characterHeight)) return std::nullopt;
  const glm::dmat3 linear(bind);
  const glm::dmat3 back = glm::inverse(linear);
  Placement snapped = primitive.placement;
  snapped.center = glm::vec3(glm::dvec3(snapped.center) - back * (off * plan.plane.normal));
  // The axis nearest to the plane's normal is laid across the plane, the longer of the others into it.
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
  return snapped;
}

}  // namespace sinew
