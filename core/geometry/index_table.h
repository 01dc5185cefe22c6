// core/geometry/index_table.h: a hash table of indices whose keys are stored elsewhere, and hashes for it.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace sinew {

inline constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15ULL;

/// One step of SplitMix64 from this state (Steele, Lea and Flood 2014); the same on every machine.
[[nodiscard]] constexpr std::uint64_t splitMix64(std::uint64_t state) {
  std::uint64_t x = state + kSplitMixStep;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// 12345 -> "12,345".
[[nodiscard]] inline std::string grouped(long long number) {
  const std::string digits = std::to_string(number < 0 ? -number : number);
  std::string out = number < 0 ? "-" : "";
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

/// Spreads the bits of `value` over the whole word and folds them into `seed`.
[[nodiscard]] inline std::uint64_t hashCombine(std::uint64_t seed, std::uint64_t value) {
  return splitMix64(seed + value);
}

/// Bits of a float, the same for 0 and -0.
[[nodiscard]] inline std::uint64_t floatBits(float value) {
  const float positive = value + 0.0f;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &positive, sizeof bits);
  return bits;
}

/// Open addressing, linear probing, at most half full. Independent of addresses: the same result everywhere.
class IndexTable {
 public:
  /// @param most  largest number of entries (asserted)
  explicit IndexTable(std::size_t most) {
    std::size_t slots = 16;
    while (slots < 2 * most) slots *= 2;
    slots_.assign(slots, kEmpty);
  }

  /// The entry with this hash for which equals(entry), or -1.
  template <class Equals>
  [[nodiscard]] int find(std::uint64_t hash, Equals&& equals) const {
    for (std::size_t slot = hash & mask(); slots_[slot] != kEmpty; slot = (slot + 1) & mask()) {
      if (equals(slots_[slot])) return slots_[slot];
    }
    return kEmpty;
  }

  /// The equal entry if there is one, else inserts and returns `entry`.
  template <class Equals>
  int findOrInsert(std::uint64_t hash, int entry, Equals&& equals) {
    std::size_t slot = hash & mask();
    for (; slots_[slot] != kEmpty; slot = (slot + 1) & mask()) {
      if (equals(slots_[slot])) return slots_[slot];
    }
    slots_[slot] = entry;
    ++used_;
    assert(2 * used_ <= slots_.size());
    return entry;
  }

 private:
  static constexpr int kEmpty = -1;
  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }

  std::vector<int> slots_;
  std::size_t used_ = 0;
};

}  // namespace sinew
