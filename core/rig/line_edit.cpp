// core/rig/line_edit.cpp: each edit changes the rig that it was given and checks what it changed.
#include "core/rig/line_edit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/character/bone_segments.h"
#include "core/character/clip_names.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/animated_edit.h"
#include "core/rig/line_pose.h"
#include "core/rig/line_rest.h"
#include "core/rig/motion_clip.h"
#include "core/rig/references.h"
#include "core/rig/rig_edit.h"
#include "core/rig/validation.h"

namespace sinew {

// Rest and contraction from poses and clips; via points; the other end.

// Every clip, fifteen times a second if there are no hours of them.

namespace {

/// The lengths of one line, collected pose by pose.
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
  constexpr double kMostPoses = 60'000.0;  // More than an hour.
  std::vector<Track> tracks(rests.size());
  for (const auto& [clip, time] : sampleTimes(clips, kMostPoses)) {
    const Pose pose = samplePose(character.skeleton, *clip, time);
    for (std::size_t i = 0; i < rests.size(); ++i) {
      const PosedLine line = posedLine(rests[i], character.skeleton, pose);
      if (line.usable) tracks[i].add(line.stretch, clip->name);
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
constexpr float kNearJoint = 0.015f;  // Smallest distance of a via point from the joint, fraction of H.

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
  // As far from the other bone's axis as the line is from the muscle's own bone.
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

namespace {

/// In the bone's own space.
float lengthOf(const Skeleton& skeleton, int bone) { return glm::length(at(skeleton.bones, bone).tip); }

void scaleLengths(std::vector<AnimatedNumber>& animated, float factor) {
  const auto scale = [&](Curve& curve) {
    for (glm::vec2& point : curve.points) point.y *= factor;
  };
  for (AnimatedNumber& number : animated) {
    if (!isLength(number.parameter)) continue;
    for (KeyTrack& track : number.keys) scale(track.curve);
    for (Driver& driver : number.drivers) {
      if (driver.mode != DriverMode::kMultiply) scale(driver.curve);
    }
  }
}

}  // namespace

Placement carryToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld) {
  if (!isFinite(fromInWorld) || !isFinite(toInWorld)) return inFrom;
  const glm::dmat4 from(fromInWorld);
  const glm::dmat4 to(toInWorld);
  if (isFlat(glm::dmat3(from)) || isFlat(glm::dmat3(to))) return inFrom;
  const glm::dmat4 toFromFrom = glm::inverse(to) * from;
  const Placement image = imageOf(inFrom, {glm::dmat3(toFromFrom), glm::dvec3(toFromFrom[3])});
  const bool usable =
      isFinite(image.center) && isFinite(image.radii) && std::min({image.radii.x, image.radii.y, image.radii.z}) > 0.0f;
  return usable ? image : inFrom;
}

Primitive scaleToBone(Primitive primitive, const Skeleton& skeleton, int bone) {
  const std::optional<int> from = skeleton.findBone(primitive.bone);
  const float before = from ? lengthOf(skeleton, *from) : 0.0f;
  const float factor = before > 0.0f ? lengthOf(skeleton, bone) / before : 1.0f;
  if (factor > 0.0f && std::isfinite(factor)) {
    primitive.placement.center *= factor;
    primitive.placement.radii *= factor;
    scaleLengths(primitive.animated, factor);
  }
  primitive.bone = skeleton.fileName(bone);
  primitive.territory.reset();
  return primitive;
}

namespace {

std::string placeOfLine(int line) { return indexed("lines", static_cast<std::size_t>(line)); }

/// Unlinks lines whose twin is `gone`.
void dropTwin(Rig& rig, const std::string& gone) {
  for (MuscleLine& line : rig.lines) {
    if (line.mirror == gone) line.mirror.clear();
  }
}

void pairUpLines(Rig& rig, int line, int twin) {
  MuscleLine& a = at(rig.lines, line);
  MuscleLine& b = at(rig.lines, twin);
  dropTwin(rig, a.name);
  dropTwin(rig, b.name);
  a.mirror = b.name;
  b.mirror = a.name;
}

}  // namespace

Result<void> append(Rig& rig, MuscleLine line) {
  const auto index = static_cast<int>(rig.lines.size());
  line.name = freeLineName(rig, line.name.empty() ? "line" : line.name);
  const int twin = line.mirror.empty() ? -1 : findLine(rig, line.mirror);
  line.mirror.clear();
  if (const auto valid = validateLine(line, placeOfLine(index)); !valid) return valid.error();
  rig.lines.push_back(std::move(line));
  if (twin >= 0) pairUpLines(rig, index, twin);
  return {};
}

Result<Rig> addLine(Rig rig, MuscleLine line) {
  if (const auto added = append(rig, std::move(line)); !added) return added.error();
  return rig;
}

Result<Rig> editLine(Rig rig, int line, const std::function<void(MuscleLine&)>& change) {
  MuscleLine& edited = at(rig.lines, line);
  [[maybe_unused]] const std::pair names(edited.name, edited.mirror);
  change(edited);
  assert(names == std::pair(edited.name, edited.mirror));
  if (const auto valid = validateLine(edited, placeOfLine(line)); !valid) return valid.error();
  return rig;
}

Result<Rig> renameLine(Rig rig, int line, const std::string& name) {
  if (const auto valid = validateName(name, placeOfLine(line) + ".name"); !valid) return valid.error();
  if (const int owner = findLine(rig, name); owner >= 0 && owner != line) {
    return errorAt(placeOfLine(line) + ".name", "the name \"" + name + "\" is taken", "name");
  }
  const std::string former = std::exchange(at(rig.lines, line).name, name);
  renameReferences(rig, Named::kLine, former, name);
  return rig;
}

Rig setLineOfSeveral(Rig rig, std::span<const int> primitives, int line) {
  std::unordered_set<std::string> left;
  for (const int index : primitives) {
    left.insert(std::exchange(at(rig.primitives, index).line, line < 0 ? "" : at(rig.lines, line).name));
  }
  return withoutIdleLines(std::move(rig), std::move(left));
}

Rig setLineMirror(Rig rig, int line, int twin) {
  assert(line != twin);
  pairUpLines(rig, line, twin);
  return rig;
}

Rig withoutIdleLines(Rig rig, std::unordered_set<std::string> lines) {
  for (const Primitive& primitive : rig.primitives) lines.erase(primitive.line);
  lines.erase("");
  if (lines.empty()) return rig;
  std::erase_if(rig.lines, [&](const MuscleLine& line) { return lines.contains(line.name); });
  for (const std::string& gone : lines) dropTwin(rig, gone);
  dropLineInputs(rig, lines);
  return rig;
}

std::vector<int> primitivesOn(const Rig& rig, const std::string& line) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (rig.primitives[i].line == line) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

}  // namespace sinew
