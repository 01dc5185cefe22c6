// core/files/usd/blend_shapes.h: the morph targets of a glTF file's nodes as one list of names and weights.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/files/gltf/animation.h"
#include "core/files/usd/meshes.h"
#include "core/files/usd/text.h"

namespace sinew::usd {

/// USD animates blend shapes by name, all meshes together; glTF node by node. So each target of each node has a name of
/// its own. At rest USD knows no weights but 0.
class BlendShapes {
 public:
  BlendShapes(const gltf::File& file, const gltf::NodeTree& tree, std::span<const Mesh> meshes);

  /// What clips number.
  [[nodiscard]] const std::vector<gltf::NodeTargets>& ofNodes() const { return ofNodes_; }
  [[nodiscard]] bool isEmpty() const { return tokens_.empty(); }
  /// Whether all weigh nothing where no clip plays.
  [[nodiscard]] bool restsAtZero() const;
  /// Of a mesh prim that is open: its list, and a prim for each. @param path  of the mesh
  void writeMesh(const Mesh& mesh, const std::string& path, Text& text) const;
  /// Of a SkelAnimation that is open. @param frames  of kFramesPerSecond
  void writeClip(const AnimationClip& clip, std::span<const double> frames, Text& text) const;

 private:
  std::vector<gltf::NodeTargets> ofNodes_;
  std::vector<std::string> tokens_;  ///< [targets of all nodes]
  std::vector<std::string> names_;   ///< As in the file.
  std::vector<float> rest_;          ///< Weights where no clip sets them.
};

}  // namespace sinew::usd
