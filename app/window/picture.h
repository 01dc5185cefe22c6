// app/window/picture.h: the viewport's picture with the gizmo over it, redrawn only when it changes.
#pragma once

#include <cstddef>
#include <vector>

#include "app/editor/editor_state.h"
#include "app/render/viewport.h"

struct ImDrawList;

namespace sinew::app {

/// Everything the picture depends on; equal keys, equal pictures.
struct PictureKey {
  std::size_t document = 0;
  std::size_t surface = 0;
  View view;
  DisplaySettings display;
  std::vector<PrimitiveShape> shapes;
  std::vector<float> territory;  ///< Scene::territory.
  std::vector<int> territoryBones;
  int selectedBone = -1;
  int hoveredBone = -1;
  std::vector<bool> hiddenBones;  ///< Scene::hiddenBones.

  friend bool operator==(const PictureKey&, const PictureKey&) = default;
};

/// Draws the document into the viewport's texture and puts that, and the gizmo, into a draw list.
class Picture {
 public:
  explicit Picture(Viewport& viewport) : viewport_(viewport) {}

  /// Without a character: nothing. Times go to state.session.stats. The OpenGL context must be current.
  void draw(EditorState& state, const View& view, ImDrawList& list);

 private:
  void render(EditorState& state, PictureKey key);

  Viewport& viewport_;
  std::size_t shownDocument_ = 0;
  PictureKey drawn_;
};

}  // namespace sinew::app
