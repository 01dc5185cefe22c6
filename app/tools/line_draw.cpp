// app/tools/line_draw.cpp: a curve, two balls, a diamond.

#include "app/tools/line_draw.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace sinew::app {
namespace {

constexpr ImU32 kTendon = IM_COL32(244, 238, 226, 255);
constexpr ImU32 kShadow = IM_COL32(12, 14, 18, 190);
constexpr ImU32 kHot = IM_COL32(255, 196, 64, 255);
constexpr ImU32 kBone = IM_COL32(120, 220, 255, 255);

/// Belly: pale at rest, red when it is active.
ImU32 flesh(float activation) {
  const auto mixed = [&](float loose, float tense) {
    return static_cast<int>(std::lround(glm::mix(loose, tense, activation)));
  };
  return IM_COL32(mixed(214.0f, 240.0f), mixed(150.0f, 48.0f), mixed(140.0f, 40.0f), 255);
}

ImVec2 at(const PictureFrame& frame, const glm::vec3& point) {
  const glm::vec2 place = frame.topLeft + frame.unitsPerPixel * glm::vec2(frame.view.toPixel(point));
  return {place.x, place.y};
}

bool isBehind(const PictureFrame& frame, const glm::vec3& point) { return frame.view.toPixel(point).z > 1.0f; }

void stroke(ImDrawList& list, const ImVec2& a, const ImVec2& b, ImU32 color, float width) {
  list.AddLine(a, b, kShadow, width + 2.0f);
  list.AddLine(a, b, color, width);
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

void drawBone(ImDrawList& list, const PictureFrame& frame, const Skeleton& skeleton, const Pose& pose, int bone) {
  if (bone < 0) return;
  const auto index = static_cast<std::size_t>(bone);
  const glm::vec3 head(pose.boneInWorld[index][3]);
  const glm::vec3 tail(pose.boneInWorld[index] * glm::vec4(skeleton.bones[index].tip, 1.0f));
  if (isBehind(frame, head) || isBehind(frame, tail)) return;
  stroke(list, at(frame, head), at(frame, tail), kBone, 3.0f * frame.uiScale);
  ball(list, at(frame, head), 4.0f * frame.uiScale, kBone);
}

}  // namespace

void drawLine(ImDrawList& list, const PictureFrame& frame, const ShownLine& line, const LineHandles& handles) {
  if (isBehind(frame, line.origin) || isBehind(frame, line.insertion)) return;
  if (line.via && isBehind(frame, *line.via)) return;
  const glm::vec3 middle = line.via ? *line.via : 0.5f * (line.origin + line.insertion);
  const float width = 2.0f * frame.uiScale;
  // Tendons at both ends, the belly between them.
  const std::array points{line.origin, glm::mix(line.origin, middle, 0.35f), middle,
                          glm::mix(line.insertion, middle, 0.35f), line.insertion};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const bool belly = i == 1 || i == 2;
    stroke(list, at(frame, points[i]), at(frame, points[i + 1]), belly ? flesh(line.activation) : kTendon, width);
  }
  const auto tint = [&](LineEnd end) {
    const bool hot = handles.drag ? handles.drag->end == end : handles.hovered == end;
    return hot ? kHot : kTendon;
  };
  ball(list, at(frame, line.origin), 5.0f * frame.uiScale, tint(LineEnd::kOrigin));
  ball(list, at(frame, line.insertion), 5.0f * frame.uiScale, tint(LineEnd::kInsertion));
  if (line.via) diamond(list, at(frame, *line.via), 6.0f * frame.uiScale, tint(LineEnd::kVia));
}

void drawLineEnds(ImDrawList& list, const PictureFrame& frame, const LineDrag& drag, const Skeleton& skeleton,
                  const Pose& pose) {
  drawBone(list, frame, skeleton, pose, drag.startBone);
  if (drag.endBone != drag.startBone) drawBone(list, frame, skeleton, pose, drag.endBone);
}

}  // namespace sinew::app
