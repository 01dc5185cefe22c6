// app/ui/icons.cpp: a drawing for each icon.
#include "app/ui/icons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include <imgui.h>

namespace sinew::app {
namespace {

constexpr float kHalfCircle = 3.14159265f;  ///< Radians.

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
constexpr std::size_t at(Icon icon) { return static_cast<std::size_t>(icon); }

void drawMove(const Pen& pen) {
  pen.line(8, 2.5f, 8, 13.5f);
  pen.line(2.5f, 8, 13.5f, 8);
  pen.fill({{8, 0.5f}, {10.4f, 3.6f}, {5.6f, 3.6f}});
  pen.fill({{8, 15.5f}, {5.6f, 12.4f}, {10.4f, 12.4f}});
  pen.fill({{0.5f, 8}, {3.6f, 5.6f}, {3.6f, 10.4f}});
  pen.fill({{15.5f, 8}, {12.4f, 10.4f}, {12.4f, 5.6f}});
}

void drawRotate(const Pen& pen) {
  pen.arc(8, 8, 5.6f, -0.35f * kHalfCircle, 1.3f * kHalfCircle);
  pen.fill({{8.0f, 0.6f}, {13.0f, 2.6f}, {9.0f, 6.0f}});
}

void drawScale(const Pen& pen) {
  pen.outline({{2, 9}, {7, 9}, {7, 14}, {2, 14}}, true);
  pen.line(8.5f, 7.5f, 13, 3);
  pen.outline({{8.6f, 2.4f}, {13.6f, 2.4f}, {13.6f, 7.4f}}, false);
}

void drawLoop(const Pen& pen) {
  pen.outline({{4, 5}, {12, 5}, {14, 7}, {14, 9}}, false);
  pen.outline({{12, 12}, {4, 12}, {2, 10}, {2, 8}}, false);
  pen.fill({{7.0f, 2.2f}, {7.0f, 7.8f}, {3.2f, 5.0f}});
  pen.fill({{9.0f, 9.2f}, {12.8f, 12.0f}, {9.0f, 14.8f}});
}

/// A body with one arm up.
void drawPose(const Pen& pen) {
  pen.ellipse(8, 2.8f, 1.9f, 1.9f, 0.0f, true);
  pen.outline({{13.6f, 2.2f}, {11.4f, 6.6f}, {4.6f, 6.6f}, {2.6f, 10.8f}}, false);
  pen.line(8, 6.6f, 8, 10.4f);
  pen.outline({{4.8f, 15}, {8, 10.4f}, {11.2f, 15}}, false);
}

void drawAxes(const Pen& pen) {
  pen.line(5, 11, 5, 2);
  pen.line(5, 11, 14, 11);
  pen.line(5, 11, 1.5f, 14.5f);
  pen.fill({{5, 0.6f}, {7, 3.6f}, {3, 3.6f}});
  pen.fill({{15.4f, 11}, {12.4f, 13}, {12.4f, 9}});
}

void drawCircled(const Pen& pen) { pen.ellipse(8, 8, 6.2f, 6.2f, 0.0f, false); }

void drawLock(const Pen& pen, bool closed) {
  pen.list.AddRectFilled(pen.at(3.4f, 7.4f), pen.at(12.6f, 14.0f), pen.color, 1.4f * pen.unit);
  const float x = closed ? 8.0f : 10.6f;
  pen.list.PathArcTo(pen.at(x, 5.6f), 2.9f * pen.unit, kHalfCircle, 2.0f * kHalfCircle, 14);
  if (closed) pen.list.PathLineTo(pen.at(x + 2.9f, 7.6f));
  pen.list.PathStroke(pen.color, ImDrawFlags_None, pen.width());
  pen.line(x - 2.9f, 5.4f, x - 2.9f, 7.6f);
}

void drawMatrix(const Pen& pen) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column <= row; ++column) {
      const float x = 2.0f + 4.4f * static_cast<float>(column);
      const float y = 2.0f + 4.4f * static_cast<float>(row);
      pen.list.AddRectFilled(pen.at(x, y), pen.at(x + 3.2f, y + 3.2f), pen.color, 0.8f * pen.unit);
    }
  }
}

void drawGraph(const Pen& pen) {
  pen.line(4.0f, 11.6f, 8.0f, 4.0f);
  pen.line(8.0f, 4.0f, 12.4f, 10.6f);
  pen.disc(4.0f, 11.8f, 2.5f);
  pen.disc(8.0f, 3.8f, 2.5f);
  pen.disc(12.4f, 11.0f, 2.5f);
}

/// A body, half of it filled: before and after.
void drawBefore(const Pen& pen) {
  pen.ring(8.0f, 8.0f, 5.8f);
  pen.list.PathArcTo(pen.at(8.0f, 8.0f), 5.8f * pen.unit, -0.5f * kHalfCircle, 0.5f * kHalfCircle, 16);
  pen.list.PathFillConvex(pen.color);
}

void drawTerritory(const Pen& pen) {
  pen.outline({{2.0f, 5.0f}, {6.4f, 2.4f}, {13.6f, 4.2f}, {14.0f, 10.4f}, {9.0f, 13.8f}, {3.0f, 11.6f}}, true);
  pen.disc(8.0f, 8.0f, 2.2f);
}

void drawReset(const Pen& pen) {
  pen.list.PathArcTo(pen.at(8.2f, 8.6f), 4.9f * pen.unit, -0.75f * kHalfCircle, 0.95f * kHalfCircle, 20);
  pen.list.PathStroke(pen.color, ImDrawFlags_None, pen.width());
  pen.fill({{1.8f, 5.6f}, {6.8f, 2.2f}, {7.2f, 7.4f}});
}

IconDrawings allDrawings() {
  IconDrawings drawings{};
  drawings[at(Icon::kSelect)] = [](const Pen& pen) {
    pen.outline({{4, 2}, {13, 8.6f}, {8.6f, 9.4f}, {6, 13.6f}}, true);
  };
  drawings[at(Icon::kMove)] = drawMove;
  drawings[at(Icon::kRotate)] = drawRotate;
  drawings[at(Icon::kScale)] = drawScale;
  drawings[at(Icon::kAddMuscle)] = [](const Pen& pen) {
    pen.ellipse(6.8f, 9.2f, 6.0f, 3.4f, -0.6f, false);
    pen.line(12.6f, 1.6f, 12.6f, 6.8f);
    pen.line(10, 4.2f, 15.2f, 4.2f);
  };
  drawings[at(Icon::kMuscleLine)] = [](const Pen& pen) {
    pen.line(1.6f, 14.4f, 4.6f, 11.4f);
    pen.ellipse(8, 8, 4.8f, 2.6f, -0.785f, true);
    pen.line(11.4f, 4.6f, 14.4f, 1.6f);
    pen.ellipse(1.8f, 14.2f, 1.2f, 1.2f, 0.0f, true);
    pen.ellipse(14.2f, 1.8f, 1.2f, 1.2f, 0.0f, true);
  };
  drawings[at(Icon::kSheet)] = [](const Pen& pen) {
    pen.line(2, 2.4f, 4.2f, 13.8f);
    pen.line(13.4f, 5.6f, 13.8f, 10);
    pen.line(2.2f, 3.4f, 13.4f, 6.2f);
    pen.line(3.1f, 8.2f, 13.6f, 7.9f);
    pen.line(4, 12.8f, 13.7f, 9.4f);
  };
  drawings[at(Icon::kPose)] = drawPose;
  drawings[at(Icon::kLoop)] = drawLoop;
  drawings[at(Icon::kPlus)] = [](const Pen& pen) {
    pen.line(8, 3.4f, 8, 12.6f);
    pen.line(3.4f, 8, 12.6f, 8);
  };
  drawings[at(Icon::kClose)] = [](const Pen& pen) {
    pen.line(4.2f, 4.2f, 11.8f, 11.8f);
    pen.line(11.8f, 4.2f, 4.2f, 11.8f);
  };
  drawings[at(Icon::kBone)] = [](const Pen& pen) {
    pen.outline({{3, 13}, {3.6f, 8.6f}, {13, 3}, {7.4f, 12.4f}}, true);
  };
  drawings[at(Icon::kMuscle)] = [](const Pen& pen) { pen.ellipse(8, 8, 6.2f, 3.6f, -0.6f, true); };
  drawings[at(Icon::kCarve)] = [](const Pen& pen) { pen.ellipse(8, 8, 6.0f, 3.4f, -0.6f, false); };
  drawings[at(Icon::kAxes)] = drawAxes;
  drawings[at(Icon::kFolder)] = [](const Pen& pen) {
    pen.outline({{2, 4}, {6.4f, 4}, {7.8f, 5.8f}, {14, 5.8f}, {14, 13}, {2, 13}}, true);
  };
  drawings[at(Icon::kFile)] = [](const Pen& pen) {
    pen.outline({{4, 2}, {9.6f, 2}, {12.4f, 4.8f}, {12.4f, 14}, {4, 14}}, true);
  };
  drawings[at(Icon::kSymmetry)] = [](const Pen& pen) {
    for (const float y : {1.0f, 5.0f, 9.0f, 13.0f}) pen.line(8, y, 8, y + 2);
    pen.fill({{6, 4}, {6, 12}, {0.8f, 12}});
    pen.outline({{10, 4}, {10, 12}, {15.2f, 12}}, true);
  };
  drawings[at(Icon::kBox)] = [](const Pen& pen) {
    for (const float at : {2.0f, 6.5f, 11.0f}) {
      pen.line(at, 2, at + 3, 2);
      pen.line(at, 14, at + 3, 14);
      pen.line(2, at, 2, at + 3);
      pen.line(14, at, 14, at + 3);
    }
    pen.ellipse(8, 8, 3, 2, 0.5f, true);
  };
  drawings[at(Icon::kMinimize)] = [](const Pen& pen) { pen.line(3.6f, 11.4f, 12.4f, 11.4f); };
  drawings[at(Icon::kCopy)] = [](const Pen& pen) {
    pen.outline({{5.4f, 5.4f}, {13.4f, 5.4f}, {13.4f, 14}, {5.4f, 14}}, true);
    pen.outline({{3.4f, 10.6f}, {2.6f, 10.6f}, {2.6f, 2}, {10.6f, 2}, {10.6f, 3.4f}}, false);
  };
  drawings[at(Icon::kPlay)] = [](const Pen& pen) { pen.fill({{4, 2.4f}, {13.4f, 8}, {4, 13.6f}}); };
  drawings[at(Icon::kPause)] = [](const Pen& pen) {
    pen.fill({{3.6f, 2.6f}, {6.6f, 2.6f}, {6.6f, 13.4f}, {3.6f, 13.4f}});
    pen.fill({{9.4f, 2.6f}, {12.4f, 2.6f}, {12.4f, 13.4f}, {9.4f, 13.4f}});
  };
  drawings[at(Icon::kNext)] = [](const Pen& pen) {
    pen.fill({{3.4f, 3.4f}, {10.4f, 8}, {3.4f, 12.6f}});
    pen.line(12, 3.4f, 12, 12.6f);
  };
  drawings[at(Icon::kPrevious)] = [](const Pen& pen) {
    pen.fill({{12.6f, 3.4f}, {12.6f, 12.6f}, {5.6f, 8}});
    pen.line(4, 3.4f, 4, 12.6f);
  };
  drawings[at(Icon::kEnd)] = [](const Pen& pen) {
    pen.fill({{7.4f, 3.4f}, {12.8f, 8}, {7.4f, 12.6f}});
    pen.fill({{1.8f, 3.4f}, {7.2f, 8}, {1.8f, 12.6f}});
    pen.line(14, 3.4f, 14, 12.6f);
  };
  drawings[at(Icon::kStart)] = [](const Pen& pen) {
    pen.fill({{8.6f, 3.4f}, {8.6f, 12.6f}, {3.2f, 8}});
    pen.fill({{14.2f, 3.4f}, {14.2f, 12.6f}, {8.8f, 8}});
    pen.line(2, 3.4f, 2, 12.6f);
  };
  drawings[at(Icon::kBack)] = [](const Pen& pen) {
    pen.outline({{7, 3.4f}, {2.6f, 8}, {7, 12.6f}}, false);
    pen.line(3, 8, 13.4f, 8);
  };
  drawings[at(Icon::kForward)] = [](const Pen& pen) {
    pen.outline({{9, 3.4f}, {13.4f, 8}, {9, 12.6f}}, false);
    pen.line(13, 8, 2.6f, 8);
  };
  drawings[at(Icon::kUp)] = [](const Pen& pen) {
    pen.outline({{3.4f, 7}, {8, 2.6f}, {12.6f, 7}}, false);
    pen.line(8, 3, 8, 13.4f);
  };
  drawings[at(Icon::kNewFolder)] = [](const Pen& pen) {
    pen.outline({{9, 13}, {2, 13}, {2, 4}, {6.4f, 4}, {7.8f, 5.8f}, {14, 5.8f}, {14, 8}}, false);
    pen.line(12, 9.6f, 12, 15);
    pen.line(9.3f, 12.3f, 14.7f, 12.3f);
  };
  drawings[at(Icon::kHidden)] = [](const Pen& pen) {
    pen.ellipse(8, 8, 6.6f, 4.0f, 0.0f, false);
    pen.ellipse(8, 8, 1.9f, 1.9f, 0.0f, true);
  };
  drawings[at(Icon::kNote)] = [](const Pen& pen) {
    drawCircled(pen);
    pen.line(8, 7.2f, 8, 11.4f);
    pen.line(8, 4.6f, 8, 5.8f);
  };
  drawings[at(Icon::kWarning)] = [](const Pen& pen) {
    pen.outline({{8, 1.8f}, {14.6f, 13.6f}, {1.4f, 13.6f}}, true);
    pen.line(8, 6, 8, 9.6f);
    pen.line(8, 11, 8, 12.2f);
  };
  drawings[at(Icon::kError)] = [](const Pen& pen) {
    drawCircled(pen);
    pen.line(5.6f, 5.6f, 10.4f, 10.4f);
    pen.line(10.4f, 5.6f, 5.6f, 10.4f);
  };
  drawings[at(Icon::kEye)] = [](const Pen& pen) {
    pen.lid(-1.0f);
    pen.lid(1.0f);
    pen.disc(8.0f, 8.0f, 2.3f);
  };
  drawings[at(Icon::kEyeShut)] = [](const Pen& pen) {
    pen.lid(1.0f);
    pen.line(8.0f, 12.6f, 8.0f, 15.0f);
    pen.line(3.8f, 11.4f, 2.6f, 13.4f);
    pen.line(12.2f, 11.4f, 13.4f, 13.4f);
  };
  drawings[at(Icon::kLock)] = [](const Pen& pen) { drawLock(pen, true); };
  drawings[at(Icon::kUnlocked)] = [](const Pen& pen) { drawLock(pen, false); };
  drawings[at(Icon::kSolo)] = [](const Pen& pen) {
    pen.ring(8.0f, 8.0f, 5.6f);
    pen.disc(8.0f, 8.0f, 2.6f);
  };
  drawings[at(Icon::kFilter)] = [](const Pen& pen) {
    pen.outline({{2.0f, 3.0f}, {14.0f, 3.0f}, {9.4f, 8.6f}, {9.4f, 13.4f}, {6.6f, 12.0f}, {6.6f, 8.6f}}, true);
  };
  drawings[at(Icon::kMatrix)] = drawMatrix;
  drawings[at(Icon::kGraph)] = drawGraph;
  drawings[at(Icon::kArrange)] = [](const Pen& pen) {
    pen.disc(8.0f, 3.2f, 2.0f);
    pen.disc(3.2f, 12.4f, 2.0f);
    pen.disc(12.8f, 12.4f, 2.0f);
    pen.list.PathArcTo(pen.at(8.0f, 9.2f), 6.4f * pen.unit, 0.0f, 2.0f * kHalfCircle, 28);
    pen.list.PathStroke(pen.color, ImDrawFlags_Closed, 0.7f * pen.width());
  };
  drawings[at(Icon::kBefore)] = drawBefore;
  drawings[at(Icon::kTerritory)] = drawTerritory;
  drawings[at(Icon::kFoldOpen)] = [](const Pen& pen) {
    pen.outline({{4.4f, 6.2f}, {8.0f, 9.8f}, {11.6f, 6.2f}}, false);
  };
  drawings[at(Icon::kFoldClosed)] = [](const Pen& pen) {
    pen.outline({{6.2f, 4.4f}, {9.8f, 8.0f}, {6.2f, 11.6f}}, false);
  };
  drawings[at(Icon::kReset)] = drawReset;
  return drawings;
}

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, const ImVec2& topLeft, float size, ImU32 color) {
  static const IconDrawings kDrawings = allDrawings();
  const Pen pen{list, topLeft, size / 16.0f, color};
  if (const IconDrawing draw = kDrawings[at(icon)]) draw(pen);
}

}  // namespace sinew::app
