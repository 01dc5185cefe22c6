// core/geometry/formulas/blend.h: shares of cliques for soft grooves (docs/design.md, Grooves). Needs a type Blending
// and for it cliqueCount(), shareOf() of a clique, exchangeOf() and exchange() of two.

/// What the second gives; negative: takes.
formula Real givenShare(Exchange of, Real first, Real second) {
  return select(of.fall > num(0.0), clamp(of.gain / of.fall, num(0.0) - first, second), num(0.0));
}

/// F is the largest sum of softPart() over shares of the cliques. It is concave in them, so pairs of cliques exchange
/// shares until F does not rise any more; two cliques need one exchange. A clique with a negative share takes no part.
/// @param settled  how little F rises by a share that need not be given.
formula void settleShares(Blending blending, Real settled, Mask open) {
  const int kMostRounds = 64;
  int cliques = cliqueCount(blending);
  for (int round = 0; round < kMostRounds && any(open); ++round) {
    Real pairs = num(0.0);
    Real most = num(0.0);
    for (int first = 0; first < cliques; ++first) {
      for (int second = first + 1; second < cliques; ++second) {
        Real own = shareOf(blending, first);
        Real other = shareOf(blending, second);
        Mask exchanges = both(open, both(own >= num(0.0), other >= num(0.0)));
        if (!any(exchanges)) continue;
        Exchange of = exchangeOf(blending, first, second);
        Real given = select(exchanges, givenShare(of, own, other), num(0.0));
        exchange(blending, first, second, given);
        most = max(most, abs(given) * of.fall);
        pairs = pairs + select(exchanges, num(1.0), num(0.0));
      }
    }
    open = both(open, both(most > settled, pairs > num(1.0)));
  }
}
