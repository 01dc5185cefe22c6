// app/viewport/tools/select.h: what lies under the pointer or in a box, and selecting it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/render/picking.h"
#include "app/viewport/render/view.h"
#include "app/viewport/tools/viewport_context.h"

struct ImDrawList;

namespace sinew::app {

/// A muscle or a bone under the pointer.
struct PickEntry {
  PrimitiveId muscle;      ///< 0: a bone. Of a sheet its first belly.
  int bone = -1;           ///< Index into Skeleton::bones; -1: a muscle.
  float distance = 0.0f;   ///< Along the ray.
  bool concealed = false;  ///< Hidden: only picked by repeated clicks.

  [[nodiscard]] bool isSameAs(const PickEntry& other) const { return muscle == other.muscle && bone == other.bone; }
};

/// First part of a ray inside the body. Layers of skin that nearly touch, such as clothes, count as one.
struct BodySpan {
  float enter = 0.0f;  ///< The visible skin.
  float leave = 0.0f;  ///< Out of the body or into another part of it; infinite for open surfaces.
};
/// @param crossings  nearest first  @param seen  distance of the visible skin  @param layer  largest distance of layers
[[nodiscard]] BodySpan bodySpan(const std::vector<SurfaceCrossing>& crossings, float seen, float layer);

/// The muscles under the pointer that are neither hidden nor locked. Visible ones first:
///   shells in front of the skin, nearest first;
///   muscles that lift the skin there, by distance from their shells;
///   drawn shells under this skin, no deeper than they are thick and in the nearer half of the body.
/// Then concealed ones, nearest first: shells deeper in the body or behind it. Shells that are not drawn need skin in
/// front of them.
/// @param skin  the nearest hit of the ray; nullopt: it misses the body  @param skinBone  boneAt of that hit
[[nodiscard]] std::vector<PickEntry> musclesUnder(const ViewportContext& context, const Ray& ray,
                                                  const std::optional<SurfaceHit>& skin, int skinBone);

/// A point that moves with the skin: on a control triangle, or a little off it where the patch is curved.
struct SkinAnchor {
  int triangle = -1;            ///< Control triangle.
  glm::vec3 barycentric{0.0f};  ///< Sums to 1.
  float height = 0.0f;          ///< Above the flat triangle along the skinned normal, character units.
};

/// A skin anchor in a pose.
struct SkinPoint {
  glm::vec3 point{0.0f};   ///< World.
  glm::vec3 normal{0.0f};  ///< World, unit, outward.
};

/// Things under the pointer. Index -1: none.
struct ViewportHover {
  int primitive = -1;  ///< Rig index of what a click picks, see musclesUnder; of a sheet its first belly.
  int bone = -1;       ///< Strongest bone of the skin, or a bone in x-ray.
  std::optional<SkinAnchor> skin;
  glm::vec3 pointInWorld{0.0f};  ///< The nearest hit; valid if primitive >= 0, bone >= 0 or skin.
  std::vector<PickEntry> here;   ///< Picked by clicks on this place, in turn.
  std::size_t at = 0;            ///< Index into `here` of the next pick.
  int taken = -1;                ///< Index of the last pick; -1: none yet.

  [[nodiscard]] bool any() const { return primitive >= 0 || bone >= 0 || skin.has_value(); }
};

/// The nearest skin under a pixel, whatever else lies there.
[[nodiscard]] std::optional<SkinAnchor> skinUnder(const ViewportContext& context, const View& view,
                                                  const glm::vec2& pixel);

/// An anchor in a pose, by linear blend skinning of its three corners.
[[nodiscard]] SkinPoint skinPointAt(const Character& character, const Pose& pose, const SkinAnchor& anchor);

/// The bone with the largest weight on the skin there; ties go to the lower index.
[[nodiscard]] int boneAt(const Character& character, const SkinAnchor& anchor);

/// The visible primitives of the document's rig in a pose, with their selection.
[[nodiscard]] std::vector<PrimitiveShape> primitiveShapes(const Document& document, const Pose& pose);

/// `skin` is the nearest skin, whatever else lies there. Muscles in the order of musclesUnder, then the skin's bone; a
/// bone in x-ray within a few pixels comes first.
[[nodiscard]] ViewportHover hoverAt(const ViewportContext& context, const View& view, const glm::vec2& pixel);

/// A click: selects the primitive, else the bone; `add` (Shift) toggles a primitive. On nothing: clears, unless `add`.
void pick(Document& document, const ViewportHover& hover, bool add);

/// For the status line and the tooltip: "thigh L on b_LeftLeg01_015", "Bone b_LeftLeg01_015" or "".
[[nodiscard]] std::string describe(const ViewportHover& hover, const Document& document);

enum class BoxMode { kReplace, kAdd, kRemove };

/// In pixels.
struct BoxDrag {
  glm::vec2 from{0.0f};
  glm::vec2 to{0.0f};
  BoxMode mode = BoxMode::kReplace;
};

struct BoxSelectState {
  bool armed = false;  ///< The next press on the picture begins a box.
  std::optional<BoxDrag> drag;
};

/// Applies a finished box to the muscles whose outline or center it contains, also behind the skin.
void selectBox(const ViewportContext& context, const View& view, const BoxDrag& box);

/// @param topLeft, unitsPerPixel  as for drawGizmo
void drawBox(ImDrawList& list, const BoxDrag& box, const glm::vec2& topLeft, float unitsPerPixel);

}  // namespace sinew::app
