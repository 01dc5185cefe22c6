// tests/support/oracle/grooves.cpp: tries every set of cliques that could have shares, and solves its linear system.

#include "tests/support/oracle/grooves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace sinew::oracle {
namespace {

/// Of the largest sum: a gap that only rounding leaves.
constexpr double kRoundingGap = 1e-14;

using Cliques = std::vector<Clique>;
using Row = std::vector<double>;

Blended withShares(const PerGroup& shares, const PerGroup& x, const PerGroup& y) {
  Blended out;
  out.shares = shares;
  for (std::size_t j = 0; j < kMostGroups; ++j) {
    out.value += shares[j] * x[j] + 0.5 * shares[j] * (1.0 - shares[j]) * y[j];
  }
  return out;
}

/// Cliques by the groups that have potential, without those that another one contains: since y <= 2 x, a group that
/// joins never lowers the sum.
Cliques largestWithPotential(std::span<const Clique> cliques, const PerGroup& x) {
  Clique present = 0;
  for (std::size_t j = 0; j < kMostGroups; ++j) present |= x[j] > 0.0 ? 1u << j : 0u;
  Cliques out;
  for (const Clique whole : cliques) {
    const Clique clique = whole & present;
    const auto contains = [](Clique a, Clique b) { return (a & b) == b; };
    if (std::ranges::any_of(out, [&](Clique other) { return contains(other, clique); })) continue;
    std::erase_if(out, [&](Clique other) { return contains(clique, other); });
    out.push_back(clique);
  }
  return out;
}

/// A clique's slope lies between S - Y/2 and S + Y/2 whatever the shares; one whose slope is always below another's
/// has no share.
void leaveOutHopeless(Cliques& cliques, const PerGroup& x, const PerGroup& y) {
  double most = 0.0;
  for (const Clique clique : cliques) most = std::max(most, sumOver(clique, x) - 0.5 * sumOver(clique, y));
  std::erase_if(cliques, [&](Clique clique) { return sumOver(clique, x) + 0.5 * sumOver(clique, y) < most; });
}

/// Share of the first of two cliques: the top of a parabola.
double shareOfTwo(Clique first, Clique second, const PerGroup& x, const PerGroup& y) {
  const double ahead = sumOver(first & ~second, x) - sumOver(second & ~first, x);
  const double width = sumOver(first ^ second, y);
  if (2.0 * std::abs(ahead) >= width) return ahead > 0.0 ? 1.0 : ahead < 0.0 ? 0.0 : 0.5;
  return 0.5 + ahead / width;
}

/// Gaussian elimination with pivoting; the last column is the right side. None where there is no single answer.
std::optional<Row> solved(std::vector<Row> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
    }
    if (rows[pivot][k] == 0.0) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double times = rows[i][k] / rows[k][k];
      for (std::size_t c = k; c <= n; ++c) rows[i][c] -= times * rows[k][c];
    }
  }
  Row out(n, 0.0);
  for (std::size_t k = n; k-- > 0;) {
    out[k] = rows[k][n];
    for (std::size_t c = k + 1; c < n; ++c) out[k] -= rows[k][c] * out[c];
    out[k] /= rows[k][k];
  }
  return out;
}

/// The search for the shares of three and more cliques, over the groups that only some of them hold.
class Shares {
 public:
  Shares(const Cliques& cliques, Clique differing, const PerGroup& x, const PerGroup& y) : cliques_(cliques) {
    for (std::size_t j = 0; j < kMostGroups; ++j) {
      start_[j] = holds(differing, j) ? x[j] + 0.5 * y[j] : 0.0;
      bend_[j] = holds(differing, j) ? y[j] : 0.0;
    }
    // Sums of about 1, so that rounding is what it is of 1.
    double most = 0.0;
    for (const Clique clique : cliques_) most = std::max(most, sumOver(clique, start_));
    for (std::size_t j = 0; j < kMostGroups; ++j) {
      start_[j] /= most;
      bend_[j] /= most;
    }
    largest_ = std::min(cliques_.size(), static_cast<std::size_t>(std::popcount(differing)) + 1);
  }

  /// m of the groups. Some best shares have no more cliques than groups, plus one, and their system has one answer.
  [[nodiscard]] PerGroup best() {
    for (std::size_t size = 1; size <= largest_; ++size) {
      for (std::uint32_t set = 1; set < (1u << cliques_.size()); ++set) {
        if (static_cast<std::size_t>(std::popcount(set)) != size) continue;
        attempt(set);
        if (gap_ <= kRoundingGap) return shares_;
      }
    }
    return shares_;
  }

 private:
  /// Shares of these cliques alone, where all their slopes are the same.
  [[nodiscard]] std::optional<Row> levelled(const Cliques& chosen) const {
    const std::size_t n = chosen.size();
    std::vector<Row> rows(n + 1, Row(n + 2, 0.0));
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) rows[a][b] = sumOver(chosen[a] & chosen[b], bend_);
      rows[a][n] = rows[n][a] = 1.0;
      rows[a][n + 1] = sumOver(chosen[a], start_);
    }
    rows[n][n + 1] = 1.0;
    return solved(std::move(rows));
  }

  void attempt(std::uint32_t set) {
    Cliques chosen;
    for (std::size_t k = 0; k < cliques_.size(); ++k) {
      if ((set >> k & 1u) != 0) chosen.push_back(cliques_[k]);
    }
    const std::optional<Row> answer = levelled(chosen);
    if (!answer) return;
    double total = 0.0;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (!((*answer)[k] > -1e-9)) return;
      total += std::max((*answer)[k], 0.0);
    }
    PerGroup shares{};
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const double share = std::max((*answer)[k], 0.0) / total;
      for (std::size_t j = 0; j < kMostGroups; ++j) shares[j] += holds(chosen[k], j) ? share : 0.0;
    }
    const double gap = gapOf(shares);
    if (gap >= gap_) return;
    gap_ = gap;
    shares_ = shares;
  }

  /// How far the best clique's slope exceeds the mean slope: the function is concave, so it can rise by no more.
  [[nodiscard]] double gapOf(const PerGroup& shares) const {
    PerGroup slopes{};
    double mean = 0.0;
    for (std::size_t j = 0; j < kMostGroups; ++j) {
      slopes[j] = start_[j] - shares[j] * bend_[j];
      mean += shares[j] * slopes[j];
    }
    double most = 0.0;
    for (const Clique clique : cliques_) most = std::max(most, sumOver(clique, slopes));
    return most - mean;
  }

  const Cliques& cliques_;
  PerGroup start_{};  ///< Slope of each group without shares.
  PerGroup bend_{};   ///< By how much its share lowers it.
  std::size_t largest_ = 0;
  double gap_ = 1e300;
  PerGroup shares_{};
};

}  // namespace

double sumOver(Clique clique, const PerGroup& of) {
  double out = 0.0;
  for (Clique left = clique & ((1u << kMostGroups) - 1); left != 0; left &= left - 1) {
    out += of[static_cast<std::size_t>(std::countr_zero(left))];
  }
  return out;
}

Blended blended(std::span<const Clique> cliques, const PerGroup& x, const PerGroup& y) {
  Cliques left = largestWithPotential(cliques, x);
  leaveOutHopeless(left, x, y);
  if (left.empty()) return {};
  Clique all = 0;
  Clique common = left.front();
  for (const Clique clique : left) {
    all |= clique;
    common &= clique;
  }
  PerGroup shares{};
  if (left.size() == 2) {
    const double first = shareOfTwo(left[0], left[1], x, y);
    for (std::size_t j = 0; j < kMostGroups; ++j) shares[j] = holds(left[0], j) ? first : 1.0 - first;
  } else if (left.size() > 2) {
    shares = Shares(left, all & ~common, x, y).best();
  }
  for (std::size_t j = 0; j < kMostGroups; ++j) {
    if (holds(common, j)) shares[j] = 1.0;
    if (!holds(all, j)) shares[j] = 0.0;
  }
  return withShares(shares, x, y);
}

}  // namespace sinew::oracle
