// app/viewport/tools/pick_list.cpp: all that lies under the pointer, in the order in which clicks take it.

#include "app/viewport/tools/pick_list.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/rig/attachment.h"

namespace sinew::app {
namespace {

constexpr float kCoveredBelow = 1.12f;  ///< Skin over a muscle lies a little outside its ellipsoid, where both blend.
constexpr float kBulgeBelow = 1.4f;     ///< Where the skin is lifted visibly, its bulge reaches further.
constexpr float kVisibleLift = 0.004f;  ///< Fraction of H.
constexpr float kNearHalf = 0.6f;  ///< Share of the way through the body: what is further belongs to its other side.
constexpr float kLayer = 0.006f;   ///< Fraction of H: clothes on skin.

enum class Place { kInFront, kHoldsSkin, kUnderSkin, kConcealed };

struct Candidate {
  PickEntry entry;
  Place place;
  float rank;  ///< Within the place; smaller is taken first.
};

/// What the ray meets, the same for all muscles.
struct Sight {
  const ViewportContext& context;
  const Ray& ray;
  const std::optional<SurfaceHit>& skin;
  int skinBone;
  BodySpan body;
  float lift = 0.0f;  ///< How far muscles move the skin that is hit, character units.
};

/// One muscle before it.
struct Muscle {
  const Primitive& primitive;
  int bone;
  const Placement& placement;  ///< As its line bends it.
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

/// The muscle's middle lies in that half of the body which the viewer sees.
bool isOnThisSide(const Sight& sight, float middle) {
  return middle <= glm::mix(sight.body.enter, sight.body.leave, kNearHalf) || std::isinf(sight.body.leave);
}

/// How far outside its shell the skin there is, in radii, if the muscle holds it up. A muscle only counts where its
/// territory is.
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

/// How thick an ellipsoid is along a direction.
float thicknessAlong(const glm::mat4& unitBallInWorld, const glm::vec3& direction) {
  return 2.0f * glm::length(glm::transpose(glm::mat3(unitBallInWorld)) * direction);
}

bool isUnderSkin(const Sight& sight, const ShellSpan& span, const glm::mat4& shape) {
  return span.enter < sight.body.leave && span.enter - sight.body.enter <= thicknessAlong(shape, sight.ray.direction) &&
         isOnThisSide(sight, 0.5f * (span.enter + span.leave));
}

std::optional<Candidate> candidateOf(const Sight& sight, const Muscle& muscle) {
  Candidate found{{muscle.primitive.id(), -1, 0.0f, false}, Place::kConcealed, 0.0f};
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
    if (const auto candidate = candidateOf(sight, {rig.primitives[i], bones[i], placement, carrier, drawn})) {
      found.push_back(*candidate);
    }
  }
  std::ranges::stable_sort(found, [](const Candidate& a, const Candidate& b) {
    return a.place != b.place ? a.place < b.place : a.rank < b.rank;
  });
  std::vector<PickEntry> entries;
  for (const Candidate& candidate : found) entries.push_back(candidate.entry);
  return entries;
}

}  // namespace sinew::app
