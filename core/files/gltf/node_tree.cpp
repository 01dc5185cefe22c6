// core/files/gltf/node_tree.cpp: reading the node tree.
#include "core/files/gltf/node_tree.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"

namespace sinew::gltf {

// Hidden characters.

namespace {

constexpr float kLeastShown = 0.5f / 255.0f;  ///< Smaller values round to 0 in 8 bits.

/// [materials] the largest alpha of the vertex colors; nullopt: unused.
std::vector<std::optional<float>> vertexAlphas(const Character& character) {
  std::vector<std::optional<float>> largest(character.materials.size());
  for (const ControlTriangle& triangle : character.mesh.triangles) {
    std::optional<float>& own = at(largest, triangle.material);
    for (const int wedge : triangle.wedges) {
      own = std::max(own.value_or(0.0f), at(character.mesh.wedges, wedge).color.a);
    }
  }
  return largest;
}

/// Largest alpha of a material's texture, 0..1.
float textureAlpha(const Character& character, const Material& material) {
  if (material.baseColorTexture < 0) return 1.0f;
  const Texture& texture = at(character.textures, material.baseColorTexture);
  std::uint8_t largest = 0;
  for (std::size_t i = 3; i < texture.rgba.size() && largest < 255; i += 4) {
    largest = std::max(largest, texture.rgba[i]);
  }
  return static_cast<float>(largest) / 255.0f;
}

bool hides(const Material& material, float alpha) {
  if (material.alphaMode == AlphaMode::kMask) return alpha < material.alphaCutoff;
  return material.alphaMode == AlphaMode::kBlend && alpha < kLeastShown;
}

std::string shortText(float number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 3).ptr;
  return {text.data(), end};
}

std::string noteOf(const Material& material, float alpha) {
  std::string note = "material \"" + material.name + "\": its alpha of ";
  note += (alpha > 0.0f ? "at most " : "") + shortText(alpha);
  if (material.alphaMode == AlphaMode::kMask) note += " (cutoff " + shortText(material.alphaCutoff) + ')';
  return note + " would hide the whole character; shown opaque";
}

}  // namespace

void showHiddenCharacter(Character& character, Notes& notes) {
  const std::vector<std::optional<float>> vertexAlpha = vertexAlphas(character);
  std::vector<float> alphas(character.materials.size(), 1.0f);
  for (std::size_t m = 0; m < alphas.size(); ++m) {
    const Material& material = character.materials[m];
    if (!vertexAlpha[m]) continue;
    if (material.alphaMode == AlphaMode::kOpaque) return;
    alphas[m] = material.baseColor.a * *vertexAlpha[m];
    if (!hides(material, alphas[m])) alphas[m] *= textureAlpha(character, material);
    if (!hides(material, alphas[m])) return;
  }
  for (std::size_t m = 0; m < alphas.size(); ++m) {
    if (!vertexAlpha[m]) continue;
    character.materials[m].shownOpaque = true;
    notes.add(noteOf(character.materials[m], alphas[m]));
  }
}

// The node tree.

namespace {

/// A matrix, or translation, rotation and scale; in float for posing and in double for binding.
void readTransform(const tinygltf::Node& from, TreeNode& node) {
  if (!from.matrix.empty()) {
    node.local = glm::make_mat4(from.matrix.data());
    for (int column = 0; column < 4; ++column) node.local[column][3] = column == 3 ? 1.0 : 0.0;
    node.rest.matrix = glm::mat4(node.local);
    return;
  }
  const glm::dvec3 t = from.translation.empty() ? glm::dvec3(0.0) : glm::make_vec3(from.translation.data());
  const glm::dvec4 r = from.rotation.empty() ? glm::dvec4(0.0, 0.0, 0.0, 1.0) : glm::make_vec4(from.rotation.data());
  const glm::dvec3 s = from.scale.empty() ? glm::dvec3(1.0) : glm::make_vec3(from.scale.data());
  glm::dquat rotation(r[3], r[0], r[1], r[2]);
  const double length = glm::length(rotation);
  rotation = length > 0.0 && std::isfinite(length) ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
  node.rest.translation = glm::vec3(t);
  node.rest.rotation = glm::quat(rotation);
  node.rest.scale = glm::vec3(s);
  node.local = glm::translate(glm::dmat4(1.0), t) * glm::mat4_cast(rotation);
  node.local = glm::scale(node.local, s);
}

void linkChildren(const std::vector<tinygltf::Node>& list, NodeTree& tree, std::vector<std::vector<int>>& children) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t k = 0; k < list[i].children.size(); ++k) {
      const int child = list[i].children[k];
      const auto place = [&] { return placeOf(placeOf("nodes", i) + ".children", k); };
      TreeNode& node = at(tree.nodes, child);
      if (toIndex(child) == i) refuse(place(), "a node is its own child");
      if (node.parent >= 0) {
        refuse(place(), "node " + std::to_string(child) + " already has a parent, node " + std::to_string(node.parent));
      }
      node.parent = static_cast<int>(i);
      children[i].push_back(child);
    }
  }
}

/// Breadth first from the roots; unreached nodes lie on a cycle.
void orderNodes(const std::vector<std::vector<int>>& children, NodeTree& tree) {
  tree.order.reserve(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].parent < 0) tree.order.push_back(static_cast<int>(i));
  }
  for (std::size_t next = 0; next < tree.order.size(); ++next) {
    const std::vector<int>& kids = children[toIndex(tree.order[next])];
    tree.order.insert(tree.order.end(), kids.begin(), kids.end());
  }
  if (tree.order.size() != tree.nodes.size()) refuse("nodes", "some nodes are their own ancestors");
}

void markScene(const File& file, NodeTree& tree, Notes& notes) {
  const std::vector<tinygltf::Scene>& scenes = file.model().scenes;
  if (scenes.empty()) {
    for (TreeNode& node : tree.nodes) node.inScene = true;
    return;
  }
  file.expectSound("scene");
  const std::size_t used = toIndex(std::max(file.model().defaultScene, 0));
  if (scenes.size() > 1) {
    notes.add("scenes (" + std::to_string(scenes.size() - 1) + ") besides the default one, scene " +
              std::to_string(used) + ", are ignored: they are not shown");
  }
  file.expectSound(placeOf("scenes", used));
  for (const int node : scenes[used].nodes) at(tree.nodes, node).inScene = true;
  for (const int node : tree.order) {
    TreeNode& child = at(tree.nodes, node);
    if (child.parent >= 0 && tree[child.parent].inScene) child.inScene = true;
  }
}

void placeInWorld(NodeTree& tree) {
  for (const int index : tree.order) {
    TreeNode& node = at(tree.nodes, index);
    node.restInWorld = node.parent < 0 ? node.local : tree[node.parent].restInWorld * node.local;
    if (!isTame(node.restInWorld)) refuse("nodes[" + std::to_string(index) + "]", "lies too far away in the scene");
  }
}

}  // namespace

NodeTree readNodes(const File& file, Notes& notes) {
  const std::vector<tinygltf::Node>& list = file.model().nodes;
  NodeTree tree;
  tree.nodes.resize(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    file.expectSound(placeOf("nodes", i));
    TreeNode& node = tree.nodes[i];
    node.name = list[i].name;
    node.mesh = list[i].mesh;
    node.skin = list[i].skin;
    readTransform(list[i], node);
    if (!isTame(node.local)) refuse(placeOf("nodes", i), "the node's transform is too large");
  }
  std::vector<std::vector<int>> children(tree.nodes.size());
  linkChildren(list, tree, children);
  orderNodes(children, tree);
  markScene(file, tree, notes);
  placeInWorld(tree);
  return tree;
}

std::optional<glm::dmat4> affineInverse(const glm::dmat4& matrix) {
  const glm::dmat3 linear(matrix);
  double size = 1.0;
  for (int column = 0; column < 3; ++column) size *= glm::length(linear[column]);
  const double determinant = glm::determinant(linear);
  constexpr double kFlat = 1e-9;  // volume of the axes relative to a box of their lengths
  if (!(std::abs(determinant) > kFlat * size)) return std::nullopt;
  const glm::dmat3 inverse = glm::inverse(linear);
  glm::dmat4 result(inverse);
  result[3] = glm::dvec4(-(inverse * glm::dvec3(matrix[3])), 1.0);
  return isTame(result) ? std::optional(result) : std::nullopt;
}

bool isTame(const glm::dmat4& matrix) {
  constexpr double kMaxEntry = 1e15;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(matrix[column][row]) <= kMaxEntry)) return false;
    }
  }
  return true;
}

}  // namespace sinew::gltf
