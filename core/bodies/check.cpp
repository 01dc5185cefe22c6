// core/bodies/check.cpp: measures every muscle in every pose and keeps the worst of each kind.
#include "core/bodies/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/character/bindings.h"
#include "core/character/bone_segments.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/rig/attachment.h"

namespace sinew {

namespace {

constexpr std::array<float, FollowedBelly::kPoints> kAlong{0.0f, -0.6f, 0.6f};  ///< Fractions of half the length.
constexpr float kMoreThanInBind = 1.3f;
constexpr float kLeastSine = 0.3f;  ///< Of the angle between belly and skin normal; steeper bellies have no side.

/// Half the extent in a unit direction of the cross section at `along` of half the length.
float extentOf(const BellyBody& body, const glm::vec3& direction, float along) {
  return std::sqrt(1.0f - along * along) * glm::length(glm::transpose(body.axes) * direction);
}

/// The skin's normal, made perpendicular to the belly, so that tilted skin does not make it higher.
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
    // Sliding along the line does not count: bellies do so when they shorten.
    const glm::vec3 side = glm::cross(height, half / length);
    const glm::vec3 moved = now - (skin.origin + skin.axes * points_[i].inSkin);
    const float width = extentOf(body, side, kAlong[i]);
    if (width > 0.0f) motion.beside = std::max(motion.beside, std::abs(glm::dot(moved, side)) / width);
  }
  return motion;
}

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

namespace {

constexpr std::size_t kFarBones = 4;  ///< Bones from one to the other, both included: three joints away.

/// The largest weighted measure and its pose; the first of equal ones.
struct Worst {
  float counted = 0.0f;  ///< `value` times its weight.
  float value = 0.0f;
  int pose = -1;

  void take(float other, int at, float share = 1.0f) {
    if (!(other * share > counted)) return;
    counted = other * share;
    value = other;
    pose = at;
  }
};

/// Extremes of a muscle's line and belly.
struct Deeds {
  Worst out;
  Worst beside;
  Worst ball;  ///< Over its limit.
  float mostBall = 1.0f;
  Worst shrunk;  ///< 1 / stretch.
  Worst stretched;
};

/// Skin in a muscle's territory that the muscle should not reach.
struct FarSkin {
  int vertex = 0;
  int bone = 0;
};

/// Only territories set in the rig can have any: the default has only bones next to the muscle's.
std::vector<FarSkin> farSkin(const Rig& rig, const Primitive& primitive, const Character& character) {
  std::vector<FarSkin> out;
  const Skeleton& skeleton = character.skeleton;
  if (!primitive.territory) return out;
  std::vector<int> own;
  if (const auto bone = skeleton.findBone(primitive.bone)) own.push_back(*bone);
  if (const int line = findLine(rig, primitive.line); line >= 0) {
    for (const LineAnchor* anchor : {&at(rig.lines, line).origin, &at(rig.lines, line).insertion}) {
      if (const auto bone = skeleton.findBone(anchor->bone)) own.push_back(*bone);
    }
  }
  if (const int sheet = findSheet(rig, primitive.sheet); sheet >= 0) {
    for (const SheetEdge& edge : at(rig.sheets, sheet).edges) {
      for (const LineAnchor& point : edge.points) {
        if (const auto bone = skeleton.findBone(point.bone)) own.push_back(*bone);
      }
    }
  }
  std::vector<bool> isFar(skeleton.bones.size(), false);
  for (const std::string& name : *primitive.territory) {
    const auto bone = skeleton.findBone(name);
    if (!bone) continue;
    isFar[toIndex(*bone)] =
        std::ranges::all_of(own, [&](int from) { return bonesBetween(skeleton, from, *bone).size() >= kFarBones; });
  }
  for (int v = 0; v < static_cast<int>(character.mesh.positions.size()); ++v) {
    if (character.mesh.influencesOf(v).empty()) continue;
    const int bone = strongestBone(character, v);
    if (isFar[toIndex(bone)]) out.push_back({v, bone});
  }
  return out;
}

/// Both are bellies of the same strip: "name 1.1", "name 1.2".
bool inOneStrip(const Primitive& a, const Primitive& b) {
  if (a.sheet.empty() || a.sheet != b.sheet) return false;
  return a.name.substr(0, a.name.rfind('.')) == b.name.substr(0, b.name.rfind('.'));
}

class Checker {
 public:
  Checker(const Rig& rig, const Motions& motions)
      : rig_(rig), motions_(motions), poser_(rig, motions.character()), posed_(motions.poses().size()) {
    const std::span<const Pose> poses = motions.poses();
    forRanges(poses.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) poser_.pose(poses[i], posed_[i]);
    });
    bind_ = poser_.pose(bindPose(motions.character().skeleton));
  }

  std::vector<Finding> run() {
    const std::vector<std::vector<int>> muscles = judgedTogether();
    std::vector<std::vector<Finding>> found(muscles.size());
    forEachIndex(found.size(), 1, [&](std::size_t i) {
      if (at(rig_.primitives, muscles[i].front()).sign > 0) found[i] = findingsOf(muscles[i]);
    });
    std::vector<Finding> out;
    for (auto& own : found) std::ranges::move(own, std::back_inserter(out));
    return out;
  }

 private:
  /// Bellies of one strip of a sheet are one muscle; any other is one by itself. In the rig's order.
  std::vector<std::vector<int>> judgedTogether() const {
    std::vector<std::vector<int>> muscles;
    for (int i = 0; i < static_cast<int>(rig_.primitives.size()); ++i) {
      const int before = i - 1;
      if (before >= 0 && !muscles.empty() && inOneStrip(at(rig_.primitives, before), at(rig_.primitives, i))) {
        muscles.back().push_back(i);
      } else {
        muscles.push_back({i});
      }
    }
    return muscles;
  }

  std::vector<Finding> findingsOf(std::span<const int> bellies) const {
    std::vector<Finding> out;
    const int primitive = bellies.front();
    const Deeds deeds = deedsOf(bellies);
    const auto add = [&](FindingKind kind, const Worst& worst, float measure, std::string bone = {}) {
      Finding finding{kind, primitive, {}, 0.0f, measure, std::move(bone)};
      if (worst.pose >= 0) {
        const Pose& pose = motions_.poses()[toIndex(worst.pose)];
        finding.clip = pose.clip;
        finding.time = pose.time;
      }
      out.push_back(std::move(finding));
    };
    if (deeds.out.counted > kMostOut) add(FindingKind::kComesOut, deeds.out, deeds.out.value);
    if (deeds.beside.counted > kMostBeside) add(FindingKind::kSlidesOff, deeds.beside, deeds.beside.value);
    if (deeds.ball.counted > 1.0f) add(FindingKind::kBall, deeds.ball, deeds.ball.value * deeds.mostBall);
    if (deeds.shrunk.value > 1.0f / kLeastStretch) add(FindingKind::kTooShort, deeds.shrunk, 1.0f / deeds.shrunk.value);
    if (deeds.stretched.value > kMostStretch) add(FindingKind::kTooLong, deeds.stretched, deeds.stretched.value);
    if (const auto across = reachAcross(primitive)) {
      const std::string& bone = motions_.character().skeleton.fileName(across->second);
      add(FindingKind::kReachesAcross, across->first, across->first.value, bone);
    }
    return out;
  }

  /// A belly with the skin over it in all poses.
  struct Followed {
    int primitive = 0;
    FollowedBelly belly;
    std::vector<std::optional<SkinFrame>> frames;  ///< [poses * kPoints]
  };

  std::vector<Followed> follow(std::span<const int> bellies) const {
    std::vector<Followed> followed;
    for (const int primitive : bellies) {
      const auto bone = motions_.character().skeleton.findBone(at(rig_.primitives, primitive).bone);
      if (!bone) continue;
      auto belly = FollowedBelly::create(motions_.character(), motions_.skin(), at(bind_.muscles, primitive), *bone);
      if (!belly) continue;
      std::vector<std::optional<SkinFrame>> frames = motions_.framesOf(belly->spots());
      followed.push_back({primitive, *belly, std::move(frames)});
    }
    return followed;
  }

  /// The mean of a strip's bellies, which hold each other; sideways of the sheet's width; the height of the highest
  /// over the length of all.
  BellyMotion motionOf(std::span<const Followed> followed, std::size_t pose) const {
    constexpr std::size_t kPoints = FollowedBelly::kPoints;
    BellyMotion all;
    if (followed.empty()) return all;
    const auto count = static_cast<float>(followed.size());
    const int sheet = findSheet(rig_, at(rig_.primitives, followed.front().primitive).sheet);
    const float strips = sheet < 0 ? 1.0f : static_cast<float>(at(rig_.sheets, sheet).strips);
    for (const Followed& one : followed) {
      const PosedMuscle& muscle = at(posed_[pose].muscles, one.primitive);
      const BellyMotion motion = one.belly.motion(muscle, std::span(one.frames).subspan(pose * kPoints, kPoints));
      all.out += motion.out / count;
      all.beside += motion.beside / (count * strips);
      all.ball = std::max(all.ball, motion.ball / count);
    }
    return all;
  }

  Deeds deedsOf(std::span<const int> bellies) const {
    Deeds deeds;
    const std::vector<Followed> followed = follow(bellies);
    if (!followed.empty()) deeds.mostBall = followed.front().belly.mostBall();
    const int line = at(bind_.muscles, bellies.front()).line;
    const bool leads = line >= 0 && firstOn(line) == bellies.front();
    for (int i = 0; i < static_cast<int>(posed_.size()); ++i) {
      const PosedRig& posed = posed_[toIndex(i)];
      if (!followed.empty()) {
        const BellyMotion motion = motionOf(followed, toIndex(i));
        const float share = motions_.shareOf(toIndex(i));
        deeds.out.take(motion.out, i, share);
        if (line < 0) continue;  // Its shape is fixed.
        deeds.beside.take(motion.beside, i, share);
        deeds.ball.take(motion.ball / deeds.mostBall, i, share);
      }
      if (!leads || !at(posed.lines, line).usable) continue;
      deeds.shrunk.take(1.0f / std::max(at(posed.lines, line).stretch, 1e-6f), i);
      deeds.stretched.take(at(posed.lines, line).stretch, i);
    }
    return deeds;
  }

  int firstOn(int line) const {
    for (std::size_t i = 0; i < bind_.muscles.size(); ++i) {
      if (bind_.muscles[i].line == line) return static_cast<int>(i);
    }
    return -1;
  }

  /// How deep far skin comes into the muscle's influence, fraction of the reach, and that skin's bone.
  std::optional<std::pair<Worst, int>> reachAcross(int primitive) const {
    const Primitive& own = at(rig_.primitives, primitive);
    std::pair<Worst, int> worst;
    for (const FarSkin& far : farSkin(rig_, own, motions_.character())) {
      const glm::vec3 bindPlace = at(motions_.character().mesh.positions, far.vertex);
      const std::vector<glm::vec3> places = motions_.placesOf(far.vertex);
      const float before = worst.first.value;
      worst.first.take(depthIn(bind_, primitive, bindPlace), -1);
      for (int i = 0; i < static_cast<int>(places.size()); ++i) {
        worst.first.take(depthIn(posed_[toIndex(i)], primitive, places[toIndex(i)]), i);
      }
      if (worst.first.value > before) worst.second = far.bone;
    }
    if (!(worst.first.value > 0.0f)) return std::nullopt;
    return worst;
  }

  /// 0 outside the influence, 1 at its center.
  float depthIn(const PosedRig& posed, int primitive, const glm::vec3& place) const {
    const PosedMuscle& muscle = at(posed.muscles, primitive);
    if (!muscle.usable) return 0.0f;
    const BellyBody body = bellyBody(muscle);
    if (!(std::abs(glm::determinant(body.axes)) > 0.0f)) return 0.0f;
    const float r = glm::length(glm::inverse(body.axes) * (place - body.center));
    return std::max(0.0f, 1.0f - r / at(rig_.primitives, primitive).reach);
  }

  const Rig& rig_;
  const Motions& motions_;
  RigPoser poser_;
  std::vector<PosedRig> posed_;  ///< [poses]
  PosedRig bind_;
};

std::string percent(float share) { return std::to_string(std::lround(100.0f * share)) + " %"; }

}  // namespace

std::string_view nameOf(FindingKind kind) {
  constexpr std::array<std::string_view, 6> kNames{"comes_out", "slides_off", "ball",
                                                   "too_short", "too_long",   "reaches_across"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string textOf(const Finding& finding) {
  const std::string measure = percent(finding.measure);
  switch (finding.kind) {
    case FindingKind::kComesOut:
      return "comes out of the skin by " + measure + " of its height";
    case FindingKind::kSlidesOff:
      return "slides sideways under the skin by " + measure + " of half its width";
    case FindingKind::kBall:
      return "swells to a ball: its height is " + measure + " of its length";
    case FindingKind::kTooShort:
      return "its line gets as short as " + measure + " of its rest length";
    case FindingKind::kTooLong:
      return "its line gets as long as " + measure + " of its rest length";
    case FindingKind::kReachesAcross:
      return "moves skin of " + finding.bone + ", which is on another limb";
  }
  return {};
}

std::vector<Finding> check(const Rig& rig, const Motions& motions) { return Checker(rig, motions).run(); }

}  // namespace sinew
