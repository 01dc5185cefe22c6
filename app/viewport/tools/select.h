// app/viewport/tools/select.h: what lies under the pointer, and picking it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/render/picking.h"
#include "app/viewport/tools/viewport_context.h"

namespace sinew::app {

// All that lies under the pointer, in the order in which clicks take it.

/// One thing under the pointer: a muscle, or a bone.
struct PickEntry {
  PrimitiveId muscle;      ///< 0: a bone.
  int bone = -1;           ///< Index into Skeleton::bones; -1: a muscle.
  float distance = 0.0f;   ///< Along the ray: where it begins to lie under the pointer.
  bool concealed = false;  ///< Something hides it: only further clicks on the same place take it.

  /// The same thing, wherever it is by now.
  [[nodiscard]] bool isSameAs(const PickEntry& other) const { return muscle == other.muscle && bone == other.bone; }
};

/// Where the ray is inside the body for the first time. Layers of skin that nearly touch, as clothes do, count as one.
struct BodySpan {
  float enter = 0.0f;  ///< The skin that is seen.
  float leave = 0.0f;  ///< Out of the body, or into another part of it; infinite for an open surface.
};
/// @param crossings  nearest first.  @param seen  where the ray meets the skin that is drawn  @param layer  furthest
/// that layers of skin lie apart.
[[nodiscard]] BodySpan bodySpan(const std::vector<SurfaceCrossing>& crossings, float seen, float layer);

/// The muscles under the pointer that are neither hidden nor locked. Those that are seen come first:
///   shells in front of the skin, nearest first;
///   muscles that hold up the skin there, by how near it is to their shells;
///   shells under this skin, if shells are drawn: no deeper than they are thick, and in the body's nearer half.
/// Then the concealed ones, nearest first: shells deeper in the body or behind it. A shell that is not drawn and has no
/// skin in front of it does not count.
/// @param skin  the nearest hit of the same ray; nullopt: it misses the body  @param skinBone  boneAt of that hit
[[nodiscard]] std::vector<PickEntry> musclesUnder(const ViewportContext& context, const Ray& ray,
                                                  const std::optional<SurfaceHit>& skin, int skinBone);

/// A point that rides on the skin: on a control triangle, a little off it where the patch curves.
struct SkinAnchor {
  int triangle = -1;            ///< Control triangle.
  glm::vec3 barycentric{0.0f};  ///< Sums to 1.
  float height = 0.0f;          ///< Along the skinned normal, character units, from the flat triangle.
};

/// A skin anchor in a pose.
struct SkinPoint {
  glm::vec3 point{0.0f};   ///< World.
  glm::vec3 normal{0.0f};  ///< World, unit, outward.
};

/// What the pointer is over. Index -1 where there is none.
struct ViewportHover {
  int primitive = -1;  ///< Rig index: what a click takes, see musclesUnder.
  int bone = -1;       ///< The skin's, by weight; or of the skeleton shown in x-ray.
  std::optional<SkinAnchor> skin;
  glm::vec3 pointInWorld{0.0f};  ///< The nearest hit; valid if primitive >= 0, bone >= 0 or skin.
  std::vector<PickEntry> here;   ///< All that clicks on this place take, in turn.
  std::size_t at = 0;            ///< Index into `here` of what the next click takes.
  int taken = -1;                ///< The same of what the last click took; -1: none has taken from `here` yet.

  [[nodiscard]] bool any() const { return primitive >= 0 || bone >= 0 || skin.has_value(); }
};

/// Where an anchor is in a pose, by linear blend skinning of its three corners.
[[nodiscard]] SkinPoint skinPointAt(const Character& character, const Pose& pose, const SkinAnchor& anchor);

/// The bone with the largest share of the skin there; ties go to the lower index.
[[nodiscard]] int boneAt(const Character& character, const SkinAnchor& anchor);

/// The attached primitives of the document's rig in a pose that are not hidden, with how they are picked: for drawing
/// and for picking (locked ones are drawn and not picked).
[[nodiscard]] std::vector<PrimitiveShape> primitiveShapes(const Document& document, const Pose& pose);

/// What is under a pixel. `skin` is the nearest skin, whatever else lies there. Muscles come in the order of
/// musclesUnder, the skin's bone after those that are seen; a bone shown in x-ray, within a few pixels, comes first.
[[nodiscard]] ViewportHover hoverAt(const ViewportContext& context, const View& view, const glm::vec2& pixel);

/// A click: selects the primitive, else the bone; `add` (Shift) toggles a primitive. On nothing: clears, unless `add`.
void pick(Document& document, const ViewportHover& hover, bool add);

/// For the status line and the tooltip: "thigh L on b_LeftLeg01_015", "Bone b_LeftLeg01_015" or "".
[[nodiscard]] std::string describe(const ViewportHover& hover, const Document& document);

}  // namespace sinew::app
