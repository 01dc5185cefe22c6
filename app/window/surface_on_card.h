// app/window/surface_on_card.h: the graphics card's part in the editor: whether it computes the surface, and that
// surface.
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
  /// After the frame's surface is up to date, before its picture: decides, and makes the surface on the card if it is
  /// to be there. Says in state.session.surfaceMaker how it was decided.
  void follow(EditorState& state);

  /// What the picture draws. Null: the processor's surface.
  [[nodiscard]] const DrawnOnCard* drawn() const { return shows_ ? card_.get() : nullptr; }

 private:
  bool wanted(EditorState& state);
  std::optional<std::string> make(const EditorState& state);
  std::optional<std::string> prepare(const std::shared_ptr<const Preparation>& preparation);
  std::optional<std::string> compilePrograms();
  bool measuredFaster(EditorState& state);
  void leave(EditorState& state, const std::string& why);

  std::shared_ptr<const StagePrograms> programs_;
  std::string broken_;  ///< Why the card is of no use to this window; "": it is.
  std::unique_ptr<DrawnOnCard> card_;
  std::shared_ptr<const Preparation> refused_;  ///< The last preparation that is left to the processor,
  std::string refusedWhy_;                      ///< and why.
  std::size_t made_ = 0;                        ///< LiveSurface::revision() of what card_ holds.
  std::size_t madeOf_ = 0;                      ///< SessionState::documentsOpened of that.
  bool shows_ = false;
  std::string said_;                                        ///< The last reason that was told.
  std::optional<std::pair<std::size_t, bool>> measuredOf_;  ///< Document, and whether it had muscles.
  std::string measurement_;                                 ///< In words.
  bool cardIsFaster_ = false;
};

}  // namespace sinew::app
