// core/bodies/check.cpp: every muscle in every pose; the worst of each kind is kept.
#include "core/bodies/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/bodies/belly_motion.h"
#include "core/character/bindings.h"
#include "core/character/bone_segments.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/rig/attachment.h"

namespace sinew {
namespace {

constexpr std::size_t kFarBones = 4;  ///< On the way, both ends included: three joints away.

/// What counts most, how much it is, and where it was; the first of equal ones.
struct Worst {
  float counted = 0.0f;
  float value = 0.0f;
  int pose = -1;

  void take(float other, int at, float share = 1.0f) {
    if (!(other * share > counted)) return;
    counted = other * share;
    value = other;
    pose = at;
  }
};

/// What a muscle's line and belly did.
struct Deeds {
  Worst out;
  Worst beside;
  Worst ball;  ///< Of the most that is allowed.
  float mostBall = 1.0f;
  Worst shrunk;  ///< 1 / stretch.
  Worst stretched;
};

/// Skin that a muscle may move but should not reach.
struct FarSkin {
  int vertex = 0;
  int bone = 0;
};

/// Of a territory that the rig names: the default holds the bones next to the muscle's alone.
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
    std::vector<std::vector<Finding>> found(rig_.primitives.size());
    forEachIndex(found.size(), 1, [&](std::size_t i) {
      if (rig_.primitives[i].sign > 0) found[i] = findingsOf(static_cast<int>(i));
    });
    std::vector<Finding> out;
    for (auto& own : found) std::ranges::move(own, std::back_inserter(out));
    return out;
  }

 private:
  std::vector<Finding> findingsOf(int primitive) const {
    std::vector<Finding> out;
    const Deeds deeds = deedsOf(primitive);
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

  Deeds deedsOf(int primitive) const {
    Deeds deeds;
    const PosedMuscle& bind = at(bind_.muscles, primitive);
    const auto bone = motions_.character().skeleton.findBone(at(rig_.primitives, primitive).bone);
    if (!bone) return deeds;
    const auto belly = FollowedBelly::create(motions_.character(), motions_.skin(), bind, *bone);
    std::vector<std::optional<SkinFrame>> frames;
    if (belly) {
      frames = motions_.framesOf(belly->spots());
      deeds.mostBall = belly->mostBall();
    }
    const int line = bind.line;
    const bool leads = line >= 0 && firstOn(line) == primitive;
    for (int i = 0; i < static_cast<int>(posed_.size()); ++i) {
      const PosedRig& posed = posed_[toIndex(i)];
      if (belly) {
        constexpr std::size_t kPoints = FollowedBelly::kPoints;
        const BellyMotion motion =
            belly->motion(at(posed.muscles, primitive), std::span(frames).subspan(toIndex(i) * kPoints, kPoints));
        const float share = motions_.shareOf(toIndex(i));
        deeds.out.take(motion.out, i, share);
        if (line < 0) continue;  // It stays as it is, whatever the skin does.
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

  /// How deep far skin comes into a muscle's influence, of the reach, and the bone.
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

  /// 0 outside, 1 at the middle.
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
