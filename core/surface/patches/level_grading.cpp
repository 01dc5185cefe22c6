// core/surface/patches/level_grading.cpp: a work list of triangles, until none asks for more.
#include "core/surface/patches/level_grading.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kMostRatio = 3.0f;

/// The least level of the list that makes pieces of at most that length.
int levelFor(float length, float most) {
  const auto fits = [&](int level) { return length <= most * static_cast<float>(level); };
  const auto found = std::ranges::find_if(kGradedLevels, fits);
  return found == kGradedLevels.end() ? kGradedLevels.back() : *found;
}

/// The shortest piece of a triangle's sides and inside, and the level that makes it.
struct Finest {
  float piece = 0.0f;
  int level = 1;
};

/// A work list of triangles.
class Waiting {
 public:
  explicit Waiting(std::size_t triangles) : waits_(triangles, true), list_(triangles) {
    std::iota(list_.begin(), list_.end(), 0);
  }

  [[nodiscard]] bool empty() const { return list_.empty(); }

  [[nodiscard]] int take() {
    const int t = list_.back();
    list_.pop_back();
    at(waits_, t) = false;
    return t;
  }

  void add(int t) {
    if (!at(waits_, t)) list_.push_back(t);
    at(waits_, t) = true;
  }

 private:
  std::vector<bool> waits_;  ///< [T]
  std::vector<int> list_;
};

}  // namespace

LevelGrader::LevelGrader(const ControlMesh& mesh)
    : mesh_(mesh), trianglesBegin_(mesh.edges.size() + 1, 0), trianglesAt_(3 * mesh.triangles.size()) {
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
  }
}

RefinementLevels LevelGrader::graded(RefinementLevels levels) const {
  Waiting waiting(mesh_.triangles.size());
  while (!waiting.empty()) {
    const int t = waiting.take();
    const std::array<int, 3>& edges = at(mesh_.triangles, t).edges;
    std::uint8_t& inside = at(levels.triangles, t);
    const auto isWhole = [&](int edge) { return at(levels.edges, edge) == 1; };
    if (inside == 1 && std::ranges::all_of(edges, isWhole)) continue;  // Most of a fine mesh.
    float longest = 0.0f;
    for (const int edge : edges) longest = std::max(longest, at(lengths_, edge));
    Finest finest{longest / static_cast<float>(inside), inside};
    for (const int edge : edges) {
      const int level = at(levels.edges, edge);
      const Finest own{at(lengths_, edge) / static_cast<float>(level), level};
      if (level > 1 && own.piece < finest.piece) finest = own;
    }
    const auto needed = [&](float length) {
      return std::min(levelFor(length, kMostRatio * finest.piece), finest.level);
    };
    inside = static_cast<std::uint8_t>(std::max<int>(inside, needed(longest)));
    for (const int edge : edges) {
      const int level = needed(at(lengths_, edge));
      if (level <= at(levels.edges, edge)) continue;
      at(levels.edges, edge) = static_cast<std::uint8_t>(level);
      for (int i = at(trianglesBegin_, edge); i < at(trianglesBegin_, edge + 1); ++i) waiting.add(at(trianglesAt_, i));
    }
  }
  return levels;
}

}  // namespace sinew
