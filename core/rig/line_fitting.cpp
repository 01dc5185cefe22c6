// core/rig/line_fitting.cpp: rest and contraction from poses and clips; via points; the other end.
#include "core/rig/line_fitting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/character/bone_segments.h"
#include "core/character/clip_names.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/line_pose.h"
#include "core/rig/line_rest.h"
#include "core/rig/rig_edit_several.h"

namespace sinew {

// Every clip, fifteen times a second if there are no hours of them.

namespace {

constexpr float kHertz = 15.0f;
constexpr double kMostPoses = 60'000.0;  ///< Of all clips together, about an hour: longer ones are sampled more thinly.

/// No integer: a file may say that a clip lasts for ages.
float stepsOf(const AnimationClip& clip, float hertz) { return std::max(1.0f, std::ceil(clip.duration * hertz)); }

float samplesPerSecond(std::span<const AnimationClip> clips) {
  double all = 0.0;
  for (const AnimationClip& clip : clips) all += static_cast<double>(stepsOf(clip, kHertz));
  return all > kMostPoses ? static_cast<float>(static_cast<double>(kHertz) * kMostPoses / all) : kHertz;
}

/// The lengths of one line, pose after pose.
struct Track {
  std::vector<float> stretches;
  LineLengths lengths;

  void add(float stretch, const std::string& clip) {
    if (stretches.empty() || stretch < lengths.least) {
      lengths.least = stretch;
      lengths.shortestIn = clip;
    }
    if (stretches.empty() || stretch > lengths.most) {
      lengths.most = stretch;
      lengths.longestIn = clip;
    }
    stretches.push_back(stretch);
  }
  LineLengths finish() {
    lengths.poses = static_cast<int>(stretches.size());
    if (stretches.empty()) return lengths;
    const auto rank = static_cast<std::ptrdiff_t>(0.02 * static_cast<double>(stretches.size() - 1));
    std::ranges::nth_element(stretches, stretches.begin() + rank);
    lengths.secondPercentile = stretches[static_cast<std::size_t>(rank)];
    return lengths;
  }
};

}  // namespace

LineLengths lengthsOver(const LineRest& rest, const Character& character, std::span<const AnimationClip> clips) {
  return lengthsOver(std::span(&rest, 1), character, clips).front();
}

std::vector<LineLengths> lengthsOver(std::span<const LineRest> rests, const Character& character,
                                     std::span<const AnimationClip> clips) {
  std::vector<Track> tracks(rests.size());
  const float hertz = samplesPerSecond(clips);
  for (const AnimationClip& clip : clips) {
    const int steps = static_cast<int>(stepsOf(clip, hertz));
    for (int step = 0; step <= steps; ++step) {
      const float time = clip.duration * static_cast<float>(step) / static_cast<float>(steps);
      const Pose pose = samplePose(character.skeleton, clip, time);
      for (std::size_t i = 0; i < rests.size(); ++i) {
        const PosedLine line = posedLine(rests[i], character.skeleton, pose);
        if (line.usable) tracks[i].add(line.stretch, clip.name);
      }
    }
  }
  std::vector<LineLengths> lengths;
  for (Track& track : tracks) lengths.push_back(track.finish());
  return lengths;
}

LineLengths lengthsOver(const LineRest& rest, const Skeleton& skeleton, std::span<const Pose> poses) {
  Track track;
  LineScratch scratch;
  std::vector<PosedLine> posed;
  const std::array<std::optional<LineRest>, 1> rests{rest};
  for (const Pose& pose : poses) {
    poseLines(rests, skeleton, pose, scratch, posed);
    if (posed[0].usable) track.add(posed[0].stretch, pose.clip);
  }
  return track.finish();
}

namespace {

constexpr float kAlongOther = 0.15f;  // Fraction of the other bone, from its joint.
constexpr float kNearJoint = 0.015f;  // Fraction of H: a via point keeps this far from the joint at least.

std::string percent(float stretch) { return std::to_string(std::lround(100.0f * stretch)) + " %"; }

const Bone& boneAt(const Character& character, int bone) { return at(character.skeleton.bones, bone); }

/// Both ends of the muscle's long axis, in the bind pose.
std::array<glm::vec3, 2> polesOf(const Primitive& primitive, const Bone& bone) {
  const Placement& placement = primitive.placement;
  int longest = 1;
  for (const int axis : {0, 2}) {
    if (placement.radii[axis] > 1.001f * placement.radii[longest]) longest = axis;
  }
  const glm::vec3 half = placement.radii[longest] * glm::mat3_cast(placement.rotation)[longest];
  const auto world = [&](const glm::vec3& point) { return glm::vec3(bone.bindInWorld * glm::vec4(point, 1.0f)); };
  return {world(placement.center - half), world(placement.center + half)};
}

}  // namespace

glm::vec3 jointBetween(const LineRest& rest, const Character& character) {
  const auto isAbove = [&](int above, int bone) {
    for (; bone >= 0; bone = boneAt(character, bone).parent) {
      if (bone == above) return true;
    }
    return false;
  };
  const bool insertionIsLower = isAbove(rest.origin.bone, rest.insertion.bone);
  return glm::vec3(boneAt(character, insertionIsLower ? rest.insertion.bone : rest.origin.bone).bindInWorld[3]);
}

Result<Rig> withRestNow(Rig rig, int line, float stretch) {
  return editLine(std::move(rig), line, [&](MuscleLine& edited) { edited.settings.rest *= stretch; });
}

Result<Rig> withFullNow(Rig rig, int line, float stretch) {
  if (!(stretch < kMostFull)) {
    return errorAt("", "the muscle is not shorter than at rest in this pose: bend the joint first");
  }
  return editLine(std::move(rig), line,
                  [&](MuscleLine& edited) { edited.settings.full = std::max(stretch, kLeastFull); });
}

Result<Learned> withLearned(Rig rig, int line, const LineLengths& lengths) {
  const std::string name = '"' + at(rig.lines, line).name + '"';
  if (lengths.poses == 0) return errorAt("", kNoClips);
  if (!(lengths.secondPercentile < kMostFull)) {
    return errorAt("", name + " never gets shorter than at rest in any clip: it is at least " + percent(lengths.least));
  }
  Result<Rig> full = withFullNow(std::move(rig), line, lengths.secondPercentile);
  if (!full) return full.error();
  Learned learned{std::move(full).value(), {}, {}};
  learned.said =
      name + ": full contraction at " + percent(lengths.secondPercentile) + ", shortest in " + lengths.shortestIn;
  if (lengths.least < kPlausibleLeast || lengths.most > kPlausibleMost) {
    const bool isLong = lengths.most > kPlausibleMost;
    learned.warning = name + " gets as " + (isLong ? "long" : "short") + " as " +
                      percent(isLong ? lengths.most : lengths.least) + " in " +
                      (isLong ? lengths.longestIn : lengths.shortestIn) +
                      ": does it pass through the joint? Add a via point";
  }
  return learned;
}

Result<Rig> withViaPoint(Rig rig, int line, const Character& character) {
  Result<LineRest> rest = lineRest(at(rig.lines, line), character);
  if (!rest) return rest.error();
  const glm::vec3 joint = jointBetween(rest.value(), character);
  const glm::vec3 from(rest->origin.inBind);
  const Segment straight{from, glm::vec3(rest->insertion.inBind) - from};
  const glm::vec3 passing = straight.from + std::clamp(straight.parameter(joint), 0.1f, 0.9f) * straight.along;
  const glm::vec3 height(rest->frame * glm::dvec3(0.0, 0.0, 1.0));
  const float least = kNearJoint * character.height;
  const float away = glm::distance(passing, joint);
  const glm::vec3 side = away > 0.1f * least ? (passing - joint) / away : height;
  const glm::vec3 via = joint + std::max(away, least) * side;
  return editLine(std::move(rig), line,
                  [&](MuscleLine& edited) { edited.via = anchorOn(character.skeleton, rest->origin.bone, via); });
}

Result<Rig> withoutViaPoint(Rig rig, int line) {
  return editLine(std::move(rig), line, [](MuscleLine& edited) { edited.via.reset(); });
}

Result<Rig> withOtherEnd(Rig rig, int primitive, int bone, const Character& character) {
  const Primitive& muscle = at(rig.primitives, primitive);
  const std::optional<int> own = character.skeleton.findBone(muscle.bone);
  if (!own) return errorAt("", "this character has no bone \"" + muscle.bone + '"');
  const Bone& other = boneAt(character, bone);
  const Segment axis = bindSegment(other);
  const glm::vec3 onAxis = axis.from + kAlongOther * axis.along;
  std::array<glm::vec3, 2> poles = polesOf(muscle, boneAt(character, *own));
  if (glm::distance(poles[0], onAxis) < glm::distance(poles[1], onAxis)) std::swap(poles[0], poles[1]);
  // As far off the other bone's axis as the muscle's own line is off its bone's.
  const glm::vec3 origin = halfWayToAxis(boneAt(character, *own), poles[0]);
  const glm::vec3 middle = 0.5f * (poles[0] + poles[1]);
  const glm::vec3 offset = middle - halfWayToAxis(boneAt(character, *own), middle);
  MuscleLine line;
  line.name = muscle.name;
  line.origin = anchorOn(character.skeleton, *own, origin);
  line.insertion = anchorOn(character.skeleton, bone, onAxis + offset);
  if (const Result<LineRest> rest = lineRest(line, character); !rest) return rest.error();
  if (const auto added = append(rig, std::move(line)); !added) return added.error();
  const auto last = static_cast<int>(rig.lines.size()) - 1;
  return setLineOfSeveral(std::move(rig), std::array{primitive}, last);
}

}  // namespace sinew
