// core/bodies/body_frame.cpp: axes run from bone to bone; the end of a last bone is found from its skin.
#include "core/bodies/body_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "core/character/bindings.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kRadians = std::numbers::pi_v<float> / 180.0f;
constexpr float kAtStart = 0.05f;  ///< Marks up to here on a hand or foot are at the end of the part before.
constexpr glm::vec3 kUp(0.0f, 1.0f, 0.0f);

bool isEnd(Slot slot) {
  return slot == Slot::kHand || slot == Slot::kFoot || slot == Slot::kFrontFoot || slot == Slot::kHindFoot;
}

/// Parts and the next ones away from the trunk.
constexpr std::array<std::pair<Slot, Slot>, 10> kNextParts{{{Slot::kNeck, Slot::kHead},
                                                            {Slot::kUpperArm, Slot::kLowerArm},
                                                            {Slot::kLowerArm, Slot::kHand},
                                                            {Slot::kUpperLeg, Slot::kLowerLeg},
                                                            {Slot::kLowerLeg, Slot::kFoot},
                                                            {Slot::kFoot, Slot::kToes},
                                                            {Slot::kFrontUpper, Slot::kFrontLower},
                                                            {Slot::kFrontLower, Slot::kFrontFoot},
                                                            {Slot::kHindUpper, Slot::kHindLower},
                                                            {Slot::kHindLower, Slot::kHindFoot}}};

std::optional<Slot> partAfter(Slot slot) {
  const auto found = std::ranges::find(kNextParts, slot, &std::pair<Slot, Slot>::first);
  return found == kNextParts.end() ? std::nullopt : std::optional(found->second);
}

class FrameMaker {
 public:
  FrameMaker(const Character& character, const BodySlots& slots) : character_(character) {
    frame_.slots = slots;
    frame_.height = character.height;
  }

  BodyFrame make() {
    makeZones();
    for (const Slot slot :
         {Slot::kUpperArm, Slot::kLowerArm, Slot::kUpperLeg, Slot::kLowerLeg, Slot::kFrontUpper, Slot::kFrontLower,
          Slot::kFrontFoot, Slot::kHindUpper, Slot::kHindLower, Slot::kHindFoot, Slot::kFoot, Slot::kNeck}) {
      makePart(slot);
    }
    makeShoulder();
    makeTrunk();
    return std::move(frame_);
  }

 private:
  [[nodiscard]] const Bone& bone(int i) const { return at(character_.skeleton.bones, i); }
  [[nodiscard]] glm::vec3 joint(int i) const { return glm::vec3(bone(i).bindInWorld[3]); }
  [[nodiscard]] bool has(Slot slot, BodySide side = BodySide::kLeft) const {
    return frame_.slots.boneOf(slot, side) >= 0;
  }
  [[nodiscard]] glm::vec3 ventral() const {
    return frame_.slots.kind == BodyKind::kQuadruped ? -kUp : frame_.slots.forward;
  }

  void makeZones() {
    const std::size_t count = character_.skeleton.bones.size();
    frame_.zoneOfBone.assign(count, -1);
    for (const BodySlot& slot : allBodySlots()) {
      const SlotBone& part = frame_.slots[slot];
      // If two parts share a bone, its skin belongs to the upper one.
      if (part.bone >= 0 && at(frame_.zoneOfBone, part.bone) < 0)
        at(frame_.zoneOfBone, part.bone) = zoneOf(slot.slot, slot.side);
    }
    for (const int i : frame_.slots.trunk) at(frame_.zoneOfBone, i) = zoneOf(Slot::kSpine);
    for (const int i : frame_.slots.neck) at(frame_.zoneOfBone, i) = zoneOf(Slot::kNeck);
    for (std::size_t i = 0; i < count; ++i) {
      const int parent = character_.skeleton.bones[i].parent;
      if (frame_.zoneOfBone[i] < 0 && parent >= 0) frame_.zoneOfBone[i] = at(frame_.zoneOfBone, parent);
    }
  }

  void makePart(Slot slot) {
    if (!has(slot)) return;
    const auto to = end(slot);
    if (!to) return;
    PartAxis axis{{start(slot), *to}, {frame_.slots.boneOf(slot)}, frame_.slots.forward};
    axis.middle = slot == Slot::kNeck;
    if (axis.middle) axis.front = ventral();
    if (slot == Slot::kLowerArm || slot == Slot::kUpperArm) {
      // The front of an arm is the side to which its elbow folds, if the bind pose shows that.
      const int elbow = frame_.slots.boneOf(Slot::kLowerArm);
      const int hand = frame_.slots.boneOf(Slot::kHand);
      const int upper = frame_.slots.boneOf(Slot::kUpperArm);
      if (elbow >= 0 && hand >= 0 && upper >= 0) {
        const glm::vec3 before = normalizeOr(joint(elbow) - joint(upper), kUp);
        const glm::vec3 after = normalizeOr(joint(hand) - joint(elbow), kUp);
        const glm::vec3 folds = after - glm::dot(after, before) * before;
        if (glm::length(folds) > 0.17f && glm::dot(folds, axis.front) > 0.5f * glm::length(folds)) axis.front = folds;
      }
    }
    if (slot == Slot::kFoot) axis.front = kUp;
    put(slot, std::move(axis));
  }

  void makeShoulder() {
    const Slot arm = frame_.slots.kind == BodyKind::kQuadruped ? Slot::kFrontUpper : Slot::kUpperArm;
    if (!has(Slot::kShoulder) || !has(arm)) return;
    const int own = frame_.slots.boneOf(Slot::kShoulder);
    put(Slot::kShoulder, {{joint(own), joint(frame_.slots.boneOf(arm))}, {own}, frame_.slots.forward});
  }

  /// From the level of the hip joints to the neck, over the joints of the trunk.
  void makeTrunk() {
    const Slot leg = frame_.slots.kind == BodyKind::kQuadruped ? Slot::kHindUpper : Slot::kUpperLeg;
    const Slot arm = frame_.slots.kind == BodyKind::kQuadruped ? Slot::kFrontUpper : Slot::kUpperArm;
    if (!has(Slot::kHips)) return;
    const glm::vec3 left = frame_.slots.left;
    const int hips = frame_.slots.boneOf(Slot::kHips);
    const auto inMiddle = [&](const glm::vec3& point) { return point - glm::dot(point - joint(hips), left) * left; };
    PartAxis axis;
    axis.front = ventral();
    axis.middle = true;
    axis.points.push_back(has(leg) ? inMiddle(joint(frame_.slots.boneOf(leg))) : joint(hips));
    axis.bones.push_back(hips);
    std::optional<glm::vec3> top;
    if (has(Slot::kNeck)) top = joint(frame_.slots.boneOf(Slot::kNeck));
    else if (has(arm)) top = inMiddle(joint(frame_.slots.boneOf(arm)));
    else if (has(Slot::kHead)) top = joint(frame_.slots.boneOf(Slot::kHead));
    if (!top) return;
    const glm::vec3 way = normalizeOr(*top - axis.points.front(), kUp);
    const auto along = [&](const glm::vec3& point) { return glm::dot(point - axis.points.front(), way); };
    for (const int i : frame_.slots.trunk) {
      const float here = along(joint(i));
      if (here < 0.02f * frame_.height || here > along(*top) - 0.01f * frame_.height) continue;
      if (here <= along(axis.points.back())) continue;
      axis.points.push_back(inMiddle(joint(i)));
      axis.bones.push_back(i);
    }
    axis.points.push_back(inMiddle(*top));
    put(Slot::kSpine, std::move(axis));
  }

  void put(Slot slot, PartAxis axis) {
    for (std::size_t i = 0; i + 1 < axis.points.size(); ++i)
      axis.length += glm::distance(axis.points[i], axis.points[i + 1]);
    if (axis.length > 0.005f * frame_.height) frame_.axes[static_cast<std::size_t>(slot)] = std::move(axis);
  }

  glm::vec3 start(Slot slot) const {
    const SlotBone& part = frame_.slots[{slot, BodySide::kLeft}];
    const glm::vec3 from = joint(part.bone);
    if (part.from <= 0.0f) return from;
    const int next = frame_.slots.boneOf(*partAfter(slot));
    return next < 0 ? from : glm::mix(from, joint(next), part.from);
  }

  std::optional<glm::vec3> end(Slot slot) const {
    const SlotBone& part = frame_.slots[{slot, BodySide::kLeft}];
    const std::optional<Slot> next = partAfter(slot);
    if (part.to < 1.0f) {
      // The rest of the bone is the next part, which ends where the one after it begins.
      const std::optional<Slot> beyond = partAfter(*next);
      const int last = beyond ? frame_.slots.boneOf(*beyond) : -1;
      if (last < 0) return std::nullopt;
      return glm::mix(joint(part.bone), joint(last), part.to);
    }
    if (next && has(*next)) return joint(frame_.slots.boneOf(*next));
    return endOfSkin(slot);
  }

  /// End of the skin of a last bone.
  std::optional<glm::vec3> endOfSkin(Slot slot) const {
    const int own = frame_.slots.boneOf(slot);
    std::vector<glm::vec3> skin;
    glm::vec3 sum(0.0f);
    for (std::size_t v = 0; v < character_.mesh.positions.size(); ++v) {
      const int strongest = strongestBone(character_, static_cast<int>(v));
      if (at(frame_.zoneOfBone, strongest) != zoneOf(slot)) continue;
      skin.push_back(character_.mesh.positions[v]);
      sum += skin.back();
    }
    if (skin.empty()) return std::nullopt;
    const glm::vec3 from = joint(own);
    const glm::vec3 along = normalizeOr(sum / static_cast<float>(skin.size()) - from, -kUp);
    float far = 0.0f;
    for (const glm::vec3& point : skin) far = std::max(far, glm::dot(point - from, along));
    return from + 0.9f * far * along;
  }

  const Character& character_;
  BodyFrame frame_;
};

}  // namespace

PartAxis::Piece PartAxis::pieceAt(float u) const {
  float along = u * length;
  for (std::size_t i = 0;; ++i) {
    const float own = glm::distance(points[i], points[i + 1]);
    const bool last = i + 2 == points.size();
    if (along <= own || last) return {i, own > 0.0f ? along / own : 0.0f};
    along -= own;
  }
}

glm::vec3 PartAxis::point(float u) const {
  const Piece piece = pieceAt(u);
  return points[piece.index] + piece.share * (points[piece.index + 1] - points[piece.index]);
}

glm::vec3 PartAxis::direction(float u) const {
  // Smooths the direction where the axis bends.
  const float near = 0.12f;
  const glm::vec3 way = point(std::min(u + near, 1.0f + near)) - point(std::max(u - near, -near));
  return normalizeOr(way, normalizeOr(points.back() - points.front(), {0, 1, 0}));
}

glm::vec3 PartAxis::radial(float u, float angle) const {
  const glm::vec3 along = direction(u);
  const glm::vec3 ahead = normalizeOr(front - glm::dot(front, along) * along, {1, 0, 0});
  const glm::vec3 outer = middle ? glm::cross(along, ahead) : glm::cross(ahead, along);
  return std::cos(kRadians * angle) * ahead + std::sin(kRadians * angle) * outer;
}

int PartAxis::bone(float u) const { return bones[std::min(pieceAt(u).index, bones.size() - 1)]; }

const PartAxis* BodyFrame::axisOf(const Mark& mark, float& u) const {
  u = mark.u;
  Slot slot = isTrunk(mark.slot) ? Slot::kSpine : mark.slot;
  if (isEnd(slot) && u <= kAtStart) {
    slot = partBefore(slot);
    u = 1.0f;
  }
  const auto& axis = axes[static_cast<std::size_t>(slot)];
  return axis ? &*axis : nullptr;
}

int BodyFrame::boneOf(const Mark& mark) const {
  if (isTrunk(mark.slot)) {
    const auto& trunk = axes[static_cast<std::size_t>(Slot::kSpine)];
    return trunk ? trunk->bone(mark.u) : -1;
  }
  const int own = slots.boneOf(mark.slot);
  return own < 0 && isEnd(mark.slot) ? slots.boneOf(partBefore(mark.slot)) : own;
}

BodyFrame makeBodyFrame(const Character& character, const BodySlots& slots) {
  return FrameMaker(character, slots).make();
}

Zone zoneOf(Slot slot, BodySide side) {
  if (isTrunk(slot)) slot = Slot::kSpine;
  return static_cast<Zone>(indexOf({slot, slot >= kFirstSidedSlot ? side : BodySide::kLeft}));
}

Slot partBefore(Slot slot) {
  if (slot == Slot::kUpperArm || slot == Slot::kFrontUpper) return Slot::kShoulder;
  const auto found = std::ranges::find(kNextParts, slot, &std::pair<Slot, Slot>::second);
  return found == kNextParts.end() ? Slot::kSpine : found->first;
}

std::vector<Zone> zonesAround(Slot slot) {
  if (isTrunk(slot)) {
    std::vector<Zone> zones{zoneOf(Slot::kSpine), zoneOf(Slot::kNeck)};
    for (const BodySide side : {BodySide::kLeft, BodySide::kRight}) {
      for (const Slot near : {Slot::kShoulder, Slot::kUpperLeg, Slot::kFrontUpper, Slot::kHindUpper})
        zones.push_back(zoneOf(near, side));
    }
    return zones;
  }
  std::vector<Zone> zones{zoneOf(slot), zoneOf(partBefore(slot))};
  if (const auto after = partAfter(slot)) zones.push_back(zoneOf(*after));
  if (slot == Slot::kShoulder) {
    zones.push_back(zoneOf(Slot::kUpperArm));
    zones.push_back(zoneOf(Slot::kFrontUpper));
    zones.push_back(zoneOf(Slot::kNeck));
  }
  if (slot == Slot::kNeck) {
    zones.push_back(zoneOf(Slot::kShoulder));
    zones.push_back(zoneOf(Slot::kShoulder, BodySide::kRight));
  }
  return zones;
}

}  // namespace sinew
