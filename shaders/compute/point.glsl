// shaders/compute/point.glsl: F and its gradient at a point. As core/rig/field.cpp. Needs potential.glsl and blend.glsl.
const float kTie = 1e-4;

// Of one muscle, times its weight; 0: it does not count.
vec4 partAt(Candidate c, Primitive p, vec3 x) {
  float weight = weightOf(c);
  float w = 1.0 - rSquaredAt(p, x - p.center.xyz);
  if (!(weight > 0.0) || !(w > 0.0) || p.center.w == 0.0) return vec4(0.0);
  float factor = strengthOf(p) * weight;
  return vec4(potential(factor, w), -4.0 * factor * potentialRate(w) * halfSlopeAt(p, x - p.center.xyz));
}

// With soft grooves.
vec4 softFieldAt(vec3 x) {
  vec4 field = vec4(0.0);
  clearGroups();
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive p = primitives[firstPrimitive + c.primitive];
    vec4 part = partAt(c, p, x);
    if (strengthOf(p) < 0.0) field += part;
    else if (part != vec4(0.0)) addToGroup(c.slot, Real(part.x), Real(grooveOf(p)));
  }
  blendAmong(groupSlots);
  field.x += float(settleGroups());
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive p = primitives[firstPrimitive + c.primitive];
    if (strengthOf(p) < 0.0 || !holds(groupSlots, c.slot) || meanShares[c.slot] == Real(0.0)) continue;
    field.yzw += float(countedOf(c.slot, Real(grooveOf(p)))) * partAt(c, p, x).yzw;
  }
  return field;
}

// F and its gradient: with crisp grooves of the highest clique, or the mean of two that tie; of levels the mean.
vec4 fieldAt(vec3 x) {
  if (softGrooves) return softFieldAt(x);
  vec4 carved = vec4(0.0);
  vec4 sums[kMostCliques];
  for (int k = 0; k < cliquesSeen; ++k) sums[k] = vec4(0.0);
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive p = primitives[firstPrimitive + c.primitive];
    vec4 part = partAt(c, p, x);
    if (part == vec4(0.0)) continue;
    if (strengthOf(p) < 0.0) {
      carved += part;
      continue;
    }
    for (int k = 0; k < cliquesSeen; ++k) {
      if (holds(cliqueAt(k), c.slot)) sums[k] += part;
    }
  }
  vec4 together = vec4(0.0);
  for (int level = 0, first = 0; level < levelsSeen; first = levelEnd(level), ++level) {
    vec4 best = vec4(0.0);
    for (int k = first; k < levelEnd(level); ++k) {
      if (sums[k].x > best.x) best = sums[k];
    }
    vec4 other = vec4(0.0);  // x: by how much it ties, of kTie.
    float most = 0.0;
    for (int k = first; k < levelEnd(level); ++k) {
      float near = min(kTie - (best.x - sums[k].x), sums[k].x);
      vec3 apart = sums[k].yzw - best.yzw;
      float pull = near * near * dotOf(apart, apart);
      if (!(near > 0.0 && pull > most)) continue;
      most = pull;
      other = vec4(near, sums[k].yzw);
    }
    float share = other.x / kTie;
    best.yzw = (best.yzw + share * other.yzw) / (1.0 + share);
    together += levelWeight(level) * best;
  }
  return together + carved;
}
