// app/tools/select.cpp: what lies under the pointer, and picking it.

#include "app/tools/select.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "app/document/shown_names.h"
#include "app/render/picking.h"
#include "core/character/bindings.h"
#include "core/rig/attachment.h"

namespace sinew::app {
namespace {

constexpr float kBoneReach = 6.0f;      ///< Design pixels.
constexpr float kCoveredBelow = 1.12f;  ///< Skin over a muscle lies a little outside its ellipsoid, where both blend.

glm::mat4 skinMatrix(const Character& character, const Pose& pose, int vertex) {
  glm::mat4 sum(0.0f);
  for (const WeightedBinding& follows : bindingsOf(character, vertex)) {
    const glm::mat4& bone = pose.boneInWorld[static_cast<std::size_t>(follows.bone())];
    sum += follows.weight * (bone * follows.binding.inverseBind);
  }
  return sum;
}

/// By rig index: neither hidden nor locked.
std::vector<bool> pickablePrimitives(const Document& document) {
  const Rig& rig = document.rig();
  const Skeleton& skeleton = document.character->skeleton;
  if (document.visibility.plain()) return std::vector<bool>(rig.primitives.size(), true);
  const EffectiveVisibility effective =
      effectiveVisibility(document.visibility, rig, skeleton, boneOfEach(rig, skeleton));
  std::vector<bool> pickable = effective.visible;
  for (std::size_t i = 0; i < pickable.size(); ++i) pickable[i] = pickable[i] && !effective.locked[i];
  return pickable;
}

/// The innermost of the muscles that hold up the skin at a point, or -1. A muscle only counts where its territory is.
int muscleUnder(const glm::vec3& point, int skinBone, const Document& document, const Pose& pose) {
  int best = -1;
  float least = kCoveredBelow;
  const Skeleton& skeleton = document.character->skeleton;
  const std::vector<bool> pickable = pickablePrimitives(document);
  const std::vector<int> bones = boneOfEach(document.rig(), skeleton);
  for (std::size_t i = 0; i < document.rig().primitives.size(); ++i) {
    const Primitive& primitive = document.rig().primitives[i];
    const int bone = bones[i];
    if (!pickable[i] || bone < 0) continue;
    if (!std::ranges::binary_search(territoryBones(primitive, bone, skeleton), skinBone)) continue;
    const UnitBallMap map = unitBallMap(primitive.placement, 1.0f, pose.boneInWorld[static_cast<std::size_t>(bone)]);
    if (!(map.boundingRadius > 0.0f)) continue;
    const float distance = std::sqrt(map.rSquared(point));
    if (distance >= least) continue;
    least = distance;
    best = static_cast<int>(i);
  }
  return best;
}

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
  std::vector<PrimitiveShape> shapes = shapesOf(document.rig(), document.character->skeleton, pose);
  const std::vector<int> hidden = hiddenPrimitives(document.visibility, document.rig(), document.character->skeleton);
  std::erase_if(shapes,
                [&](const PrimitiveShape& shape) { return std::ranges::binary_search(hidden, shape.rigIndex); });
  for (PrimitiveShape& shape : shapes) {
    shape.selected = document.selection.contains(document.idAt(shape.rigIndex));
  }
  return shapes;
}

ViewportHover hoverAt(const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  ViewportHover hover;
  const Character& character = *context.document.character;
  const Ray ray = view.rayThrough(pixel);
  if (const std::optional<SurfaceHit> hit = hitSkin(context, ray)) {
    hover.skin = anchorOf(*hit, character, context.pose);
    hover.bone = boneAt(character, *hover.skin);
    hover.pointInWorld = hit->position;
    hover.primitive = muscleUnder(hit->position, hover.bone, context.document, context.pose);
  }
  if (context.display.primitives) {
    std::vector<PrimitiveShape> shapes = primitiveShapes(context.document, context.pose);
    const std::vector<bool> pickable = pickablePrimitives(context.document);
    std::erase_if(shapes,
                  [&](const PrimitiveShape& shape) { return !pickable[static_cast<std::size_t>(shape.rigIndex)]; });
    if (const auto hit = pickPrimitive(ray, shapes)) {
      hover.primitive = hit->rigIndex;
      if (!hover.skin) hover.pointInWorld = hit->position;
    }
  }
  if (context.display.skeleton) {
    if (const auto hit = pickBone(pixel, view, character.skeleton, context.pose, kBoneReach * context.uiScale,
                                  context.hiddenBones)) {
      const glm::mat4& boneInWorld = context.pose.boneInWorld[static_cast<std::size_t>(hit->bone)];
      if (!hover.any()) hover.pointInWorld = glm::vec3(boneInWorld[3]);
      hover.bone = hit->bone;
      hover.primitive = -1;
    }
  }
  return hover;
}

void pick(Document& document, const ViewportHover& hover, bool add) {
  if (hover.primitive >= 0) {
    const PrimitiveId muscle = document.idAt(hover.primitive);
    if (add) document.selection.toggle(muscle);
    else document.selection.set(muscle);
  } else if (hover.bone >= 0) {
    if (!add) document.selection.clear();
    document.selection.bone = hover.bone;
  } else if (!add) {
    document.selection.clear();
  }
}

std::string describe(const ViewportHover& hover, const Document& document) {
  if (hover.primitive >= 0) {
    const Primitive& primitive = document.rig().primitives[static_cast<std::size_t>(hover.primitive)];
    return primitive.name + " on " + shownBoneName(document.character->skeleton, primitive.bone);
  }
  if (hover.bone >= 0) return "bone " + shownBoneName(document.character->skeleton, hover.bone);
  return "";
}

}  // namespace sinew::app
