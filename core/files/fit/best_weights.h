// core/files/fit/best_weights.h: the best weights of one vertex: at most four, >= 0, sum 1, least squares.
#pragma once

#include <array>
#include <cstddef>

namespace sinew::exporting {

inline constexpr std::size_t kMostCandidates = 16;

/// Symmetric; rows and columns are candidates.
using Gram = std::array<std::array<double, kMostCandidates>, kMostCandidates>;
using CandidateWeights = std::array<double, kMostCandidates>;

/// w^T G w: the sum of squared distances, where G holds the products of the candidates' ways to the target.
[[nodiscard]] double energyOf(const Gram& gram, const CandidateWeights& weights, std::size_t count);

/// The least w^T G w + mu |w - near|^2 with w >= 0, sum 1 and at most four of them not 0: exact, for every choice of up
/// to four is tried, and the best weights are those of the choice whose own best has none below 0.
/// @param gram  positive semidefinite  @param count  candidates in use, 1..kMostCandidates  @param mu  > 0
[[nodiscard]] CandidateWeights bestWeights(const Gram& gram, std::size_t count, double mu,
                                           const CandidateWeights& near);

}  // namespace sinew::exporting
