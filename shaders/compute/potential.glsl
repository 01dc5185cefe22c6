// shaders/compute/potential.glsl: potentials of muscles and their field F at a point. As core/rig/field.cpp.
// Includes nothing: field.glsl and, with Real float, shape.glsl and its formulas come before.
vec3 inUnit(Primitive p, vec3 d) {
  if (p.toUnit[2].w > 0.0) return d;
  precise vec3 y = d.x * p.toUnit[0].xyz + d.y * p.toUnit[1].xyz + d.z * p.toUnit[2].xyz;
  return y;
}

float rSquaredAt(Primitive p, vec3 fromCenter) {
  vec3 y = inUnit(p, fromCenter);
  return isShaped(p) ? shapeRSquared(shapePoint(numbersOf(p), y)) : scaleOf(p) * dotOf(y, y);
}

// Half of d(r^2)/dx.
vec3 halfSlopeAt(Primitive p, vec3 fromCenter) {
  if (p.toUnit[2].w > 0.0) return scaleOf(p) * fromCenter;
  vec3 y = inUnit(p, fromCenter);
  if (isShaped(p)) y = shapeHalfSlope(numbersOf(p), shapePoint(numbersOf(p), y));
  return vec3(dotOf(p.toUnit[0].xyz, y), dotOf(p.toUnit[1].xyz, y), dotOf(p.toUnit[2].xyz, y));
}

const float kTie = 1e-4;

// F and its gradient: of the highest clique, or the mean of two that tie.
vec4 fieldAt(vec3 x) {
  vec4 carved = vec4(0.0);
  vec4 sums[kMostCliques];
  for (int k = 0; k < cliqueCount; ++k) sums[k] = vec4(0.0);
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive p = primitives[firstPrimitive + c.primitive];
    float weight = weightOf(c);
    float w = 1.0 - rSquaredAt(p, x - p.center.xyz);
    if (!(weight > 0.0) || !(w > 0.0) || p.center.w == 0.0) continue;
    float factor = strengthOf(p) * weight;
    vec4 part = vec4(potential(factor, w), -4.0 * factor * potentialRate(w) * halfSlopeAt(p, x - p.center.xyz));
    if (factor < 0.0) {
      carved += part;
      continue;
    }
    for (int k = 0; k < cliqueCount; ++k) {
      if (holds(cliqueAt(k), c.slot)) sums[k] += part;
    }
  }
  vec4 best = vec4(0.0);
  for (int k = 0; k < cliqueCount; ++k) {
    if (sums[k].x > best.x) best = sums[k];
  }
  vec4 other = vec4(0.0);  // x: by how much it ties, of kTie.
  float most = 0.0;
  for (int k = 0; k < cliqueCount; ++k) {
    float near = min(kTie - (best.x - sums[k].x), sums[k].x);
    vec3 apart = sums[k].yzw - best.yzw;
    float pull = near * near * dotOf(apart, apart);
    if (!(near > 0.0 && pull > most)) continue;
    most = pull;
    other = vec4(near, sums[k].yzw);
  }
  float share = other.x / kTie;
  best.yzw = (best.yzw + share * other.yzw) / (1.0 + share);
  return best + carved;
}
