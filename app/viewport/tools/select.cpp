// app/viewport/tools/select.cpp: what lies under the pointer, and picking it.

#include "app/viewport/tools/select.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "app/document/shown_names.h"
#include "app/ui/readable_names.h"
#include "app/viewport/render/picking.h"
#include "core/character/bindings.h"

namespace sinew::app {
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
  const std::vector<Primitive>& muscles = document.rig().primitives;
  const int active = document.activePrimitive();
  for (PrimitiveShape& shape : shapes) {
    const Primitive& muscle = muscles[static_cast<std::size_t>(shape.rigIndex)];
    shape.selected = document.selection.contains(muscle.id());
    shape.active = shape.rigIndex == active;
    const int twin = shape.selected || muscle.mirror.empty() ? -1 : findPrimitive(document.rig(), muscle.mirror);
    shape.twin = twin >= 0 && document.selection.contains(document.idAt(twin));
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
  // Where no muscle is seen the skin stands for its bone. Concealed muscles come after all that are seen.
  if (shown || (hit && (hover.here.empty() || hover.here.front().concealed))) {
    hover.here.insert(hover.here.begin(), PickEntry{{}, hover.bone, hit ? hit->distance : 0.0f, false});
  }
  if (!hover.here.empty()) hover.primitive = findPrimitive(context.document.rig(), hover.here.front().muscle);
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
    return shownMuscleName(document.rig(), hover.primitive) + " on " +
           shownBoneName(document.character->skeleton, primitive.bone);
  }
  if (hover.bone >= 0) return "Bone " + shownBoneName(document.character->skeleton, hover.bone);
  return "";
}

}  // namespace sinew::app
