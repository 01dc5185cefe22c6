// app/viewport/tools/box_select.cpp: a rectangle drawn over the picture selects what it touches.

#include "app/viewport/tools/box_select.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/style.h"
#include "app/viewport/tools/select.h"
#include "core/geometry/silhouette.h"

namespace sinew::app {
namespace {

bool inside(const glm::vec3& pixel, const glm::vec2& low, const glm::vec2& high) {
  return std::abs(pixel.z) <= 1.0f && pixel.x >= low.x && pixel.y >= low.y && pixel.x <= high.x && pixel.y <= high.y;
}

/// Points of the outline that the eye sees, and the middle.
std::vector<glm::vec3> outlineOf(const PrimitiveShape& shape, const View& view) {
  const glm::vec3 eye = view.orthographic ? view.forwardInWorld() : view.eyeInWorld;
  const Silhouette line = silhouetteOf(shape.shape, shape.unitBallInWorld, eye, view.orthographic);
  std::vector<glm::vec3> points(line.begin(), line.end());
  points.emplace_back(shape.unitBallInWorld[3]);
  return points;
}

}  // namespace

std::vector<PrimitiveId> musclesInBox(const ViewportContext& context, const View& view, const glm::vec2& corner,
                                      const glm::vec2& opposite) {
  const glm::vec2 low = glm::min(corner, opposite);
  const glm::vec2 high = glm::max(corner, opposite);
  const Document& document = context.document;
  std::vector<PrimitiveId> muscles;
  for (const PrimitiveShape& shape : primitiveShapes(document, context.pose)) {
    if (!isPickable(document.visibility, document.rig(), document.character->skeleton, shape.rigIndex)) continue;
    const std::vector<glm::vec3> points = outlineOf(shape, view);
    const bool hit =
        std::ranges::any_of(points, [&](const glm::vec3& p) { return inside(view.toPixel(p), low, high); });
    if (hit) muscles.push_back(document.idAt(shape.rigIndex));
  }
  return muscles;
}

void selectBox(const ViewportContext& context, const View& view, const BoxDrag& box) {
  const std::vector<PrimitiveId> muscles = musclesInBox(context, view, box.from, box.to);
  Selection& selection = context.document.selection;
  if (box.mode == BoxMode::kRemove) {
    selection.remove(muscles);
    return;
  }
  if (box.mode == BoxMode::kReplace) selection.bone = -1;
  selection.setAll(muscles, box.mode == BoxMode::kAdd);
}

void drawBox(ImDrawList& list, const BoxDrag& box, const glm::vec2& topLeft, float unitsPerPixel) {
  const glm::vec2 low = topLeft + glm::min(box.from, box.to) * unitsPerPixel;
  const glm::vec2 high = topLeft + glm::max(box.from, box.to) * unitsPerPixel;
  const bool removes = box.mode == BoxMode::kRemove;
  const Tint tint = removes ? palette::kWarning : palette::kAccent;
  list.AddRectFilled({low.x, low.y}, {high.x, high.y}, tint.faded(0.12f).packed());
  list.AddRect({low.x, low.y}, {high.x, high.y}, tint.packed());
}

}  // namespace sinew::app
