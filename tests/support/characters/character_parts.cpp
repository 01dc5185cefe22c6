// tests/support/characters/character_parts.cpp: triangle soups, bones, swings and bodies of cells.

#include "tests/support/characters/character_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sinew::test {

int addVertex(TriangleSoup& soup, const glm::vec3& position, const glm::vec2& uv, const Weights& weights) {
  if (soup.influenceBegin.empty()) soup.influenceBegin.push_back(0);
  soup.positions.push_back(position);
  soup.uvs.push_back(uv);
  for (const auto& [binding, weight] : weights) soup.influences.push_back({binding, weight});
  soup.influenceBegin.push_back(static_cast<int>(soup.influences.size()));
  return static_cast<int>(soup.positions.size()) - 1;
}

void addTriangle(TriangleSoup& soup, int a, int b, int c) {
  soup.triangles.push_back(
      {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  soup.materials.push_back(0);
}

void addQuad(TriangleSoup& soup, int a, int b, int c, int d) {
  addTriangle(soup, a, b, c);
  addTriangle(soup, a, c, d);
}

void addBone(Skeleton& skeleton, const std::string& name, int parent, const glm::vec3& joint) {
  Bone bone;
  bone.name = name;
  bone.node = static_cast<int>(skeleton.bones.size());
  bone.parent = parent;
  bone.bindInWorld = glm::translate(glm::mat4(1.0f), joint);
  Node node;
  node.name = name;
  node.parent = parent;
  node.rest.translation = joint;
  if (parent >= 0) node.rest.translation -= glm::vec3(skeleton.bones[static_cast<std::size_t>(parent)].bindInWorld[3]);
  skeleton.nodes.push_back(node);
  skeleton.bones.push_back(bone);
  skeleton.bindings.push_back({bone.node, glm::translate(glm::mat4(1.0f), -joint)});
}

void swing(AnimationClip& clip, int node, const glm::vec3& axis, float from, float to) {
  Channel channel;
  channel.node = node;
  channel.path = ChannelPath::kRotation;
  for (int key = 0; key <= 4; ++key) {
    const float angle = key % 4 == 0 ? 0.0f : key == 1 ? from : key == 2 ? 0.5f * (from + to) : to;
    const glm::quat q = glm::angleAxis(angle, glm::normalize(axis));
    channel.times.push_back(0.5f * static_cast<float>(key));
    channel.values.push_back({q.x, q.y, q.z, q.w});
  }
  clip.duration = 2.0f;
  clip.channels.push_back(channel);
}

std::shared_ptr<const Character> finish(const std::string& name, const TriangleSoup& soup, Skeleton skeleton,
                                        AnimationClip clip) {
  auto character = std::make_shared<Character>();
  character->name = name;
  const Bounds bounds = boundsOf(soup.positions);
  const glm::vec3 extent = bounds.extent();
  character->height = extent.y > 0.0f ? extent.y : std::max(extent.x, extent.z);
  finishBones(skeleton);
  character->skeleton = std::move(skeleton);
  character->mesh = weld(soup, 1e-6f * character->height);
  character->clips.push_back(std::move(clip));
  character->materials.emplace_back();
  return character;
}

void boundaryQuads(const std::set<Cell>& cells, std::vector<Cell>& corners, std::vector<std::array<int, 4>>& quads) {
  std::map<Cell, int> ids;
  const auto idOf = [&](const Cell& corner) {
    const auto [at, isNew] = ids.emplace(corner, static_cast<int>(corners.size()));
    if (isNew) corners.push_back(corner);
    return at->second;
  };
  for (const Cell& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Cell neighbor = cell;
        neighbor[axis] += side;
        if (cells.count(neighbor) != 0) continue;
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        std::array<int, 4> quad{};
        for (std::size_t i = 0; i < 4; ++i) {
          Cell corner = cell;
          corner[axis] += side > 0 ? 1 : 0;
          corner[u] += i == 1 || i == 2 ? 1 : 0;
          corner[v] += i >= 2 ? 1 : 0;
          quad[side > 0 ? i : 3 - i] = idOf(corner);
        }
        quads.push_back(quad);
      }
    }
  }
}

std::vector<glm::vec3> rounded(const std::vector<Cell>& corners, const std::vector<std::array<int, 4>>& quads) {
  std::vector<glm::vec3> points;
  for (const Cell& c : corners) points.emplace_back(c[0], c[1], c[2]);
  for (int pass = 0; pass < 3; ++pass) {
    std::vector<glm::vec3> sum(points.size(), glm::vec3(0.0f));
    std::vector<float> count(points.size(), 0.0f);
    for (const auto& quad : quads) {
      for (std::size_t i = 0; i < 4; ++i) {
        sum[static_cast<std::size_t>(quad[i])] += points[static_cast<std::size_t>(quad[(i + 1) % 4])];
        count[static_cast<std::size_t>(quad[i])] += 1.0f;
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = 0.5f * points[i] + 0.5f * sum[i] / count[i];
  }
  return points;
}

}  // namespace sinew::test
