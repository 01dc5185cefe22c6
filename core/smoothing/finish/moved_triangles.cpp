// core/smoothing/finish/moved_triangles.cpp: from moved vertices to the triangles around them, on all cores.
#include "core/smoothing/finish/moved_triangles.h"

#include <array>
#include <atomic>

#include "core/base/at.h"
#include "core/base/parallel_list.h"

namespace sinew {
namespace {

constexpr std::size_t kFewMoved = 4096;  ///< Vertices or triangles for one thread.

/// What is flagged, ascending. Without a branch: flags change too often to be foreseen.
void list(std::span<const std::uint8_t> flags, std::vector<int>& out) {
  out.resize(flags.size());
  out.resize(listInBlocks(flags.size(), kFewMoved, out.data(), [&](std::size_t begin, std::size_t end, int* listed) {
    std::size_t count = 0;
    for (std::size_t v = begin; v < end; ++v) {
      listed[count] = static_cast<int>(v);
      count += flags[v];
    }
    return count;
  }));
}

// Spans of their own: bytes may lie anywhere, so that a flag that is written has members of vectors read again.
using Triangles = std::span<const std::array<int, 3>>;
using Flags = std::span<std::uint8_t>;

/// Whether one of a triangle's corners is flagged.
bool isAny(Flags flags, const std::array<int, 3>& t) {
  return (at(flags, t[0]) | at(flags, t[1]) | at(flags, t[2])) != 0;
}

/// Several threads may flag the same corner.
void flag(const std::array<int, 3>& t, Flags flags) {
  for (const int corner : t) std::atomic_ref(at(flags, corner)).store(1, std::memory_order_relaxed);
}

void findMoved(std::span<const glm::vec3> patch, std::span<const glm::vec3> positions, Flags isMoved) {
  forEachIndex(positions.size(), kFewMoved, [&](std::size_t v) {
    const glm::vec3& p = patch[v];
    const glm::vec3& q = positions[v];
    isMoved[v] = static_cast<std::uint8_t>((p.x != q.x) | (p.y != q.y) | (p.z != q.z));
  });
}

/// Control triangles with a moved vertex, and the vertices of their pieces that have one.
void findNear(Triangles triangles, std::span<const int> begin, Flags isMoved, Flags isControl, Flags isNear) {
  forEachIndex(isControl.size(), kFewMoved, [&](std::size_t t) {
    std::uint8_t any = 0;
    for (int i = begin[t]; i < begin[t + 1]; ++i) {
      if (!isAny(isMoved, at(triangles, i))) continue;
      any = 1;
      flag(at(triangles, i), isNear);
    }
    isControl[t] = any;
  });
}

/// Triangles at those vertices, and their corners. @return  how many
std::size_t findRefined(Triangles triangles, Flags isNear, Flags isCorner, std::span<int> refined) {
  return listInBlocks(triangles.size(), kFewMoved, refined.data(),
                      [&](std::size_t begin, std::size_t end, int* listed) {
                        std::size_t count = 0;
                        for (std::size_t i = begin; i < end; ++i) {
                          if (!isAny(isNear, triangles[i])) continue;
                          listed[count++] = static_cast<int>(i);
                          flag(triangles[i], isCorner);
                        }
                        return count;
                      });
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
