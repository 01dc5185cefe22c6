// app/ui/icon_drawings.h: how icons are drawn: a function each, on a grid of 16 units.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include <imgui.h>

#include "app/ui/icons.h"

namespace sinew::app {

// Lines and shapes of small pictures, on a grid of 16 units.

inline constexpr float kHalfCircle = 3.14159265f;  ///< Radians.

/// Draws on a grid of 16 units.
struct Pen {
  ImDrawList& list;
  ImVec2 origin;
  float unit;
  ImU32 color;
  float stroke = 1.4f;    ///< Line width, units.
  float thinnest = 0.0f;  ///< ... and pixels, at least.

  [[nodiscard]] ImVec2 at(float x, float y) const { return {origin.x + x * unit, origin.y + y * unit}; }
  [[nodiscard]] float width() const { return std::max(stroke * unit, thinnest); }
  void line(float x0, float y0, float x1, float y1) const { list.AddLine(at(x0, y0), at(x1, y1), color, width()); }
  void fill(std::initializer_list<ImVec2> points) const {
    for (const ImVec2& p : points) list.PathLineTo(at(p.x, p.y));
    list.PathFillConvex(color);
  }
  void outline(std::initializer_list<ImVec2> points, bool closed) const {
    for (const ImVec2& p : points) list.PathLineTo(at(p.x, p.y));
    list.PathStroke(color, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width());
  }
  void arc(float x, float y, float radius, float from, float to) const {
    list.PathArcTo(at(x, y), radius * unit, from, to, 20);
    list.PathStroke(color, ImDrawFlags_None, width());
  }
  void ellipse(float x, float y, float a, float b, float turn, bool filled) const {
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps; ++i) {
      const float angle = 2.0f * kHalfCircle * static_cast<float>(i) / kSteps;
      const float u = a * std::cos(angle);
      const float v = b * std::sin(angle);
      list.PathLineTo(at(x + u * std::cos(turn) - v * std::sin(turn), y + u * std::sin(turn) + v * std::cos(turn)));
    }
    if (filled) {
      list.PathFillConvex(color);
    } else {
      list.PathStroke(color, ImDrawFlags_Closed, width());
    }
  }
  void disc(float x, float y, float radius) const { list.AddCircleFilled(at(x, y), radius * unit, color, 16); }
  void ring(float x, float y, float radius) const { list.AddCircle(at(x, y), radius * unit, color, 20, width()); }
  void box(float x0, float y0, float x1, float y1, float round) const {
    list.AddRect(at(x0, y0), at(x1, y1), color, round * unit, 0, width());
  }
  /// The upper (-1) or lower (1) lid of an eye.
  void lid(float way) const {
    list.PathLineTo(at(1.2f, 8.0f));
    list.PathBezierCubicCurveTo(at(4.6f, 8.0f + 6.0f * way), at(11.4f, 8.0f + 6.0f * way), at(14.8f, 8.0f));
    list.PathStroke(color, ImDrawFlags_None, width());
  }
};

using IconDrawing = void (*)(const Pen&);
using IconDrawings = std::array<IconDrawing, kIconCount>;  ///< By Icon; null: nothing is drawn.

[[nodiscard]] constexpr std::size_t at(Icon icon) { return static_cast<std::size_t>(icon); }

void addToolDrawings(IconDrawings& drawings);
void addMarkDrawings(IconDrawings& drawings);

}  // namespace sinew::app
