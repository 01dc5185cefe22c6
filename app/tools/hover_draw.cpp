// app/tools/hover_draw.cpp: the landing mark of the add-muscle tool.
#include "app/tools/hover_draw.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <imgui.h>

namespace sinew::app {
namespace {

constexpr ImU32 kMark = IM_COL32(255, 214, 64, 255);
constexpr ImU32 kMarkFaint = IM_COL32(255, 214, 64, 120);
constexpr ImU32 kShadow = IM_COL32(12, 14, 18, 190);
constexpr float kRingRadius = 0.022f;  ///< Of H.
constexpr std::size_t kRingPoints = 40;

struct Canvas {
  const View& view;
  glm::vec2 topLeft;
  float unitsPerPixel;

  [[nodiscard]] bool isBehind(const glm::vec3& point) const { return view.toPixel(point).z > 1.0f; }
  [[nodiscard]] ImVec2 at(const glm::vec3& point) const {
    const glm::vec2 p = topLeft + glm::vec2(view.toPixel(point)) * unitsPerPixel;
    return {p.x, p.y};
  }
};

void drawRing(ImDrawList& list, const Canvas& canvas, const SkinPoint& skin, float radius) {
  const glm::vec3 helper = std::abs(skin.normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 u = normalizeOr(glm::cross(skin.normal, helper), glm::vec3(1, 0, 0));
  const glm::vec3 v = glm::cross(skin.normal, u);
  std::array<ImVec2, kRingPoints> ring;
  for (std::size_t i = 0; i < kRingPoints; ++i) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(kRingPoints);
    const glm::vec3 point = skin.point + radius * (std::cos(angle) * u + std::sin(angle) * v);
    if (canvas.isBehind(point)) return;
    ring[i] = canvas.at(point);
  }
  list.AddConvexPolyFilled(ring.data(), static_cast<int>(ring.size()), IM_COL32(255, 214, 64, 50));
  list.AddPolyline(ring.data(), static_cast<int>(ring.size()), kMark, ImDrawFlags_Closed, 2.0f);
}

void drawBone(ImDrawList& list, const Canvas& canvas, const Bone& bone, const glm::mat4& boneInWorld) {
  const glm::vec3 origin(boneInWorld[3]);
  const glm::vec3 tip(boneInWorld * glm::vec4(bone.tip, 1.0f));
  if (canvas.isBehind(origin) || canvas.isBehind(tip)) return;
  const ImVec2 a = canvas.at(origin);
  const ImVec2 b = canvas.at(tip);
  list.AddLine(a, b, kShadow, 5.0f);
  list.AddLine(a, b, kMarkFaint, 3.0f);
  list.AddCircleFilled(a, 5.0f, kShadow);
  list.AddCircleFilled(a, 4.0f, kMark);
  list.AddCircleFilled(b, 2.5f, kMark);
}

void drawName(ImDrawList& list, const ImVec2& beside, const std::string& name) {
  const ImVec2 size = ImGui::CalcTextSize(name.c_str());
  const ImVec2 low{beside.x + 18.0f, beside.y + 14.0f};
  list.AddRectFilled({low.x - 6.0f, low.y - 3.0f}, {low.x + size.x + 6.0f, low.y + size.y + 3.0f}, kShadow, 4.0f);
  list.AddText(low, IM_COL32(235, 238, 242, 255), name.c_str());
}

}  // namespace

void drawLanding(ImDrawList& list, const ViewportHover& hover, const Character& character, const Pose& pose,
                 const View& view, const glm::vec2& topLeft, float unitsPerPixel) {
  if (!hover.skin) return;
  const Canvas canvas{view, topLeft, unitsPerPixel};
  const auto bone = static_cast<std::size_t>(boneAt(character, *hover.skin));
  const SkinPoint skin = skinPointAt(character, pose, *hover.skin);
  drawBone(list, canvas, character.skeleton.bones[bone], pose.boneInWorld[bone]);
  drawRing(list, canvas, skin, kRingRadius * character.height);
  if (!canvas.isBehind(skin.point)) drawName(list, canvas.at(skin.point), character.skeleton.bones[bone].name);
}

}  // namespace sinew::app
