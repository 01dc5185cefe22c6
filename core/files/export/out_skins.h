// core/files/export/out_skins.h: the skins of the exported file: those of the source, with joints appended where
// needed.
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

/// A skin keeps its joints, their order and their matrices; a joint that only fitted weights name comes after them.
/// A node whose mesh had no skin gets one of its own.
class OutSkins {
 public:
  explicit OutSkins(Source& source);

  /// Joints that bindings beyond the skeleton's mean. @param nodes  [joints] of the file
  void addJoints(std::span<const HelperJoint> joints, std::span<const int> nodes);
  /// Number of a binding among the joints of a node's skin; appended if it is none yet.
  int jointOf(int node, int binding);
  /// Mesh space of a node's skin -> world in the bind pose.
  [[nodiscard]] const glm::dmat4& meshToBind(int node) const;
  /// Puts the skins into the file and sets those of the nodes that asked for joints. Once, at the end.
  void write(GltfRewrite& rewrite);
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
