// app/viewport/tools/axis_triad.cpp: the axis gizmo: layout, input, drawing.
#include "app/viewport/tools/axis_triad.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <imgui.h>
#include <glm/geometric.hpp>

#include "app/viewport/render/view.h"
#include "app/viewport/tools/status_line.h"

namespace sinew::app {
namespace {

constexpr float kKnobPlace = 0.78f;  ///< Fraction of the ball's radius, from its center.
constexpr float kKnobRadius = 9.0f;  ///< Design pixels.
constexpr float kSameDirection = 0.9995f;

glm::vec3 directionOf(AxisEnd end) {
  const int number = static_cast<int>(end);
  glm::vec3 direction(0.0f);
  direction[number / 2] = number % 2 == 0 ? 1.0f : -1.0f;
  return direction;
}

AxisEnd oppositeOf(AxisEnd end) {
  const int number = static_cast<int>(end);
  return static_cast<AxisEnd>(number % 2 == 0 ? number + 1 : number - 1);
}

/// Position of the camera, or the end of its transition.
CameraStand standAhead(const Camera& camera) { return camera.transition ? camera.transition->to : camera.stand; }

/// Looks from an end of an axis, or from the opposite one if it already does.
void lookFrom(Camera& camera, AxisEnd end) {
  // By AxisEnd.
  constexpr std::array<StandardView, 6> kViews{StandardView::kLeft,   StandardView::kRight, StandardView::kTop,
                                               StandardView::kBottom, StandardView::kFront, StandardView::kBack};
  const CameraStand stand = standAhead(camera);
  const glm::vec3 backward = cameraAxes(stand.yaw, stand.pitch)[2];
  const bool thereAlready = glm::dot(backward, directionOf(end)) > kSameDirection;
  showStandardView(camera, kViews[static_cast<std::size_t>(thereAlready ? oppositeOf(end) : end)]);
}

}  // namespace

TriadLayout layoutTriad(const Camera& camera, const glm::ivec2& size, float uiScale) {
  TriadLayout layout;
  layout.radius = kTriadRadius * uiScale;
  layout.center = glm::vec2(size) - (kTriadMargin + kTriadRadius) * uiScale;
  const glm::mat3 axes = cameraAxes(camera.stand.yaw, camera.stand.pitch);  // Right, up, backward.
  for (std::size_t i = 0; i < layout.ends.size(); ++i) {
    const auto end = static_cast<AxisEnd>(i);
    const glm::vec3 seen = directionOf(end) * axes;
    const float nearness = 1.0f + 0.12f * seen.z;
    layout.ends[i] = {end, layout.center + kKnobPlace * layout.radius * glm::vec2(seen.x, -seen.y),
                      kKnobRadius * uiScale * nearness, seen.z};
  }
  std::ranges::stable_sort(layout.ends, {}, &TriadLayout::End::depth);
  return layout;
}

std::optional<AxisEnd> axisEndAt(const TriadLayout& layout, const glm::vec2& pixel) {
  for (std::size_t i = layout.ends.size(); i-- > 0;) {  // Nearest to the eye first.
    const TriadLayout::End& end = layout.ends[i];
    if (glm::distance(pixel, end.pixel) <= end.radius + 1.0f) return end.end;
  }
  return std::nullopt;
}

bool routeTriad(AxisTriad& triad, Camera& camera, const ViewportInput& input, const glm::ivec2& size, float uiScale) {
  const TriadLayout layout = layoutTriad(camera, size, uiScale);
  const ButtonState& left = input.button(MouseButton::kLeft);
  if (!triad.pressed) {
    triad.ballHovered = !input.mouseTaken && glm::distance(input.mouse, layout.center) <= layout.radius;
    triad.hovered = triad.ballHovered ? axisEndAt(layout, input.mouse) : std::nullopt;
    if (!triad.ballHovered || !left.pressed || input.alt) return false;
    triad.pressed = true;
    triad.turning = false;
    triad.pressPixel = triad.lastPixel = input.mouse;
  }
  if (!triad.turning && glm::distance(input.mouse, triad.pressPixel) > kDragThreshold * uiScale) triad.turning = true;
  if (triad.turning) {
    // A drag across the ball is half a rotation, whatever the size of the picture.
    const int across = std::max(static_cast<int>(2.0f * layout.radius), 1);
    orbit(camera, input.mouse - triad.lastPixel, {across, across});
  }
  triad.lastPixel = input.mouse;
  if (left.released || !left.down) {
    if (!triad.turning && triad.hovered) lookFrom(camera, *triad.hovered);
    triad.pressed = triad.turning = false;
  }
  return true;
}

ViewportInput passTriad(AxisTriad& triad, Camera& camera, ViewportInput input, const glm::ivec2& size, float uiScale,
                        bool busy) {
  if (busy && !triad.pressed) {
    triad.hovered.reset();
    triad.ballHovered = false;
    return input;
  }
  const bool taken = routeTriad(triad, camera, input, size, uiScale);
  input.mouseTaken = input.mouseTaken || taken || triad.ballHovered;
  return input;
}

std::string describe(const AxisTriad& triad) {
  if (triad.turning) return statusLine("Orbit", {"Release ends"});
  if (!triad.ballHovered) return "";
  if (!triad.hovered) return statusLine("Axis gizmo", {"Click on an axis looks along it", "Drag orbits"});
  struct Named {
    const char* axis;
    const char* first;
    const char* again;
  };
  // By AxisEnd.
  constexpr std::array<Named, 6> kEnds{{
      {"Axis +X", "Click shows the character's left", "Click again shows its right"},
      {"Axis -X", "Click shows the character's right", "Click again shows its left"},
      {"Axis +Y", "Click looks from above", "Click again looks from below"},
      {"Axis -Y", "Click looks from below", "Click again looks from above"},
      {"Axis +Z", "Click shows the front", "Click again shows the back"},
      {"Axis -Z", "Click shows the back", "Click again shows the front"},
  }};
  const Named& end = kEnds[static_cast<std::size_t>(*triad.hovered)];
  return statusLine(end.axis, {end.first, end.again, "Drag orbits"});
}

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
