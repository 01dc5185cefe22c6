// core/files/export/out_skins.h: the skins of the exported file: the source's, with added joints; data of muscle lines.
#pragma once

#include <map>
#include <set>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/source.h"
#include "core/files/fit/helper_motion.h"

namespace sinew::exporting {

/// Adds data for posing the joints of muscle lines in new poses to `extras.sinew` of the first skin with one of them
/// (docs/export.md, "Line data"). Settings are the rig's, without keys and drivers. Call after the skins are written.
/// False: there are such skins, but their extras are not objects. @param nodes  of the file, those of lines.joints()
/// first
bool addLineData(const Source& source, const LineJoints& lines, std::span<const int> nodes, GltfRewrite& rewrite);

/// Skins keep joints, order and matrices; joints that only fitted weights use are appended. Nodes without skin get one.
class OutSkins {
 public:
  explicit OutSkins(Source& source);

  /// Joints of bindings beyond the skeleton's. @param nodes  [joints] of the file
  void addJoints(std::span<const HelperJoint> joints, std::span<const int> nodes);
  int jointOf(int node, int binding);  ///< Number of a binding among the joints of a node's skin, appended if absent.
  /// Mesh space of a node's skin -> world in the bind pose.
  [[nodiscard]] const glm::dmat4& meshToBind(int node) const;
  void write(GltfRewrite& rewrite);  ///< Writes the skins and assigns them to nodes. Call once, at the end.
  /// Nodes that are joints of the skins written.
  [[nodiscard]] int jointNodes() const { return static_cast<int>(nodes_.size()); }

 private:
  struct Skin {
    glm::dmat4 meshToBind{1.0};
    std::vector<int> bindings;   // [joints]
    std::map<int, int> jointOf;  // binding -> joint
    std::size_t own = 0;         // joints of the file's skin
    std::vector<int> users;      // nodes
  };

  [[nodiscard]] int keyOf(int node) const;
  [[nodiscard]] int nodeOf(int binding) const;
  [[nodiscard]] glm::dmat4 inverseBindOf(int binding) const;
  void writeSkin(int fileSkin, const Skin& skin, GltfRewrite& rewrite);
  [[nodiscard]] std::vector<glm::mat4> inverseBinds(int fileSkin, const Skin& skin, bool& changed);

  Source& source_;
  std::map<int, Skin> skins_;  // by the file's number; new ones by -1 - node
  std::set<int> nodes_;
  std::vector<int> addedNodes_;
  std::vector<glm::dmat4> addedInverseBinds_;
};

}  // namespace sinew::exporting
