// app/document/selection.h: what the designer has picked.
#pragma once

#include <span>
#include <vector>

#include "sinew/rig/rig.h"

namespace sinew::app {

/// Primitives in order of picking (the last is the active one, which gizmo and inspector show), and one bone. Those
/// that the rig lacks at the moment stay: what undo takes away, redo brings back selected.
struct Selection {
  std::vector<PrimitiveId> primitives;
  int bone = -1;  ///< Index into Skeleton::bones, or -1.

  [[nodiscard]] bool contains(PrimitiveId primitive) const;
  [[nodiscard]] PrimitiveId active() const;  ///< 0 if none.
  void set(PrimitiveId primitive);           ///< Only this one.
  void toggle(PrimitiveId primitive);
  /// Picks several at once, in their order; the last becomes active. They replace what was picked, or (`add`) join it.
  void setAll(std::span<const PrimitiveId> several, bool add = false);
  void remove(std::span<const PrimitiveId> several);
  /// Selects those of `all` that were not selected, and deselects the others.
  void invert(std::span<const PrimitiveId> all);
  void clear();
};

}  // namespace sinew::app
