// app/viewport/render/reference_drawer.h: pictures to work after, on planes behind the body or through it.
#pragma once

#include <map>
#include <memory>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/viewport.h"

namespace sinew::app {

class ReferenceDrawer {
 public:
  [[nodiscard]] static Result<ReferenceDrawer> create();

  /// Textures of the frame's planes; those of others go.
  void prepare(const Frame& frame);
  /// Over what is there, tested against its depth. They hide nothing that is drawn later.
  /// @param inside  those that go through the body, else those behind it
  void draw(const Frame& frame, bool inside) const;

 private:
  struct Uploaded {
    std::shared_ptr<const Image> pixels;  ///< Held, so that no other image has its address.
    GlTexture texture;
  };
  ReferenceDrawer() = default;

  GlProgram program_;
  GlVertexArray empty_;
  std::map<const Image*, Uploaded> textures_;
};

}  // namespace sinew::app
