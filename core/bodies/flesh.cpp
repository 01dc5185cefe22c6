// core/bodies/flesh.cpp: rays from an axis to the skin of its own part.
#include "core/bodies/flesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/character/bindings.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kMostFlesh = 0.4f;   ///< Of H: thicker is no flesh but a ray that went astray.
constexpr float kUsualFlesh = 1.8f;  ///< Of the median: skin farther away belongs to another limb.
constexpr float kAround[] = {-150, -120, -90, -60, -30, 0, 30, 60, 90, 120, 150, 180};

/// Moeller & Trumbore 1997; nullopt: it misses, or enters.
std::optional<SkinExit> exitThrough(const glm::vec3& from, const glm::vec3& direction, const glm::vec3& a,
                                    const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 ab = b - a;
  const glm::vec3 ac = c - a;
  const glm::vec3 p = glm::cross(direction, ac);
  const float determinant = glm::dot(ab, p);
  if (!(determinant < 0.0f)) return std::nullopt;  // Outward normals along the ray: it leaves.
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

/// Van Oosterom & Strackee 1983: the solid angles of all triangles, over that of a whole turn.
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
  // Where few triangles cover a shoulder, the skin of the trunk is that of the arm.
  if (!own && part == Slot::kSpine) own = usualExit(place, {zoneOf(Slot::kUpperArm), zoneOf(Slot::kFrontUpper)}, usual);
  float thickness = own ? own->distance : 0.0f;
  // A gap between parts is bridged by the skin on both sides of it.
  for (float aside = 15.0f; thickness <= 0.0f && aside <= 60.0f; aside += 15.0f) {
    const auto one = thicknessAt(*axis, u, mark.angle - aside, zones, usual);
    const auto other = thicknessAt(*axis, u, mark.angle + aside, zones, usual);
    if (one && other) thickness = 0.5f * (*one + *other);
  }
  // Next to a shoulder or a hip the skin is the trunk's.
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

}  // namespace sinew
