// core/geometry/split_mix.h: well spread bits from any number, the same on every machine.
#pragma once

#include <cstdint>

namespace sinew {

inline constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15ULL;

/// One step of SplitMix64 from this state (Steele, Lea and Flood 2014).
[[nodiscard]] constexpr std::uint64_t splitMix64(std::uint64_t state) {
  std::uint64_t x = state + kSplitMixStep;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace sinew
