// app/window/screen.h: the finished frame on its way to the window; what has not changed is not drawn again.
#pragma once

#include <span>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/ui/changed_tiles.h"

struct ImDrawData;

namespace sinew::app {

/// Draws the interface into the window's back buffer. Where the processor draws, a pixel of the interface costs as much
/// as one of the picture: there only the changed parts are drawn, over the frame before. A graphics processor draws
/// all.
class Screen {
 public:
  Screen();

  /// @param parts  of the picture that have changed; window coordinates
  /// @param covered  by the picture, which lets nothing shine through: low x and y, high x and y; window coordinates
  /// @param still  the window shows the frame before, and an equal one need not be shown again
  /// @return whether there is a frame to be shown, by swapping the buffers.
  [[nodiscard]] bool draw(ImDrawData& data, const glm::ivec2& size, std::span<const TextureRevision> textures,
                          std::span<const glm::vec4> parts, const glm::vec4& covered, bool still);
  /// The frame of draw() was shown: looks at what the back buffer holds now. Nothing waits to be drawn just then; later
  /// the look would wait for the picture.
  void noteShown();
  /// Draws all of the next frame: fonts or another texture with a known revision were made anew.
  void forget() { tiles_ = {}; }

 private:
  bool software_ = false;
  ChangedTiles tiles_;
  int mark_ = 0;  ///< What the frame before has left in a corner of the back buffer.
};

}  // namespace sinew::app
