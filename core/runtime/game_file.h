// core/runtime/game_file.h: the head of a game file. docs/games.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace sinew::gamefile {

inline constexpr std::array<char, 8> kMagic{'S', 'i', 'n', 'e', 'w', 'G', 'm', '\n'};
inline constexpr std::uint32_t kVersion = 4;

/// Little endian; `bytes` bytes follow.
struct Head {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t reserved = 0;
  std::uint64_t bytes = 0;
  std::uint64_t sum = 0;  ///< sumOf() these bytes.
};
static_assert(sizeof(Head) == 32);

/// 64-bit FNV-1a: detects damage, not forgery.
[[nodiscard]] inline std::uint64_t sumOf(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const std::byte byte : bytes) sum = (sum ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3U;
  return sum;
}

}  // namespace sinew::gamefile
