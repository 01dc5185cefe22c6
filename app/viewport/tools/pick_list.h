// app/viewport/tools/pick_list.h: all that lies under the pointer, in the order in which clicks take it.
#pragma once

#include <optional>
#include <vector>

#include "app/viewport/render/picking.h"
#include "app/viewport/tools/viewport_context.h"

namespace sinew::app {

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

}  // namespace sinew::app
