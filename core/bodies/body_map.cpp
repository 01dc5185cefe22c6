// core/bodies/body_map.cpp: casts rays from the axes to the skin; maps cylindrical coordinates between bodies.
#include "core/bodies/body_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/bodies/fit_preset.h"
#include "core/character/bindings.h"
#include "core/geometry/at.h"

namespace sinew {

namespace {

constexpr float kMostFlesh = 0.4f;   ///< Fraction of H beyond which a ray has hit something else.
constexpr float kUsualFlesh = 1.8f;  ///< Multiple of the median beyond which skin belongs to another limb.
constexpr float kAround[] = {-150, -120, -90, -60, -30, 0, 30, 60, 90, 120, 150, 180};

/// Moeller & Trumbore 1997; nullopt: the ray misses, or enters.
std::optional<SkinExit> exitThrough(const glm::vec3& from, const glm::vec3& direction, const glm::vec3& a,
                                    const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 ab = b - a;
  const glm::vec3 ac = c - a;
  const glm::vec3 p = glm::cross(direction, ac);
  const float determinant = glm::dot(ab, p);
  if (!(determinant < 0.0f)) return std::nullopt;  // The ray enters.
  const glm::vec3 s = from - a;
  const float v = glm::dot(s, p) / determinant;
  if (v < 0.0f || v > 1.0f) return std::nullopt;
  const glm::vec3 q = glm::cross(s, ab);
  const float w = glm::dot(direction, q) / determinant;
  if (w < 0.0f || v + w > 1.0f) return std::nullopt;
  const float distance = glm::dot(ac, q) / determinant;
  if (!(distance > 0.0f)) return std::nullopt;
  return SkinExit{distance, glm::cross(ab, ac), -1, {1.0f - v - w, v, w}};
}

}  // namespace

Flesh::Flesh(const Character& character, BodyFrame& frame) : character_(character), frame_(frame) {
  skinOfZone_.resize(allBodySlots().size());
  const ControlMesh& mesh = character.mesh;
  std::vector<Zone> zones(mesh.positions.size());
  for (std::size_t v = 0; v < zones.size(); ++v) {
    zones[v] = at(frame.zoneOfBone, strongestBone(character, static_cast<int>(v)));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& corners = mesh.triangles[i].vertices;
    const Zone second = at(zones, corners[1]);
    const Zone zone = second == at(zones, corners[2]) ? second : at(zones, corners[0]);
    const Piece piece{{at(mesh.positions, corners[0]), at(mesh.positions, corners[1]), at(mesh.positions, corners[2])},
                      static_cast<int>(i)};
    skin_.push_back(piece);
    if (zone >= 0) at(skinOfZone_, zone).push_back(piece);
  }
  if (auto& trunk = frame_.axes[static_cast<std::size_t>(Slot::kSpine)]) centerTrunk(*trunk);
  measureMedians();
}

std::optional<SkinExit> Flesh::leave(const glm::vec3& from, const glm::vec3& direction, const std::vector<Zone>& zones,
                                     float usual) const {
  std::optional<SkinExit> last;
  std::optional<SkinExit> beyond;
  for (const Zone zone : zones) {
    for (const Piece& piece : at(skinOfZone_, zone)) {
      const auto found = exitThrough(from, direction, piece.corners[0], piece.corners[1], piece.corners[2]);
      if (!found || found->distance > kMostFlesh * frame_.height) continue;
      const bool isUsual = found->distance <= usual;
      std::optional<SkinExit>& best = isUsual ? last : beyond;
      if (best && (best->distance < found->distance) != isUsual) continue;
      if (best && best->distance == found->distance) continue;
      best = found;
      best->triangle = piece.triangle;
    }
  }
  if (!last) last = beyond;
  if (last) last->normal = normalizeOr(last->normal, direction);
  return last;
}

std::optional<float> Flesh::thicknessAt(const PartAxis& axis, float u, float angle, const std::vector<Zone>& zones,
                                        float usual) const {
  const auto found = leave(axis.point(u), axis.radial(u, angle), zones, usual);
  return found ? std::optional(found->distance) : std::nullopt;
}

void Flesh::centerTrunk(PartAxis& trunk) const {
  const std::vector<Zone> zones = zonesAround(Slot::kSpine);
  const PartAxis before = trunk;
  for (std::size_t i = 0; i < trunk.points.size(); ++i) {
    float along = 0.0f;
    for (std::size_t k = 0; k < i; ++k) along += glm::distance(before.points[k], before.points[k + 1]);
    const float u = before.length > 0.0f ? std::clamp(along / before.length, 0.05f, 0.95f) : 0.0f;
    const glm::vec3 ahead = before.radial(u, 0.0f);
    const auto front = leave(before.point(u), ahead, zones);
    const auto back = leave(before.point(u), -ahead, zones);
    if (front && back) trunk.points[i] += 0.5f * (front->distance - back->distance) * ahead;
  }
}

void Flesh::measureMedians() {
  for (int i = 0; i < kSlotCount; ++i) {
    const auto& axis = at(frame_.axes, i);
    if (!axis) continue;
    const std::vector<Zone> zones = zonesAround(static_cast<Slot>(i));
    std::vector<float> found;
    for (const float u : {0.25f, 0.5f, 0.75f}) {
      for (const float angle : kAround) {
        if (const auto t = thicknessAt(*axis, u, angle, zones, std::numeric_limits<float>::max())) found.push_back(*t);
      }
    }
    if (found.size() < 6) continue;
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::ranges::nth_element(found, middle);
    at(medians_, i) = *middle;
  }
}

/// Sum of the solid angles of all triangles (van Oosterom & Strackee 1983).
bool Flesh::isInside(const glm::vec3& point) const {
  double turns = 0.0;
  for (const Piece& piece : skin_) {
    const glm::vec3 a = piece.corners[0] - point;
    const glm::vec3 b = piece.corners[1] - point;
    const glm::vec3 c = piece.corners[2] - point;
    const float toA = glm::length(a);
    const float toB = glm::length(b);
    const float toC = glm::length(c);
    const float over = glm::dot(a, glm::cross(b, c));
    const float under = toA * toB * toC + glm::dot(a, b) * toC + glm::dot(b, c) * toA + glm::dot(c, a) * toB;
    turns += static_cast<double>(std::atan2(over, under));
  }
  return turns > 0.5 * 2.0 * std::numbers::pi;
}

std::optional<SkinExit> Flesh::usualExit(const FleshPoint& place, const std::vector<Zone>& zones, float usual) const {
  auto found = leave(place.axis, place.radial, zones, usual);
  return found && found->distance <= usual ? found : std::nullopt;
}

std::optional<FleshPoint> Flesh::measure(const Mark& mark, bool onSkin) const {
  float u = 0.0f;
  const PartAxis* axis = frame_.axisOf(mark, u);
  if (axis == nullptr) return std::nullopt;
  Slot part = Slot::kSpine;
  for (int i = 0; i < kSlotCount; ++i) {
    const auto& own = at(frame_.axes, i);
    if (own && &*own == axis) part = static_cast<Slot>(i);
  }
  const float median = medians_[static_cast<std::size_t>(part)];
  if (!(median > 0.0f)) return std::nullopt;
  const std::vector<Zone> zones = zonesAround(part);
  FleshPoint place;
  place.axis = axis->point(u);
  place.radial = axis->radial(u, mark.angle);
  const float usual = kUsualFlesh * median;
  auto own = leave(place.axis, place.radial, zones, usual);
  // At a shoulder with few triangles, the skin over the trunk may belong to the arm.
  if (!own && part == Slot::kSpine) own = usualExit(place, {zoneOf(Slot::kUpperArm), zoneOf(Slot::kFrontUpper)}, usual);
  float thickness = own ? own->distance : 0.0f;
  // Bridges a gap between parts by the skin on both sides of it.
  for (float aside = 15.0f; thickness <= 0.0f && aside <= 60.0f; aside += 15.0f) {
    const auto one = thicknessAt(*axis, u, mark.angle - aside, zones, usual);
    const auto other = thicknessAt(*axis, u, mark.angle + aside, zones, usual);
    if (one && other) thickness = 0.5f * (*one + *other);
  }
  // Near a shoulder or hip the skin may belong to the trunk.
  if (thickness <= 0.0f && part != Slot::kSpine) {
    own = usualExit(place, {zoneOf(Slot::kSpine)}, usual);
    if (own) thickness = own->distance;
  }
  if (thickness <= 0.0f && !onSkin) thickness = median;
  if (thickness <= 0.0f) return std::nullopt;
  place.thickness = std::clamp(thickness, 0.2f * median, 5.0f * median);
  place.size = std::clamp(place.thickness, 0.6f * median, 1.5f * median);
  glm::vec3 normal(0.0f);
  float edges = 0.0f;
  int count = 0;
  const auto add = [&](const std::optional<SkinExit>& found) {
    if (!found) return;
    normal += found->normal;
    const auto& corners = at(character_.mesh.triangles, found->triangle).vertices;
    for (std::size_t k = 0; k < 3; ++k) {
      edges += glm::distance(at(character_.mesh.positions, corners[k]),
                             at(character_.mesh.positions, corners[(k + 1) % 3])) /
               3.0f;
    }
    ++count;
  };
  add(own);
  const auto addBeside = [&](float along, float angle) {
    add(leave(axis->point(along), axis->radial(along, angle), zones, usual));
  };
  for (const float aside : {-14.0f, 14.0f}) addBeside(u, mark.angle + aside);
  for (const float beside : {-0.06f, 0.06f}) addBeside(u + beside, mark.angle);
  place.normal = normalizeOr(normal, place.radial);
  if (glm::dot(place.normal, place.radial) < 0.3f) place.normal = place.radial;
  place.edge = count > 0 ? edges / static_cast<float>(count) : 0.0f;
  return place;
}

namespace {

BodyKind kindOf(Slot slot) {
  if (slot >= Slot::kFrontUpper) return BodyKind::kQuadruped;
  return slot >= Slot::kUpperArm ? BodyKind::kHumanoid : BodyKind::kUnknown;
}

}  // namespace

BodySlots bodySlots(const Character& character, const MirrorPlan& plan, std::span<const SlotCorrection> corrections) {
  SlotHints hints;
  hints.twinOf = plan.twinOf;
  hints.planeNormal = glm::vec3(plan.plane.normal);
  hints.carriesSkin = bonesWithSkin(character);
  hints.height = character.height;
  BodySlots slots = findBodySlots(character.skeleton, hints);
  // Parts in the file replace those found on the same bones, and all limbs of an animal.
  for (SlotBone& found : slots.bones) {
    const bool named = std::ranges::count(character.bodyParts, found.bone, &BodyPart::bone) > 0;
    if (found.bone >= 0 && named) found = {};
  }
  for (const BodySlot slot : allBodySlots()) {
    if (!character.bodyParts.empty() && slot.slot >= Slot::kFrontUpper) slots[slot] = {};
  }
  for (const BodyPart& part : character.bodyParts) {
    slots[bodySlotNamed(part.slot).value()] = {part.bone, SlotConfidence::kSure};
    slots.kind = BodyKind::kHumanoid;
  }
  for (const auto& [name, boneName] : corrections) {
    const std::optional<BodySlot> slot = bodySlotNamed(name);
    if (!slot) continue;
    if (boneName.empty()) {
      slots[*slot] = {-1, SlotConfidence::kGiven};
    } else if (const std::optional<int> bone = character.skeleton.findBone(boneName)) {
      slots[*slot] = {*bone, SlotConfidence::kGiven};
      if (kindOf(slot->slot) != BodyKind::kUnknown) slots.kind = kindOf(slot->slot);
    }
  }
  return slots;
}

namespace {

constexpr float kBeyond = 0.1f;      ///< Flesh is measured up to this far beyond the ends of a part.
constexpr int kPulls = 16;           ///< Steps to the axis.
constexpr float kUnderSkin = 0.85f;  ///< Fraction of the distance from the axis to the end of the flesh.
constexpr float kRounder = 2.0f;  ///< Largest stretch across over stretch along, so that muscles do not become balls.

BodySlot slotOf(Zone zone) { return at(allBodySlots(), zone); }

glm::vec3 joint(const Character& character, int bone) {
  return glm::vec3(at(character.skeleton.bones, bone).bindInWorld[3]);
}

glm::vec3 mirrored(const MirrorPlan& plan, const glm::vec3& point) {
  return glm::vec3(reflected(plan.plane, glm::dvec3(point)));
}
glm::mat3 mirrored(const MirrorPlan& plan, const glm::mat3& axes) {
  const glm::vec3 normal(plan.plane.normal);
  glm::mat3 image;
  for (glm::length_t i = 0; i < 3; ++i) image[i] = axes[i] - 2.0f * glm::dot(axes[i], normal) * normal;
  return image;
}

}  // namespace

MeasuredBody::MeasuredBody(const Character& body, const MirrorPlan& mirror,
                           const std::vector<SlotCorrection>& corrections)
    : character(body),
      plan(mirror),
      frame(makeBodyFrame(body, bodySlots(body, mirror, corrections))),
      flesh(body, frame) {}

float BodyMove::stretchAlong(const glm::vec3& way) const {
  // A weighted geometric mean, so that mapping there and back cancels.
  float sum = 0.0f;
  for (glm::length_t i = 0; i < 3; ++i) {
    const float share = glm::dot(way, from[i]);
    sum += share * share * std::log(stretch[i]);
  }
  return std::exp(sum);
}

bool BodyMap::hasPart(BodySlot slot) const {
  // Different kinds of bodies share only the parts in the middle: a collar bone is not a shoulder blade.
  const bool sameKind = from_.frame.slots.kind == to_.frame.slots.kind;
  if (slot.isSided() && !sameKind) return false;
  return to_.frame.slots[slot].bone >= 0;
}

int BodyMap::byName(int bone, std::optional<Zone> zone) const {
  const Bone& own = at(from_.character.skeleton.bones, bone);
  for (const std::string* name : {&own.path, &own.name}) {
    const std::optional<int> found = to_.character.skeleton.findBone(*name);
    if (found && (!zone || at(to_.frame.zoneOfBone, *found) == *zone)) return *found;
  }
  return -1;
}

/// The bone at the same index in a chain of equal length, else the one at the same level of the part.
int BodyMap::inChain(int bone, const std::vector<int>& ours, const std::vector<int>& theirs, Slot slot) const {
  const auto found = std::ranges::find(ours, bone);
  if (found == ours.end() || theirs.empty()) return -1;
  if (ours.size() == theirs.size()) return theirs[static_cast<std::size_t>(found - ours.begin())];
  const auto& axis = at(from_.frame.axes, static_cast<int>(slot));
  const auto& other = at(to_.frame.axes, static_cast<int>(slot));
  if (!axis || !other) return theirs.front();
  const Bone& own = at(from_.character.skeleton.bones, bone);
  const glm::vec3 middle(own.bindInWorld * glm::vec4(0.5f * own.tip, 1.0f));
  const float u = placeAt(*axis, middle, 0.0f).u;
  const auto level = [&](int each) { return placeAt(*other, joint(to_.character, each), 0.0f).u; };
  int best = theirs.front();
  for (const int each : theirs) {
    if (level(each) <= u) best = each;
  }
  return best;
}

int BodyMap::bone(int bone) const {
  const Zone zone = at(from_.frame.zoneOfBone, bone);
  if (zone < 0) return byName(bone, std::nullopt);
  const BodySlots& ours = from_.frame.slots;
  const BodySlots& theirs = to_.frame.slots;
  const BodySlot slot = slotOf(zone);
  if (slot.slot == Slot::kSpine) {
    if (theirs.boneOf(Slot::kHips) < 0) return byName(bone, std::nullopt);
    if (bone == ours.boneOf(Slot::kHips)) return theirs.boneOf(Slot::kHips);
    if (const int same = inChain(bone, ours.trunk, theirs.trunk, Slot::kSpine); same >= 0) return same;
    if (const int same = byName(bone, zone); same >= 0) return same;
    const int parent = at(from_.character.skeleton.bones, bone).parent;
    return parent >= 0 && at(from_.frame.zoneOfBone, parent) == zone ? this->bone(parent) : theirs.boneOf(Slot::kHips);
  }
  if (!hasPart(slot)) return -1;
  if (bone == ours[slot].bone) return theirs[slot].bone;
  if (slot.slot == Slot::kNeck) {
    if (const int same = inChain(bone, ours.neck, theirs.neck, Slot::kNeck); same >= 0) return same;
  }
  const int same = byName(bone, zone);
  return same >= 0 ? same : theirs[slot].bone;
}

/// On the left side.
BodyMove BodyMap::alongPart(Slot slot, const glm::vec3& point) const {
  const PartAxis& ours = *at(from_.frame.axes, static_cast<int>(slot));
  const PartAxis& theirs = *at(to_.frame.axes, static_cast<int>(slot));
  const auto [u, angle, away, beside] = placeAt(ours, point, kOnAxis * from_.frame.height);
  const Mark mark{slot, std::clamp(u, -kBeyond, 1.0f + kBeyond), angle, 0.0f};
  const auto flesh = from_.flesh.measure(mark, false);
  const auto other = to_.flesh.measure(mark, false);
  const float along = theirs.length / ours.length;
  float deep = to_.frame.height / from_.frame.height;
  float across = deep;
  if (flesh && other) {
    deep = other->thickness / flesh->thickness;
    across = std::min(other->size / flesh->size, kRounder * along);
  }
  BodyMove move;
  move.from = axesAt(ours, u, angle);
  move.to = axesAt(theirs, u, angle);
  move.stretch = {across, across, along};
  move.axis = theirs.point(u);
  move.point = theirs.point(u) + deep * away * move.to[0] + along * beside * move.to[2];
  return move;
}

/// For a part without axis: follows the direction of the bone and the sizes of the bodies.
BodyMove BodyMap::besideBone(int bone, const glm::vec3& point) const {
  const int counterpart = this->bone(bone);
  const auto basisOf = [](const MeasuredBody& body, int which) {
    const Bone& own = at(body.character.skeleton.bones, which);
    const glm::vec3 along = normalizeOr(glm::mat3(own.bindInWorld) * own.tip, {0.0f, 1.0f, 0.0f});
    const glm::vec3& front = body.frame.slots.forward;
    glm::vec3 ahead = front - glm::dot(front, along) * along;
    if (glm::length(ahead) < 0.3f) ahead = glm::vec3(0, 1, 0) - along.y * along;
    ahead = glm::normalize(ahead);
    return glm::mat3(ahead, glm::cross(along, ahead), along);
  };
  BodyMove move;
  move.from = basisOf(from_, bone);
  move.to = basisOf(to_, counterpart);
  const float size = to_.frame.height / from_.frame.height;
  move.stretch = glm::vec3(size);
  move.axis = joint(to_.character, counterpart);
  move.point = move.axis + size * (move.turn() * (point - joint(from_.character, bone)));
  return move;
}

bool BodyMap::isMeasured(Zone zone) const {
  if (zone < 0) return false;
  const auto index = static_cast<int>(slotOf(zone).slot);
  return at(from_.frame.axes, index) && at(to_.frame.axes, index);
}

bool BodyMap::isOnRight(Zone zone, const glm::vec3& inBind) const {
  const BodySlot slot = slotOf(zone);
  if (slot.isSided()) return slot.side == BodySide::kRight;
  return glm::dot(inBind - mirrored(from_.plan, inBind), from_.frame.slots.left) < 0.0f;
}

/// Towards the axis until the skin encloses the point, and its mirror image too, as no mesh is quite symmetric.
bool BodyMap::pullIn(BodyMove& move, const glm::vec3& point, bool onBothSides) const {
  const auto isInside = [&](const glm::vec3& place) {
    return to_.flesh.isInside(place) && (!onBothSides || to_.flesh.isInside(mirrored(to_.plan, place)));
  };
  if (isInside(move.point) || !from_.flesh.isInside(point)) return true;
  const auto towardsAxis = [&](float share) { return glm::mix(move.axis, move.point, share); };
  for (int step = kPulls - 1; step >= 0; --step) {
    const float share = static_cast<float>(step) / kPulls;
    if (!isInside(towardsAxis(share))) continue;
    const bool deeper = isInside(towardsAxis(kUnderSkin * share));
    move.point = towardsAxis(deeper ? kUnderSkin * share : share);
    move.isPulled = true;
    return true;
  }
  return false;
}

std::optional<BodyMove> BodyMap::moved(int bone, const glm::vec3& inBind, bool into) const {
  const Zone zone = at(from_.frame.zoneOfBone, bone);
  const bool measured = isMeasured(zone);
  // Everything is measured on the left, so that twins stay twins although the sides differ.
  const bool onRight = measured && isOnRight(zone, inBind);
  const glm::vec3 point = onRight ? mirrored(from_.plan, inBind) : inBind;
  BodyMove move = measured ? alongPart(slotOf(zone).slot, point) : besideBone(bone, point);
  if (into && !pullIn(move, point, measured)) return std::nullopt;
  if (!onRight) return move;
  move.point = mirrored(to_.plan, move.point);
  move.axis = mirrored(to_.plan, move.axis);
  move.from = mirrored(from_.plan, move.from);
  move.to = mirrored(to_.plan, move.to);
  return move;
}

BodyMove BodyMap::move(int bone, const glm::vec3& inBind) const { return *moved(bone, inBind, false); }

std::optional<BodyMove> BodyMap::moveInto(int bone, const glm::vec3& inBind) const { return moved(bone, inBind, true); }

}  // namespace sinew
