// core/smoothing/patches/level_grading.cpp: a work list of triangles, until none asks for more.
#include "core/smoothing/patches/level_grading.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "core/base/at.h"

namespace sinew {
namespace {

constexpr float kMostRatio = 3.0f;

/// The least level of the list that makes pieces of at most that length.
int levelFor(float length, float most) {
  const auto fits = [&](int level) { return length <= most * static_cast<float>(level); };
  const auto found = std::ranges::find_if(kGradedLevels, fits);
  return found == kGradedLevels.end() ? kGradedLevels.back() : *found;
}

class Grader {
 public:
  Grader(const ControlMesh& mesh, RefinementLevels& levels)
      : mesh_(mesh),
        levels_(levels),
        trianglesBegin_(mesh.edges.size() + 1, 0),
        trianglesAt_(3 * mesh.triangles.size()),
        waits_(mesh.triangles.size(), true) {
    for (const Edge& edge : mesh.edges) {
      lengths_.push_back(glm::distance(at(mesh.positions, edge.vertices[0]), at(mesh.positions, edge.vertices[1])));
    }
    for (const ControlTriangle& triangle : mesh.triangles) {
      for (const int edge : triangle.edges) ++at(trianglesBegin_, edge + 1);
    }
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) trianglesBegin_[e + 1] += trianglesBegin_[e];
    std::vector<int> next = trianglesBegin_;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const int edge : mesh.triangles[t].edges) at(trianglesAt_, at(next, edge)++) = static_cast<int>(t);
      waiting_.push_back(static_cast<int>(t));
    }
  }

  void run() {
    while (!waiting_.empty()) {
      const int t = waiting_.back();
      waiting_.pop_back();
      at(waits_, t) = false;
      grade(t);
    }
  }

 private:
  /// The shortest piece of a triangle's sides and inside, and the level that makes it.
  struct Finest {
    float piece = 0.0f;
    int level = 1;
  };

  void grade(int t) {
    const ControlTriangle& triangle = at(mesh_.triangles, t);
    float longest = 0.0f;
    for (const int edge : triangle.edges) longest = std::max(longest, at(lengths_, edge));
    std::uint8_t& inside = at(levels_.triangles, t);
    Finest finest{longest / static_cast<float>(inside), inside};
    for (const int edge : triangle.edges) {
      const int level = at(levels_.edges, edge);
      const Finest own{at(lengths_, edge) / static_cast<float>(level), level};
      if (level > 1 && own.piece < finest.piece) finest = own;
    }
    const auto needed = [&](float length) {
      return std::min(levelFor(length, kMostRatio * finest.piece), finest.level);
    };
    inside = static_cast<std::uint8_t>(std::max<int>(inside, needed(longest)));
    for (const int edge : triangle.edges) {
      const int level = needed(at(lengths_, edge));
      if (level <= at(levels_.edges, edge)) continue;
      at(levels_.edges, edge) = static_cast<std::uint8_t>(level);
      for (int i = at(trianglesBegin_, edge); i < at(trianglesBegin_, edge + 1); ++i) {
        const int other = at(trianglesAt_, i);
        if (!at(waits_, other)) waiting_.push_back(other);
        at(waits_, other) = true;
      }
    }
  }

  const ControlMesh& mesh_;
  RefinementLevels& levels_;
  std::vector<float> lengths_;       ///< [E]
  std::vector<int> trianglesBegin_;  ///< [E + 1] into trianglesAt_.
  std::vector<int> trianglesAt_;     ///< Edge by edge.
  std::vector<bool> waits_;          ///< [T]
  std::vector<int> waiting_;
};

}  // namespace

RefinementLevels gradedLevels(const ControlMesh& mesh, RefinementLevels levels) {
  Grader(mesh, levels).run();
  return levels;
}

}  // namespace sinew
