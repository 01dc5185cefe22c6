// app/window/surface_on_card.h: whether the graphics card computes the surface, and that surface.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/editor/editor_state.h"
#include "app/viewport/gpu/drawn_on_card.h"

namespace sinew::app {

/// Follows the open document. The OpenGL context must be current. docs/performance.md
class SurfaceOnCard {
 public:
  /// Call between the frame's surface and its picture: decides, and computes the surface on the card if chosen.
  /// state.session.surfaceMaker has the reason.
  void follow(EditorState& state);

  /// Null: draw the processor's surface.
  [[nodiscard]] const DrawnOnCard* drawn() const { return shows_ ? card_.get() : nullptr; }

 private:
  bool wanted(EditorState& state);
  std::optional<std::string> make(const EditorState& state);
  std::optional<std::string> prepare(const std::shared_ptr<const Preparation>& preparation);
  std::optional<std::string> compilePrograms();
  bool measuredFaster(EditorState& state);
  void leave(EditorState& state, const std::string& why);

  std::shared_ptr<const StagePrograms> programs_;
  std::string broken_;  ///< Why the card cannot be used at all; "": it can.
  std::unique_ptr<DrawnOnCard> card_;
  std::shared_ptr<const Preparation> refused_;  ///< The last preparation that the card refused,
  std::string refusedWhy_;                      ///< and why.
  std::size_t made_ = 0;                        ///< LiveSurface::revision() of card_'s surface.
  std::size_t madeOf_ = 0;                      ///< Its SessionState::documentsOpened.
  bool shows_ = false;
  std::string said_;                                        ///< The last reported reason.
  std::optional<std::pair<std::size_t, bool>> measuredOf_;  ///< Document, and whether it had muscles.
  std::string measurement_;
  bool cardIsFaster_ = false;
};

}  // namespace sinew::app
