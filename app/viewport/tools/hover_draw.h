// app/viewport/tools/hover_draw.h: where a muscle would land: the skin and the bone under the pointer light up.
#pragma once

#include <imgui.h>

#include <string>

#include "app/viewport/tools/select.h"

namespace sinew::app {

/// Where the picture lies in a draw list.
struct Canvas {
  const View& view;
  glm::vec2 topLeft;    ///< The viewport's pixel (0, 0), draw list units.
  float unitsPerPixel;  ///< Draw list units per viewport pixel.
  float scale;          ///< Draw list units per design pixel.

  [[nodiscard]] bool isBehind(const glm::vec3& point) const { return view.toPixel(point).z > 1.0f; }
  [[nodiscard]] ImVec2 at(const glm::vec3& point) const {
    const glm::vec2 p = topLeft + glm::vec2(view.toPixel(point)) * unitsPerPixel;
    return {p.x, p.y};
  }
};

/// What a mesh is called, under its box. Needs a current ImGui frame, for its font.
void drawMeshName(ImDrawList& list, const Canvas& canvas, const Bounds& box, const std::string& name);

/// A bone's segment through everything. Nothing where an end is behind the eye.
void drawBoneMark(ImDrawList& list, const Canvas& canvas, const Bone& bone, const glm::mat4& boneInWorld);

/// A ring on the skin, the bone's segment through everything, its name beside the pointer. Nothing without skin under
/// the pointer. Needs a current ImGui frame, for its font.
void drawLanding(ImDrawList& list, const Canvas& canvas, const ViewportHover& hover, const Character& character,
                 const Pose& pose);

}  // namespace sinew::app
