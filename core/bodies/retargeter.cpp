// core/bodies/retargeter.cpp: R'(t) = (R_clip(t) R_clip,0^-1) R_0 for each bone, then the path of the hips.
#include "core/bodies/retargeter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtx/quaternion.hpp>

#include "core/geometry/at.h"

namespace sinew {

namespace {

constexpr double kShortest = 1e-9;     ///< Shortest limb with a direction, character units.
constexpr double kLeastHeight = 0.02;  ///< Least usable height of hips above feet, fraction of the skeleton's extent.

/// Parts whose directions are aligned, and the parts at their ends.
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

/// The character's bone that is this part, or whose partner is: feet that are not below their legs but targets of them
/// are found by their names alone. -1: none.
int partOf(const ClipBodies& bodies, BodySlot slot) {
  if (const int own = bodies.toSlots[slot].bone; own >= 0) return own;
  const int theirs = bodies.fromSlots[slot].bone;
  const auto found = theirs < 0 ? bodies.partner.end() : std::ranges::find(bodies.partner, theirs);
  return found == bodies.partner.end() ? -1 : static_cast<int>(found - bodies.partner.begin());
}

/// The rotation in a matrix; the identity for a flat one.
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

  /// Parents come first: turns_ of the bones above are known.
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

  /// The body's hips, else the topmost bone with most partners below it.
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

CommonStance findCommonStance(const ClipBodies& bodies) { return StanceFinder(bodies).run(); }

namespace {

constexpr double kSampledFrame = 1.0 / 30.0;  ///< Between keys that cannot be copied, seconds.
constexpr double kMostSampled = 200'000.0;    ///< Most samples of one channel.

glm::dquat quatOf(const glm::vec4& v) {
  return {static_cast<double>(v.w), static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

glm::vec4 vecOf(const glm::dquat& q) {
  return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}

glm::dquat unitOr(const glm::dquat& q) {
  const double length = glm::length(q);
  return length > 0.0 && std::isfinite(length) ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

/// Adds times between those further apart than a sampled frame, unless they would be too many.
std::vector<float> refinedTimes(std::vector<float> times) {
  if (times.size() < 2) return times;
  const double length = static_cast<double>(times.back()) - static_cast<double>(times.front());
  if (!(length / kSampledFrame < kMostSampled)) return times;
  std::vector<float> fine;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const auto from = static_cast<double>(times[i]);
    const double span = static_cast<double>(times[i + 1]) - from;
    const auto parts = static_cast<int>(std::ceil(span / kSampledFrame - 1e-3));
    fine.push_back(times[i]);
    for (int part = 1; part < parts; ++part) {
      const auto time = static_cast<float>(from + span * part / parts);
      if (time > fine.back() && time < times[i + 1]) fine.push_back(time);
    }
  }
  fine.push_back(times.back());
  return fine;
}

/// Rising, each time once.
void sortTimes(std::vector<float>& times) {
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

/// Flips quaternions so that each is on the side of the one before.
void alignSigns(Channel& channel) {
  for (std::size_t i = 1; i < channel.values.size(); ++i) {
    if (glm::dot(channel.values[i - 1], channel.values[i]) < 0.0f) channel.values[i] = -channel.values[i];
  }
}

/// A clip's channels by node, and the rotations of the nodes in it.
class ClipTurns {
 public:
  ClipTurns(const Skeleton& skeleton, const AnimationClip& clip)
      : skeleton_(skeleton), channels_(3 * skeleton.nodes.size(), nullptr) {
    for (const Channel& channel : clip.channels) {
      const Channel*& place = channels_[3 * toIndex(channel.node) + static_cast<std::size_t>(channel.path)];
      if (place == nullptr && !at(skeleton.nodes, channel.node).rest.matrix) place = &channel;
    }
  }

  const Channel* channel(int node, ChannelPath path) const {
    return channels_[3 * toIndex(node) + static_cast<std::size_t>(path)];
  }

  /// Relative to the parent.
  glm::dquat turn(int node, float time) const {
    if (const Channel* turning = channel(node, ChannelPath::kRotation)) return quatOf(sampleChannel(*turning, time));
    const LocalTransform& rest = at(skeleton_.nodes, node).rest;
    return rest.matrix ? rotationIn(*rest.matrix) : unitOr(glm::dquat(rest.rotation));
  }

  /// @param nodes  out: from below `above` (-1: from the root) to the node  @return false: the node is not below it
  bool chain(int above, int node, std::vector<int>& nodes) const {
    nodes.clear();
    int next = node;
    for (; next >= 0 && next != above; next = at(skeleton_.nodes, next).parent) nodes.push_back(next);
    std::ranges::reverse(nodes);
    return next == above;
  }

  /// Times of all channels of these nodes, ascending; refined if `fine`.
  std::vector<float> timesOf(std::span<const int> nodes, bool fine) const {
    std::vector<float> times;
    for (const int node : nodes) {
      for (std::size_t path = 0; path < 3; ++path) {
        const Channel* one = channels_[3 * toIndex(node) + path];
        if (one != nullptr) times.insert(times.end(), one->times.begin(), one->times.end());
      }
    }
    sortTimes(times);
    if (times.empty()) times.push_back(0.0f);
    return fine ? refinedTimes(std::move(times)) : times;
  }

  /// left * (rotation of `above`, -1: the world)^-1 * (rotation of `node`) * right, in the world. If only one channel
  /// rotates the chain between them, its keys and tangents are used; otherwise samples. Empty: the budget is spent.
  Channel between(int above, int node, const glm::dquat& left, const glm::dquat& right, double& budget) const {
    Channel made;
    made.path = ChannelPath::kRotation;
    std::vector<int> nodes;
    const bool below = chain(above, node, nodes);
    std::vector<int> turning;
    for (const int one : nodes) {
      if (channel(one, ChannelPath::kRotation) != nullptr) turning.push_back(one);
    }
    const auto product = [&](std::span<const int> some, float time) {
      glm::dquat all(1.0, 0.0, 0.0, 0.0);
      for (const int one : some) all = all * turn(one, time);
      return all;
    };
    if (below && turning.size() <= 1) {
      const Channel* keys = turning.empty() ? nullptr : channel(turning.front(), ChannelPath::kRotation);
      const auto own = turning.empty() ? nodes.end() : std::ranges::find(nodes, turning.front());
      const glm::dquat front = left * product({nodes.begin(), own}, 0.0f);
      const glm::dquat behind =
          (own == nodes.end() ? glm::dquat(1.0, 0.0, 0.0, 0.0) : product({std::next(own), nodes.end()}, 0.0f)) * right;
      if (keys == nullptr) {
        made.times = {0.0f};
        made.values = {vecOf(unitOr(front * behind))};
        return made;
      }
      made.interpolation = keys->interpolation;
      made.times = keys->times;
      for (const glm::vec4& value : keys->values) made.values.push_back(vecOf(front * quatOf(value) * behind));
      return made;
    }
    std::vector<int> others;
    if (!below) {
      (void)chain(-1, node, nodes);
      (void)chain(-1, above, others);
    }
    std::vector<int> all = nodes;
    all.insert(all.end(), others.begin(), others.end());
    const std::vector<float> times = timesOf(all, true);
    budget -= static_cast<double>(times.size()) * static_cast<double>(all.size());
    if (budget < 0.0) return made;
    made.times = times;
    for (const float time : times) {
      made.values.push_back(vecOf(unitOr(left * glm::conjugate(product(others, time)) * product(nodes, time) * right)));
    }
    alignSigns(made);
    return made;
  }

 private:
  const Skeleton& skeleton_;
  std::vector<const Channel*> channels_;  // [nodes * 3]
};

constexpr float kSameTurn = 1e-6f;   ///< Per component of a rotation.
constexpr float kSamePlace = 1e-6f;  ///< Relative to the larger one.
constexpr double kLargest = 1e15;    ///< The limit of the import.

glm::dquat restTurn(const Node& node) {
  return node.rest.matrix ? rotationIn(*node.rest.matrix) : glm::normalize(glm::dquat(node.rest.rotation));
}

glm::dquat bindTurn(const Skeleton& skeleton, int bone) { return rotationIn(at(skeleton.bones, bone).bindInWorld); }

bool isFiniteMatrix(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(matrix[column][row]) < kLargest)) return false;
    }
  }
  return true;
}

bool isTame(const Channel& channel) {
  return std::ranges::all_of(channel.values, [](const glm::vec4& value) {
    return std::abs(static_cast<double>(value.x)) < kLargest && std::abs(static_cast<double>(value.y)) < kLargest &&
           std::abs(static_cast<double>(value.z)) < kLargest && std::abs(static_cast<double>(value.w)) < kLargest;
  });
}

bool isSame(const glm::vec4& a, const glm::vec4& b, ChannelPath path) {
  const glm::vec4 apart = glm::abs(a - b);
  const float most = std::max({apart.x, apart.y, apart.z, apart.w});
  if (path == ChannelPath::kRotation) {
    const glm::vec4 sum = glm::abs(a + b);
    return std::min(most, std::max({sum.x, sum.y, sum.z, sum.w})) <= kSameTurn;
  }
  return most <= kSamePlace * std::max(glm::length(a), glm::length(b));
}

/// Keeps one key if all are the same.
void shorten(Channel& channel) {
  const bool still = std::ranges::all_of(
      channel.values, [&](const glm::vec4& value) { return isSame(value, channel.values.front(), channel.path); });
  if (!still || channel.interpolation == Interpolation::kCubicSpline || channel.values.size() < 2) return;
  channel.times.resize(1);
  channel.values.resize(1);
}

std::size_t placeOf(int node, ChannelPath path) { return 2 * toIndex(node) + (path == ChannelPath::kRotation ? 0 : 1); }

class MadeChannels {
 public:
  explicit MadeChannels(std::size_t nodes) : places_(2 * nodes, -1) {}

  void add(Channel channel) {
    places_[placeOf(channel.node, channel.path)] = static_cast<int>(channels_.size());
    channels_.push_back(std::move(channel));
  }

  /// Rotation or translation; null: the node rests.
  const Channel* of(int node, ChannelPath path) const {
    const int place = places_[placeOf(node, path)];
    return place < 0 ? nullptr : &at(channels_, place);
  }

  [[nodiscard]] std::vector<Channel> take() && { return std::move(channels_); }

 private:
  std::vector<Channel> channels_;
  std::vector<int> places_;  // [nodes * 2]
};

class Retargeter {
 public:
  Retargeter(const ClipBodies& bodies, const CommonStance& stance) : bodies_(bodies), stance_(stance) {}

  std::vector<Channel> channelsOf(const AnimationClip& clip, double& budget) const {
    const ClipTurns turns(bodies_.from, clip);
    MadeChannels made(bodies_.to.nodes.size());
    for (std::size_t i = 0; i < bodies_.to.bones.size() && budget >= 0.0; ++i) {
      const int bone = static_cast<int>(i);
      if (!canTurn(bone)) continue;
      Channel channel = turnOf(bone, turns, budget);
      if (channel.times.empty() || !isTame(channel)) continue;
      shorten(channel);
      if (!isAtRest(channel)) made.add(std::move(channel));
    }
    Channel path = hipPath(turns, made, budget);
    if (!path.times.empty() && isTame(path)) {
      shorten(path);
      if (!isAtRest(path)) made.add(std::move(path));
    }
    addPartsApart(made, budget);
    return std::move(made).take();
  }

 private:
  [[nodiscard]] int partnerOf(int bone) const { return bodies_.partner[static_cast<std::size_t>(bone)]; }

  bool canTurn(int bone) const {
    return partnerOf(bone) >= 0 && !at(bodies_.to.nodes, at(bodies_.to.bones, bone).node).rest.matrix;
  }

  /// The nearest bone above that has a partner, or -1.
  int anchorOf(int bone) const {
    int above = at(bodies_.to.bones, bone).parent;
    while (above >= 0 && !canTurn(above)) above = at(bodies_.to.bones, above).parent;
    return above;
  }

  Channel turnOf(int bone, const ClipTurns& turns, double& budget) const {
    const int anchor = anchorOf(bone);
    const int node = at(bodies_.to.bones, bone).node;
    const int top = anchor < 0 ? -1 : at(bodies_.to.bones, anchor).node;
    glm::dquat between(1.0, 0.0, 0.0, 0.0);
    for (int above = at(bodies_.to.nodes, node).parent; above >= 0 && above != top;
         above = at(bodies_.to.nodes, above).parent) {
      between = restTurn(at(bodies_.to.nodes, above)) * between;
    }
    glm::dquat left = glm::conjugate(between);
    int theirs = -1;
    if (anchor >= 0) {
      left = left * glm::conjugate(bindTurn(bodies_.to, anchor)) * at(stance_.turn, anchor) * stance_.facing *
             bindTurn(bodies_.from, partnerOf(anchor));
      theirs = at(bodies_.from.bones, partnerOf(anchor)).node;
    } else {
      left = left * stance_.facing;
    }
    const glm::dquat right = glm::conjugate(bindTurn(bodies_.from, partnerOf(bone))) * glm::conjugate(stance_.facing) *
                             glm::conjugate(at(stance_.turn, bone)) * bindTurn(bodies_.to, bone);
    Channel channel = turns.between(theirs, at(bodies_.from.bones, partnerOf(bone)).node, left, right, budget);
    channel.node = node;
    return channel;
  }

  /// p'(t) = p'_0 + k (p(t) - p_0) for the joint in the world, then relative to the node above it.
  Channel hipPath(const ClipTurns& turns, const MadeChannels& made, double& budget) const {
    Channel channel;
    if (stance_.hips < 0 || !canTurn(stance_.hips)) return channel;
    const Bone& ours = at(bodies_.to.bones, stance_.hips);
    const Bone& theirs = at(bodies_.from.bones, partnerOf(stance_.hips));
    channel.node = ours.node;
    channel.path = ChannelPath::kTranslation;
    std::vector<int> nodes;
    (void)turns.chain(-1, theirs.node, nodes);
    const int above = at(bodies_.to.nodes, ours.node).parent;
    const std::vector<float> ourTimes = timesAbove(above, made);
    const glm::dmat3 scaled = glm::mat3_cast(stance_.facing) * stance_.heightRatio;
    const glm::dvec3 start(ours.bindInWorld[3]);
    const glm::dvec3 from(theirs.bindInWorld[3]);
    // World position of their joint. @param own  replaces its translation  @param point  1: position, 0: direction
    const auto theirPlace = [&](float time, const glm::vec4* own, double point) {
      glm::dmat4 world(1.0);
      for (const int node : nodes) {
        LocalTransform local = at(bodies_.from.nodes, node).rest;
        if (local.matrix) {
          world = world * glm::dmat4(*local.matrix);
          continue;
        }
        const glm::dquat turn = turns.turn(node, time);
        local.rotation = glm::quat(turn);
        if (const Channel* path = turns.channel(node, ChannelPath::kTranslation)) {
          local.translation = glm::vec3(sampleChannel(*path, time));
        }
        if (const Channel* size = turns.channel(node, ChannelPath::kScale))
          local.scale = glm::vec3(sampleChannel(*size, time));
        if (node == theirs.node && own != nullptr) return glm::dvec3(world * glm::dvec4(glm::dvec3(*own), point));
        world = world * glm::dmat4(local.toMatrix());
      }
      return glm::dvec3(world[3]);
    };
    const auto under = [&](float time) {
      return glm::inverse(above < 0 ? glm::dmat4(1.0) : placed(above, made, time));
    };
    const Channel* own = turns.channel(theirs.node, ChannelPath::kTranslation);
    const bool othersStill = std::ranges::all_of(nodes, [&](int node) {
      if (node == theirs.node) return true;
      return turns.channel(node, ChannelPath::kTranslation) == nullptr &&
             turns.channel(node, ChannelPath::kRotation) == nullptr &&
             turns.channel(node, ChannelPath::kScale) == nullptr;
    });
    if (othersStill && ourTimes.empty() && own != nullptr) {
      const glm::dmat4 inParent = under(0.0f);
      if (!isFiniteMatrix(inParent)) return {};
      channel.interpolation = own->interpolation;
      channel.times = own->times;
      const bool cubic = own->interpolation == Interpolation::kCubicSpline;
      for (std::size_t i = 0; i < own->values.size(); ++i) {
        const bool isPoint = !cubic || i % 3 == 1;
        const glm::dvec3 there = theirPlace(0.0f, &own->values[i], isPoint ? 1.0 : 0.0);
        const glm::dvec3 here = isPoint ? start + scaled * (there - from) : scaled * there;
        channel.values.emplace_back(glm::vec3(inParent * glm::dvec4(here, isPoint ? 1.0 : 0.0)), 0.0f);
      }
      return channel;
    }
    std::vector<float> times = turns.timesOf(nodes, false);
    times.insert(times.end(), ourTimes.begin(), ourTimes.end());
    sortTimes(times);
    times = refinedTimes(std::move(times));
    budget -= static_cast<double>(times.size()) * (static_cast<double>(nodes.size()) + depthOf(above));
    if (budget < 0.0) return {};
    for (const float time : times) {
      const glm::dmat4 inParent = under(time);
      if (!isFiniteMatrix(inParent)) return {};
      const glm::dvec3 here = start + scaled * (theirPlace(time, nullptr, 1.0) - from);
      channel.times.push_back(time);
      channel.values.emplace_back(glm::vec3(inParent * glm::dvec4(here, 1.0)), 0.0f);
    }
    return channel;
  }

  /// Translates a bone elsewhere in the tree so that it stays where it is bound to the carrier.
  Channel follow(int bone, int carrier, const MadeChannels& made, double& budget) const {
    const Bone& own = at(bodies_.to.bones, bone);
    const Bone& by = at(bodies_.to.bones, carrier);
    const int above = at(bodies_.to.nodes, own.node).parent;
    std::vector<float> times = timesAbove(by.node, made);
    const std::vector<float> others = timesAbove(above, made);
    times.insert(times.end(), others.begin(), others.end());
    sortTimes(times);
    Channel channel;
    channel.node = own.node;
    channel.path = ChannelPath::kTranslation;
    if (times.empty()) times.push_back(0.0f);
    times = refinedTimes(std::move(times));
    budget -= static_cast<double>(times.size()) * (depthOf(above) + depthOf(by.node));
    if (budget < 0.0) return {};
    const glm::dvec4 inCarrier = glm::dmat4(by.inverseBindInWorld) * glm::dvec4(glm::dvec3(own.bindInWorld[3]), 1.0);
    for (const float time : times) {
      const glm::dmat4 inParent = glm::inverse(above < 0 ? glm::dmat4(1.0) : placed(above, made, time));
      if (!isFiniteMatrix(inParent)) return {};
      channel.times.push_back(time);
      channel.values.emplace_back(glm::vec3(inParent * placed(by.node, made, time) * inCarrier), 0.0f);
    }
    return channel;
  }

  /// Parts that are not below the part that carries them would stay behind, as feet that are targets of their legs.
  void addPartsApart(MadeChannels& made, double& budget) const {
    constexpr std::array<std::pair<Slot, Slot>, 6> kCarried{{{Slot::kHips, Slot::kSpine},
                                                             {Slot::kHips, Slot::kUpperLeg},
                                                             {Slot::kHips, Slot::kHindUpper},
                                                             {Slot::kLowerLeg, Slot::kFoot},
                                                             {Slot::kFrontLower, Slot::kFrontFoot},
                                                             {Slot::kHindLower, Slot::kHindFoot}}};
    for (const auto& [by, part] : kCarried) {
      for (const BodySide side : {BodySide::kLeft, BodySide::kRight}) {
        if (side == BodySide::kRight && part < kFirstSidedSlot) continue;
        const int bone = partOf(bodies_, {part, side});
        const int carrier = partOf(bodies_, {by, by < kFirstSidedSlot ? BodySide::kLeft : side});
        if (bone < 0 || carrier < 0 || !canTurn(carrier)) continue;
        const auto isAbove = [&](int above, int below) {
          while (below >= 0 && below != above) below = at(bodies_.to.bones, below).parent;
          return below == above;
        };
        const LocalTransform& rest = at(bodies_.to.nodes, at(bodies_.to.bones, bone).node).rest;
        if (isAbove(carrier, bone) || isAbove(bone, carrier) || rest.matrix) continue;
        Channel channel = follow(bone, carrier, made, budget);
        if (!channel.times.empty() && isTame(channel)) made.add(std::move(channel));
      }
    }
  }

  glm::dmat4 placed(int node, const MadeChannels& made, float time) const {
    glm::dmat4 world(1.0);
    for (int next = node; next >= 0; next = at(bodies_.to.nodes, next).parent) {
      LocalTransform local = at(bodies_.to.nodes, next).rest;
      if (const Channel* turn = made.of(next, ChannelPath::kRotation)) {
        const glm::vec4 value = sampleChannel(*turn, time);
        local.rotation = glm::quat(value.w, value.x, value.y, value.z);
      }
      if (const Channel* path = made.of(next, ChannelPath::kTranslation)) {
        local.translation = glm::vec3(sampleChannel(*path, time));
      }
      world = glm::dmat4(local.toMatrix()) * world;
    }
    return world;
  }

  std::vector<float> timesAbove(int node, const MadeChannels& made) const {
    std::vector<float> times;
    for (int next = node; next >= 0; next = at(bodies_.to.nodes, next).parent) {
      for (const ChannelPath path : {ChannelPath::kRotation, ChannelPath::kTranslation}) {
        const Channel* channel = made.of(next, path);
        if (channel != nullptr) times.insert(times.end(), channel->times.begin(), channel->times.end());
      }
    }
    return times;
  }

  double depthOf(int node) const {
    double depth = 1.0;
    for (int next = node; next >= 0; next = at(bodies_.to.nodes, next).parent) ++depth;
    return depth;
  }

  bool isAtRest(const Channel& channel) const {
    const LocalTransform& rest = at(bodies_.to.nodes, channel.node).rest;
    if (channel.values.size() != 1) return false;
    const glm::quat& turn = rest.rotation;
    const glm::vec4 still = channel.path == ChannelPath::kRotation ? glm::vec4(turn.x, turn.y, turn.z, turn.w)
                                                                   : glm::vec4(rest.translation, 0.0f);
    return isSame(channel.values.front(), still, channel.path);
  }

  const ClipBodies& bodies_;
  const CommonStance& stance_;
};

}  // namespace

std::vector<Channel> retargetedChannels(const ClipBodies& bodies, const CommonStance& stance, const AnimationClip& clip,
                                        double& budget) {
  return Retargeter(bodies, stance).channelsOf(clip, budget);
}

}  // namespace sinew
