// core/surface/projection/swell.h: the default mode: skin rises over the muscles. docs/design.md, Swell.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/formulas.h"
#include "core/surface/projection/projection_scratch.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::in_double {

/// Heights below overhangs.  @tparam Psi  (s) -> psi and its derivative, a Sample.
template <class Psi>
struct Overhangs {
  using Rays = const Psi&;
  static Sample psiAt(Rays psi, Real s) { return psi(s); }
#define formula static
#include "core/geometry/formulas/overhang.h"
#undef formula
};

}  // namespace sinew::in_double

namespace sinew {

inline constexpr float kLeastAlong = 0.2f;  ///< Cosine of rise direction and normal that divides slopes, at the least.

struct RiseView {
  std::span<const glm::vec3> directions;  ///< [V'] world, unit, outward (rise.h).
  std::span<const float> inverseLimits;   ///< [V'] 1/L, 0: none (rise.h).
};

/// Constants of one character and rig.
struct SwellSettings {
  float iso = kDefaultIso;
  float blendWidth = 0.04f;  ///< Largest h, world units; a smaller muscle blends over its mean radius.
  ProjectionKind projection = ProjectionKind::kNewton;
  double tolerance = 1e-6;  ///< Tolerance of roots, world units.
};

/// Moves positions from the patch along the directions d to the first root of f_skin(s) + F(p + s d) - T, outwards from
/// s = 0; inwards where F(p) < 0, down to s = -r_T W at most. A root beyond half the rise limit, or half of
/// inverseTouchLimit(), is drawn in below that limit (limitedRise). Moved vertices get the field's normal at the root:
/// exact, and finer than the mesh can show (shading_normals.h). Vertices with F(p) = 0 stay. Fills displacement (s) and
/// the counts of the report.
void swell(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
           Surface& surface, ProjectionScratch& scratch);

void swellVertex(const CarriedVertex& vertex, const FieldView& field, const SwellSettings& settings,
                 const RiseView& rise, Surface& surface, VertexScratch& scratch);

/// How a height changes with the field of one muscle.
struct HeightSlope {
  int primitive = 0;
  float atTop = 0.0f;   ///< d height / d f_i at the root.
  float onSkin = 0.0f;  ///< The same on the patch, where the limit over muscles that only touch the skin is made.
};
struct HeightSlopes {
  glm::vec3 top{0.0f};  ///< The root; below an overhang, what is left of it. World.
  std::vector<HeightSlope> of;
};

/// Slopes of the height that swell() has found at a vertex, other muscles and all blend widths staying as they are.
/// Empty where it is 0.  @param patch  the vertex on its patch, world  @param height  Surface::displacement
void heightSlopes(const CarriedVertex& vertex, const FieldView& field, const SwellSettings& settings,
                  const RiseView& rise, const glm::vec3& patch, float height, VertexScratch& scratch,
                  HeightSlopes& out);

}  // namespace sinew
