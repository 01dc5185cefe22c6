// app/viewport/tools/select.cpp: what lies under the pointer or in a box, and selecting it.

#include "app/viewport/tools/select.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_set>

#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/ui/code_points.h"
#include "app/ui/style.h"
#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/silhouette.h"
#include "core/rig/attachment.h"

namespace sinew::app {
namespace {

constexpr float kCoveredBelow = 1.12f;  ///< Skin over a muscle blends a little outside its ellipsoid.
constexpr float kBulgeBelow = 1.4f;     ///< Where the skin is visibly lifted, its bulge reaches further.
constexpr float kVisibleLift = 0.004f;  ///< Fraction of H.
constexpr float kNearHalf = 0.6f;       ///< Fraction of the way through the body; the rest belongs to its other side.
constexpr float kLayer = 0.006f;        ///< Distance of clothes from skin, fraction of H.

enum class Place { kInFront, kHoldsSkin, kUnderSkin, kConcealed };

struct Candidate {
  PickEntry entry;
  Place place;
  float rank;  ///< Within the place; smaller is taken first.
};

/// Hits of the ray, for all muscles.
struct Sight {
  const ViewportContext& context;
  const Ray& ray;
  const std::optional<SurfaceHit>& skin;
  int skinBone;
  BodySpan body;
  float lift = 0.0f;  ///< Displacement of the skin that is hit, character units.
};

struct Muscle {
  const Primitive& primitive;
  PrimitiveId id;  ///< Of a belly that of the sheet's first.
  int bone;
  const Placement& placement;  ///< On its line.
  const glm::mat4& carrier;    ///< Bone space -> world.
  bool drawn;
};

float liftAt(const SurfaceHit& hit, const Surface& surface) {
  const auto& corners = surface.refinement->triangles[static_cast<std::size_t>(hit.refinedTriangle)];
  float lift = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const auto vertex = static_cast<std::size_t>(corners[static_cast<std::size_t>(i)]);
    if (vertex < surface.displacement.size()) lift += hit.barycentric[i] * surface.displacement[vertex];
  }
  return std::abs(lift);
}

/// Whether a depth is in the half of the body that the viewer sees.
bool isOnThisSide(const Sight& sight, float middle) {
  return middle <= glm::mix(sight.body.enter, sight.body.leave, kNearHalf) || std::isinf(sight.body.leave);
}

/// Distance of the skin from the shell in radii, if the muscle lifts it and has it in its territory.
std::optional<float> heldSkin(const Sight& sight, const Muscle& muscle) {
  const Skeleton& skeleton = sight.context.document.character->skeleton;
  const UnitBallMap map = unitBallMap(muscle.placement, 1.0f, muscle.carrier);
  if (!(map.boundingRadius > 0.0f)) return std::nullopt;
  const glm::vec3& skin = sight.skin->position;
  const float radii = std::sqrt(map.rSquared(skin));
  const bool bulges = sight.lift > kVisibleLift * sight.context.document.character->height;
  if (!(radii < (bulges ? kBulgeBelow : kCoveredBelow))) return std::nullopt;
  const MuscleLine* line = lineOf(sight.context.document.rig(), muscle.primitive);
  if (!std::ranges::binary_search(territoryBones(muscle.primitive, muscle.bone, line, skeleton), sight.skinBone)) {
    return std::nullopt;
  }
  const glm::vec3 direction = map.toUnit * sight.ray.direction;
  const glm::vec3 origin = map.toUnit * (sight.ray.origin - map.center);
  const float middle = -glm::dot(origin, direction) / glm::dot(direction, direction);
  return isOnThisSide(sight, middle) ? std::optional(radii) : std::nullopt;
}

/// Thickness of an ellipsoid along a direction.
float thicknessAlong(const glm::mat4& unitBallInWorld, const glm::vec3& direction) {
  return 2.0f * glm::length(glm::transpose(glm::mat3(unitBallInWorld)) * direction);
}

bool isUnderSkin(const Sight& sight, const ShellSpan& span, const glm::mat4& shape) {
  return span.enter < sight.body.leave && span.enter - sight.body.enter <= thicknessAlong(shape, sight.ray.direction) &&
         isOnThisSide(sight, 0.5f * (span.enter + span.leave));
}

std::optional<Candidate> candidateOf(const Sight& sight, const Muscle& muscle) {
  Candidate found{{muscle.id, -1, 0.0f, false}, Place::kConcealed, 0.0f};
  const glm::mat4 shape = shapeInWorld(muscle.placement, 1.0f, muscle.carrier);
  const std::optional<ShellSpan> span = crossShell(sight.ray, shape, muscle.placement.shape);
  if (span && muscle.drawn && (!sight.skin || span->enter < sight.body.enter)) {
    found.place = Place::kInFront;
    found.rank = found.entry.distance = span->enter;
    return found;
  }
  if (!sight.skin) return std::nullopt;
  if (const std::optional<float> radii = heldSkin(sight, muscle)) {
    found.place = Place::kHoldsSkin;
    found.rank = *radii;
    found.entry.distance = sight.body.enter;
    return found;
  }
  if (!span) return std::nullopt;
  found.rank = found.entry.distance = span->enter;
  found.entry.concealed = !muscle.drawn || !isUnderSkin(sight, *span, shape);
  if (!found.entry.concealed) found.place = Place::kUnderSkin;
  return found;
}

}  // namespace

BodySpan bodySpan(const std::vector<SurfaceCrossing>& crossings, float seen, float layer) {
  BodySpan span{seen, std::numeric_limits<float>::infinity()};
  float last = seen;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const SurfaceCrossing& crossing = crossings[i];
    if (crossing.distance <= seen + 0.01f * layer) continue;
    const bool next = !crossing.front && i + 1 < crossings.size() && crossings[i + 1].front &&
                      crossings[i + 1].distance - crossing.distance <= layer;
    if (!next && !(crossing.front && crossing.distance - last <= layer)) {
      span.leave = crossing.distance;
      break;
    }
    last = crossing.distance;
  }
  return span;
}

std::vector<PickEntry> musclesUnder(const ViewportContext& context, const Ray& ray,
                                    const std::optional<SurfaceHit>& skin, int skinBone) {
  const Document& document = context.document;
  const Rig& rig = document.rig();
  const PosedRig& posed = document.posedRig(context.pose);
  const Skeleton& skeleton = document.character->skeleton;
  const std::vector<int> bones = boneOfEach(rig, skeleton);
  const EffectiveVisibility effective = effectiveVisibility(document.visibility, rig, skeleton, bones);
  Sight sight{context, ray, skin, skinBone, {}};
  if (skin) {
    sight.body = bodySpan(crossSurface(ray, *context.surface), skin->distance, kLayer * document.character->height);
    sight.lift = liftAt(*skin, *context.surface);
  }
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (!effective.visible[i] || effective.locked[i] || bones[i] < 0) continue;
    const bool drawn =
        context.display.primitives || context.display.anatomy || document.selection.contains(rig.primitives[i].id());
    if (!posed.muscles[i].usable) continue;
    const auto& [carrier, placement] = posed.muscles[i].body;
    const PrimitiveId id = document.idAt(leadOf(rig, static_cast<int>(i)));
    if (const auto candidate = candidateOf(sight, {rig.primitives[i], id, bones[i], placement, carrier, drawn})) {
      found.push_back(*candidate);
    }
  }
  std::ranges::stable_sort(found, [](const Candidate& a, const Candidate& b) {
    return a.place != b.place ? a.place < b.place : a.rank < b.rank;
  });
  std::vector<PickEntry> entries;
  std::unordered_set<std::uint32_t> seen;
  for (const Candidate& candidate : found) {
    if (seen.insert(candidate.entry.muscle.value).second) entries.push_back(candidate.entry);
  }
  return entries;
}

namespace {

constexpr float kBoneReach = 6.0f;  ///< Design pixels.

std::optional<SurfaceHit> hitSkin(const ViewportContext& context, const Ray& ray) {
  if (!context.surface || !context.surface->refinement || context.surface->positions.empty()) return std::nullopt;
  const Character& character = *context.document.character;
  return pickSurface(ray, *context.surface, character.mesh, character.materials);
}

SkinAnchor anchorOf(const SurfaceHit& hit, const Character& character, const Pose& pose) {
  SkinAnchor anchor{hit.controlTriangle, hit.controlBarycentric, 0.0f};
  const SkinPoint flat = skinPointAt(character, pose, anchor);
  anchor.height = glm::dot(hit.position - flat.point, flat.normal);
  return anchor;
}

}  // namespace

std::optional<SkinAnchor> skinUnder(const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  const std::optional<SurfaceHit> hit = hitSkin(context, view.rayThrough(pixel));
  if (!hit) return std::nullopt;
  return anchorOf(*hit, *context.document.character, context.pose);
}

SkinPoint skinPointAt(const Character& character, const Pose& pose, const SkinAnchor& anchor) {
  const ControlTriangle& triangle = character.mesh.triangles[static_cast<std::size_t>(anchor.triangle)];
  SkinPoint at;
  glm::vec3 first(0.0f, 1.0f, 0.0f);
  for (int corner = 0; corner < 3; ++corner) {
    const int vertex = triangle.vertices[static_cast<std::size_t>(corner)];
    const glm::mat4 matrix = skinMatrix(character, pose, vertex);
    const glm::vec3 position = character.mesh.positions[static_cast<std::size_t>(vertex)];
    const glm::vec3 bindNormal = character.mesh.normals[static_cast<std::size_t>(vertex)];
    const glm::vec3 normal = normalizeOr(normalMatrix(glm::mat3(matrix)) * bindNormal, bindNormal);
    at.point += anchor.barycentric[corner] * glm::vec3(matrix * glm::vec4(position, 1.0f));
    at.normal += anchor.barycentric[corner] * normal;
    if (corner == 0) first = normal;
  }
  at.normal = normalizeOr(at.normal, first);
  at.point += anchor.height * at.normal;
  return at;
}

int boneAt(const Character& character, const SkinAnchor& anchor) {
  std::vector<float> share(character.skeleton.bones.size(), 0.0f);
  const ControlTriangle& triangle = character.mesh.triangles[static_cast<std::size_t>(anchor.triangle)];
  for (int corner = 0; corner < 3; ++corner) {
    const int vertex = triangle.vertices[static_cast<std::size_t>(corner)];
    for (const WeightedBinding& follows : bindingsOf(character, vertex)) {
      share[static_cast<std::size_t>(follows.bone())] += anchor.barycentric[corner] * follows.weight;
    }
  }
  return static_cast<int>(std::ranges::max_element(share) - share.begin());
}

std::vector<PrimitiveShape> primitiveShapes(const Document& document, const Pose& pose) {
  std::vector<PrimitiveShape> shapes = shapesOf(document.rig(), document.posedRig(pose));
  const std::vector<int> hidden = hiddenPrimitives(document.visibility, document.rig(), document.character->skeleton);
  std::erase_if(shapes,
                [&](const PrimitiveShape& shape) { return std::ranges::binary_search(hidden, shape.rigIndex); });
  const Rig& rig = document.rig();
  const int active = document.activePrimitive();
  std::unordered_set<std::uint32_t> selected;
  for (const PrimitiveId id : document.selection.primitives) selected.insert(id.value);
  std::unordered_set<std::string_view> names;
  for (const Primitive& muscle : rig.primitives) {
    if (selected.contains(muscle.id().value)) names.insert(muscle.name);
  }
  for (PrimitiveShape& shape : shapes) {
    const Primitive& muscle = at(rig.primitives, shape.rigIndex);
    shape.selected = selected.contains(muscle.id().value);
    shape.active = shape.selected && leadOf(rig, shape.rigIndex) == active;
    shape.twin = !shape.selected && names.contains(muscle.mirror);
  }
  return shapes;
}

ViewportHover hoverAt(const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  ViewportHover hover;
  const Character& character = *context.document.character;
  const Ray ray = view.rayThrough(pixel);
  const std::optional<SurfaceHit> hit = hitSkin(context, ray);
  if (hit) {
    hover.skin = anchorOf(*hit, character, context.pose);
    hover.bone = boneAt(character, *hover.skin);
    hover.pointInWorld = hit->position;
  }
  hover.here = musclesUnder(context, ray, hit, hover.bone);
  if (!hit && !hover.here.empty()) hover.pointInWorld = ray.origin + hover.here.front().distance * ray.direction;
  std::optional<BoneHit> shown;
  if (context.display.skeleton) {
    shown = pickBone(pixel, view, character.skeleton, context.pose, kBoneReach * context.uiScale, context.hiddenBones);
  }
  if (shown) {
    const glm::vec3 joint(context.pose.boneInWorld[static_cast<std::size_t>(shown->bone)][3]);
    if (!hover.any() && hover.here.empty()) hover.pointInWorld = joint;
    hover.bone = shown->bone;
  }
  // Without visible muscles the skin picks its bone. Concealed muscles come last.
  if (shown || (hit && (hover.here.empty() || hover.here.front().concealed))) {
    hover.here.insert(hover.here.begin(), PickEntry{{}, hover.bone, hit ? hit->distance : 0.0f, false});
  }
  if (!hover.here.empty()) hover.primitive = findPrimitive(context.document.rig(), hover.here.front().muscle);
  return hover;
}

void pick(Document& document, const ViewportHover& hover, bool add) {
  if (hover.primitive >= 0) {
    if (add) toggleMuscle(document, hover.primitive);
    else selectMuscle(document, hover.primitive);
  } else if (hover.bone >= 0) {
    if (!add) document.selection.clear();
    document.selection.bone = hover.bone;
  } else if (!add) {
    document.selection.clear();
  }
}

std::string describe(const ViewportHover& hover, const Document& document) {
  if (hover.primitive >= 0) {
    return shownMuscleName(document.rig(), hover.primitive) + " on " +
           shownBoneName(document.character->skeleton, listedBone(document.rig(), hover.primitive));
  }
  if (hover.bone >= 0) return "Bone " + shownBoneName(document.character->skeleton, hover.bone);
  return "";
}

namespace {

bool inside(const glm::vec3& pixel, const glm::vec2& low, const glm::vec2& high) {
  return std::abs(pixel.z) <= 1.0f && pixel.x >= low.x && pixel.y >= low.y && pixel.x <= high.x && pixel.y <= high.y;
}

/// Points of the visible outline, and the center.
std::vector<glm::vec3> outlineOf(const PrimitiveShape& shape, const View& view) {
  const glm::vec3 eye = view.orthographic ? view.forwardInWorld() : view.eyeInWorld;
  const Silhouette line = silhouetteOf(shape.shape, shape.unitBallInWorld, eye, view.orthographic);
  std::vector<glm::vec3> points(line.begin(), line.end());
  points.emplace_back(shape.unitBallInWorld[3]);
  return points;
}

/// In rig order, without hidden and locked ones; sheets with all their bellies.
std::vector<PrimitiveId> musclesInBox(const ViewportContext& context, const View& view, const glm::vec2& corner,
                                      const glm::vec2& opposite) {
  const glm::vec2 low = glm::min(corner, opposite);
  const glm::vec2 high = glm::max(corner, opposite);
  const Document& document = context.document;
  const Rig& rig = document.rig();
  const Skeleton& skeleton = document.character->skeleton;
  const EffectiveVisibility effective =
      effectiveVisibility(document.visibility, rig, skeleton, boneOfEach(rig, skeleton));
  std::vector<int> hits;
  for (const PrimitiveShape& shape : primitiveShapes(document, context.pose)) {
    if (effective.locked[toIndex(shape.rigIndex)]) continue;
    const std::vector<glm::vec3> points = outlineOf(shape, view);
    const bool hit =
        std::ranges::any_of(points, [&](const glm::vec3& p) { return inside(view.toPixel(p), low, high); });
    if (hit) hits.push_back(shape.rigIndex);
  }
  std::vector<PrimitiveId> muscles;
  for (const int lead : leadsOf(rig, hits)) {
    for (const int member : membersOfMuscle(rig, lead)) muscles.push_back(document.idAt(member));
  }
  return muscles;
}

}  // namespace

void selectBox(const ViewportContext& context, const View& view, const BoxDrag& box) {
  const std::vector<PrimitiveId> muscles = musclesInBox(context, view, box.from, box.to);
  Selection& selection = context.document.selection;
  if (box.mode == BoxMode::kRemove) {
    selection.remove(muscles);
    return;
  }
  if (box.mode == BoxMode::kReplace) selection.bone = -1;
  selection.setAll(muscles, box.mode == BoxMode::kAdd);
  completeSheets(context.document);
}

void drawBox(ImDrawList& list, const BoxDrag& box, const glm::vec2& topLeft, float unitsPerPixel) {
  const glm::vec2 low = topLeft + glm::min(box.from, box.to) * unitsPerPixel;
  const glm::vec2 high = topLeft + glm::max(box.from, box.to) * unitsPerPixel;
  const bool removes = box.mode == BoxMode::kRemove;
  const Tint tint = removes ? palette::kWarning : palette::kAccent;
  list.AddRectFilled({low.x, low.y}, {high.x, high.y}, tint.faded(0.12f).packed());
  list.AddRect({low.x, low.y}, {high.x, high.y}, tint.packed());
}

}  // namespace sinew::app
