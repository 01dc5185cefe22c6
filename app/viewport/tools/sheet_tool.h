// app/viewport/tools/sheet_tool.h: adds sheets by two strokes on the skin.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/tools/select.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// A stroke in progress; the pose is held.
struct SheetDrag {
  Surface skin;                    ///< At the press: the sheet being drawn lifts the skin.
  std::vector<SkinAnchor> stroke;  ///< From the press on, not empty.
  glm::vec2 lastPixel{0.0f};       ///< Of the last point.
  float thicker = 1.0f;            ///< Factor on the heights, from the wheel.
  bool shown = false;              ///< The sheet is the state of the gesture.
  std::string why;                 ///< Why it is not.
  Selection selectionBefore;
  std::shared_ptr<const Rig> rigBefore;
};

struct SheetToolState {
  std::optional<SheetEdge> origin;  ///< Of the first stroke; the next one is the insertion.
  std::optional<SheetDrag> drag;
};

/// Polylines to draw over the picture: the origin and the stroke in progress. World.
[[nodiscard]] std::vector<std::vector<glm::vec3>> drawnEdges(const SheetToolState& state, const Character& character,
                                                             const Pose& pose);

}  // namespace sinew::app
