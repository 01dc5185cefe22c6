// app/ui/icon_marks.cpp: the icons of switches and marks: eye, lock, solo, fold, matrix, graph, territory.

#include "app/ui/icon_drawings.h"

namespace sinew::app {
namespace {

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

}  // namespace

void addMarkDrawings(IconDrawings& drawings) {
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
}

}  // namespace sinew::app
