// core/geometry/formulas/finish.h: weights and bounds of the stages after projection: heights, folds, shading normals
// (docs/design.md, Swell and Normals).

// Heights.

constant float kLevel = 0.4f;  ///< rho from which heights stay.
/// Fraction that is left of a height where the pose folds the skin itself.
formula Real leftOfHeight(Real rho) { return num(0.4) + num(1.0 - 0.4) * smoothstep(num(-0.3), num(kLevel), rho); }

constant float kMostSlope = 1.5f;  ///< Of heights over the patch: flanks of muscles up to 56 degrees stay as they are.

/// Difference of a height from its neighbors' mean, in edges, that the mesh can follow.
constant float kBentFrom = 0.15f;
/// Weight of the filter.
formula Real bentWeight(Real bent) { return smoothstep(num(kBentFrom), num(0.5), bent); }
/// What a vertex passes on to its neighbors. Otherwise one that starts to move beside high ones would lower them at
/// once.  @param rise  its height in edges
formula Real passedWeight(Real weight, Real rise) { return weight * smoothstep(num(0.0), num(0.1), rise); }
/// A round of the filter.  @param difference, perLength  sums over the edges: of height differences per length, and of
/// 1 / length.  @param raw  height before the first round.
formula Real filteredHeight(Real own, Real weight, Real difference, Real perLength, Real raw) {
  return clamp(own + num(0.5) * weight * difference / perLength, min(num(0.0), raw), max(num(0.0), raw));
}

// Folds.

constant float kLeastArea = 0.3f;  ///< q below which a triangle counts as folded.
/// A triangle's front.  @param face  twice the area along the normal, of the corners u and v from the third.
/// @param normals  sum of the three.
formula Real frontOf(Real3 face, Real3 normals, Real3 u, Real3 v) {
  Real edges = num(3.0) * (dot(u, u) + dot(v, v) + dot(v - u, v - u));
  return select(edges > num(0.0), dot(face, normals) / edges, num(0.0));
}
/// Trust in q, from a patch triangle's front over that in the bind pose.
formula Real foldTrust(Real ratio) { return smoothstep(num(0.0), num(0.05), ratio); }
/// Move of a corner along the gradient of the area. The gradients vanish where the triangle has shrunk to a line along
/// the normal: moves stay small.  @param area  of the patch, doubled.  @param squared  sum of the squared gradients.
formula Real foldStep(Real q, Real area, Real squared) { return (num(kLeastArea) - q) * area / max(squared, area); }
/// The q of a sliver changes fast: its requests must not weigh as much as its neighbors' at once.
formula Real foldWeight(Real trust, Real q, Real move) {
  return trust * min(num(1.0), min((num(kLeastArea) - q) / num(0.1), move / num(0.01)));
}
/// Factor of a corner's summed moves: above the mean, for faster convergence.  @param weight  sum of their weights
formula Real foldRelaxation(Real weight) { return num(1.5) / max(num(1.0), weight); }

// Shading normals. A delta is the field's normal less the patch's.

constant float kRimFrom = 0.2f;
/// Weight of the ring's mean in a normal at a rim.  @param apart  largest difference of delta to a neighbor's
formula Real rimWeight(Real apart) { return num(0.6) * smoothstep(num(kRimFrom), num(0.45), apart); }

constant float kTeethFrom = 0.22f;
/// The same where normals alternate from vertex to vertex; 0 where delta is, and continuous from there.
/// @param filtered  weight of the filter of heights.  @param turn  length of delta.
formula Real teethWeight(Real apart, Real filtered, Real turn) {
  Real cliff = (num(1.0) - filtered) * smoothstep(num(0.45), num(0.8), apart);
  return num(0.23) * smoothstep(num(kTeethFrom), num(0.45), apart) * (num(1.0) - cliff) *
         smoothstep(num(0.0), num(0.1), turn);
}

/// Normalizes a sum of a few weighted unit vectors; `fallback` where they cancel.
formula Real3 unitOfSum(Real3 sum, Real3 fallback) {
  Real squared = dot(sum, sum);
  return select(squared > num(1e-12), (num(1.0) / sqrt(squared)) * sum, fallback);
}

/// Change of v by the least rotation from `from` to `to`, both unit. Opposite vectors have none; near them the change
/// becomes to - from.
formula Real3 turnOf(Real3 v, Real3 from, Real3 to) {
  Real cosine = dot(from, to);
  Real share = smoothstep(num(-0.95), num(-0.7), cosine);
  Real3 axis = cross(from, to);
  Real3 across = cross(axis, v);
  Real3 rotated = across + (num(1.0) / (num(1.0) + cosine)) * cross(axis, across);
  if (!any(share < num(1.0))) return rotated;
  Real3 plain = to - from;
  Real3 between = share * rotated + (num(1.0) - share) * plain;
  return select(share >= num(1.0), rotated, select(share > num(0.0), between, plain));
}

/// A delta held to `shown`, what the faces around a vertex show, but for 8 degrees of freedom.
struct Held {
  Real3 delta;
  Mask isHeld;
};
formula Held heldDelta(Real3 delta, Real3 shown, Real filtered) {
  Real freedom = num(0.145) * (num(1.0) - filtered);
  Real3 beyond = delta - shown;
  Real squared = dot(beyond, beyond);
  Mask isHeld = squared > freedom * freedom;
  Held held = {select(isHeld, shown + (freedom / sqrt(squared)) * beyond, delta), isHeld};
  return held;
}
