// core/character/range_of_motion.cpp: finds the axes about which joints turn and writes the keys.
#include "core/character/range_of_motion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/character/bone_names.h"
#include "core/character/joint_roles.h"
#include "core/character/pose_override.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kRadians = kPi / 180.0f;
constexpr int kMotionFramesPerSecond = 30;
constexpr int kOneWayFrames = 30;
constexpr int kBothWaysFrames = 45;
constexpr float kPlaceTolerance = 0.02f;  ///< Between a twin and the mirror image, fraction of the skeleton's size.

// Movements by role -------------------------------------------------------------------------------------------------

enum class Way { kBend, kSide, kTwist };  ///< Towards the reference; outwards or upwards; about the bone itself.

struct Swing {
  Way way;
  float from, to;  ///< Degrees.
};

std::span<const Swing> swingsOf(JointRole role) {
  using enum Way;
  static constexpr Swing kTrunk[] = {{kBend, -20, 25}, {kSide, -20, 20}, {kTwist, -25, 25}};
  static constexpr Swing kNeck[] = {{kBend, -30, 35}, {kSide, -25, 25}, {kTwist, -45, 45}};
  static constexpr Swing kTail[] = {{kBend, -25, 25}, {kSide, -30, 30}};
  static constexpr Swing kCollar[] = {{kBend, -15, 20}, {kSide, -10, 25}};
  static constexpr Swing kShoulder[] = {{kBend, -40, 80}, {kSide, -50, 70}, {kTwist, -50, 50}};
  static constexpr Swing kElbow[] = {{kBend, 0, 130}};
  static constexpr Swing kWrist[] = {{kBend, -60, 60}, {kSide, -25, 25}};
  static constexpr Swing kHip[] = {{kBend, -30, 90}, {kSide, -15, 45}, {kTwist, -35, 35}};
  static constexpr Swing kKnee[] = {{kBend, 0, 120}};
  static constexpr Swing kAnkle[] = {{kBend, -45, 30}, {kSide, -20, 20}};
  static constexpr Swing kDigit[] = {{kBend, 0, 75}};
  static constexpr Swing kFree[] = {{kBend, -45, 45}, {kSide, -45, 45}, {kTwist, -45, 45}};
  static constexpr std::span<const Swing> kSwings[] = {{},     kTrunk, kNeck, kTail,  kCollar, kShoulder, kElbow,
                                                       kWrist, kHip,   kKnee, kAnkle, kDigit,  kFree};  // [JointRole]
  return kSwings[static_cast<std::size_t>(role)];
}

// The body ----------------------------------------------------------------------------------------------------------

struct Body {
  const Skeleton& skeleton;
  std::vector<JointRole> roles;
  std::vector<int> twinOf;
  glm::vec3 normal;  ///< Normal of the mirror plane.
  glm::vec3 left;    ///< The plane's normal, towards the left.
  glm::vec3 forward;
  std::vector<bool> moves;

  [[nodiscard]] const Bone& bone(int i) const { return at(skeleton.bones, i); }
  [[nodiscard]] glm::vec3 origin(int i) const { return glm::vec3(bone(i).bindInWorld[3]); }
  [[nodiscard]] JointRole role(int i) const { return at(roles, i); }
};

constexpr glm::vec3 kUp(0.0f, 1.0f, 0.0f);

/// Twins by place, across the plane through the first root normal to x: mirrored origins, parents twins or the same.
std::vector<int> twinsByPlace(const Skeleton& skeleton) {
  Bounds bounds;
  for (const Bone& bone : skeleton.bones) bounds.add(glm::vec3(bone.bindInWorld[3]));
  const std::size_t count = skeleton.bones.size();
  std::vector<int> twins(count, -1);
  if (count == 0) return twins;
  const float near = kPlaceTolerance * glm::length(bounds.extent());
  const float middle = skeleton.bones[0].bindInWorld[3].x;
  for (std::size_t i = 0; i < count; ++i) {
    if (twins[i] >= 0) continue;
    const Bone& bone = skeleton.bones[i];
    glm::vec3 mirrored(bone.bindInWorld[3]);
    if (std::abs(mirrored.x - middle) <= near) continue;
    mirrored.x = 2.0f * middle - mirrored.x;
    const int parentTwin = bone.parent >= 0 ? at(twins, bone.parent) : -1;
    const int wantedParent = parentTwin >= 0 ? parentTwin : bone.parent;
    for (std::size_t j = i + 1; j < count && twins[i] < 0; ++j) {
      const Bone& other = skeleton.bones[j];
      if (twins[j] >= 0 || other.parent != wantedParent) continue;
      if (glm::length(glm::vec3(other.bindInWorld[3]) - mirrored) > near) continue;
      twins[i] = static_cast<int>(j);
      twins[j] = static_cast<int>(i);
    }
  }
  return twins;
}

/// The normal or its negative, towards the left by names, else towards `known`.
glm::vec3 towardsLeft(const Skeleton& skeleton, const glm::vec3& normal, const std::optional<glm::vec3>& known) {
  double sum = 0.0;
  bool named = false;
  for (const Bone& bone : skeleton.bones) {
    const glm::dvec3 origin(glm::vec3(bone.bindInWorld[3]));
    const glm::dvec3 root(glm::vec3(skeleton.bones[0].bindInWorld[3]));
    const std::optional<Side> side = sideNamed(bone.name);
    if (!side) continue;
    named = true;
    sum += (*side == Side::kLeft ? 1.0 : -1.0) * glm::dot(origin - root, glm::dvec3(normal));
  }
  if (!named && known) sum = glm::dot(*known, normal);
  return sum < 0.0 ? -normal : normal;
}

/// Bones with a moving role that are no helpers.
std::vector<bool> movingBones(const Skeleton& skeleton, const std::vector<JointRole>& roles,
                              const std::vector<bool>& carriesSkin) {
  std::vector<bool> moves = bonesThatMoveSkin(skeleton, carriesSkin);
  for (std::size_t i = 0; i < moves.size(); ++i) moves[i] = moves[i] && roles[i] != JointRole::kStill;
  return moves;
}

Body bodyOf(const Skeleton& skeleton, const RangeOfMotionHints& hints) {
  const bool paired = hints.twinOf.size() == skeleton.bones.size();
  Body body{skeleton,
            jointRoles(skeleton, hints.parts),
            paired ? hints.twinOf : twinsByPlace(skeleton),
            paired ? normalizeOr(hints.planeNormal, {1, 0, 0}) : glm::vec3(1, 0, 0),
            {},
            {},
            {}};
  // An end moves if skin follows it.
  for (std::size_t i = 0; i < hints.carriesSkin.size() && i < body.roles.size(); ++i) {
    const bool end = body.roles[i] == JointRole::kStill && skeleton.bones[i].children.empty();
    if (end && hints.carriesSkin[i] && skeleton.bones[i].parent >= 0) body.roles[i] = JointRole::kFree;
  }
  const bool level = std::abs(body.normal.y) < 0.5f;
  body.left = level ? towardsLeft(skeleton, body.normal, hints.left) : glm::vec3(1, 0, 0);
  body.forward = normalizeOr(glm::cross(body.left, kUp), {0, 0, 1});
  body.moves = movingBones(skeleton, body.roles, hints.carriesSkin);
  return body;
}

// Axes --------------------------------------------------------------------------------------------------------------

/// Axes of a joint's movements, world, bind pose.
struct Axes {
  glm::vec3 bend, side, twist;
};

/// Direction of a bone to its tip, else that of its parent.
glm::vec3 directionOf(const Body& body, int bone) {
  for (int i = bone; i >= 0; i = body.bone(i).parent) {
    const glm::vec3 along = glm::mat3(body.bone(i).bindInWorld) * body.bone(i).tip;
    if (const glm::vec3 unit = normalizeOr(along, glm::vec3(0.0f)); unit != glm::vec3(0.0f)) return unit;
  }
  return kUp;
}

/// Direction towards which a joint bends; another one if the bone already points there.
glm::vec3 referenceOf(const Body& body, JointRole role, const glm::vec3& along, float side) {
  glm::vec3 first = body.forward;
  glm::vec3 second = kUp;
  switch (role) {
    case JointRole::kKnee:
      first = -body.forward;
      second = -kUp;
      break;
    case JointRole::kWrist:
    case JointRole::kAnkle:
    case JointRole::kTail:
      first = kUp;
      second = body.forward;
      break;
    case JointRole::kDigit:
      first = -kUp;
      second = -side * body.left;
      break;
    default:
      break;
  }
  return std::abs(glm::dot(first, along)) < 0.9f ? first : second;
}

Axes axesOf(const Body& body, int bone) {
  const JointRole role = body.role(bone);
  const glm::vec3 along = directionOf(body, bone);
  const int parent = body.bone(bone).parent;
  const float outward = glm::dot(body.origin(bone) - body.origin(0), body.left);
  const float side = outward < 0.0f ? -1.0f : 1.0f;
  Axes axes;
  axes.twist = along;
  axes.bend = normalizeOr(glm::cross(along, referenceOf(body, role, along, side)), body.left);
  if ((role == JointRole::kElbow || role == JointRole::kKnee) && parent >= 0) {
    // A limb that is bent in the bind pose bends further in its own plane.
    const glm::vec3 before = normalizeOr(body.origin(bone) - body.origin(parent), along);
    const glm::vec3 natural = glm::cross(before, along);
    const float sine = glm::length(natural);
    if (sine > 0.17f && glm::dot(natural, axes.bend) > 0.5f * sine) axes.bend = natural / sine;
  }
  axes.side = side * glm::cross(axes.bend, along);
  if (role == JointRole::kKnee) axes.side = -axes.side;
  return axes;
}

// The script --------------------------------------------------------------------------------------------------------

JointMovement movementOf(const Body& body, int bone, const Swing& swing) {
  const Axes axes = axesOf(body, bone);
  const glm::vec3 inWorld = swing.way == Way::kBend ? axes.bend : (swing.way == Way::kSide ? axes.side : axes.twist);
  const glm::mat3 frame = turnFrame(body.bone(bone).bindInWorld);
  glm::vec3 axis = glm::transpose(frame) * inWorld;
  if (glm::determinant(frame) < 0.0f) axis = -axis;  // A mirrored frame reverses rotations.
  return {bone, normalizeOr(axis, {1, 0, 0}), swing.from * kRadians, swing.to * kRadians};
}

JointMovement mirrored(const Body& body, const JointMovement& movement, int twin) {
  const glm::quat turn = glm::angleAxis(1.0f, movement.axis);
  const glm::quat other = mirroredTurn(turn, body.bone(movement.bone), body.bone(twin), body.normal);
  return {twin, normalizeOr(glm::vec3(other.x, other.y, other.z), movement.axis), movement.from, movement.to};
}

/// Joints that move together: the bone and its twin, all digits, or the whole tail.
std::vector<int> companions(const Body& body, int bone) {
  const JointRole role = body.role(bone);
  const int twin = at(body.twinOf, bone);
  std::vector<int> group{bone};
  for (int i = 0; i < static_cast<int>(body.roles.size()); ++i) {
    const bool together = (role == JointRole::kDigit || role == JointRole::kTail) && body.role(i) == role;
    if (i != bone && at(body.moves, i) && (together || i == twin)) group.push_back(i);
  }
  return group;
}

MovementStep stepOf(const Body& body, std::span<const int> group, const Swing& swing) {
  MovementStep step;
  for (const int bone : group) {
    const int twin = at(body.twinOf, bone);
    const auto first = std::ranges::find(step, twin, &JointMovement::bone);
    if (twin != bone && first != step.end()) step.push_back(mirrored(body, *first, bone));
    else step.push_back(movementOf(body, bone, swing));
  }
  return step;
}

// The clip ----------------------------------------------------------------------------------------------------------

/// Angle at a fraction of a step: to `to`, back, to `from` and back; or to the only one that is not 0 and back. At rest
/// at both ends and wherever it reverses.
float angleAt(const JointMovement& movement, float share) {
  const auto hump = [](float u) { return 0.5f - 0.5f * std::cos(2.0f * kPi * u); };
  if (movement.from == 0.0f) return movement.to * hump(share);
  if (movement.to == 0.0f) return movement.from * hump(share);
  return share < 0.5f ? movement.to * hump(2.0f * share) : movement.from * hump(2.0f * share - 1.0f);
}

int framesOf(const MovementStep& step) {
  const bool bothWays = std::ranges::any_of(step, [](const auto& m) { return m.from < 0.0f && m.to > 0.0f; });
  return bothWays ? kBothWaysFrames : kOneWayFrames;
}

void addKeys(Channel& channel, const JointMovement& movement, int begin, int frames) {
  for (int i = 0; i <= frames; ++i) {
    const float time = static_cast<float>(begin + i) / kMotionFramesPerSecond;
    if (!channel.times.empty() && channel.times.back() >= time) continue;
    const bool ends = i == 0 || i == frames;
    const float angle = ends ? 0.0f : angleAt(movement, static_cast<float>(i) / static_cast<float>(frames));
    const glm::quat q = glm::angleAxis(angle, movement.axis);
    channel.times.push_back(time);
    channel.values.push_back(ends ? glm::vec4(0, 0, 0, 1) : glm::vec4(q.x, q.y, q.z, q.w));
  }
}

}  // namespace

/// Roles of joints (joint_roles.h) give the movements. Axes follow from the places of bones and the direction in which
/// the character faces, not from the joints' own axes, which every exporter sets differently. Twins move together, the
/// second as the mirror image of the first.
std::vector<MovementStep> rangeOfMotionSteps(const Skeleton& skeleton, const RangeOfMotionHints& hints) {
  std::vector<MovementStep> steps;
  if (skeleton.bones.empty()) return steps;
  const Body body = bodyOf(skeleton, hints);
  std::vector<bool> done(skeleton.bones.size(), false);
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    if (done[i] || !body.moves[i]) continue;
    const std::vector<int> group = companions(body, static_cast<int>(i));
    for (const int bone : group) at(done, bone) = true;
    for (const Swing& swing : swingsOf(body.roles[i])) steps.push_back(stepOf(body, group, swing));
  }
  return steps;
}

AnimationClip rangeOfMotion(const Skeleton& skeleton, const RangeOfMotionHints& hints) {
  AnimationClip clip;
  clip.name = kRangeOfMotionName;
  clip.turnsBindPose = true;
  std::map<int, Channel> channels;  // By bone.
  int frame = 0;
  for (const MovementStep& step : rangeOfMotionSteps(skeleton, hints)) {
    const int frames = framesOf(step);
    for (const JointMovement& movement : step) {
      Channel& channel = channels[movement.bone];
      channel.node = at(skeleton.bones, movement.bone).node;
      channel.path = ChannelPath::kRotation;
      addKeys(channel, movement, frame, frames);
    }
    frame += frames;
  }
  for (auto& [bone, channel] : channels) clip.channels.push_back(std::move(channel));
  clip.duration = static_cast<float>(frame) / kMotionFramesPerSecond;
  return clip;
}

}  // namespace sinew
