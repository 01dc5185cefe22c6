// core/geometry/formulas/blend.h: shares of cliques for soft grooves (docs/design.md, Grooves). Needs a type Blending
// and for it cliqueCount(), shareOf() of a clique, exchangeOf() and exchange() of two; for disjoint cliques a type
// Leveling and for it levelCount(), sumOf() and softnessOf() of a clique's own groups, setLevel(), levelOf(),
// giveShare().

/// F is the largest sum of softPart() over shares of the cliques. For cliques that have only groups in common that all
/// have: where F is largest, a share changes it as much for every clique that has one, by rate = x + y / 2 - y share.
/// The sum of the shares falls with the rate, by straight pieces that get less steep, so Newton's steps from below end
/// at the rate for 1.
/// @param narrowest  least y / x: numbers could not tell a narrower groove's sums apart.
/// @param settled  by how much the sum may exceed 1 before it is scaled.
formula void levelShares(Leveling leveling, Real narrowest, Real settled) {
  int cliques = levelCount(leveling);
  Real rate = num(0.0);
  for (int k = 0; k < cliques; ++k) {
    Real x = sumOf(leveling, k);
    Real y = max(softnessOf(leveling, k), narrowest * x);
    Level level = {x + num(0.5) * y, select(y > num(1e-30), num(1.0) / y, num(0.0))};
    rate = max(rate, x - num(0.5) * y);
    setLevel(leveling, k, level);
  }
  Real whole = num(0.0);
  Real holders = num(0.0);
  Mask open = rate >= num(0.0);
  for (int step = 0; step <= cliques && any(open); ++step) {
    Real shares = num(0.0);
    Real having = num(0.0);
    Real fall = num(0.0);
    for (int k = 0; k < cliques; ++k) {
      Level level = levelOf(leveling, k);
      Real share = shareAt(level, rate);
      Mask has = share > num(0.0);
      shares = shares + share;
      having = having + select(has, num(1.0), num(0.0));
      fall = fall + select(has, level.inverse, num(0.0));
    }
    whole = select(open, shares, whole);
    holders = select(open, having, holders);
    open = both(open, shares > num(1.0) + settled);
    if (step < cliques) rate = select(open, rate + (shares - num(1.0)) / fall, rate);
  }
  Real scale = num(1.0) / whole;
  for (int k = 0; k < cliques; ++k) {
    Real share = shareAt(levelOf(leveling, k), rate);
    Real alone = select(share > num(0.0), num(1.0), num(0.0));
    giveShare(leveling, k, select(holders > num(1.0), share * scale, alone));
  }
}

/// What the second gives; negative: takes.
formula Real givenShare(Exchange of, Real first, Real second) {
  return select(of.fall > num(0.0), clamp(of.gain / of.fall, num(0.0) - first, second), num(0.0));
}

/// For any cliques. F is concave in the shares, so pairs of cliques exchange shares until F does not rise any more; two
/// cliques need one exchange. A clique with a negative share takes no part.
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
