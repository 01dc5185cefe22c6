// core/files/export/line_data.cpp: lines as JSON, everything in the spaces of the file's nodes or in the line's bind
// frame.
#include "core/files/export/line_data.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

constexpr int kLineDataVersion = 1;

/// Shortest texts that give the float back.
Json numbers(std::initializer_list<double> values) {
  Json list = Json::array();
  for (const double value : values) list.push(static_cast<float>(value));
  return list;
}

Json floatsOf(const glm::dvec2& v) { return numbers({v.x, v.y}); }
Json floatsOf(const glm::dvec3& v) { return numbers({v.x, v.y, v.z}); }

class LineWriter {
 public:
  LineWriter(const Source& source, const LineJoints& lines, std::span<const int> nodes)
      : source_(source), lines_(lines), nodes_(nodes) {}

  /// Joints of one line follow each other.
  [[nodiscard]] Json all() const {
    Json list = Json::array();
    const std::vector<HelperJoint>& joints = lines_.joints();
    for (std::size_t first = 0; first < joints.size();) {
      std::size_t end = first;
      while (end < joints.size() && joints[end].line == joints[first].line) ++end;
      list.push(line(first, end));
      first = end;
    }
    return list;
  }

 private:
  [[nodiscard]] const Bone& bone(int index) const { return at(source_.bound.skeleton.bones, index); }

  /// A point that rides a node.
  [[nodiscard]] Json place(const BonePoint& point) const {
    Json data = Json::object();
    data.set("node", source_.nodeOfBone(point.bone)).set("point", floatsOf(point.inBone));
    return data;
  }

  /// With the line's bind frame in the node's space: what the node makes of it in a pose is how it has turned and
  /// grown.
  [[nodiscard]] Json end(const BonePoint& point, const LineRest& rest) const {
    const glm::dmat3 frame = glm::inverse(glm::dmat3(glm::dmat4(bone(point.bone).bindInWorld))) * rest.frame;
    Json data = place(point);
    data.set("frame", numbers({frame[0].x, frame[0].y, frame[0].z, frame[1].x, frame[1].y, frame[1].z, frame[2].x,
                               frame[2].y, frame[2].z}));
    return data;
  }

  [[nodiscard]] Json line(std::size_t first, std::size_t end_) const {
    const HelperJoint& joint = lines_.joints()[first];
    const LineRest& rest = lines_.restOf(joint.line);
    const LineSettings& settings = rest.settings;
    const glm::dmat3 intoFrame = glm::transpose(rest.frame);
    const glm::dmat4 parent(bone(joint.bone).bindInWorld);
    Json joints = Json::array();
    for (std::size_t j = first; j < end_; ++j) {
      const glm::dvec3 stands(parent * glm::dvec4(lines_.joints()[j].rest.translation, 1.0));
      Json one = Json::object();
      one.set("node", nodes_[j]).set("at", floatsOf(intoFrame * (stands - rest.start)));
      joints.push(std::move(one));
    }
    Json data = Json::object();
    data.set("name", lines_.nameOf(joint.line)).set("joints", std::move(joints));
    data.set("size", static_cast<float>(std::cbrt(std::abs(glm::determinant(glm::dmat3(parent))))));
    data.set("origin", end(rest.origin, rest)).set("insertion", end(rest.insertion, rest));
    if (rest.via) data.set("via", place(*rest.via).set("shift", floatsOf(intoFrame * rest.viaShift)));
    data.set("length", static_cast<float>(rest.length)).set("rest", settings.rest);
    data.set("tendons", floatsOf(settings.tendons)).set("volume", settings.volume);
    data.set("limits", floatsOf(settings.limits)).set("depth", static_cast<float>(rest.depth));
    data.set("twist", settings.twist).set("flex", floatsOf(settings.flex));
    data.set("base", settings.base).set("gain", settings.gain).set("full", settings.full);
    return data;
  }

  const Source& source_;
  const LineJoints& lines_;
  std::span<const int> nodes_;
};

bool namesAny(const Json& skin, std::span<const int> nodes) {
  return std::ranges::any_of(skin.at("joints").items(), [&](const Json& joint) {
    return std::ranges::find(nodes, static_cast<int>(joint.number(-1.0))) != nodes.end();
  });
}

}  // namespace

bool addLineData(const Source& source, const LineJoints& lines, std::span<const int> nodes, GltfRewrite& rewrite) {
  Json* skins = memberOf(rewrite.root(), "skins");
  if (lines.joints().empty() || !skins) return true;
  bool isHeld = true;
  for (Json& skin : skins->children) {
    if (!namesAny(skin, nodes.first(lines.joints().size()))) continue;
    Json& extras = ensureMember(skin, "extras", Json::object());
    isHeld = extras.kind == Json::Kind::kObject;
    if (!isHeld) continue;
    Json data = Json::object();
    data.set("version", kLineDataVersion).set("joint_scale", nameOf(lines.scale()));
    extras.set("sinew", data.set("lines", LineWriter(source, lines, nodes).all()));
    break;
  }
  return isHeld;
}

}  // namespace sinew::exporting
