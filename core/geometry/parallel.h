// core/geometry/parallel.h: loops whose rounds do not need each other, on all cores.
#pragma once

#include <cstddef>
#include <type_traits>

#include "sinew/geometry/threads.h"

namespace sinew {
namespace parallel {

using Call = void (*)(void* use, std::size_t begin, std::size_t end);

void run(std::size_t count, std::size_t least, void* use, Call call);

}  // namespace parallel

/// Calls use(begin, end) for ranges that make up 0..count, on up to threadCount() threads; only ranges longer than
/// `least` are divided.
/// A range's results must not depend on how far the others are: then they do not depend on the number of threads. What
/// is thrown is thrown again here.
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

}  // namespace sinew
