// app/ui/panel_glyphs.cpp: small marks on a grid of 16 units, and the buttons that carry them.

#include "app/ui/panel_glyphs.h"

#include <algorithm>
#include <cctype>

#include "app/ui/pen.h"

namespace sinew::app {
namespace {

void drawLock(const Pen& pen, bool closed) {
  pen.list.AddRectFilled(pen.at(3.4f, 7.4f), pen.at(12.6f, 14.0f), pen.color, 1.4f * pen.unit);
  const float x = closed ? 8.0f : 10.6f;
  pen.list.PathArcTo(pen.at(x, 5.6f), 2.9f * pen.unit, kPi, 2.0f * kPi, 14);
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
  pen.list.PathArcTo(pen.at(8.0f, 8.0f), 5.8f * pen.unit, -0.5f * kPi, 0.5f * kPi, 16);
  pen.list.PathFillConvex(pen.color);
}

void drawTerritory(const Pen& pen) {
  pen.outline({{2.0f, 5.0f}, {6.4f, 2.4f}, {13.6f, 4.2f}, {14.0f, 10.4f}, {9.0f, 13.8f}, {3.0f, 11.6f}}, true);
  pen.disc(8.0f, 8.0f, 2.2f);
}

void drawReset(const Pen& pen) {
  pen.list.PathArcTo(pen.at(8.2f, 8.6f), 4.9f * pen.unit, -0.75f * kPi, 0.95f * kPi, 20);
  pen.list.PathStroke(pen.color, ImDrawFlags_None, pen.width());
  pen.fill({{1.8f, 5.6f}, {6.8f, 2.2f}, {7.2f, 7.4f}});
}

std::string lowered(const char* word) {
  std::string text = word;
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

void drawGlyph(ImDrawList& list, Glyph glyph, const ImVec2& topLeft, float size, ImU32 color) {
  const Pen pen{list, topLeft, size / 16.0f, color, 1.3f, 1.0f};
  switch (glyph) {
    case Glyph::kEye:
      pen.lid(-1.0f);
      pen.lid(1.0f);
      pen.disc(8.0f, 8.0f, 2.3f);
      break;
    case Glyph::kEyeShut:
      pen.lid(1.0f);
      pen.line(8.0f, 12.6f, 8.0f, 15.0f);
      pen.line(3.8f, 11.4f, 2.6f, 13.4f);
      pen.line(12.2f, 11.4f, 13.4f, 13.4f);
      break;
    case Glyph::kLock:
      drawLock(pen, true);
      break;
    case Glyph::kUnlocked:
      drawLock(pen, false);
      break;
    case Glyph::kSolo:
      pen.ring(8.0f, 8.0f, 5.6f);
      pen.disc(8.0f, 8.0f, 2.6f);
      break;
    case Glyph::kFilter:
      pen.outline({{2.0f, 3.0f}, {14.0f, 3.0f}, {9.4f, 8.6f}, {9.4f, 13.4f}, {6.6f, 12.0f}, {6.6f, 8.6f}}, true);
      break;
    case Glyph::kMatrix:
      drawMatrix(pen);
      break;
    case Glyph::kGraph:
      drawGraph(pen);
      break;
    case Glyph::kArrange:
      pen.disc(8.0f, 3.2f, 2.0f);
      pen.disc(3.2f, 12.4f, 2.0f);
      pen.disc(12.8f, 12.4f, 2.0f);
      pen.list.PathArcTo(pen.at(8.0f, 9.2f), 6.4f * pen.unit, 0.0f, 2.0f * kPi, 28);
      pen.list.PathStroke(pen.color, ImDrawFlags_Closed, 0.7f * pen.width());
      break;
    case Glyph::kBefore:
      drawBefore(pen);
      break;
    case Glyph::kTerritory:
      drawTerritory(pen);
      break;
    case Glyph::kFoldOpen:
      pen.outline({{4.4f, 6.2f}, {8.0f, 9.8f}, {11.6f, 6.2f}}, false);
      break;
    case Glyph::kFoldClosed:
      pen.outline({{6.2f, 4.4f}, {9.8f, 8.0f}, {6.2f, 11.6f}}, false);
      break;
    case Glyph::kReset:
      drawReset(pen);
      break;
    case Glyph::kPlus:
      pen.line(8.0f, 3.4f, 8.0f, 12.6f);
      pen.line(3.4f, 8.0f, 12.6f, 8.0f);
      break;
  }
}

bool glyphButton(Ui& ui, const std::string& id, Glyph glyph, bool active, float size, const std::string& hint) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id.c_str(), {size, size});
  const bool hovered = ImGui::IsItemHovered();
  ui.widgets.note(id);
  tooltip(ui, hint);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered || active) {
    list.AddRectFilled(corner, {corner.x + size, corner.y + size},
                       active ? palette::kAccent.faded(0.20f).packed() : palette::kLine.packed(), ui.px(4));
  }
  const float inner = std::min(size - ui.px(4), ui.px(16));
  const float inset = 0.5f * (size - inner);
  const ImU32 color = (active ? palette::kAccent : (hovered ? palette::kText : palette::kMuted)).packed();
  drawGlyph(list, glyph, {corner.x + inset, corner.y + inset}, inner, color);
  return pressed;
}

int segmented(Ui& ui, const std::string& id, const char* const* words, int count, int chosen, float width) {
  int clicked = -1;
  const float height = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), ui.px(5));
  const float part = width / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const ImVec2 low{corner.x + part * static_cast<float>(i), corner.y};
    ImGui::SetCursorScreenPos(low);
    const std::string name = id + "/" + lowered(words[i]);
    if (ImGui::InvisibleButton(name.c_str(), {part, height})) clicked = i;
    ui.widgets.note(name);
    const bool lit = i == chosen;
    if (lit) {
      list.AddRectFilled({low.x + ui.px(2), low.y + ui.px(2)}, {low.x + part - ui.px(2), low.y + height - ui.px(2)},
                         palette::kLine.packed(), ui.px(4));
    }
    const ImVec2 text = ImGui::CalcTextSize(words[i]);
    const Tint color = lit || ImGui::IsItemHovered() ? palette::kText : palette::kMuted;
    list.AddText({low.x + 0.5f * (part - text.x), low.y + 0.5f * (height - text.y)}, color.packed(), words[i]);
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({width, height});
  return clicked;
}

void clippedText(ImDrawList& list, const ImVec2& at, float width, ImU32 color, const std::string& text) {
  if (width <= 0.0f) return;
  if (ImGui::CalcTextSize(text.c_str()).x <= width) {
    list.AddText(at, color, text.c_str());
    return;
  }
  // The end stays, as names that begin alike differ there: "rectus abd...upper L".
  const float room = std::max(width - ImGui::CalcTextSize("...").x, 0.0f);
  const char* const last = text.c_str() + text.size();
  const char* tail = last;
  for (const char* c = last; c > text.c_str() && ImGui::CalcTextSize(c, last).x <= 0.4f * room; --c) {
    if ((static_cast<unsigned char>(*c) & 0xC0u) != 0x80u) tail = c;
  }
  const float tailWidth = ImGui::CalcTextSize(tail, last).x;
  const char* end = last;
  ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), room - tailWidth, 0.0f, text.c_str(), last, &end);
  const std::string shown = std::string(text.c_str(), end) + "..." + tail;
  list.AddText(at, color, shown.c_str());
}

}  // namespace sinew::app
