// app/render/scene.cpp: primitives as they are drawn.
#include "app/render/scene.h"

#include <span>
#include <string_view>
#include <unordered_map>

#include "app/document/group_colors.h"
#include "core/drivers/driven_numbers.h"
#include "core/lines/carriers.h"

namespace sinew::app {
namespace {

/// The rig's lines in a pose; those that cannot be used are left out.
std::unordered_map<std::string_view, ShapeLine> linesByName(const Rig& rig, std::span<const PosedLine> posed) {
  std::unordered_map<std::string_view, ShapeLine> lines;
  for (std::size_t i = 0; i < posed.size(); ++i) {
    const PosedLine& line = posed[i];
    if (!line.usable) continue;
    const LinePath path{line.origin, rig.lines[i].via ? std::optional(line.via) : std::nullopt, line.insertion};
    lines.emplace(rig.lines[i].name, ShapeLine{path, line.activation, line.stretch});
  }
  return lines;
}

}  // namespace

std::vector<PrimitiveShape> shapesOf(const Rig& drawn, const Character& character, const Pose& pose) {
  std::vector<PrimitiveShape> shapes;
  Rig memory;
  const Rig& rig = inPose(drawn, character, pose, memory);
  const std::vector<PosedLine> posed = posedLines(rig, character, pose);
  const std::vector<std::optional<BentMuscle>> muscles = carriedMuscles(rig, character, pose, posed);
  const std::unordered_map<std::string_view, ShapeLine> lines = linesByName(rig, posed);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    if (!muscles[i]) continue;
    PrimitiveShape shape;
    shape.rigIndex = static_cast<int>(i);
    shape.unitBallInWorld = shapeInWorld(muscles[i]->placement, 1.0f, muscles[i]->carrier);
    shape.shape = muscles[i]->placement.shape;
    shape.reach = primitive.reach;
    shape.sign = primitive.sign;
    shape.radii = muscles[i]->placement.radii;
    if (const auto line = lines.find(primitive.line); line != lines.end()) shape.line = line->second;
    shape.color = toLinear(groupColor(rig, primitive.group));
    shapes.push_back(shape);
  }
  return shapes;
}

std::array<glm::vec3, 6> extremesOf(const PrimitiveShape& shape, float scale) {
  std::array<glm::vec3, 6> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    glm::vec3 axis(0.0f);
    axis[static_cast<int>(i / 2)] = i % 2 == 0 ? 1.0f : -1.0f;
    points[i] = glm::vec3(shape.unitBallInWorld * glm::vec4(onShape(shape.shape, scale, axis), 1.0f));
  }
  return points;
}

}  // namespace sinew::app
