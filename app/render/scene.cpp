// app/render/scene.cpp: primitives as they are drawn.
#include "app/render/scene.h"

#include <string_view>
#include <unordered_map>

#include "app/document/group_colors.h"
#include "core/lines/carriers.h"

namespace sinew::app {
namespace {

/// The rig's lines as they are in a pose, by name; those that cannot be used are left out.
std::unordered_map<std::string_view, ShapeLine> linesOf(const Rig& rig, const Character& character, const Pose& pose) {
  std::unordered_map<std::string_view, ShapeLine> lines;
  if (rig.lines.empty()) return lines;
  LineScratch scratch;
  std::vector<PosedLine> posed;
  poseLines(lineRests(rig, character), character.skeleton, pose, scratch, posed);
  for (std::size_t i = 0; i < posed.size(); ++i) {
    const PosedLine& line = posed[i];
    if (!line.usable) continue;
    const LinePath path{line.origin, rig.lines[i].via ? std::optional(line.via) : std::nullopt, line.insertion};
    lines.emplace(rig.lines[i].name, ShapeLine{path, line.activation, line.stretch});
  }
  return lines;
}

}  // namespace

std::vector<PrimitiveShape> shapesOf(const Rig& rig, const Character& character, const Pose& pose) {
  std::vector<PrimitiveShape> shapes;
  const std::vector<std::optional<glm::mat4>> carriers = carriersOf(rig, character, pose);
  const std::unordered_map<std::string_view, ShapeLine> lines = linesOf(rig, character, pose);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    if (!carriers[i]) continue;
    PrimitiveShape shape;
    shape.rigIndex = static_cast<int>(i);
    shape.unitBallInWorld = shapeInWorld(primitive.placement, 1.0f, *carriers[i]);
    shape.shape = primitive.placement.shape;
    shape.reach = primitive.reach;
    shape.sign = primitive.sign;
    shape.radii = primitive.placement.radii;
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
