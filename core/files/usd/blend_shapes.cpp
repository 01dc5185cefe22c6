// core/files/usd/blend_shapes.cpp: tokens, prims and sampled weights.
#include "core/files/usd/blend_shapes.h"

#include <algorithm>

#include "core/files/usd/joints.h"
#include "core/geometry/at.h"

namespace sinew::usd {

BlendShapes::BlendShapes(const gltf::File& file, const gltf::NodeTree& tree, std::span<const Mesh> meshes) {
  ofNodes_.resize(tree.nodes.size());
  Siblings siblings;
  for (const Mesh& mesh : meshes) {
    gltf::NodeTargets& of = at(ofNodes_, mesh.node);
    if (of.count == 0) of.first = static_cast<int>(tokens_.size());
    const int number = tree[mesh.node].mesh;
    const std::vector<std::string>& named = file.targetNames(number);
    const std::vector<double>& own = at(file.model().nodes, mesh.node).weights;
    const std::vector<double>& weights = own.empty() ? at(file.model().meshes, number).weights : own;
    for (auto k = toIndex(of.count); k < mesh.shapes.size(); ++k) {
      names_.push_back(k < named.size() ? named[k] : std::string());
      tokens_.push_back(siblings.fresh(identifierOf(names_.back(), "Shape")));
      rest_.push_back(k < weights.size() ? static_cast<float>(weights[k]) : 0.0f);
      ++of.count;
    }
  }
}

bool BlendShapes::restsAtZero() const {
  return std::ranges::all_of(rest_, [](float weight) { return weight == 0.0f; });
}

void BlendShapes::writeMesh(const Mesh& mesh, const std::string& path, Text& text) const {
  if (mesh.shapes.empty()) return;
  const auto first = toIndex(at(ofNodes_, mesh.node).first);
  const std::span<const std::string> tokens = std::span(tokens_).subspan(first, mesh.shapes.size());
  std::string targets;
  for (const std::string& token : tokens) targets += (targets.empty() ? "[<" : ", <") + path + '/' + token + '>';
  text.attribute("uniform token[] skel:blendShapes", quotedList(tokens));
  text.attribute("rel skel:blendShapeTargets", targets + ']');
  for (std::size_t k = 0; k < mesh.shapes.size(); ++k) {
    const BlendShape& shape = mesh.shapes[k];
    text.open("def BlendShape \"" + tokens[k] + '"', displayName(names_[first + k], tokens[k]));
    if (!shape.normalOffsets.empty())
      text.attribute("uniform vector3f[] normalOffsets", arrayText(shape.normalOffsets));
    text.attribute("uniform vector3f[] offsets", arrayText(shape.offsets));
    text.attribute("uniform int[] pointIndices", arrayText(shape.points));
    text.close();
  }
}

void BlendShapes::writeClip(const AnimationClip& clip, std::span<const double> frames, Text& text) const {
  if (isEmpty()) return;
  text.attribute("uniform token[] blendShapes", quotedList(tokens_));
  std::vector<std::string> values;
  std::vector<float> weights = rest_;
  for (const double frame : frames) {
    const float time = std::min(static_cast<float>(frame / kFramesPerSecond), clip.duration);
    for (const MorphChannel& channel : clip.morphChannels) {
      sampleMorphs(channel, time, std::span(weights).subspan(toIndex(channel.firstTarget), toIndex(channel.targets)));
    }
    values.push_back(arrayText(weights));
  }
  if (std::ranges::all_of(values, [&](const std::string& value) { return value == values.front(); })) {
    text.attribute("float[] blendShapeWeights", values.front());
    return;
  }
  text.openSamples("float[] blendShapeWeights");
  for (std::size_t f = 0; f < values.size(); ++f) text.line(numberText(frames[f]) + ": " + values[f] + ',');
  text.close();
}

}  // namespace sinew::usd
