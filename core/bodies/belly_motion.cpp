// core/bodies/belly_motion.cpp: points of a belly in the frames of the skin over them.
#include "core/bodies/belly_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/bodies/check.h"
#include "core/character/bone_segments.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr std::array<float, FollowedBelly::kPoints> kAlong{0.0f, -0.6f, 0.6f};  ///< Of half the length.
constexpr float kMoreThanInBind = 1.3f;
constexpr float kLeastSine = 0.3f;  ///< Between belly and skin's normal: steeper bellies have no side.

/// Half the extent along a unit direction, where it is `along` of half the length from the middle.
float extentOf(const BellyBody& body, const glm::vec3& direction, float along) {
  return std::sqrt(1.0f - along * along) * glm::length(glm::transpose(body.axes) * direction);
}

/// The skin's normal, made square to the belly's length: what stands under a tilted skin is not higher for it.
glm::vec3 heightUnder(const SkinFrame& skin, const glm::vec3& along) {
  const glm::vec3 height = skin.normal() - glm::dot(skin.normal(), along) * along;
  const float sine = glm::length(height);
  return sine > kLeastSine ? height / sine : skin.normal();
}

int longestAxis(const BellyBody& body) {
  int longest = 1;
  for (const int axis : {0, 2}) {
    if (glm::length(body.axes[axis]) > 1.001f * glm::length(body.axes[longest])) longest = axis;
  }
  return longest;
}

}  // namespace

BellyBody bellyBody(const PosedMuscle& muscle) {
  const Placement& placement = muscle.body.placement;
  glm::mat3 axes = glm::mat3(muscle.body.carrier) * glm::mat3_cast(placement.rotation);
  for (int i = 0; i < 3; ++i) axes[i] *= placement.radii[i];
  return {glm::vec3(muscle.body.carrier * glm::vec4(placement.center, 1.0f)), axes};
}

std::optional<FollowedBelly> FollowedBelly::create(const Character& character, const SkinRuns& outer,
                                                   const PosedMuscle& bind, int bone) {
  if (!bind.usable) return std::nullopt;
  const BellyBody body = bellyBody(bind);
  const Segment axis = bindSegment(at(character.skeleton.bones, bone));
  const glm::vec3 away = body.center - axis.nearest(body.center);
  const float distance = glm::length(away);
  if (!(distance > 0.0f)) return std::nullopt;
  const glm::vec3 outwards = away / distance;
  FollowedBelly out;
  out.long_ = longestAxis(body);
  const Pose pose = bindPose(character.skeleton);
  const glm::vec3 along = glm::normalize(body.axes[out.long_]);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const glm::vec3 point = body.center + kAlong[i] * body.axes[out.long_];
    const auto spot = spotOver(outer, point + extentOf(body, outwards, kAlong[i]) * outwards, outwards);
    const auto skin = spot ? frameAt(character, *spot, pose) : std::nullopt;
    if (!skin) return std::nullopt;
    const glm::vec3 inSkin = glm::transpose(skin->axes) * (point - skin->origin);
    const glm::vec3 height = heightUnder(*skin, along);
    out.spots_[i] = *spot;
    out.points_[i] = {inSkin, glm::dot(point - skin->origin, height) - extentOf(body, height, kAlong[i])};
    if (i == 0) out.ball_ = extentOf(body, height, 0.0f) / glm::length(body.axes[out.long_]);
  }
  return out;
}

float FollowedBelly::mostBall() const { return std::max(kMostBall, kMoreThanInBind * ball_); }

BellyMotion FollowedBelly::motion(const PosedMuscle& muscle, std::span<const std::optional<SkinFrame>> frames) const {
  if (!muscle.usable) return {};
  const BellyBody body = bellyBody(muscle);
  // Bent muscles are laid with y along their line (core/rig/posed_rig.h).
  const glm::vec3 half = body.axes[muscle.isBent ? 1 : long_];
  const float length = glm::length(half);
  BellyMotion motion;
  const std::size_t counted = muscle.line >= 0 ? kPoints : 1;
  for (std::size_t i = 0; i < counted; ++i) {
    if (!frames[i] || !(length > 0.0f)) continue;
    const SkinFrame& skin = *frames[i];
    const glm::vec3 now = body.center + kAlong[i] * half;
    const glm::vec3 height = heightUnder(skin, half / length);
    const float extent = extentOf(body, height, kAlong[i]);
    if (!(extent > 0.0f)) continue;
    if (i == 0) motion.ball = extent / length;
    const float under = glm::dot(now - skin.origin, height) - extent;
    motion.out = std::max(motion.out, (under - points_[i].under) / (2.0f * extent));
    // Along its line a belly may slide: that is how it shortens.
    const glm::vec3 side = glm::cross(height, half / length);
    const glm::vec3 moved = now - (skin.origin + skin.axes * points_[i].inSkin);
    const float width = extentOf(body, side, kAlong[i]);
    if (width > 0.0f) motion.beside = std::max(motion.beside, std::abs(glm::dot(moved, side)) / width);
  }
  return motion;
}

// The worst of all poses.

namespace {

Rig rigOf(const BellyChoice& choice, const SurfaceSettings& surface) {
  Rig alone;
  alone.surface = surface;
  alone.primitives = {choice.primitive};
  alone.primitives[0].animated.clear();
  if (choice.line) alone.lines = {*choice.line};
  for (MuscleLine& line : alone.lines) line.animated.clear();
  return alone;
}

}  // namespace

Trouble troubleOf(const FollowedBelly& belly, const BellyMotion& motion, const PosedLine& line, float share) {
  const float stretch = std::max(line.stretch / kMostStretch, kLeastStretch / std::max(line.stretch, 1e-6f));
  return {std::max({share * motion.out / kMostOut, share * motion.beside / kMostBeside, stretch}),
          share * motion.ball / belly.mostBall()};
}

BellyTrial::BellyTrial(const BellyChoice& choice, const SurfaceSettings& surface, const Motions& motions)
    : motions_(motions), poser_(rigOf(choice, surface), motions.character()) {
  const Character& character = motions.character();
  const auto bone = character.skeleton.findBone(choice.primitive.bone);
  if (!bone) return;
  const PosedRig bind = poser_.pose(bindPose(character.skeleton));
  belly_ = FollowedBelly::create(character, motions.skin(), bind.muscles[0], *bone);
  body_ = bellyBody(bind.muscles[0]);
}

glm::vec3 BellyTrial::outwards() const {
  const Character& character = motions_.character();
  const auto frame = frameAt(character, spot(), bindPose(character.skeleton));
  return frame ? frame->normal() : glm::vec3(0.0f);
}

float BellyTrial::trouble(float enough, std::size_t* first) const {
  constexpr std::size_t kPoints = FollowedBelly::kPoints;
  const Character& character = motions_.character();
  std::array<std::optional<SkinFrame>, kPoints> frames;
  PosedRig posed;
  float worst = 0.0f;
  const std::size_t count = motions_.poses().size();
  const std::size_t begin = first != nullptr ? *first : 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (begin + k) % count;
    if (worst > enough) break;
    if (first != nullptr) *first = i;
    const Pose& pose = motions_.poses()[i];
    poser_.pose(pose, posed);
    for (std::size_t s = 0; s < kPoints; ++s) frames[s] = frameAt(character, belly_->spots()[s], pose);
    const BellyMotion motion = belly_->motion(posed.muscles[0], frames);
    const float share = motions_.shareOf(i);
    worst = std::max(worst, share * motion.out / kMostOut);
    if (posed.lines.empty() || !posed.lines[0].usable) continue;
    worst = std::max(worst, troubleOf(*belly_, motion, posed.lines[0], share).worst());
  }
  return worst;
}

}  // namespace sinew
