// core/geometry/at.h: tables are indexed by int here, as the numbers in meshes and skeletons are.
#pragma once

#include <concepts>
#include <cstddef>
#include <ranges>
#include <type_traits>

namespace sinew {

/// An index as containers want it. Not negative.
[[nodiscard]] constexpr std::size_t toIndex(std::same_as<int> auto index) { return static_cast<std::size_t>(index); }

/// items[index], which is in range. An int alone, so that no other number is narrowed.
template <class Items>
requires(std::is_lvalue_reference_v<Items> || std::ranges::borrowed_range<Items>) [[nodiscard]] constexpr decltype(auto)
    at(Items&& items, std::same_as<int> auto index) {
  return items[toIndex(index)];
}

}  // namespace sinew
