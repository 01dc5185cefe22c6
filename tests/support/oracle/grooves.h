// tests/support/oracle/grooves.h: the maximum over means of cliques, which makes soft grooves between unlinked groups.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace sinew::oracle {

inline constexpr std::size_t kMostGroups = 16;

/// Bit j: it holds group j.
using Clique = std::uint32_t;
using PerGroup = std::array<double, kMostGroups>;

inline bool holds(Clique clique, std::size_t group) { return (clique >> group & 1u) != 0; }
double sumOver(Clique clique, const PerGroup& of);

struct Blended {
  double value = 0.0;
  PerGroup shares{};  ///< m_j; 0 for groups without potential.
};

/// The maximum of sum x_j m_j + y_j m_j (1 - m_j) / 2 over shares of the cliques that are >= 0 and sum to 1, where m_j
/// sums the shares of those that hold group j.
/// @param y  at most 2 x each, as kappa is at most 2.
Blended blended(std::span<const Clique> cliques, const PerGroup& x, const PerGroup& y);

}  // namespace sinew::oracle
