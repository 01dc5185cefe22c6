// core/io/gltf/nodes.cpp: reading the node tree.

#include "core/io/gltf/nodes.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace sinew::gltf {
namespace {

constexpr std::size_t kMostNodes = 200'000;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// A matrix, or translation, rotation and scale; either way kept in float for posing and in double for binding.
void readTransform(const Field& field, TreeNode& node) {
  std::array<double, 16> m{};
  if (field.member("matrix").numbers(m)) {
    node.local = glm::make_mat4(m.data());
    for (int column = 0; column < 4; ++column) node.local[column][3] = column == 3 ? 1.0 : 0.0;
    node.rest.matrix = glm::mat4(node.local);
  } else {
    std::array<double, 3> t{0.0, 0.0, 0.0};
    std::array<double, 4> r{0.0, 0.0, 0.0, 1.0};
    std::array<double, 3> s{1.0, 1.0, 1.0};
    field.member("translation").numbers(t);
    field.member("rotation").numbers(r);
    field.member("scale").numbers(s);
    glm::dquat rotation(r[3], r[0], r[1], r[2]);
    const double length = glm::length(rotation);
    rotation = length > 0.0 && std::isfinite(length) ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
    node.rest.translation = glm::vec3(t[0], t[1], t[2]);
    node.rest.rotation = glm::quat(rotation);
    node.rest.scale = glm::vec3(s[0], s[1], s[2]);
    node.local = glm::translate(glm::dmat4(1.0), glm::dvec3(t[0], t[1], t[2])) * glm::mat4_cast(rotation);
    node.local = glm::scale(node.local, glm::dvec3(s[0], s[1], s[2]));
  }
  if (!isTame(node.local)) refuse(field.place(), "the node's transform is too large");
}

void linkChildren(const Field& list, NodeTree& tree, std::vector<std::vector<int>>& children) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Field kids = list.item(i).member("children");
    for (std::size_t k = 0; k < kids.size(); ++k) {
      const int child = kids.item(k).requiredIndex(tree.nodes.size(), "node");
      TreeNode& node = tree.nodes[at(child)];
      if (at(child) == i) refuse(kids.item(k).place(), "a node is its own child");
      if (node.parent >= 0) {
        refuse(kids.item(k).place(),
               "node " + std::to_string(child) + " already has a parent, node " + std::to_string(node.parent));
      }
      node.parent = static_cast<int>(i);
      children[i].push_back(child);
    }
  }
}

/// Breadth first from the roots; what it does not reach lies on a cycle.
void orderNodes(const std::vector<std::vector<int>>& children, NodeTree& tree) {
  tree.order.reserve(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].parent < 0) tree.order.push_back(static_cast<int>(i));
  }
  for (std::size_t next = 0; next < tree.order.size(); ++next) {
    const std::vector<int>& kids = children[at(tree.order[next])];
    tree.order.insert(tree.order.end(), kids.begin(), kids.end());
  }
  if (tree.order.size() != tree.nodes.size()) refuse("nodes", "some nodes are their own ancestors");
}

void markScene(const Field& root, NodeTree& tree, Notes& notes) {
  const Field scenes = root.member("scenes");
  if (scenes.size() == 0) {
    for (TreeNode& node : tree.nodes) node.inScene = true;
    return;
  }
  const int used = root.member("scene").index(scenes.size(), "scene").value_or(0);
  if (scenes.size() > 1) {
    notes.add("scenes: " + std::to_string(scenes.size() - 1) + " besides the default one, scene " +
              std::to_string(used));
  }
  const Field roots = scenes.item(at(used)).member("nodes");
  for (std::size_t i = 0; i < roots.size(); ++i) {
    tree.nodes[at(roots.item(i).requiredIndex(tree.nodes.size(), "node"))].inScene = true;
  }
  for (const int node : tree.order) {
    TreeNode& child = tree.nodes[at(node)];
    if (child.parent >= 0 && tree[child.parent].inScene) child.inScene = true;
  }
}

void placeInWorld(NodeTree& tree) {
  for (const int index : tree.order) {
    TreeNode& node = tree.nodes[at(index)];
    node.restInWorld = node.parent < 0 ? node.local : tree[node.parent].restInWorld * node.local;
    if (!isTame(node.restInWorld)) refuse("nodes[" + std::to_string(index) + "]", "lies too far away in the scene");
  }
}

}  // namespace

NodeTree readNodes(const Field& root, Notes& notes) {
  const Field list = root.member("nodes");
  if (list.size() > kMostNodes) refuse(list.place(), "more than 200,000 nodes");
  const std::size_t meshes = root.member("meshes").size();
  const std::size_t skins = root.member("skins").size();
  NodeTree tree;
  tree.nodes.resize(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Field field = list.item(i);
    TreeNode& node = tree.nodes[i];
    node.name = std::string(field.member("name").text(""));
    node.mesh = field.member("mesh").index(meshes, "mesh");
    node.skin = field.member("skin").index(skins, "skin");
    readTransform(field, node);
  }
  std::vector<std::vector<int>> children(tree.nodes.size());
  linkChildren(list, tree, children);
  orderNodes(children, tree);
  markScene(root, tree, notes);
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
  constexpr double kLargest = 1e15;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(matrix[column][row]) <= kLargest)) return false;
    }
  }
  return true;
}

}  // namespace sinew::gltf
