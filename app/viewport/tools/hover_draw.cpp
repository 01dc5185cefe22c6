// app/viewport/tools/hover_draw.cpp: the landing mark of the add-muscle tool.
#include "app/viewport/tools/hover_draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "app/document/shown_names.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

constexpr ImU32 kMark = IM_COL32(255, 214, 64, 255);
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
  list.AddPolyline(ring.data(), static_cast<int>(ring.size()), kMark, ImDrawFlags_Closed, 2.0f * canvas.scale);
}

/// Kept within the picture. @param corner  where the text begins
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

void drawName(ImDrawList& list, const ImVec2& beside, float scale, const std::string& name) {
  drawPlate(list, {beside.x + 18.0f * scale, beside.y + 14.0f * scale}, scale, inReadingOrder(name));
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
  list.AddCircleFilled(a, 4.0f * canvas.scale, kMark);
  list.AddCircleFilled(b, 2.5f * canvas.scale, kMark);
}

void drawLanding(ImDrawList& list, const Canvas& canvas, const ViewportHover& hover, const Character& character,
                 const Pose& pose) {
  if (!hover.skin) return;
  const auto bone = static_cast<std::size_t>(boneAt(character, *hover.skin));
  const SkinPoint skin = skinPointAt(character, pose, *hover.skin);
  drawBoneMark(list, canvas, character.skeleton.bones[bone], pose.boneInWorld[bone]);
  drawRing(list, canvas, skin, kRingRadius * character.height);
  if (canvas.isBehind(skin.point)) return;
  drawName(list, canvas.at(skin.point), canvas.scale, shownBoneName(character.skeleton, static_cast<int>(bone)));
}

}  // namespace sinew::app
