// app/viewport/tools/add_muscle.cpp: paths on the skin, and the ellipsoids along them.

#include "app/viewport/tools/add_muscle.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/viewport/tools/gizmo.h"
#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {

namespace {

constexpr float kFold = 0.02f;          ///< Fraction of H: hidden length that ends the stroke.
constexpr float kShortestLine = 0.01f;  ///< Pixels.

using EdgeEnds = std::pair<int, int>;  ///< Refined vertices, the smaller first.

/// The cut through one triangle.
struct CutPiece {
  EdgeEnds enter;
  EdgeEnds leave;
};

/// The skin cut by a plane. Neighbors wind an edge in opposite ways: the edge that leaves one triangle enters the next.
class SkinCut {
 public:
  SkinCut(const SkinSnapshot& skin, const glm::vec3& origin, const glm::vec3& normal) : skin_(skin) {
    heights_.reserve(skin.positions.size());
    for (const glm::vec3& position : skin.positions) heights_.push_back(glm::dot(position - origin, normal));
    for (const std::array<int, 3>& triangle : skin.refinement->triangles) {
      const auto above = std::ranges::count_if(triangle, [this](int vertex) { return isAbove(vertex); });
      if (above == 1 || above == 2) pieces_.push_back(pieceOf(triangle));
    }
  }

  [[nodiscard]] std::size_t size() const { return pieces_.size(); }

  /// nullopt: the plane misses the skin.
  [[nodiscard]] std::optional<CutPiece> nearestTo(const glm::vec3& point) const {
    std::optional<CutPiece> nearest;
    float least = std::numeric_limits<float>::infinity();
    for (const CutPiece& piece : pieces_) {
      const glm::vec3 from = crossing(piece.enter).point;
      const glm::vec3 along = crossing(piece.leave).point - from;
      const float length2 = glm::dot(along, along);
      const float t = length2 > 0.0f ? std::clamp(glm::dot(point - from, along) / length2, 0.0f, 1.0f) : 0.0f;
      const float distance = glm::length(point - (from + t * along));
      if (distance >= least) continue;
      least = distance;
      nearest = piece;
    }
    return nearest;
  }

  /// Reverses the direction of next().
  void reverse() {
    for (CutPiece& piece : pieces_) std::swap(piece.enter, piece.leave);
  }

  void link() {
    for (const CutPiece& piece : pieces_) byEnter_.emplace(piece.enter, piece);
  }

  /// After link(). nullopt: the skin ends.
  [[nodiscard]] std::optional<CutPiece> next(const CutPiece& piece) const {
    const auto found = byEnter_.find(piece.leave);
    return found == byEnter_.end() ? std::nullopt : std::optional(found->second);
  }

  /// Where the plane crosses an edge.
  [[nodiscard]] SkinPoint crossing(const EdgeEnds& edge) const {
    const auto a = static_cast<std::size_t>(edge.first), b = static_cast<std::size_t>(edge.second);
    const float t = heights_[a] / (heights_[a] - heights_[b]);
    return {glm::mix(skin_.positions[a], skin_.positions[b], t),
            normalizeOr(glm::mix(skin_.normals[a], skin_.normals[b], t), skin_.normals[a])};
  }

 private:
  [[nodiscard]] bool isAbove(int vertex) const { return at(heights_, vertex) >= 0.0f; }

  [[nodiscard]] CutPiece pieceOf(const std::array<int, 3>& triangle) const {
    CutPiece piece;
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = triangle[i], to = triangle[(i + 1) % 3];
      if (isAbove(from) == isAbove(to)) continue;
      (isAbove(from) ? piece.leave : piece.enter) = std::minmax(from, to);
    }
    return piece;
  }

  const SkinSnapshot& skin_;
  std::vector<float> heights_;  ///< [V'] over the plane.
  std::vector<CutPiece> pieces_;
  std::map<EdgeEnds, CutPiece> byEnter_;
};

/// The line on the screen from the press to the pointer.
struct ScreenLine {
  const View& view;
  glm::vec2 from{0.0f};
  glm::vec2 direction{0.0f};
  float length = 0.0f;  ///< Pixels.

  /// Pixels from the start, towards the pointer.
  [[nodiscard]] float progress(const glm::vec3& point) const {
    return glm::dot(glm::vec2(view.toPixel(point)) - from, direction);
  }
};

/// Normal of the plane through the eye and the line, or 0.
glm::vec3 planeNormal(const ScreenLine& line, const glm::vec3& start) {
  const Ray from = line.view.rayThrough(line.from);
  const Ray to = line.view.rayThrough(line.from + line.length * line.direction);
  const float distance = glm::dot(start - from.origin, from.direction);
  const glm::vec3 along = to.origin + distance * to.direction - start;
  return normalizeOr(glm::cross(from.direction, along), glm::vec3(0.0f));
}

SkinPoint between(const SkinPoint& a, const SkinPoint& b, float t) {
  return {glm::mix(a.point, b.point, t), normalizeOr(glm::mix(a.normal, b.normal, t), a.normal)};
}

/// Adds the visible points of the cut up to the line's end.
void follow(const SkinCut& cut, CutPiece piece, const ScreenLine& line, float fold, SkinStroke& stroke) {
  float reached = 0.0f;
  float hidden = 0.0f;
  glm::vec3 last = stroke.points.front().point;
  for (std::size_t step = 0; step < cut.size(); ++step) {
    const SkinPoint here = cut.crossing(piece.leave);
    if (line.view.toPixel(here.point).z > 1.0f) return;
    const float progress = line.progress(here.point);
    if (progress >= line.length) {
      stroke.points.push_back(between(stroke.points.back(), here, (line.length - reached) / (progress - reached)));
      return;
    }
    hidden += glm::length(here.point - last);
    last = here.point;
    if (progress > reached) {
      stroke.points.push_back(here);
      reached = progress;
      hidden = 0.0f;
    }
    const std::optional<CutPiece> next = cut.next(piece);
    if (!next || hidden > fold) return;
    piece = *next;
  }
}

}  // namespace

SkinSnapshot snapshotOf(const Surface& surface) { return {surface.refinement, surface.positions, surface.normals}; }

SkinStroke strokeOnSkin(const SkinSnapshot& skin, const SkinPoint& start, const View& view, const glm::vec2& pixel,
                        float characterHeight) {
  assert(skin.refinement);
  SkinStroke stroke{{start}};
  const glm::vec2 from(view.toPixel(start.point));
  const float length = glm::length(pixel - from);
  if (!(length > kShortestLine)) return stroke;
  const ScreenLine line{view, from, (pixel - from) / length, length};
  const glm::vec3 normal = planeNormal(line, start.point);
  if (normal == glm::vec3(0.0f)) return stroke;
  SkinCut cut(skin, start.point, normal);
  std::optional<CutPiece> piece = cut.nearestTo(start.point);
  if (!piece) return stroke;
  // Seen from behind, triangles wind the other way.
  if (line.progress(cut.crossing(piece->leave).point) < line.progress(cut.crossing(piece->enter).point)) {
    cut.reverse();
    std::swap(piece->enter, piece->leave);
  }
  cut.link();
  follow(cut, *piece, line, kFold * characterHeight, stroke);
  return stroke;
}

namespace {

constexpr float kClickLength = 0.05f;  ///< Semi-axes, of H.
constexpr float kClickWidth = 0.025f;
constexpr float kClickThickness = 0.011f;
constexpr float kWidth = 0.5f;            ///< Fraction of half a stroke's length.
constexpr float kThickness = 0.22f;       // Thin: skin lifted only by the top of a thick ellipsoid would pop in motion.
constexpr float kLeastThickness = 0.01f;  ///< Of H: visible on the skin,
constexpr float kMostThickness = 0.012f;  ///< but not a lump.
constexpr float kShortestStroke = 0.01f;  ///< Chord, of H.
constexpr float kLongestStroke = 1.5f;
constexpr float kLeastHalf = 0.015f;  ///< Half length, of H.
constexpr float kMostHalf = 0.75f;
constexpr float kMostHalfOnBone = 0.3f;
constexpr float kSlenderness = 1.25f;   ///< Length over thickness of a muscle added on a bone, at least.
constexpr float kPerWheelStep = 1.12f;  ///< Factor on the thickness.
constexpr float kThinnest = 0.3f;       ///< Factor on the initial thickness.
constexpr float kThickest = 3.0f;
constexpr float kThinnestEver = 0.003f;  ///< Of H.
constexpr float kSunk = 0.2f;            ///< Depth of the center under the skin, fraction of the thickness.

bool isUsable(const glm::mat4& boneInWorld) {
  return isFinite(boneInWorld) && !isFlat(glm::dmat3(glm::mat3(boneInWorld)));
}

/// World space.
struct EllipsoidInWorld {
  glm::vec3 center{0.0f};
  glm::vec3 along{1.0f, 0.0f, 0.0f};   ///< Unit.
  glm::vec3 normal{0.0f, 0.0f, 1.0f};  ///< Unit, perpendicular to `along`, out of the skin.
  glm::vec3 semiAxes{1.0f};            ///< Along, across, out.
};

EllipsoidInWorld ellipsoidOfClick(const SkinPoint& start, const glm::vec3& boneAxisInWorld, float height) {
  EllipsoidInWorld ellipsoid;
  // Along the bone, unless it is perpendicular to the skin.
  const glm::vec3 bone = normalizeOr(boneAxisInWorld, start.normal);
  const glm::vec3 flat = bone - glm::dot(bone, start.normal) * start.normal;
  ellipsoid.along = glm::dot(flat, flat) > 1e-4f ? glm::normalize(flat) : across(start.normal);
  ellipsoid.normal = start.normal;
  ellipsoid.semiAxes = height * glm::vec3(kClickLength, kClickWidth, kClickThickness);
  ellipsoid.center = start.point - kSunk * ellipsoid.semiAxes.z * start.normal;
  return ellipsoid;
}

/// The points within a distance of the first, up to the first beyond it.
std::span<const SkinPoint> withinReach(const std::vector<SkinPoint>& points, float longest) {
  const auto tooFar = std::ranges::find_if(
      points, [&](const SkinPoint& at) { return glm::length(at.point - points.front().point) > longest; });
  return {points.begin(), tooFar};
}

/// Sum of the path's normals, weighted by length.
glm::vec3 normalSum(std::span<const SkinPoint> path) {
  glm::vec3 sum = 1e-6f * path.front().normal;
  for (std::size_t i = 1; i < path.size(); ++i) {
    sum += glm::length(path[i].point - path[i - 1].point) * (path[i].normal + path[i - 1].normal);
  }
  return sum;
}

/// A path seen from the side: x along its chord from 0 to the chord's length, y over the chord.
struct PathProfile {
  std::vector<glm::vec2> points;
  float length = 0.0f;

  /// y where the path first reaches x, 0..length.
  [[nodiscard]] float heightAt(float x) const {
    for (std::size_t i = 1; i < points.size(); ++i) {
      const glm::vec2 a = points[i - 1], b = points[i];
      if (b.x >= x && b.x > a.x) return glm::mix(a.y, b.y, std::clamp((x - a.x) / (b.x - a.x), 0.0f, 1.0f));
    }
    return 0.0f;
  }

  /// First and last x at a height, or the whole length if the path is lower.
  [[nodiscard]] glm::vec2 rangeAt(float y) const {
    const auto firstX = [y](const auto& from, float otherwise) {
      for (std::size_t i = 1; i < from.size(); ++i) {
        const glm::vec2 a = from[i - 1], b = from[i];
        if (a.y < y && b.y >= y) return glm::mix(a.x, b.x, (y - a.y) / (b.y - a.y));
      }
      return otherwise;
    };
    const std::vector<glm::vec2> backwards(points.rbegin(), points.rend());
    return {firstX(points, 0.0f), firstX(backwards, length)};
  }
};

PathProfile profileOf(std::span<const SkinPoint> path, const glm::vec3& along, const glm::vec3& normal) {
  PathProfile profile;
  for (const SkinPoint& at : path) {
    const glm::vec3 offset = at.point - path.front().point;
    profile.points.emplace_back(glm::dot(offset, along), glm::dot(offset, normal));
  }
  profile.length = profile.points.back().x;
  return profile;
}

float flatThickness(float half, float height) {
  return std::clamp(kThickness * half, kLeastThickness * height, kMostThickness * height);
}

/// Sets semi-axes and center.
void fitToProfile(EllipsoidInWorld& ellipsoid, const glm::vec3& start, const PathProfile& profile, float height) {
  const float halfChord = 0.5f * profile.length;
  const float rise = std::clamp(profile.heightAt(halfChord), -halfChord, halfChord);
  const float thickness = flatThickness(halfChord, height);
  // Half of an arch's height raises the center, half thickens the ellipsoid.
  const float arch = std::max(rise, 0.0f);
  const float level = rise - 0.5f * arch - kSunk * thickness;
  // On a high arch the path at the level of the center is shorter than the chord.
  const glm::vec2 ends = level > 0.0f ? profile.rangeAt(level) : glm::vec2(0.0f, profile.length);
  const float half = std::clamp(0.5f * (ends.y - ends.x), kLeastHalf * height, kMostHalf * height);
  ellipsoid.semiAxes = {half, std::clamp(kWidth * half, 0.02f * height, 0.2f * height),
                        std::min(thickness + 0.5f * arch, kMostHalf * height)};
  ellipsoid.center = start + 0.5f * (ends.x + ends.y) * ellipsoid.along + level * ellipsoid.normal;
}

EllipsoidInWorld ellipsoidOnSkin(const SkinStroke& stroke, const glm::vec3& boneAxisInWorld, float height) {
  assert(!stroke.points.empty());
  const std::span<const SkinPoint> path = withinReach(stroke.points, kLongestStroke * height);
  const SkinPoint& start = path.front();
  const glm::vec3 chord = path.back().point - start.point;
  const float length = glm::length(chord);
  if (length < kShortestStroke * height) return ellipsoidOfClick(start, boneAxisInWorld, height);
  EllipsoidInWorld ellipsoid;
  ellipsoid.along = chord / length;
  const glm::vec3 out = normalSum(path);
  ellipsoid.normal = normalizeOr(out - glm::dot(out, ellipsoid.along) * ellipsoid.along, across(ellipsoid.along));
  fitToProfile(ellipsoid, start.point, profileOf(path, ellipsoid.along, ellipsoid.normal), height);
  return ellipsoid;
}

/// Keeps the relative depth of the center under the skin.
void thicken(EllipsoidInWorld& ellipsoid, float factor, float height) {
  const glm::vec3 before = ellipsoid.semiAxes;
  for (const int axis : {1, 2}) {
    ellipsoid.semiAxes[axis] = std::clamp(factor * before[axis], kThinnestEver * height, kMostHalf * height);
  }
  ellipsoid.center -= kSunk * (ellipsoid.semiAxes.z - before.z) * ellipsoid.normal;
}

/// The bone-space ellipsoid with this world-space long axis, tangent plane and extents. Directions are mapped by
/// inverse(B), planes by transpose(B), which keeps the two perpendicular.
Placement placementOf(const EllipsoidInWorld& ellipsoid, const glm::mat4& boneInWorld) {
  const glm::dmat3 bone{glm::mat3(boneInWorld)};
  const glm::dmat3 inverse = glm::inverse(bone);
  const glm::dvec3 along = glm::normalize(inverse * glm::dvec3(ellipsoid.along));
  const glm::dvec3 out = glm::normalize(glm::transpose(bone) * glm::dvec3(ellipsoid.normal));
  const glm::dvec3 side = glm::cross(out, along);
  const glm::dvec3 size(ellipsoid.semiAxes);
  Placement placement;
  placement.center = glm::vec3(inverse * (glm::dvec3(ellipsoid.center) - glm::dvec3(boneInWorld[3])));
  placement.rotation = glm::normalize(glm::quat_cast(glm::mat3(glm::vec3(along), glm::vec3(side), glm::vec3(out))));
  placement.radii = glm::vec3(size.x / glm::length(bone * along), size.y / glm::length(bone * side),
                              size.z / glm::dot(glm::dvec3(ellipsoid.normal), bone * out));
  return placement;
}

Primitive newMuscle(const Skeleton& skeleton, int bone, const Placement& placement) {
  Primitive primitive;
  primitive.name = defaultMuscleName(skeleton, bone);
  primitive.bone = skeleton.fileName(bone);
  primitive.placement = placement;
  primitive.reach = kNewReach;
  return primitive;
}

constexpr float kNearPlane = 0.01f;  ///< Fraction of H within which a new muscle is moved into the mirror plane.

/// Adds the muscle and, under symmetry and off the middle, its twin.
Result<Rig> withMuscle(const Document& document, const Rig& rig, Primitive muscle) {
  const MirrorPlan* const plan = document.mirror.get();
  if (!document.symmetry || !plan || !twinBone(*plan, muscle.bone)) return addPrimitive(rig, std::move(muscle));
  if (const std::optional<Placement> snapped = snappedToPlane(*plan, muscle, kNearPlane)) {
    muscle.placement = *snapped;
    return addPrimitive(rig, std::move(muscle));
  }
  return addPair(rig, std::move(muscle), *plan);
}

Placement placementOf(const AddMuscleDrag& drag, const SkinStroke& stroke, const Character& character) {
  const glm::vec3 tip = at(character.skeleton.bones, drag.bone).tip;
  return placementOnSkin(stroke, drag.boneInWorld, glm::mat3(drag.boneInWorld) * tip, character.height, drag.thicker);
}

/// Shows the muscle as the state of the gesture.
Result<void> show(const AddMuscleDrag& drag, const SkinStroke& stroke, Document& document) {
  const Placement placement = placementOf(drag, stroke, *document.character);
  Result<Rig> rig =
      withMuscle(document, *drag.rigBefore, newMuscle(document.character->skeleton, drag.bone, placement));
  if (!rig) return rig.error();
  document.commands.updateGesture(std::move(rig).value());
  document.selection.set(document.idAt(nextIndex(*drag.rigBefore)));
  return {};
}

/// Mean distance of the skin that mostly follows a bone from its line, in the bind pose; 0: no such skin.
float skinDistance(const Character& character, int bone, const glm::vec3& origin, const glm::vec3& axis) {
  float sum = 0.0f;
  int count = 0;
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    float weight = 0.0f;
    for (const WeightedBinding& follows : bindingsOf(character, static_cast<int>(v))) {
      if (follows.bone() == bone) weight += follows.weight;
    }
    if (weight < 0.5f) continue;
    const glm::vec3 offset = character.mesh.positions[v] - origin;
    sum += glm::length(offset - glm::dot(offset, axis) * axis);
    ++count;
  }
  return count > 0 ? sum / static_cast<float>(count) : 0.0f;
}

/// World semi-axes of a muscle around a bone: along and across.
glm::vec3 semiAxesAround(const Character& character, int bone, const glm::vec3& segment) {
  const float height = character.height;
  const float length = glm::length(segment);
  const glm::vec3 origin(at(character.skeleton.bones, bone).bindInWorld[3]);
  const glm::vec3 axis = normalizeOr(segment, glm::vec3(0.0f, 1.0f, 0.0f));
  const float half = std::clamp(0.45f * length, 0.03f * height, kMostHalfOnBone * height);
  const float skin = skinDistance(character, bone, origin, axis);
  const float thickness = std::clamp(skin > 0.0f ? 1.15f * skin : 0.4f * half, 0.012f * height, 0.2f * height);
  if (!(length > 0.0f)) return glm::vec3(thickness);
  // Around short bones in thick flesh, longer than the bone rather than a disc.
  const float slender = std::clamp(kSlenderness * thickness, half, kMostHalfOnBone * height);
  const float across = std::min(thickness, slender / kSlenderness);
  return {slender, across, across};
}

}  // namespace

Placement placementOnSkin(const SkinStroke& stroke, const glm::mat4& boneInWorld, const glm::vec3& boneAxisInWorld,
                          float characterHeight, float thicker) {
  assert(isUsable(boneInWorld));
  EllipsoidInWorld ellipsoid = ellipsoidOnSkin(stroke, boneAxisInWorld, characterHeight);
  if (thicker != 1.0f) thicken(ellipsoid, thicker, characterHeight);
  return placementOf(ellipsoid, boneInWorld);
}

Result<void> beginAddMuscle(AddMuscleState& state, const ViewportContext& context, const ViewportHover& hover,
                            const glm::vec2& pixel) {
  if (!hover.skin || !context.surface) return errorAt("", "a muscle is added by pressing on the skin");
  Document& document = context.document;
  AddMuscleDrag drag;
  drag.skin = snapshotOf(*context.surface);
  drag.start = {hover.pointInWorld, skinPointAt(*document.character, context.pose, *hover.skin).normal};
  drag.bone = boneAt(*document.character, *hover.skin);
  drag.boneInWorld = at(context.pose.boneInWorld, drag.bone);
  drag.pressPixel = pixel;
  drag.selectionBefore = document.selection;
  drag.rigBefore = document.commands.sharedRig();
  if (!isUsable(drag.boneInWorld)) {
    return errorAt(document.character->skeleton.fileName(drag.bone), "this bone has a scale of zero in this pose");
  }
  document.commands.beginGesture("Add " + newMuscle(document.character->skeleton, drag.bone, {}).name);
  if (const Result<void> shown = show(drag, {{drag.start}}, document); !shown) {
    document.commands.cancelGesture();
    return shown.error();
  }
  state.drag = std::move(drag);
  return {};
}

void updateAddMuscle(AddMuscleState& state, const ViewportInput& input, const ViewportContext& context,
                     const View& view) {
  assert(state.drag);
  AddMuscleDrag& drag = *state.drag;
  if (input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed) {
    cancelAddMuscle(state, context.document);
    return;
  }
  drag.dragged = drag.dragged || glm::length(input.mouse - drag.pressPixel) > kDragThreshold * context.uiScale;
  drag.thicker = std::clamp(drag.thicker * std::pow(kPerWheelStep, input.wheel), kThinnest, kThickest);
  SkinStroke stroke{{drag.start}};
  if (drag.dragged) {
    stroke = strokeOnSkin(drag.skin, drag.start, view, input.mouse, context.document.character->height);
  }
  static_cast<void>(show(drag, stroke, context.document));  // A refused state is not shown.
  if (!input.button(MouseButton::kLeft).released) return;
  context.document.commands.endGesture();
  state.drag.reset();
}

void cancelAddMuscle(AddMuscleState& state, Document& document) {
  if (!state.drag) return;
  document.commands.cancelGesture();
  document.selection = state.drag->selectionBefore;
  state.drag.reset();
}

Result<std::string> addMuscleOnBone(Document& document, int bone, ShapePreset preset) {
  const Character& character = *document.character;
  const Bone& onBone = at(character.skeleton.bones, bone);
  if (!isUsable(onBone.bindInWorld)) {
    return errorAt(character.skeleton.fileName(bone), "this bone has a scale of zero in the bind pose");
  }
  const glm::vec3 segment = glm::mat3(onBone.bindInWorld) * onBone.tip;
  const glm::vec3 origin(onBone.bindInWorld[3]);
  EllipsoidInWorld ellipsoid;
  ellipsoid.along = normalizeOr(segment, glm::vec3(0.0f, 1.0f, 0.0f));
  ellipsoid.normal = across(ellipsoid.along);
  ellipsoid.center = origin + 0.5f * segment;
  ellipsoid.semiAxes = semiAxesAround(character, bone, segment);
  const Placement placement = shaped(preset, placementOf(ellipsoid, onBone.bindInWorld), kNewReach);
  Result<Rig> rig = withMuscle(document, document.rig(), newMuscle(character.skeleton, bone, placement));
  if (!rig) return rig.error();
  const std::string name = at(rig->primitives, static_cast<int>(document.rig().primitives.size())).name;
  const int index = nextIndex(document.rig());
  document.commands.apply("Add " + name, std::move(rig).value());
  document.selection.set(document.idAt(index));
  return document.activeName();
}

}  // namespace sinew::app
