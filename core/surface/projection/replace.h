// core/surface/projection/replace.h: the paper's mode: vertices inside the influence go to the implicit surface.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/surface/projection/candidates.h"
#include "core/surface/projection/projection_scratch.h"
#include "sinew/character/pose.h"
#include "sinew/character/skeleton.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew {

// For each refined vertex the closest point on the skeleton (paper 4.2).

/// A point that rides on a bone.
struct Anchor {
  int bone = 0;
  glm::vec3 pointInBone{0.0f};
};

/// Closest points in the bind pose. The skeleton is the segments from each bone's origin to its children's origins, and
/// to its tip where it has none; the lower bone index wins a tie. A segment moves with the bone it starts at; its end,
/// a child's origin, with the child: else the many vertices closest to a joint would hang on rounding.
/// @param points [N] bind pose, world.  @return [N]
[[nodiscard]] std::vector<Anchor> findAnchors(const Skeleton& skeleton, std::span<const glm::vec3> points);

/// Anchors in a pose. @param out [N] world.
void poseAnchors(std::span<const Anchor> anchors, const Pose& pose, std::vector<glm::vec3>& out);

// Where the paper takes one root or none, several are laid over each other: along the ray, each stretch with F > T
// counts by its prominence, the largest F - T in it, from 0 at 0 to all at a quarter of T; what weight is left goes to
// the next stretch, then (from outside) to the ray along the normal, then to the patch. A stretch that vanishes as
// primitives move has faded out by then, and one that appears fades in: nothing pops. Prominent stretches give the
// paper's result exactly.

/// Constants of one character and rig.
struct ReplaceSettings {
  float iso = kDefaultIso;
  float searchLength = 0.2f;  ///< L, world units. The result's weight fades from 1 at 0.8 L to 0 at L.
  ProjectionKind projection = ProjectionKind::kNewton;
  double tolerance = 1e-6;
  bool alongNormals = false;  ///< SmoothingSettings::alongNormals
};

/// The refined mesh without elevation, in one pose: what is projected, from where and towards what.
struct FlatVertices {
  std::span<const glm::vec3> positions;  ///< [V'] barycentric, world.
  std::span<const glm::vec3> normals;    ///< [V'] barycentric, unit.
  std::span<const glm::vec3> anchors;    ///< [V'] world. Analytic projection does not look at them.
  /// [V'] 1/L, 0: none (rise_limits.h); empty: none anywhere. They count where muscles do not wrap the body.
  std::span<const float> inverseLimits = {};
};

/// Which control vertices go to the implicit surface.
struct ImplicitWeights {
  std::vector<float> omega;  ///< [V] 1 or 0 (paper 3.3).
  bool wraps = true;         ///< Muscles wrap the body.
  int unwrapped = 0;  ///< Vertices in the region of influence that keep the skin because muscles do not wrap the body.
};

/// From the bind pose. The paper takes for granted that muscles wrap the body: that anchors are inside the implicit
/// surface (4.2). They do if that holds for 70 % of the control vertices in the region of influence. Then omega is 1
/// where the vertex is inside that region and its projection exists within the search length, else 0. On any other body
/// muscles lie in the skin: omega is 1 where a muscle holds the vertex, and nothing is pulled in towards a muscle that
/// only touches it, which would tear the skin.
/// @param flat of the bind pose; its first V entries are read.
[[nodiscard]] ImplicitWeights implicitWeights(const ControlMesh& mesh, const FieldView& bindField,
                                              const ReplaceSettings& settings, const FlatVertices& flat,
                                              ProjectionScratch& scratch);

// What the scalar and the vector path share.
inline constexpr float kFadeBegin = 0.8f;  ///< Fraction of the search length from where a projection loses weight.
inline constexpr float kFullProminence = 0.25f;  ///< Fraction of T from which a stretch counts whole.
/// Tenths of a stretch at which F - T is sampled, those first where it is likely to be large: enough is enough.
inline constexpr std::array<int, 9> kProminenceSamples{5, 3, 7, 2, 8, 4, 6, 1, 9};
inline constexpr int kMostStretches = 8;  ///< Along one ray; more is noise.

/// Roots laid over each other, front to back.
struct Replaced {
  glm::vec3 position{0.0f};  ///< Weighted sum.
  glm::vec3 normal{0.0f};    ///< Weighted sum.
  float weight = 0.0f;       ///< Sum of weights, 0..1; the rest is the patch's.
};

/// Moves a vertex from its patch. @param omega  of the vertex.  @param inverseLimit  of its rise; 0: none.
void placeReplaced(const Replaced& replaced, float omega, float inverseLimit, std::size_t vertex, Surface& surface);

/// p' = w p_implicit + (1 - w) p_normal, w = omega faded over the last part of the search length; likewise normals. The
/// surface holds the patch on entry. Vertices with omega > 0 and no root stay on it and count as unresolved. On a body
/// that muscles do not wrap, skin that rises beyond half its limit is drawn in below it, as in `swell`.
void replace(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings, const FlatVertices& flat,
             const ImplicitWeights& weights, Surface& surface, ProjectionScratch& scratch);

/// One vertex, as replace() does.
void replaceVertex(const CarriedVertex& vertex, const FieldView& field, const ReplaceSettings& settings,
                   const FlatVertices& flat, const ImplicitWeights& weights, Surface& surface, VertexScratch& scratch);

}  // namespace sinew
