#pragma once  // app/document/selection.h: what the designer has picked. By name, so that it survives undo.

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
  void clear();
};

}  // namespace sinew::app
