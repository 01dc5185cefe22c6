// tests/support/characters/moved_base.cpp: overwrites positions in the file's own buffer.
#include "tests/support/characters/moved_base.h"

#include <cstring>
#include <sstream>

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "tests/support/characters/gltf_oracle.h"

namespace sinew::test {
namespace {

std::size_t toSize(int index) { return static_cast<std::size_t>(index); }

/// One separate accessor per primitive, since files share them.
void setPositions(tinygltf::Model& model, tinygltf::Primitive& primitive, const std::vector<glm::dvec3>& positions) {
  tinygltf::Accessor accessor;
  tinygltf::BufferView view;
  std::vector<unsigned char>& bytes = model.buffers.at(0).data;
  bytes.resize((bytes.size() + 3) / 4 * 4);
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = positions.size() * 12;
  for (const glm::dvec3& position : positions) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<float>(position[axis]);
      unsigned char raw[4];
      std::memcpy(raw, &value, 4);
      bytes.insert(bytes.end(), raw, raw + 4);
    }
  }
  accessor.bufferView = static_cast<int>(model.bufferViews.size());
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.type = TINYGLTF_TYPE_VEC3;
  accessor.count = positions.size();
  model.bufferViews.push_back(view);
  primitive.attributes["POSITION"] = static_cast<int>(model.accessors.size());
  model.accessors.push_back(accessor);
}

}  // namespace

std::string movedBase(const std::filesystem::path& file, const std::vector<float>& weights) {
  const GltfOracle oracle(file);
  tinygltf::TinyGLTF io;
  tinygltf::Model model;
  std::string error;
  std::string warning;
  EXPECT_TRUE(io.LoadBinaryFromFile(&model, &error, &warning, file.string())) << error;
  std::size_t next = 0;
  for (tinygltf::Node& node : model.nodes) {
    if (node.mesh < 0) continue;
    tinygltf::Mesh& mesh = model.meshes.at(toSize(node.mesh));
    const std::size_t count = mesh.primitives.front().targets.size();
    std::vector<double> own(weights.begin() + static_cast<std::ptrdiff_t>(next),
                            weights.begin() + static_cast<std::ptrdiff_t>(next + count));
    next += count;
    for (std::size_t p = 0; p < mesh.primitives.size() && count > 0; ++p) {
      setPositions(model, mesh.primitives[p], oracle.morphedPositions(node.mesh, static_cast<int>(p), own));
      mesh.primitives[p].targets.clear();
    }
    mesh.weights.clear();
    node.weights.clear();
  }
  EXPECT_EQ(next, weights.size());
  model.animations.clear();
  std::ostringstream out;
  EXPECT_TRUE(io.WriteGltfSceneToStream(&model, out, false, true));
  return out.str();
}

}  // namespace sinew::test
