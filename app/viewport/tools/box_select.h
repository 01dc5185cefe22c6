// app/viewport/tools/box_select.h: a rectangle drawn over the picture selects what it touches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/viewport/render/view.h"
#include "app/viewport/tools/viewport_context.h"

struct ImDrawList;

namespace sinew::app {

enum class BoxMode { kReplace, kAdd, kRemove };

/// Being drawn; pixels.
struct BoxDrag {
  glm::vec2 from{0.0f};
  glm::vec2 to{0.0f};
  BoxMode mode = BoxMode::kReplace;
};

struct BoxSelectState {
  bool armed = false;  ///< The next press on the picture begins a box, whatever lies there.
  std::optional<BoxDrag> drag;
};

/// Names, in rig order, of the muscles whose ellipsoid's outline or center is in the rectangle: also behind the skin.
/// Hidden and locked ones are left out.
[[nodiscard]] std::vector<PrimitiveId> musclesInBox(const ViewportContext& context, const View& view,
                                                    const glm::vec2& corner, const glm::vec2& opposite);

/// Applies a finished box to the selection. A box with nothing in it clears what it would replace.
void selectBox(const ViewportContext& context, const View& view, const BoxDrag& box);

/// The rectangle while it is drawn. @param topLeft, unitsPerPixel  as for drawGizmo.
void drawBox(ImDrawList& list, const BoxDrag& box, const glm::vec2& topLeft, float unitsPerPixel);

}  // namespace sinew::app
