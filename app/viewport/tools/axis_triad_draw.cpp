// app/viewport/tools/axis_triad_draw.cpp: the axis gizmo as ImGui draws it.

#include <imgui.h>

#include "app/viewport/tools/axis_triad.h"

namespace sinew::app {
namespace {

constexpr std::array<const char*, 3> kLetters{"X", "Y", "Z"};

ImU32 colorOf(AxisEnd end, float light, float alpha) {
  constexpr std::array<glm::vec3, 3> colors{glm::vec3{0.93f, 0.32f, 0.33f}, glm::vec3{0.47f, 0.78f, 0.25f},
                                            glm::vec3{0.30f, 0.56f, 0.95f}};
  const glm::vec3 color = glm::min(colors[static_cast<std::size_t>(end) / 2] * light, glm::vec3(1.0f));
  return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, alpha});
}

void drawLetter(ImDrawList& list, const ImVec2& at, float size, AxisEnd end, ImU32 color) {
  const char* letter = kLetters[static_cast<std::size_t>(end) / 2];
  ImFont* font = ImGui::GetFont();
  const ImVec2 extent = font->CalcTextSizeA(size, 1000.0f, 0.0f, letter);
  list.AddText(font, size, {at.x - 0.5f * extent.x, at.y - 0.5f * extent.y}, color, letter);
}

}  // namespace

void drawTriad(ImDrawList& list, const AxisTriad& triad, const TriadLayout& layout, const glm::vec2& topLeft,
               float unitsPerPixel) {
  const auto at = [&](const glm::vec2& pixel) {
    const glm::vec2 p = topLeft + pixel * unitsPerPixel;
    return ImVec2{p.x, p.y};
  };
  const ImVec2 center = at(layout.center);
  const float scale = unitsPerPixel * layout.radius / kTriadRadius;  // List units per design pixel.
  if (triad.ballHovered || triad.pressed) {
    list.AddCircleFilled(center, layout.radius * unitsPerPixel, IM_COL32(255, 255, 255, triad.turning ? 34 : 22), 48);
  }
  for (const TriadLayout::End& end : layout.ends) {  // Furthest first.
    const bool positive = static_cast<int>(end.end) % 2 == 0;
    const bool hovered = triad.hovered == end.end && !triad.turning;
    const float light = 0.72f + 0.28f * (0.5f + 0.5f * end.depth);
    const ImVec2 knob = at(end.pixel);
    const float radius = end.radius * unitsPerPixel * (hovered ? 1.12f : 1.0f);
    if (positive) list.AddLine(center, knob, colorOf(end.end, light, 0.95f), 2.2f * scale);
    list.AddCircleFilled(knob, radius, positive ? colorOf(end.end, light, 1.0f) : colorOf(end.end, 0.30f, 0.92f), 24);
    if (!positive) list.AddCircle(knob, radius - 0.75f * scale, colorOf(end.end, light, 1.0f), 24, 1.5f * scale);
    if (hovered) list.AddCircle(knob, radius, IM_COL32(255, 255, 255, 235), 24, 1.8f * scale);
    if (positive) drawLetter(list, knob, 13.0f * scale, end.end, IM_COL32(16, 18, 22, 255));
    else if (hovered) drawLetter(list, knob, 11.0f * scale, end.end, IM_COL32(240, 242, 246, 255));
  }
}

}  // namespace sinew::app
