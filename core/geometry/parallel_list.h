// core/geometry/parallel_list.h: lists that several threads write, in the order of one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/geometry/parallel.h"

namespace sinew {

/// Has 0..count-1 listed in blocks, on all cores, and closes up what the blocks have left. Allocates nothing.
/// @param least  for one thread; blocks begin at multiples of 64.
/// @param out  room for `count`.
/// @param list  (begin, end, out): writes what it lists of begin..end-1, at most end - begin, and returns how many;
///              it may also write anything up to out[end - begin - 1].
/// @return  how many are listed
template <class T, class List>
std::size_t listInBlocks(std::size_t count, std::size_t least, T* out, const List& list) {
  constexpr std::size_t kMostBlocks = 64;
  constexpr std::size_t kMultiple = 64;
  const std::size_t even = std::max({least, kMultiple, (count + kMostBlocks - 1) / kMostBlocks});
  const std::size_t size = (even + kMultiple - 1) / kMultiple * kMultiple;
  const std::size_t blocks = (count + size - 1) / size;
  std::array<std::size_t, kMostBlocks> listed{};
  forEachIndex(blocks, 1, [&](std::size_t block) {
    const std::size_t begin = block * size;
    listed[block] = list(begin, std::min(begin + size, count), out + begin);
  });
  std::size_t total = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    const T* from = out + block * size;
    if (from != out + total) std::copy(from, from + listed[block], out + total);
    total += listed[block];
  }
  return total;
}

}  // namespace sinew
