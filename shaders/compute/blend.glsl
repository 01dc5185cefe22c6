// shaders/compute/blend.glsl: soft grooves at one place: sums of groups, and the shares that their cliques have in F. As
// core/rig/group_blend.cpp. Needs field.glsl, potential.h and kSettled, how little F rises by a share that need not be
// given, times the largest sum; core/geometry/formulas/blend.h comes after it.
const int kMostSlots = 64;  // A set of slots has a bit for each.

bool holdsAny(uvec2 slots) { return (slots.x | slots.y) != 0u; }
uvec2 setOf(uint slot) { return slot < 32u ? uvec2(1u << slot, 0u) : uvec2(0u, 1u << (slot - 32u)); }

// The lowest slot of a set that is not empty leaves it.
int takeSlot(inout uvec2 slots) {
  int slot = slots.x != 0u ? findLSB(slots.x) : 32 + findLSB(slots.y);
  if (slots.x != 0u) slots.x &= slots.x - 1u;
  else slots.y &= slots.y - 1u;
  return slot;
}

// Cliques of some groups, level after level, in each at least one; none is part of another of its level, since that
// would never have a share.
uvec2 blendedOfAll[kMostCliques];
int blendedEnds[kMostCliques];  // Of each level.
uvec2 blendedSlots;

int blendedFirst, blendedCount;  // Those of one level.
uvec2 blended(int clique) { return blendedOfAll[blendedFirst + clique]; }
void useLevel(int level) {
  blendedFirst = level > 0 ? blendedEnds[level - 1] : 0;
  blendedCount = blendedEnds[level] - blendedFirst;
}

void blendAmong(uvec2 slots) {
  blendedSlots = slots;
  int end = 0;
  for (int level = 0, k = 0; level < levelsSeen; ++level) {
    int first = end;
    for (; k < levelEnd(level); ++k) {
      uvec2 own = cliqueAt(k) & slots;
      bool counts = holdsAny(own);
      int kept = first;
      for (int i = first; i < end && counts; ++i) {
        uvec2 other = blendedOfAll[i];
        counts = holdsAny(own & ~other);
        if (!counts || holdsAny(other & ~own)) blendedOfAll[kept++] = other;
      }
      if (!counts) continue;
      end = kept;
      blendedOfAll[end++] = own;
    }
    if (end == first) blendedOfAll[end++] = uvec2(0u);
    blendedEnds[level] = end;
  }
}

// x, y and m of GroupBlend, of the groups in groupSlots.
Real groupSums[kMostSlots], groupSoftness[kMostSlots], groupShares[kMostSlots];
Real meanShares[kMostSlots], meanSoftness[kMostSlots];  // What counts of x and of y, mean of the levels.
uvec2 groupSlots;

void clearGroups() { groupSlots = uvec2(0u); }
void addToGroup(uint slot, Real value, Real groove) {
  bool isFirst = !holds(groupSlots, slot);
  groupSlots |= setOf(slot);
  groupSums[slot] = (isFirst ? Real(0.0) : groupSums[slot]) + value;
  groupSoftness[slot] = (isFirst ? Real(0.0) : groupSoftness[slot]) + groove * value;
  groupShares[slot] = Real(0.0);
}

// How much of a derivative of a part of a group counts in that of F, which is largest at the shares.
Real countedOf(uint slot, Real groove) { return meanShares[slot] + groove * meanSoftness[slot]; }

Real cliqueSums[kMostCliques], cliqueSoftness[kMostCliques];  // Of `blended`, sums of x and y; then levels.
uvec2 inEvery;                                                // Groups that all of them have.

uvec2 ownOf(int clique) { return blended(clique) & groupSlots & ~inEvery; }

#define Leveling int
int levelCount(Leveling leveling) { return blendedCount; }
Real sumOf(Leveling leveling, int clique) { return cliqueSums[clique]; }
Real softnessOf(Leveling leveling, int clique) { return cliqueSoftness[clique]; }
Level levelOf(Leveling leveling, int clique) { return Level(cliqueSums[clique], cliqueSoftness[clique]); }
void setLevel(Leveling leveling, int clique, Level level) {
  cliqueSums[clique] = level.top;
  cliqueSoftness[clique] = level.inverse;
}
void giveShare(Leveling leveling, int clique, Real share) {
  for (uvec2 slots = ownOf(clique); holdsAny(slots);) groupShares[takeSlot(slots)] = share;
}

int sharing[kMostCliques];  // Which of `blended` may have a share,
Real cliqueShares[kMostCliques];  // and the share.
int sharingCount;

#define Blending int
int cliqueCount(Blending blending) { return sharingCount; }
Real shareOf(Blending blending, int clique) { return cliqueShares[clique]; }
Exchange exchangeOf(Blending blending, int first, int second) {
  uvec2 a = blended(sharing[first]), b = blended(sharing[second]);
  Exchange found = Exchange(Real(0.0), Real(0.0));
  for (uvec2 slots = (a ^ b) & groupSlots; holdsAny(slots);) {
    int j = takeSlot(slots);
    Real rate = softRate(groupSums[j], groupSoftness[j], groupShares[j]);
    found.gain += holds(a, uint(j)) ? rate : -rate;
    found.fall += groupSoftness[j];
  }
  return found;
}
void exchange(Blending blending, int first, int second, Real given) {
  uvec2 a = blended(sharing[first]), b = blended(sharing[second]);
  cliqueShares[first] += given;
  cliqueShares[second] -= given;
  for (uvec2 slots = (a ^ b) & groupSlots; holdsAny(slots);) {
    int j = takeSlot(slots);
    groupShares[j] += holds(a, uint(j)) ? given : -given;
  }
}

void levelShares(Leveling leveling, Real narrowest, Real settled);
void settleShares(Blending blending, Real settled, Mask open);

void sumCliques() {
  for (int k = 0; k < blendedCount; ++k) {
    cliqueSums[k] = cliqueSoftness[k] = Real(0.0);
    for (uvec2 slots = ownOf(k); holdsAny(slots);) {
      int j = takeSlot(slots);
      cliqueSums[k] += groupSums[j];
      cliqueSoftness[k] += groupSoftness[j];
    }
  }
}

void exchangeShares() {
  int highest = -1;
  Real largest = Real(0.0), surely = Real(0.0);
  for (int k = 0; k < blendedCount; ++k) {
    if (cliqueSums[k] > largest) highest = k;
    largest = max(largest, cliqueSums[k]);
    surely = max(surely, cliqueSums[k] - Real(0.5) * cliqueSoftness[k]);
  }
  if (highest < 0) return;
  // Taking from a clique b for k gains at most S_k + Y_k / 2 - S_b + Y_b / 2, with sums S and softness Y.
  sharingCount = 0;
  for (int k = 0; k < blendedCount; ++k) {
    if (k != highest && cliqueSums[k] + Real(0.5) * cliqueSoftness[k] < surely) continue;
    sharing[sharingCount] = k;
    cliqueShares[sharingCount++] = Real(k == highest ? 1.0 : 0.0);
  }
  for (uvec2 slots = ownOf(highest); holdsAny(slots);) groupShares[takeSlot(slots)] = Real(1.0);
  if (sharingCount > 1) settleShares(0, Real(kSettled) * largest, true);
}

// Finds the shares in the level in use for the groups' sums. @return its F
Real settleLevel() {
  uvec2 inSome = uvec2(0u), inSeveral = uvec2(0u);
  inEvery = groupSlots;
  for (int k = 0; k < blendedCount; ++k) {
    inSeveral |= inSome & blended(k);
    inSome |= blended(k);
    inEvery &= blended(k);
  }
  for (uvec2 slots = groupSlots; holdsAny(slots);) groupShares[takeSlot(slots)] = Real(0.0);
  for (uvec2 slots = inEvery; holdsAny(slots);) groupShares[takeSlot(slots)] = Real(1.0);
  sumCliques();
  if (holdsAny(inSeveral & groupSlots & ~inEvery)) exchangeShares();
  else levelShares(0, Real(4.0 * kSettled), Real(kSettled));
  Real field = Real(0.0);
  for (uvec2 slots = groupSlots; holdsAny(slots);) {
    int j = takeSlot(slots);
    field += softPart(groupSums[j], groupSoftness[j], groupShares[j]);
  }
  return field;
}

// Finds the shares in all levels. @return F
Real settleGroups() {
  Real field = Real(0.0);
  for (uvec2 slots = groupSlots; holdsAny(slots);) {
    int j = takeSlot(slots);
    meanShares[j] = meanSoftness[j] = Real(0.0);
  }
  for (int level = 0; level < levelsSeen; ++level) {
    Real weight = Real(levelWeight(level));
    useLevel(level);
    field += weight * settleLevel();
    for (uvec2 slots = groupSlots; holdsAny(slots);) {
      int j = takeSlot(slots);
      meanShares[j] += weight * softPart(Real(1.0), Real(0.0), groupShares[j]);
      meanSoftness[j] += weight * softPart(Real(0.0), Real(1.0), groupShares[j]);
    }
  }
  return field;
}
