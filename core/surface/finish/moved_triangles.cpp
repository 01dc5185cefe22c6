// core/surface/finish/moved_triangles.cpp: from moved vertices to the triangles around them, on all cores.
#include "core/surface/finish/moved_triangles.h"

#include <atomic>

namespace sinew {
namespace {

constexpr std::size_t kFewMoved = 4096;  ///< Vertices or triangles for one thread.

/// Lists what is flagged, ascending. Has no branch because flags change too often to be predicted.
void listFlagged(std::span<const std::uint8_t> flags, std::vector<int>& out) {
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

using Triangles = std::span<const std::array<int, 3>>;
using Flags = std::span<std::uint8_t>;

bool isAny(Flags flags, const std::array<int, 3>& t) {
  return (at(flags, t[0]) | at(flags, t[1]) | at(flags, t[2])) != 0;
}

/// Several threads may flag the same corner.
void flag(const std::array<int, 3>& t, Flags flags) {
  for (const int corner : t) std::atomic_ref(at(flags, corner)).store(1, std::memory_order_relaxed);
}

// Parts for several threads. They take spans by value: bytes may alias anything, so that after each write of a flag the
// compiler would read again all that a lambda refers to.

void findMoved(std::span<const glm::vec3> patch, std::span<const glm::vec3> positions, Flags isMoved, std::size_t begin,
               std::size_t end) {
  for (std::size_t v = begin; v < end; ++v) {
    const glm::vec3& p = patch[v];
    const glm::vec3& q = positions[v];
    isMoved[v] = static_cast<std::uint8_t>((p.x != q.x) | (p.y != q.y) | (p.z != q.z));
  }
}

/// Refined triangles and the first of each control triangle.
struct Pieces {
  Triangles triangles;
  std::span<const int> begin;
};

/// Flags control triangles with a moved vertex, and the corners of their refined triangles that have one.
void findNear(Pieces pieces, Flags isMoved, Flags isControl, Flags isNear, std::size_t begin, std::size_t end) {
  for (std::size_t t = begin; t < end; ++t) {
    std::uint8_t any = 0;
    for (int i = pieces.begin[t]; i < pieces.begin[t + 1]; ++i) {
      if (!isAny(isMoved, at(pieces.triangles, i))) continue;
      any = 1;
      flag(at(pieces.triangles, i), isNear);
    }
    isControl[t] = any;
  }
}

/// Lists triangles with a near vertex and flags their corners. @return  number of triangles
std::size_t findRefined(Triangles triangles, Flags isNear, Flags isCorner, int* refined, std::size_t begin,
                        std::size_t end) {
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) {
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
  forRanges(positions.size(), kFewMoved,
            [&](std::size_t begin, std::size_t end) { findMoved(patch, positions, isMoved_, begin, end); });
  isNear = isMoved_;
  isControl.resize(refinement.triangleBegin.size() - 1);
  const Pieces pieces{refinement.triangles, refinement.triangleBegin};
  forRanges(isControl.size(), kFewMoved,
            [&](std::size_t begin, std::size_t end) { findNear(pieces, isMoved_, isControl, isNear, begin, end); });
  listFlagged(isNear, near);
  isCorner_ = isNear;
  refined.resize(refinement.triangles.size());
  const auto list = [&](std::size_t begin, std::size_t end, int* listed) {
    return findRefined(refinement.triangles, isNear, isCorner_, listed, begin, end);
  };
  refined.resize(listInBlocks(refined.size(), kFewMoved, refined.data(), list));
  listFlagged(isCorner_, corners);
}

}  // namespace sinew
