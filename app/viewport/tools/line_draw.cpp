// app/viewport/tools/line_draw.cpp: a curve, two balls, a diamond.

#include "app/viewport/tools/line_draw.h"

#include <algorithm>
#include <vector>

#include "core/rig/line_rest.h"

namespace sinew::app {
namespace {

constexpr ImU32 kTendon = IM_COL32(244, 238, 226, 255);
constexpr ImU32 kLineShadow = IM_COL32(12, 14, 18, 190);
constexpr ImU32 kHot = IM_COL32(255, 196, 64, 255);

void drawCurve(ImDrawList& list, const Canvas& canvas, const ShownLine& line) {
  const std::vector<glm::vec3> points = pointsAlong({line.origin, line.via, line.insertion});
  if (std::ranges::any_of(points, [&](const glm::vec3& point) { return canvas.isBehind(point); })) return;
  std::vector<ImVec2> pixels;
  for (const glm::vec3& point : points) pixels.push_back(canvas.at(point));
  const auto stroke = [&](ImU32 color, float width) {
    list.AddPolyline(pixels.data(), static_cast<int>(pixels.size()), color, ImDrawFlags_None, width);
  };
  stroke(kLineShadow, 2.0f * canvas.scale + 2.0f);
  stroke(kTendon, 2.0f * canvas.scale);
}

void ball(ImDrawList& list, const ImVec2& center, float radius, ImU32 color) {
  list.AddCircleFilled(center, radius + 1.5f, kLineShadow, 20);
  list.AddCircleFilled(center, radius, color, 20);
}

void diamond(ImDrawList& list, const ImVec2& c, float radius, ImU32 color) {
  const auto quad = [&](float r, ImU32 fill) {
    list.AddQuadFilled({c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}, fill);
  };
  quad(radius + 2.0f, kLineShadow);
  quad(radius, color);
}

}  // namespace

void drawLine(ImDrawList& list, const Canvas& canvas, const ShownLine& line, const LineHandles& handles, bool curve) {
  if (curve) drawCurve(list, canvas, line);
  for (const LineEnd end : {LineEnd::kOrigin, LineEnd::kInsertion, LineEnd::kVia}) {
    const std::optional<glm::vec3> point = endPoint(line, end);
    if (!point || canvas.isBehind(*point)) continue;
    const bool hot = handles.drag ? handles.drag->end == end : handles.hovered == end;
    const ImU32 color = hot ? kHot : kTendon;
    if (end == LineEnd::kVia) diamond(list, canvas.at(*point), 6.0f * canvas.scale, color);
    else ball(list, canvas.at(*point), 5.0f * canvas.scale, color);
  }
}

}  // namespace sinew::app
