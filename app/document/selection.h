// app/document/selection.h: what the designer has picked. By name, so that it survives undo.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace sinew::app {

/// Primitives by name in order of picking (the last is the active one, which gizmo and inspector show), and one bone.
struct Selection {
  std::vector<std::string> primitives;
  int bone = -1;  ///< Index into Skeleton::bones, or -1.

  [[nodiscard]] bool contains(const std::string& primitive) const;
  [[nodiscard]] const std::string& active() const;  ///< "" if none.
  void set(const std::string& primitive);           ///< Only this one.
  void toggle(const std::string& primitive);
  /// Picks several at once, in their order; the last becomes active. They replace what was picked, or (`add`) join it.
  void setAll(std::span<const std::string> several, bool add = false);
  void remove(std::span<const std::string> several);
  /// Picks those of `all` that were not picked, and lets go of the others.
  void invert(std::span<const std::string> all);
  /// From the active one to `primitive`, both included, in the order of `shown` (a list as it is drawn); what was
  /// picked before stays if `add`. Without an active one in the list: that one alone.
  void extendTo(const std::string& primitive, std::span<const std::string> shown, bool add = false);
  void clear();
};

}  // namespace sinew::app
