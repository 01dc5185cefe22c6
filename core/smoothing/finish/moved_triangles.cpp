// core/smoothing/finish/moved_triangles.cpp: from moved vertices to the triangles around them.
#include "core/smoothing/finish/moved_triangles.h"

#include <array>

#include "core/base/at.h"

namespace sinew {
namespace {

/// What is flagged, ascending. Without a branch: flags change too often to be foreseen.
void list(const std::vector<std::uint8_t>& flags, std::vector<int>& out) {
  out.resize(flags.size());
  std::size_t count = 0;
  for (std::size_t v = 0; v < flags.size(); ++v) {
    out[count] = static_cast<int>(v);
    count += flags[v];
  }
  out.resize(count);
}

// Spans of their own: bytes may lie anywhere, so that a flag that is written has members of vectors read again.
using Triangles = std::span<const std::array<int, 3>>;
using Flags = std::span<std::uint8_t>;

/// Whether one of a triangle's corners is flagged.
bool isAny(Flags flags, const std::array<int, 3>& t) {
  return (at(flags, t[0]) | at(flags, t[1]) | at(flags, t[2])) != 0;
}

void flag(const std::array<int, 3>& t, Flags flags) {
  for (const int corner : t) at(flags, corner) = 1;
}

void findMoved(std::span<const glm::vec3> patch, std::span<const glm::vec3> positions, Flags isMoved) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const glm::vec3& p = patch[v];
    const glm::vec3& q = positions[v];
    isMoved[v] = static_cast<std::uint8_t>((p.x != q.x) | (p.y != q.y) | (p.z != q.z));
  }
}

/// Control triangles with a moved vertex, and the vertices of their pieces that have one.
void findNear(Triangles triangles, std::span<const int> begin, Flags isMoved, Flags isControl, Flags isNear) {
  for (std::size_t t = 0; t < isControl.size(); ++t) {
    std::uint8_t any = 0;
    for (int i = begin[t]; i < begin[t + 1]; ++i) {
      if (!isAny(isMoved, at(triangles, i))) continue;
      any = 1;
      flag(at(triangles, i), isNear);
    }
    isControl[t] = any;
  }
}

/// Triangles at those vertices, and their corners. @return  how many
std::size_t findRefined(Triangles triangles, Flags isNear, Flags isCorner, std::span<int> refined) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!isAny(isNear, triangles[i])) continue;
    refined[count++] = static_cast<int>(i);
    flag(triangles[i], isCorner);
  }
  return count;
}

}  // namespace

void MovedTriangles::find(const Refinement& refinement, std::span<const glm::vec3> patch,
                          std::span<const glm::vec3> positions) {
  isMoved_.resize(positions.size());
  findMoved(patch, positions, isMoved_);
  isNear = isMoved_;
  isControl.resize(refinement.triangleBegin.size() - 1);
  findNear(refinement.triangles, refinement.triangleBegin, isMoved_, isControl, isNear);
  list(isNear, near);
  isCorner_ = isNear;
  refined.resize(refinement.triangles.size());
  refined.resize(findRefined(refinement.triangles, isNear, isCorner_, refined));
  list(isCorner_, corners);
}

}  // namespace sinew
