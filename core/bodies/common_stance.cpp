// core/bodies/common_stance.cpp: limbs laid over limbs, in the bind poses.
#include "core/bodies/common_stance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtx/quaternion.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr double kShortest = 1e-9;  ///< Of a limb, to have a direction; character units.
/// Hips so little above the feet that their heights say nothing; fraction of the skeleton's extent.
constexpr double kLeastHeight = 0.02;

/// Parts that are laid over each other, and where they end.
constexpr std::array<std::pair<Slot, Slot>, 8> kLaidOver{{{Slot::kUpperArm, Slot::kLowerArm},
                                                          {Slot::kLowerArm, Slot::kHand},
                                                          {Slot::kUpperLeg, Slot::kLowerLeg},
                                                          {Slot::kLowerLeg, Slot::kFoot},
                                                          {Slot::kFrontUpper, Slot::kFrontLower},
                                                          {Slot::kFrontLower, Slot::kFrontFoot},
                                                          {Slot::kHindUpper, Slot::kHindLower},
                                                          {Slot::kHindLower, Slot::kHindFoot}}};

glm::dvec3 jointOf(const Skeleton& skeleton, int bone) { return glm::dvec3(at(skeleton.bones, bone).bindInWorld[3]); }

bool standsOnGround(Slot slot) { return slot == Slot::kFoot || slot == Slot::kFrontFoot || slot == Slot::kHindFoot; }

std::optional<glm::dvec3> directionOf(const glm::dvec3& from, const glm::dvec3& to) {
  const double length = glm::length(to - from);
  if (!(length > kShortest) || !std::isfinite(length)) return std::nullopt;
  return (to - from) / length;
}

glm::dquat facingOf(const BodySlots& from, const BodySlots& to) {
  if (from.kind == BodyKind::kUnknown || from.kind != to.kind) return {1.0, 0.0, 0.0, 0.0};
  const glm::dvec3 a(from.forward);
  const glm::dvec3 b(to.forward);
  const double angle = std::atan2(a.z * b.x - a.x * b.z, a.x * b.x + a.z * b.z);
  if (!std::isfinite(angle)) return {1.0, 0.0, 0.0, 0.0};
  const double quarter = std::numbers::pi / 2.0;
  return glm::angleAxis(std::round(angle / quarter) * quarter, glm::dvec3(0.0, 1.0, 0.0));
}

class StanceFinder {
 public:
  explicit StanceFinder(const ClipBodies& bodies)
      : bodies_(bodies), slotOf_(bodies.to.bones.size()), turns_(bodies.to.bones.size()) {
    for (const BodySlot slot : allBodySlots()) {
      const int bone = bodies.toSlots[slot].bone;
      if (bone >= 0 && !at(slotOf_, bone)) at(slotOf_, bone) = slot;
    }
  }

  CommonStance run() {
    CommonStance stance;
    stance.facing = facing_ = facingOf(bodies_.fromSlots, bodies_.toSlots);
    for (std::size_t bone = 0; bone < turns_.size(); ++bone) turns_[bone] = turnOf(static_cast<int>(bone));
    stance.turn = turns_;
    stance.hips = hips();
    stance.heightRatio = stance.hips < 0 ? 1.0 : heightRatio(stance.hips);
    return stance;
  }

 private:
  [[nodiscard]] int partnerOf(int bone) const { return bone < 0 ? -1 : at(bodies_.partner, bone); }

  /// Bones are in the order of the tree: those above are done.
  [[nodiscard]] glm::dquat turnOf(int bone) const {
    const glm::dquat none(1.0, 0.0, 0.0, 0.0);
    const int parent = at(bodies_.to.bones, bone).parent;
    const glm::dquat above = parent < 0 ? none : at(turns_, parent);
    const std::optional<BodySlot> slot = at(slotOf_, bone);
    if (!slot) return above;
    if (standsOnGround(slot->slot)) return none;
    const auto laid = std::ranges::find(kLaidOver, slot->slot, &std::pair<Slot, Slot>::first);
    if (laid == kLaidOver.end()) return above;
    const int end = partOf(bodies_, {laid->second, slot->side});
    if (end == bone || partnerOf(bone) < 0 || partnerOf(end) < 0) return above;
    const auto ours = directionOf(jointOf(bodies_.to, bone), jointOf(bodies_.to, end));
    const auto theirs = directionOf(jointOf(bodies_.from, partnerOf(bone)), jointOf(bodies_.from, partnerOf(end)));
    if (!ours || !theirs) return above;
    return glm::normalize(glm::rotation(above * (facing_ * *theirs), *ours) * above);
  }

  /// Of the body, else the topmost bone with most partners below it.
  [[nodiscard]] int hips() const {
    const int known = bodies_.toSlots.boneOf(Slot::kHips);
    if (partnerOf(known) >= 0) return known;
    const std::size_t count = bodies_.to.bones.size();
    std::vector<int> below(count, 0);
    for (std::size_t i = count; i-- > 0;) {
      if (bodies_.partner[i] >= 0) ++below[i];
      const int parent = bodies_.to.bones[i].parent;
      if (parent >= 0) at(below, parent) += below[i];
    }
    int best = -1;
    for (std::size_t i = 0; i < count; ++i) {
      if (bodies_.partner[i] >= 0 && (best < 0 || below[i] > at(below, best))) best = static_cast<int>(i);
    }
    return best;
  }

  struct Heights {
    double ours = 0.0;
    double theirs = 0.0;
  };

  [[nodiscard]] double heightRatio(int hipBone) const {
    const double ours = jointOf(bodies_.to, hipBone).y;
    const double theirs = jointOf(bodies_.from, partnerOf(hipBone)).y;
    Heights feet;
    int count = 0;
    for (const Slot slot : {Slot::kFoot, Slot::kFrontFoot, Slot::kHindFoot}) {
      for (const BodySide side : {BodySide::kLeft, BodySide::kRight}) {
        const int foot = partOf(bodies_, {slot, side});
        if (partnerOf(foot) < 0) continue;
        feet.ours += jointOf(bodies_.to, foot).y;
        feet.theirs += jointOf(bodies_.from, partnerOf(foot)).y;
        ++count;
      }
    }
    const Heights sizes{extent(bodies_.to), extent(bodies_.from)};
    if (count > 0) {
      const Heights above{ours - feet.ours / count, theirs - feet.theirs / count};
      if (isClear(above, sizes)) return above.ours / above.theirs;
    }
    const Heights above{ours - lowest(bodies_.to), theirs - lowest(bodies_.from)};
    if (isClear(above, sizes)) return above.ours / above.theirs;
    return sizes.ours > 0.0 && sizes.theirs > 0.0 ? sizes.ours / sizes.theirs : 1.0;
  }

  static bool isClear(const Heights& above, const Heights& sizes) {
    return above.ours > kLeastHeight * sizes.ours && above.theirs > kLeastHeight * sizes.theirs;
  }

  static double lowest(const Skeleton& skeleton) {
    double low = std::numeric_limits<double>::infinity();
    for (const Bone& bone : skeleton.bones) low = std::min(low, static_cast<double>(bone.bindInWorld[3].y));
    return low;
  }

  static double extent(const Skeleton& skeleton) {
    Bounds bounds;
    for (const Bone& bone : skeleton.bones) bounds.add(glm::vec3(bone.bindInWorld[3]));
    return bounds.isEmpty() ? 0.0 : static_cast<double>(glm::length(bounds.extent()));
  }

  const ClipBodies& bodies_;
  std::vector<std::optional<BodySlot>> slotOf_;  // [bones of to]
  std::vector<glm::dquat> turns_;
  glm::dquat facing_{1.0, 0.0, 0.0, 0.0};
};

}  // namespace

glm::dquat rotationIn(const glm::mat4& matrix) {
  const glm::dquat none(1.0, 0.0, 0.0, 0.0);
  glm::dmat3 axes(matrix);
  if (glm::determinant(axes) < 0.0) axes *= -1.0;
  const double length = glm::length(axes[0]);
  if (!(length > 0.0) || !std::isfinite(length)) return none;
  axes[0] /= length;
  axes[1] -= glm::dot(axes[0], axes[1]) * axes[0];
  const double second = glm::length(axes[1]);
  if (!(second > 0.0) || !std::isfinite(second)) return none;
  axes[1] /= second;
  axes[2] = glm::cross(axes[0], axes[1]);
  return glm::normalize(glm::quat_cast(axes));
}

int partOf(const ClipBodies& bodies, BodySlot slot) {
  if (const int own = bodies.toSlots[slot].bone; own >= 0) return own;
  const int theirs = bodies.fromSlots[slot].bone;
  const auto found = theirs < 0 ? bodies.partner.end() : std::ranges::find(bodies.partner, theirs);
  return found == bodies.partner.end() ? -1 : static_cast<int>(found - bodies.partner.begin());
}

CommonStance findCommonStance(const ClipBodies& bodies) { return StanceFinder(bodies).run(); }

}  // namespace sinew
