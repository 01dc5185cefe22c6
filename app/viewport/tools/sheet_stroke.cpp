// app/viewport/tools/sheet_stroke.cpp: sheets from strokes on the skin.
#include "app/viewport/tools/sheet_stroke.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/document/shown_names.h"
#include "app/viewport/tools/gizmo.h"
#include "core/bodies/sheets/lay_sheet.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/line_rest.h"
#include "core/rig/sheet_edit.h"

namespace sinew::app {
namespace {

// Fractions of H.
constexpr float kShortStroke = 0.03f;   ///< Below, an edge is a single point.
constexpr float kEdgeBend = 0.003f;     ///< Largest distance of a stroke from its edge.
constexpr float kLeastLength = 0.015f;  ///< Of a sheet.
constexpr float kStripWidth = 0.03f;    ///< About, where the sheet is widest.
constexpr float kBellyLength = 0.04f;   ///< About.
constexpr float kNarrowSheet = 0.04f;   ///< Below, two strips will do.
constexpr float kLeastCrest = 0.006f;
constexpr float kMostCrest = 0.018f;
constexpr float kSheetNearPlane = 0.015f;  ///< An edge that is no further on the other side does not cross the plane.

constexpr int kMostDrawnStrips = 8;
constexpr int kMostDrawnBellies = 6;
constexpr std::size_t kMostDrawnPoints = 16;
constexpr float kCrestOfSize = 0.12f;  ///< Crest over the smaller of length and width.
constexpr float kThickOverCrest = 1.2f;
constexpr float kOriginOfLength = 0.5f;  ///< Width of the origin of a sheet that two clicks made.

using EdgePolyline = std::vector<glm::vec3>;

float edgeLength(const EdgePolyline& points) {
  float length = 0.0f;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return length;
}

glm::vec3 bindPointAt(const Character& character, const Pose& bind, const SkinAnchor& place) {
  return skinPointAt(character, bind, {place.triangle, place.barycentric, 0.0f}).point;
}

/// The bind pose, world. Bones that the character lacks are left out.
EdgePolyline edgeInBind(const Character& character, const SheetEdge& edge) {
  EdgePolyline points;
  for (const LineAnchor& anchor : edge.points) {
    if (const auto found = findPoint(anchor, character.skeleton)) points.emplace_back(found->inBind);
  }
  return points;
}

/// Indices of points that a chain within a distance of all needs: splits where it is furthest away.
void splitChain(const EdgePolyline& points, std::size_t from, std::size_t to, float distance,
                std::vector<std::size_t>& kept) {
  const glm::vec3 chord = points[to] - points[from];
  const float length2 = glm::dot(chord, chord);
  std::size_t furthest = from;
  float most = distance;
  for (std::size_t i = from + 1; i < to; ++i) {
    const glm::vec3 offset = points[i] - points[from];
    const float t = length2 > 0.0f ? std::clamp(glm::dot(offset, chord) / length2, 0.0f, 1.0f) : 0.0f;
    const float away = glm::length(offset - t * chord);
    if (away <= most) continue;
    most = away;
    furthest = i;
  }
  if (furthest == from) return;
  splitChain(points, from, furthest, distance, kept);
  kept.push_back(furthest);
  splitChain(points, furthest, to, distance, kept);
}

std::vector<std::size_t> bendsOf(const EdgePolyline& points, float distance) {
  std::vector<std::size_t> kept;
  do {
    kept.assign(1, 0);
    splitChain(points, 0, points.size() - 1, distance, kept);
    kept.push_back(points.size() - 1);
    distance *= 1.5f;
  } while (kept.size() > kMostDrawnPoints);
  return kept;
}

/// Mean distance between places of two edges, in the same or in opposite directions.
float meanDistance(const EdgePolyline& from, const EdgePolyline& to, bool reversed) {
  constexpr int kPlaces = 5;
  EdgePolyline places = spreadAlong(to, kPlaces);
  if (reversed) std::ranges::reverse(places);
  const EdgePolyline starts = spreadAlong(from, kPlaces);
  float sum = 0.0f;
  for (std::size_t i = 0; i < places.size(); ++i) sum += glm::distance(starts[i], places[i]);
  return sum / static_cast<float>(kPlaces);
}

/// A straight edge through its only point, across the way to another point.
void widenEdge(const Character& character, SheetEdge& edge, const glm::vec3& towards) {
  const BonePoint point = *findPoint(edge.points.front(), character.skeleton);
  const glm::vec3 middle(point.inBind);
  const glm::vec3 inside(at(character.skeleton.bones, point.bone).bindInWorld[3]);
  const glm::vec3 way = towards - middle;
  const glm::vec3 side = glm::cross(way, middle - inside);
  const glm::vec3 half = 0.5f * kOriginOfLength * glm::length(way) * normalizeOr(side, across(glm::normalize(way)));
  edge.points = {anchorOn(character.skeleton, point.bone, middle - half), edge.points.front(),
                 anchorOn(character.skeleton, point.bone, middle + half)};
}

void setSheetSize(MuscleSheet& sheet, float length, float width, float thicker) {
  const auto count = [](float of, float part, int least, int most) {
    return std::clamp(static_cast<int>(std::lround(of / part)), least, most);
  };
  sheet.strips = count(width, kStripWidth, width < kNarrowSheet ? 2 : 3, kMostDrawnStrips);
  sheet.bellies = count(length, kBellyLength, 3, kMostDrawnBellies);
  const float crest = std::clamp(kCrestOfSize * std::min(length, width), kLeastCrest, kMostCrest);
  sheet.crest = std::min(crest * thicker, kMostSheetHeight);
  sheet.thickness = std::min(kThickOverCrest * sheet.crest, kMostSheetHeight);
}

/// Whether it has points on both sides of the plane, or on none.
bool crossesPlane(const MuscleSheet& sheet, const MirrorPlan& plan) {
  const auto near = static_cast<double>(kSheetNearPlane * plan.characterHeight);
  bool left = false;
  bool right = false;
  for (const SheetEdge& edge : sheet.edges) {
    for (const LineAnchor& anchor : edge.points) {
      const auto found = findPoint(anchor, plan.skeleton);
      const double away = found ? distanceTo(plan.plane, found->inBind) : 0.0;
      left = left || away > near;
      right = right || away < -near;
    }
  }
  return left == right;
}

}  // namespace

LineSettings linesOfSheets() {
  LineSettings line;
  line.tendons = {0.1f, 0.1f};
  line.volume = 0.5f;
  line.limits = {0.6f, 1.6f};
  line.pivot = 0.0f;
  line.flex = {0.2f, 0.0f};
  return line;
}

Result<LineAnchor> edgePointAt(const Character& character, const SkinAnchor& place) {
  const int bone = boneAt(character, place);
  const Bone& own = at(character.skeleton.bones, bone);
  if (!isFinite(own.bindInWorld) || isFlat(glm::dmat3(glm::mat3(own.bindInWorld)))) {
    return errorAt(character.skeleton.fileName(bone), "this bone has a scale of zero in the bind pose");
  }
  return anchorOn(character.skeleton, bone, bindPointAt(character, bindPose(character.skeleton), place));
}

Result<SheetEdge> edgeAlong(const Character& character, std::span<const SkinAnchor> stroke) {
  assert(!stroke.empty());
  const Pose bind = bindPose(character.skeleton);
  EdgePolyline points;
  for (const SkinAnchor& place : stroke) points.push_back(bindPointAt(character, bind, place));
  std::vector<std::size_t> kept{points.size() / 2};
  if (edgeLength(points) >= kShortStroke * character.height) kept = bendsOf(points, kEdgeBend * character.height);
  SheetEdge edge;
  for (const std::size_t i : kept) {
    Result<LineAnchor> point = edgePointAt(character, stroke[i]);
    if (!point) return point.error();
    edge.points.push_back(std::move(point).value());
  }
  return edge;
}

Result<MuscleSheet> sheetBetween(const Character& character, SheetEdge origin, SheetEdge insertion, float thicker) {
  const float height = character.height;
  EdgePolyline to = edgeInBind(character, insertion);
  EdgePolyline from = edgeInBind(character, origin);
  if (from.empty() || to.empty()) return errorAt("", "this character lacks bones of the edges");
  if (from.size() == 1 && to.size() == 1 && glm::distance(from[0], to[0]) > kLeastLength * height) {
    widenEdge(character, origin, to.front());
    from = edgeInBind(character, origin);
  }
  const bool reversed = meanDistance(from, to, true) < meanDistance(from, to, false);
  if (reversed) std::ranges::reverse(insertion.points);
  const float length = meanDistance(from, to, reversed);
  if (!(length > kLeastLength * height)) return errorAt("", "a sheet's origin and insertion must be further apart");
  MuscleSheet sheet;
  const std::string& bone = origin.points.front().bone;
  sheet.name = shortBoneNames(character.skeleton)[toIndex(*character.skeleton.findBone(bone))] + " sheet";
  if (bone != insertion.points.front().bone) sheet.line = linesOfSheets();
  setSheetSize(sheet, length / height, std::max(edgeLength(from), edgeLength(to)) / height, thicker);
  sheet.edges = {std::move(origin), std::move(insertion)};
  return sheet;
}

Result<Rig> withDrawnSheet(const Rig& rig, MuscleSheet sheet, const MirrorPlan* plan) {
  sheet.group = rig.groups.empty() ? "muscles" : rig.groups.front().name;
  const bool twin = plan && mirroredSheet(*plan, sheet).ok() && !crossesPlane(sheet, *plan);
  const int index = static_cast<int>(rig.sheets.size());
  Result<Rig> added = addSheet(rig, std::move(sheet));
  if (!added || !twin) return added;
  return mirrorSheetToOtherSide(std::move(added).value(), index, *plan);
}

}  // namespace sinew::app
