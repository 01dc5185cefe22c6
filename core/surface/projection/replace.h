// core/surface/projection/replace.h: the paper's mode: vertices within the influence go to the implicit surface.
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

/// Closest point on the skeleton of a refined vertex (paper 4.2), which moves with a bone.
struct Anchor {
  int bone = 0;
  glm::vec3 pointInBone{0.0f};
};

/// Closest points in the bind pose. The skeleton consists of segments from each bone's origin to its children's
/// origins, or to its tip if it has no children; the lower bone index wins a tie. A segment moves with its first bone,
/// but its end, a child's origin, with the child: otherwise rounding would decide for the many vertices closest to a
/// joint. Anchors keep their bones in every pose; the closest points of each pose would jump from bone to bone.
/// @param points [N] bind pose, world.  @return [N]
[[nodiscard]] std::vector<Anchor> findAnchors(const Skeleton& skeleton, std::span<const glm::vec3> points);

/// Anchors in a pose. @param out [N] world.
void poseAnchors(std::span<const Anchor> anchors, const Pose& pose, std::vector<glm::vec3>& out);

// The paper takes one root or none; here several are composited. Along the ray, each interval with F > T weighs by its
// prominence, its largest F - T, from 0 at 0 to 1 at a quarter of T. The remaining weight goes to the next interval,
// then (from outside) to the ray along the normal, then to the patch. As primitives move, intervals fade out before
// they vanish and fade in as they appear: nothing pops. Prominent intervals give the paper's result exactly.

/// Constants of one character and rig.
struct ReplaceSettings {
  float iso = kDefaultIso;
  float searchLength = 0.2f;  ///< L, world units. The result's weight fades from 1 at 0.8 L to 0 at L.
  ProjectionKind projection = ProjectionKind::kNewton;
  double tolerance = 1e-6;
  bool alongNormals = false;  ///< SmoothingSettings::alongNormals
};

/// The refined mesh without elevation in one pose: starts and targets of projection.
struct FlatVertices {
  std::span<const glm::vec3> positions;  ///< [V'] barycentric, world.
  std::span<const glm::vec3> normals;    ///< [V'] barycentric, unit.
  std::span<const glm::vec3> anchors;    ///< [V'] world. Analytic projection does not use them.
  /// [V'] 1/L, 0: none (rise.h); empty: none anywhere. For bodies that muscles do not wrap.
  std::span<const float> inverseLimits = {};
};

/// The control vertices that go to the implicit surface.
struct ImplicitWeights {
  std::vector<float> omega;  ///< [V] 1 or 0 (paper 3.3).
  bool wraps = true;         ///< Muscles wrap the body.
  int unwrapped = 0;         ///< Vertices within the influence that keep the skin because muscles do not wrap the body.
};

/// Weights from the bind pose. The paper assumes that muscles wrap the body: anchors are inside the implicit surface
/// (4.2). Here they do if that holds for 70 % of the control vertices within the influence. Then omega is 1 where a
/// vertex is within the influence and has a projection within the search length, else 0. On other bodies the muscles
/// lie in the skin: omega is 1 where a vertex is inside a muscle. A muscle that only touches the skin pulls nothing in,
/// which would tear the skin.  @param flat  of the bind pose; its first V entries are read.
void implicitWeights(const ControlMesh& mesh, const FieldView& bindField, const ReplaceSettings& settings,
                     const FlatVertices& flat, ProjectionScratch& scratch, ImplicitWeights& weights);

// Constants of the scalar and the vector path.
inline constexpr float kFadeBegin = 0.8f;        ///< Fraction of the search length beyond which weights fade.
inline constexpr float kFullProminence = 0.25f;  ///< Fraction of T from which an interval has full weight.
/// Tenths of an interval at which F - T is sampled, until the largest is enough; likely large values come first.
inline constexpr std::array<int, 9> kProminenceSamples{5, 3, 7, 2, 8, 4, 6, 1, 9};
inline constexpr int kMostIntervals = 8;  ///< Along one ray; more are noise.

/// Roots composited front to back.
struct Replaced {
  glm::vec3 position{0.0f};  ///< Weighted sum.
  glm::vec3 normal{0.0f};    ///< Weighted sum.
  float weight = 0.0f;       ///< Sum of weights, 0..1; the patch has the rest.
};

/// Moves a vertex from its patch. @param omega  of the vertex.  @param inverseLimit  of its rise; 0: none.
void placeReplaced(const Replaced& replaced, float omega, float inverseLimit, std::size_t vertex, Surface& surface);

/// p' = w p_implicit + (1 - w) p_normal, w = omega faded over the last part of the search length; likewise normals.
/// `surface` holds the patch on entry. Vertices with omega > 0 and no root stay on it and count as unresolved. On a
/// body that muscles do not wrap, skin that rises beyond half its limit is drawn in below the limit, as in `swell`.
void replace(const ControlMesh& mesh, const FieldView& field, const ReplaceSettings& settings, const FlatVertices& flat,
             const ImplicitWeights& weights, Surface& surface, ProjectionScratch& scratch);

void replaceVertex(const CarriedVertex& vertex, const FieldView& field, const ReplaceSettings& settings,
                   const FlatVertices& flat, const ImplicitWeights& weights, Surface& surface, VertexScratch& scratch);

}  // namespace sinew
