// app/viewport/tools/draw_tools.cpp: handles, marks and names over the picture.
#include "app/viewport/tools/draw_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "app/document/shown_names.h"
#include "app/ui/reading_order.h"
#include "core/rig/line_rest.h"

namespace sinew::app {
namespace {

constexpr ImU32 kHoverColor = IM_COL32(255, 214, 64, 255);
constexpr ImU32 kMarkFaint = IM_COL32(255, 214, 64, 120);
constexpr ImU32 kShadow = IM_COL32(12, 14, 18, 190);
constexpr float kRingRadius = 0.022f;  ///< Fraction of H.
constexpr std::size_t kHoverRingPoints = 40;

void drawRing(ImDrawList& list, const Canvas& canvas, const SkinPoint& skin, float radius) {
  const glm::vec3 helper = std::abs(skin.normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 u = normalizeOr(glm::cross(skin.normal, helper), glm::vec3(1, 0, 0));
  const glm::vec3 v = glm::cross(skin.normal, u);
  std::array<ImVec2, kHoverRingPoints> ring;
  for (std::size_t i = 0; i < kHoverRingPoints; ++i) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(kHoverRingPoints);
    const glm::vec3 point = skin.point + radius * (std::cos(angle) * u + std::sin(angle) * v);
    if (canvas.isBehind(point)) return;
    ring[i] = canvas.at(point);
  }
  list.AddConvexPolyFilled(ring.data(), static_cast<int>(ring.size()), IM_COL32(255, 214, 64, 50));
  list.AddPolyline(ring.data(), static_cast<int>(ring.size()), kHoverColor, ImDrawFlags_Closed, 2.0f * canvas.scale);
}

/// Text on a plate, kept within the picture.
void drawPlate(ImDrawList& list, const ImVec2& corner, float scale, const std::string& shown) {
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
  const ImVec2 pad{6.0f * scale, 3.0f * scale};
  const ImVec2 room = list.GetClipRectMax();
  const ImVec2 low{std::min(corner.x, room.x - size.x - 2.0f * pad.x),
                   std::min(corner.y, room.y - size.y - 2.0f * pad.y)};
  list.AddRectFilled({low.x - pad.x, low.y - pad.y}, {low.x + size.x + pad.x, low.y + size.y + pad.y}, kShadow,
                     4.0f * scale);
  list.AddText(low, IM_COL32(235, 238, 242, 255), shown.c_str());
}

}  // namespace

void drawMeshName(ImDrawList& list, const Canvas& canvas, const Bounds& box, const std::string& name) {
  const glm::vec3 foot(box.center().x, box.low.y, box.center().z);
  if (canvas.isBehind(foot)) return;
  const std::string shown = inReadingOrder(name);
  const ImVec2 at = canvas.at(foot);
  drawPlate(list, {at.x - 0.5f * ImGui::CalcTextSize(shown.c_str()).x, at.y + 14.0f * canvas.scale}, canvas.scale,
            shown);
}

void drawBoneMark(ImDrawList& list, const Canvas& canvas, const Bone& bone, const glm::mat4& boneInWorld) {
  const glm::vec3 origin(boneInWorld[3]);
  const glm::vec3 tip(boneInWorld * glm::vec4(bone.tip, 1.0f));
  if (canvas.isBehind(origin) || canvas.isBehind(tip)) return;
  const ImVec2 a = canvas.at(origin);
  const ImVec2 b = canvas.at(tip);
  list.AddLine(a, b, kShadow, 5.0f * canvas.scale);
  list.AddLine(a, b, kMarkFaint, 3.0f * canvas.scale);
  list.AddCircleFilled(a, 5.0f * canvas.scale, kShadow);
  list.AddCircleFilled(a, 4.0f * canvas.scale, kHoverColor);
  list.AddCircleFilled(b, 2.5f * canvas.scale, kHoverColor);
}

void drawLanding(ImDrawList& list, const Canvas& canvas, const ViewportHover& hover, const Character& character,
                 const Pose& pose) {
  if (!hover.skin) return;
  const auto bone = static_cast<std::size_t>(boneAt(character, *hover.skin));
  const SkinPoint skin = skinPointAt(character, pose, *hover.skin);
  drawBoneMark(list, canvas, character.skeleton.bones[bone], pose.boneInWorld[bone]);
  drawRing(list, canvas, skin, kRingRadius * character.height);
  if (canvas.isBehind(skin.point)) return;
  const ImVec2 beside = canvas.at(skin.point);
  drawPlate(list, {beside.x + 18.0f * canvas.scale, beside.y + 14.0f * canvas.scale}, canvas.scale,
            inReadingOrder(shownBoneName(character.skeleton, static_cast<int>(bone))));
}

namespace {

constexpr ImU32 kTendon = IM_COL32(244, 238, 226, 255);
constexpr ImU32 kHot = IM_COL32(255, 196, 64, 255);

void drawPolyline(ImDrawList& list, const Canvas& canvas, const std::vector<glm::vec3>& points) {
  if (std::ranges::any_of(points, [&](const glm::vec3& point) { return canvas.isBehind(point); })) return;
  std::vector<ImVec2> pixels;
  for (const glm::vec3& point : points) pixels.push_back(canvas.at(point));
  const auto stroke = [&](ImU32 color, float width) {
    list.AddPolyline(pixels.data(), static_cast<int>(pixels.size()), color, ImDrawFlags_None, width);
  };
  stroke(kShadow, 2.0f * canvas.scale + 2.0f);
  stroke(kTendon, 2.0f * canvas.scale);
}

void drawCurve(ImDrawList& list, const Canvas& canvas, const ShownLine& line) {
  drawPolyline(list, canvas, pointsAlong({line.origin, line.via, line.insertion}));
}

void ball(ImDrawList& list, const ImVec2& center, float radius, ImU32 color) {
  list.AddCircleFilled(center, radius + 1.5f, kShadow, 20);
  list.AddCircleFilled(center, radius, color, 20);
}

void diamond(ImDrawList& list, const ImVec2& c, float radius, ImU32 color) {
  const auto quad = [&](float r, ImU32 fill) {
    list.AddQuadFilled({c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}, fill);
  };
  quad(radius + 2.0f, kShadow);
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

void drawSheetEdges(ImDrawList& list, const Canvas& canvas, const ShownSheet& sheet, const SheetHandles& handles) {
  for (const std::vector<glm::vec3>& edge : sheet.edges) drawPolyline(list, canvas, edge);
  const std::optional<EdgePoint> hot = handles.drag ? handles.drag->point : handles.hovered;
  for (std::size_t e = 0; e < sheet.edges.size(); ++e) {
    for (std::size_t p = 0; p < sheet.edges[e].size(); ++p) {
      const glm::vec3& point = sheet.edges[e][p];
      if (canvas.isBehind(point)) continue;
      const EdgePoint own{static_cast<int>(e), static_cast<int>(p)};
      const ImU32 color = hot == own ? kHot : kTendon;
      if (e == 0) ball(list, canvas.at(point), 4.5f * canvas.scale, color);
      else if (e + 1 == sheet.edges.size()) diamond(list, canvas.at(point), 5.5f * canvas.scale, color);
      else ball(list, canvas.at(point), 3.0f * canvas.scale, color);
    }
  }
}

void drawStroke(ImDrawList& list, const Canvas& canvas, const std::vector<glm::vec3>& points) {
  drawPolyline(list, canvas, points);
  for (const glm::vec3* end : {&points.front(), &points.back()}) {
    if (!canvas.isBehind(*end)) ball(list, canvas.at(*end), 3.5f * canvas.scale, kHot);
  }
}

namespace {

constexpr std::array<ImU32, 3> kAxisColors = {IM_COL32(235, 82, 82, 255), IM_COL32(112, 200, 80, 255),
                                              IM_COL32(84, 140, 245, 255)};
constexpr ImU32 kNeutralColor = IM_COL32(225, 228, 235, 255);
constexpr ImU32 kShadowColor = IM_COL32(12, 14, 18, 150);

ImU32 faded(ImU32 color, float alpha) {
  const auto opaque = static_cast<float>((color >> IM_COL32_A_SHIFT) & 0xFFu);
  const auto value = static_cast<ImU32>(std::clamp(opaque * alpha, 0.0f, 255.0f));
  return (color & ~IM_COL32_A_MASK) | (value << IM_COL32_A_SHIFT);
}

/// A draw list addressed in viewport pixels.
struct GizmoCanvas {
  ImDrawList& list;
  glm::vec2 topLeft;
  float unitsPerPixel;
  float scale;  ///< Draw list units per design pixel.

  [[nodiscard]] ImVec2 at(const glm::vec2& pixel) const {
    const glm::vec2 p = topLeft + pixel * unitsPerPixel;
    return {p.x, p.y};
  }
  void line(const glm::vec2& a, const glm::vec2& b, ImU32 color, float width) const {
    list.AddLine(at(a), at(b), color, width * scale);
  }
  void dot(const glm::vec2& center, float radius, ImU32 color) const {
    list.AddCircleFilled(at(center), radius * scale, color, 24);
  }
  void circle(const glm::vec2& center, float radius, ImU32 color, float width) const {
    list.AddCircle(at(center), radius * scale, color, 32, width * scale);
  }
};

ImU32 colorOf(GizmoHandle handle, const GizmoState& state) {
  const GizmoHandle hot = state.drag ? state.drag->handle : state.hovered;
  if (handle == hot) return kHoverColor;
  const HandleParts parts = partsOf(handle);
  if (parts.way == Way::kWhole) return kNeutralColor;
  // Planes have the color of the axis across them.
  const int axis = isPlane(parts.way) ? normalAxisOf(parts.way) : axisOf(parts.way);
  return kAxisColors[static_cast<std::size_t>(axis)];
}

void drawArrow(const GizmoCanvas& canvas, const HandleShape& shape, ImU32 color) {
  const glm::vec2 base = shape.outline[0];
  const glm::vec2 tip = shape.outline[1];
  const float length = glm::length(tip - base);
  if (!(length > 1.0f)) return;
  const glm::vec2 along = (tip - base) / length;
  const glm::vec2 side(-along.y, along.x);
  const float pixel = canvas.scale / canvas.unitsPerPixel;  // Viewport pixels per design pixel.
  const float head = std::min(14.0f * pixel, 0.6f * length);
  const glm::vec2 neck = tip - head * along;
  canvas.line(base, neck, kShadowColor, 4.5f);
  canvas.line(base, neck, color, 2.5f);
  canvas.list.AddTriangleFilled(canvas.at(tip + 2.0f * pixel * along), canvas.at(neck + 5.5f * pixel * side),
                                canvas.at(neck - 5.5f * pixel * side), color);
}

void drawBox(const GizmoCanvas& canvas, const HandleShape& shape, ImU32 color) {
  canvas.line(shape.outline[0], shape.outline[1], kShadowColor, 4.5f);
  canvas.line(shape.outline[0], shape.outline[1], color, 2.5f);
  const ImVec2 tip = canvas.at(shape.outline[1]);
  const float half = 5.5f * canvas.scale;
  canvas.list.AddRectFilled({tip.x - half, tip.y - half}, {tip.x + half, tip.y + half}, color, 1.5f * canvas.scale);
}

void drawPlane(const GizmoCanvas& canvas, const HandleShape& shape, ImU32 color, bool hot) {
  std::array<ImVec2, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = canvas.at(shape.outline[i]);
  canvas.list.AddQuadFilled(corners[0], corners[1], corners[2], corners[3], faded(color, hot ? 0.6f : 0.32f));
  canvas.list.AddQuad(corners[0], corners[1], corners[2], corners[3], color, 1.3f * canvas.scale);
}

void drawRing(const GizmoCanvas& canvas, const HandleShape& shape, ImU32 color, bool hot) {
  const std::size_t count = shape.outline.size();
  for (const bool front : {false, true}) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      if ((shape.inFront[i] && shape.inFront[next]) != front) continue;
      const ImU32 shade = front ? color : faded(color, 0.22f);
      canvas.line(shape.outline[i], shape.outline[next], shade, front ? (hot ? 3.2f : 2.4f) : 1.4f);
    }
  }
}

void drawPole(const GizmoCanvas& canvas, const HandleShape& shape, ImU32 color, bool hot) {
  const float strength = shape.facesEye || hot ? 1.0f : 0.5f;
  const float radius = hot ? 6.0f : 4.5f;
  canvas.dot(shape.outline[0], radius + 1.5f, faded(kShadowColor, strength));
  canvas.dot(shape.outline[0], radius, faded(color, strength));
  canvas.circle(shape.outline[0], radius, faded(kNeutralColor, 0.85f * strength), 1.2f);
}

void drawDiamond(const GizmoCanvas& canvas, const glm::vec2& center, ImU32 color, bool hot) {
  const ImVec2 c = canvas.at(center);
  const auto quad = [&](float radius, ImU32 fill) {
    const float r = radius * canvas.scale;
    canvas.list.AddQuadFilled({c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}, fill);
  };
  const float radius = hot ? 7.5f : 6.0f;
  quad(radius + 2.0f, kShadowColor);
  quad(radius + 1.2f, kNeutralColor);
  quad(radius, color);
}

void drawHandle(const GizmoCanvas& canvas, const HandleShape& shape, const GizmoState& state) {
  const ImU32 color = colorOf(shape.handle, state);
  const bool hot = color == kHoverColor;
  const HandleParts parts = partsOf(shape.handle);
  if (parts.kind == HandleKind::kPole) return drawPole(canvas, shape, color, hot);
  if (parts.kind == HandleKind::kShape) return drawDiamond(canvas, shape.outline[0], color, hot);
  if (parts.kind == HandleKind::kRotate) return drawRing(canvas, shape, color, hot);
  if (parts.way == Way::kWhole) {
    canvas.circle(shape.outline[0], 8.0f, kShadowColor, 4.0f);
    canvas.circle(shape.outline[0], 8.0f, color, hot ? 2.6f : 1.8f);
    canvas.dot(shape.outline[0], 2.0f, color);
  } else if (isPlane(parts.way)) {
    drawPlane(canvas, shape, color, hot);
  } else if (parts.kind == HandleKind::kMove) {
    drawArrow(canvas, shape, color);
  } else {
    drawBox(canvas, shape, color);
  }
}

// A drag -------------------------------------------------------------------------------------------------

void drawAxisLine(const GizmoCanvas& canvas, const glm::vec3& origin, const glm::vec3& direction, float arm,
                  ImU32 color, const View& view) {
  constexpr int kPieces = 48;  // In pieces, so that those behind the eye are left out.
  for (int i = -kPieces; i < kPieces; ++i) {
    const auto at = [&](int step) { return view.toPixel(origin + 0.5f * arm * static_cast<float>(step) * direction); };
    const glm::vec3 a = at(i);
    const glm::vec3 b = at(i + 1);
    if (std::abs(a.z) > 1.0f || std::abs(b.z) > 1.0f) continue;
    canvas.line(glm::vec2(a), glm::vec2(b), faded(color, 0.75f), 1.3f);
  }
}

void drawWedge(const GizmoCanvas& canvas, const GizmoBasis& frame, const GizmoDrag& drag, const glm::vec3& normal,
               const View& view) {
  const Ray press = view.rayThrough(drag.pressPixel);
  const glm::vec3 grabbed = onPlane(frame.origin, normal, press).value_or(frame.origin + across(normal)) - frame.origin;
  const glm::vec3 u = normalizeOr(grabbed - glm::dot(grabbed, normal) * normal, across(normal));
  const glm::vec3 v = glm::cross(normal, u);
  const float shown = std::clamp(drag.angle, -6.2831853f, 6.2831853f);
  const int steps = 2 + static_cast<int>(std::abs(shown) * 14.0f);
  std::vector<ImVec2> fan{canvas.at(glm::vec2(view.toPixel(frame.origin)))};
  for (int i = 0; i <= steps; ++i) {
    const float angle = shown * static_cast<float>(i) / static_cast<float>(steps);
    const glm::vec3 pixel = view.toPixel(frame.origin + frame.arm * (std::cos(angle) * u + std::sin(angle) * v));
    if (std::abs(pixel.z) > 1.0f) return;
    fan.push_back(canvas.at(glm::vec2(pixel)));
  }
  for (std::size_t i = 1; i + 1 < fan.size(); ++i) {
    canvas.list.AddTriangleFilled(fan[0], fan[i], fan[i + 1], faded(kHoverColor, 0.22f));
  }
  canvas.list.AddLine(fan[0], fan[1], faded(kHoverColor, 0.7f), 1.3f * canvas.scale);
  canvas.list.AddLine(fan[0], fan.back(), kHoverColor, 1.6f * canvas.scale);
}

void drawLabel(const GizmoCanvas& canvas, const glm::vec2& pixel, const std::string& text) {
  if (text.empty()) return;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at = canvas.at(pixel);
  const float pad = 5.0f * canvas.scale;
  // Beside the pointer, kept within the picture.
  const ImVec2 room = canvas.list.GetClipRectMax();
  const ImVec2 low(std::min(at.x + 18.0f * canvas.scale, room.x - size.x - 2.0f * pad),
                   std::min(at.y + 16.0f * canvas.scale, room.y - size.y - 2.0f * pad));
  canvas.list.AddRectFilled({low.x - pad, low.y - 0.6f * pad}, {low.x + size.x + pad, low.y + size.y + 0.6f * pad},
                            IM_COL32(18, 20, 26, 215), 4.0f * canvas.scale);
  canvas.list.AddText(low, kNeutralColor, text.c_str());
}

void drawDrag(const GizmoCanvas& canvas, const GizmoState& state, const GizmoContext& context) {
  const GizmoDrag& drag = *state.drag;
  const HandleParts parts = partsOf(drag.handle);
  const auto frame = basisOfDrag(state, drag.handle, drag.start, context);
  if (!frame) return;
  const Way way = wayOf(drag);
  const auto axisLine = [&](int axis) {
    const auto i = static_cast<std::size_t>(axis);
    drawAxisLine(canvas, frame->origin, frame->axes[i], frame->arm, kAxisColors[i], context.view);
  };
  if (isAxis(way)) axisLine(axisOf(way));
  if (isPlane(way)) {
    for (const int axis : planeAxes(way)) axisLine(axis);
  }
  if (parts.kind == HandleKind::kRotate) {
    drawWedge(canvas, *frame, drag, frame->ringNormal(way), context.view);
  }
  if (parts.kind == HandleKind::kMove) {
    const glm::vec3 now(context.boneInWorld * glm::vec4(drag.current.center, 1.0f));
    canvas.dot(glm::vec2(context.view.toPixel(frame->origin)), 3.0f, faded(kNeutralColor, 0.5f));
    canvas.line(glm::vec2(context.view.toPixel(frame->origin)), glm::vec2(context.view.toPixel(now)),
                faded(kHoverColor, 0.6f), 1.2f);
  }
  drawLabel(canvas, drag.pointer, drag.value);
}

/// Handles that hitTest prefers are drawn last.
int drawOrder(const HandleShape& shape) {
  const HandleParts parts = partsOf(shape.handle);
  if (parts.kind == HandleKind::kShape) return 5;
  if (parts.kind == HandleKind::kPole) return shape.facesEye ? 4 : 3;
  if (parts.kind == HandleKind::kRotate) return 1;
  return parts.way == Way::kWhole ? 2 : (isAxis(parts.way) ? 1 : 0);
}

}  // namespace

void drawGizmo(ImDrawList& list, const GizmoState& state, const GizmoLayout& layout, const GizmoContext& context,
               const glm::vec2& topLeft, float unitsPerPixel) {
  if (!layout.visible) return;
  const GizmoCanvas canvas{list, topLeft, unitsPerPixel, context.uiScale * unitsPerPixel};
  const glm::vec2 size(context.view.size);
  list.PushClipRect(canvas.at(glm::vec2(0.0f)), canvas.at(size), true);
  if (state.drag) drawDrag(canvas, state, context);
  std::vector<const HandleShape*> ordered;
  for (const HandleShape& shape : layout.handles) {
    // During a drag only its handle is drawn, so that the shape is visible.
    if (!state.drag || state.drag->handle == shape.handle) ordered.push_back(&shape);
  }
  std::ranges::stable_sort(ordered, {}, [](const HandleShape* shape) { return drawOrder(*shape); });
  for (const HandleShape* shape : ordered) drawHandle(canvas, *shape, state);
  list.PopClipRect();
}

}  // namespace sinew::app
