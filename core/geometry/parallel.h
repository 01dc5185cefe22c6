// core/geometry/parallel.h: parallel loops of independent iterations.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>

#include "sinew/geometry/threads.h"

namespace sinew {

/// Uninitialized items: reading one before it is written is an error. A copy is empty.
template <class Item>
requires std::is_trivially_default_constructible_v<Item>
class ScratchArray {
 public:
  ScratchArray() = default;
  ScratchArray(const ScratchArray&) {}
  ScratchArray(ScratchArray&&) noexcept = default;
  ScratchArray& operator=(const ScratchArray& other) {
    if (this != &other) *this = ScratchArray();
    return *this;
  }
  ScratchArray& operator=(ScratchArray&&) noexcept = default;
  ~ScratchArray() = default;

  /// Loses the items if the size changes.
  void resize(std::size_t size) {
    if (size == size_) return;
    items_ = std::make_unique_for_overwrite<Item[]>(size);
    size_ = size;
  }
  [[nodiscard]] Item* data() { return items_.get(); }

 private:
  std::unique_ptr<Item[]> items_;
  std::size_t size_ = 0;
};

namespace parallel {

using Call = void (*)(void* use, std::size_t begin, std::size_t end);

void run(std::size_t count, std::size_t least, void* use, Call call);

[[nodiscard]] int ownThreads();  ///< Cores that this process may use; 1 where Sinew was built without oneTBB.
/// run() on that many of Sinew's own threads. @param limit  this thread's limit, which holds inside too
void runOnOwnThreads(std::size_t count, std::size_t least, int threads, int limit, void* use, Call call);

}  // namespace parallel

/// Calls use(begin, end) for ranges that make up 0..count, on up to threadCount() threads; only ranges longer than
/// `least` are divided. Results of a range must not depend on the others, so that they do not depend on the number of
/// threads. Rethrows exceptions.
template <class Use>
void forRanges(std::size_t count, std::size_t least, Use&& use) {
  parallel::run(count, least, &use, [](void* object, std::size_t begin, std::size_t end) {
    (*static_cast<std::remove_reference_t<Use>*>(object))(begin, end);
  });
}

/// Calls use(i) for i = 0..count-1, as above.
template <class Use>
void forEachIndex(std::size_t count, std::size_t least, Use&& use) {
  forRanges(count, least, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) use(i);
  });
}

/// Selects items of 0..count-1 in parallel blocks, compacts them in order, returns their number. Allocates nothing.
/// @param least  smallest block; blocks begin at multiples of 64.  @param out  room for `count`.
/// @param list  (begin, end, out): writes the items selected from begin..end-1 and returns how many; may write anything
///              up to out[end - begin - 1].
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
