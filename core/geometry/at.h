// core/geometry/at.h: indexing of containers by int, the type of indices in meshes and skeletons.
#pragma once

#include <concepts>
#include <cstddef>
#include <ranges>
#include <type_traits>

namespace sinew {

/// @param index  not negative
[[nodiscard]] constexpr std::size_t toIndex(std::same_as<int> auto index) { return static_cast<std::size_t>(index); }

/// items[index]. Only for int, so that no other number is narrowed.
template <class Items>
requires(std::is_lvalue_reference_v<Items> || std::ranges::borrowed_range<Items>) [[nodiscard]] constexpr decltype(auto)
    at(Items&& items, std::same_as<int> auto index) {
  return items[toIndex(index)];
}

}  // namespace sinew
