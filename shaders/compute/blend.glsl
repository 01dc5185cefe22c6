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

// Cliques of some groups, at least one; none is part of another, since that would never have a share.
uvec2 blended[kMostCliques];
int blendedCount;
uvec2 blendedSlots;

void blendAmong(uvec2 slots) {
  blendedSlots = slots;
  blendedCount = 0;
  for (int k = 0; k < cliquesSeen; ++k) {
    uvec2 own = cliqueAt(k) & slots;
    bool counts = holdsAny(own);
    int kept = 0;
    for (int i = 0; i < blendedCount && counts; ++i) {
      uvec2 other = blended[i];
      counts = holdsAny(own & ~other);
      if (!counts || holdsAny(other & ~own)) blended[kept++] = other;
    }
    if (!counts) continue;
    blendedCount = kept;
    blended[blendedCount++] = own;
  }
  if (blendedCount == 0) blended[blendedCount++] = uvec2(0u);
}

// x, y and m of GroupBlend, of the groups in groupSlots.
Real groupSums[kMostSlots], groupSoftness[kMostSlots], groupShares[kMostSlots];
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
Real countedOf(uint slot, Real groove) { return softPart(Real(1.0), groove, groupShares[slot]); }

int sharing[kMostCliques];  // Which of `blended` may have a share,
Real cliqueShares[kMostCliques];  // and the share.
int sharingCount;

#define Blending int
int cliqueCount(Blending blending) { return sharingCount; }
Real shareOf(Blending blending, int clique) { return cliqueShares[clique]; }
Exchange exchangeOf(Blending blending, int first, int second) {
  uvec2 a = blended[sharing[first]], b = blended[sharing[second]];
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
  uvec2 a = blended[sharing[first]], b = blended[sharing[second]];
  cliqueShares[first] += given;
  cliqueShares[second] -= given;
  for (uvec2 slots = (a ^ b) & groupSlots; holdsAny(slots);) {
    int j = takeSlot(slots);
    groupShares[j] += holds(a, uint(j)) ? given : -given;
  }
}
void settleShares(Blending blending, Real settled, Mask open);

Real cliqueSums[kMostCliques], cliqueSoftness[kMostCliques];  // Of `sharing`, sums of x and y.

// Gives the cliques the shares that are best if they have only those groups in common that all of them have: of
// disjoint cliques F is largest where all rates are the same, and a clique that would take less than nothing takes part
// no more. Exchanges alone would come there in many rounds. @return whether these shares are the best
bool startShares() {
  uvec2 inAll = groupSlots;
  for (int i = 0; i < sharingCount; ++i) inAll &= blended[sharing[i]];
  Real ofAll = Real(0.0);
  uvec2 inSome = inAll;
  bool disjoint = true;
  for (int i = 0; i < sharingCount; ++i) {
    uvec2 own = blended[sharing[i]] & groupSlots & ~inAll;
    disjoint = disjoint && !holdsAny(own & inSome);
    inSome |= own;
  }
  while (holdsAny(inAll)) ofAll += groupSoftness[takeSlot(inAll)];
  for (int i = 0; i < sharingCount; ++i) {
    cliqueSoftness[i] -= ofAll;
    if (!(cliqueSoftness[i] > Real(1e-6) * cliqueSums[i])) return false;
  }
  bool changes = true;
  for (int round = 0; round < sharingCount && changes; ++round) {
    Real rate = Real(-1.0), whole = Real(0.0);
    for (int i = 0; i < sharingCount; ++i) {
      if (cliqueSoftness[i] == Real(0.0)) continue;
      rate += cliqueSums[i] / cliqueSoftness[i] + Real(0.5);
      whole += Real(1.0) / cliqueSoftness[i];
    }
    changes = false;
    for (int i = 0; i < sharingCount; ++i) {
      bool counts = cliqueSoftness[i] != Real(0.0);
      cliqueShares[i] = counts ? (cliqueSums[i] - rate / whole) / cliqueSoftness[i] + Real(0.5) : Real(0.0);
      if (cliqueShares[i] >= Real(0.0)) continue;
      cliqueShares[i] = cliqueSoftness[i] = Real(0.0);
      changes = true;
    }
  }
  for (uvec2 slots = groupSlots; holdsAny(slots);) groupShares[takeSlot(slots)] = Real(0.0);
  for (int i = 0; i < sharingCount; ++i) {
    if (cliqueShares[i] == Real(0.0)) continue;
    for (uvec2 slots = blended[sharing[i]] & groupSlots; holdsAny(slots);) groupShares[takeSlot(slots)] += cliqueShares[i];
  }
  return disjoint;
}

// Finds the shares for the groups' sums. @return F
Real settleGroups() {
  int highest = -1;
  Real largest = Real(0.0), surely = Real(0.0);
  for (int k = 0; k < blendedCount; ++k) {
    Real sum = Real(0.0), softness = Real(0.0);
    for (uvec2 slots = blended[k] & groupSlots; holdsAny(slots);) {
      int j = takeSlot(slots);
      sum += groupSums[j];
      softness += groupSoftness[j];
    }
    if (sum > largest) highest = k;
    largest = max(largest, sum);
    surely = max(surely, sum - Real(0.5) * softness);
    cliqueSums[k] = sum;
    cliqueSoftness[k] = softness;
  }
  if (highest < 0) return Real(0.0);
  // Taking from a clique b for k gains at most S_k + Y_k / 2 - S_b + Y_b / 2, with sums S and softness Y.
  sharingCount = 0;
  for (int k = 0; k < blendedCount; ++k) {
    if (k != highest && cliqueSums[k] + Real(0.5) * cliqueSoftness[k] < surely) continue;
    sharing[sharingCount] = k;
    cliqueSums[sharingCount] = cliqueSums[k];
    cliqueSoftness[sharingCount] = cliqueSoftness[k];
    cliqueShares[sharingCount++] = Real(k == highest ? 1.0 : 0.0);
  }
  for (uvec2 slots = blended[highest] & groupSlots; holdsAny(slots);) groupShares[takeSlot(slots)] = Real(1.0);
  if (sharingCount < 2) return largest;
  bool settled = sharingCount > 2 && startShares();
  if (!settled) settleShares(0, Real(kSettled) * largest, true);
  Real field = Real(0.0);
  for (uvec2 slots = groupSlots; holdsAny(slots);) {
    int j = takeSlot(slots);
    field += softPart(groupSums[j], groupSoftness[j], groupShares[j]);
  }
  return field;
}
