// tests/support/oracle/oracle.h: expected position of every refined vertex in double precision, by brute force.
//
// Written from docs/design.md and the paper only. It shares no code with the smoothing: own skinning, patches, field,
// anchors and root search (thousands of samples and bisection). Slow by design; tests evaluate some of the vertices.
#pragma once

#include <array>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/projection_kind.h"
#include "sinew/surface/refinement.h"
#include "tests/support/oracle/field.h"
#include "tests/support/oracle/patch.h"

namespace sinew::oracle {

/// A refined vertex as a weighted mean of control vertices.
struct Site {
  std::array<int, 3> vertices{};
  std::array<double, 3> barycentric{};  ///< Sum 1; on an edge the last is 0, at a control vertex the last two.
};

/// @param vertex of the refinement, numbered as its header says.
Site siteOf(const ControlMesh& mesh, const Refinement& refinement, int vertex);

struct Answer {
  Vec position;
  Vec normal;  ///< Unit.
  PatchPoint patch;
  double field = 0.0;       ///< F at the start of the ray, territories counted.
  double nearest = 0.0;     ///< Smallest r of a primitive at the patch point; >= 1: none reaches it.
  double offset = 0.0;      ///< Signed distance along the ray to the root that was taken.
  double blendWidth = 0.0;  ///< `swell`: h there.
  double lead = 0.0;        ///< Field::lead at the position: near 0 the gradient is on a crease.
  double weight = 1.0;      ///< `replace`: share of the projected position, fade included.
  bool sought = false;      ///< A root was looked for.
  bool resolved = false;
  bool limited = false;   ///< `replace`: below the root, because other skin is near.
  bool fellBack = false;  ///< `replace`: the anchor was not inside, so the normal was followed.
  Vec rayOrigin;
  Vec rayDirection;                  ///< Unit.
  std::vector<double> fieldWeights;  ///< m_i there.
  std::vector<double> shares;        ///< `replace`: of each stretch along the lines, as they were laid.
  std::vector<double> roots;         ///< Every root along the ray the other choices could have meant.
};

class Oracle {
 public:
  Oracle(const Character& character, const Rig& rig, ProjectionKind projection = ProjectionKind::kNewton);

  void pose(const Pose& pose);
  [[nodiscard]] Answer evaluate(const Site& site) const;
  /// What the mode solves for zero, at a distance along the answer's ray.
  [[nodiscard]] double phiAt(const Answer& answer, double t) const;
  [[nodiscard]] const Field& field() const { return field_; }
  [[nodiscard]] const ControlMesh& mesh() const { return character_.mesh; }
  /// m_i at a site.
  [[nodiscard]] std::vector<double> weightsAt(const Site& site) const;
  /// omega of a control vertex, `replace` only.
  [[nodiscard]] double omega(int vertex) const { return omega_[static_cast<std::size_t>(vertex)]; }
  [[nodiscard]] bool swells() const { return rig_.surface.mode == SurfaceMode::kSwell; }
  /// Neither guarded nor shaded anew: `replace` on a body that muscles wrap.
  [[nodiscard]] bool standsAsProjected() const { return rig_.surface.mode == SurfaceMode::kReplace && wraps_; }
  /// Unit rise direction at a site in the pose.
  [[nodiscard]] Vec riseAt(const Site& site) const;

 private:
  struct Anchor {
    int bone = 0;
    Vec inBone;
  };
  /// One stretch of F > T on a ray: where it begins as seen from outside.
  struct Layer {
    Vec point;
    double t = 0.0;    ///< Distance from the start, along `inwards` of its Line.
    double own = 0.0;  ///< Share it takes of what is left in front of it.
  };
  struct Line {
    Vec origin;
    Vec inwards;  ///< Unit.
    double length = 0.0;
    bool inside = false;  ///< The origin has F > T.
  };
  struct Hit {
    std::vector<Layer> layers;
    bool fellBack = false;
    Line line;  ///< The first one followed.
    [[nodiscard]] bool found() const { return !layers.empty(); }
    /// Share that the first `count` layers leave over: the product of 1 - own.
    [[nodiscard]] double leftBehind(std::size_t count) const;
    [[nodiscard]] double left() const;
  };
  /// @param outwardsAlone  the stretches further in do not count.
  void lay(const Line& line, const std::vector<double>& weights, Hit& hit, bool outwardsAlone = false) const;
  [[nodiscard]] double isoRadius() const;  ///< r_T
  /// s / W + r_T, not below 0.
  [[nodiscard]] double skinRadius(double s, double blendWidth) const;
  [[nodiscard]] double inverseLimitAt(const Site& site) const;
  [[nodiscard]] Corners cornersOf(const Site& site) const;
  [[nodiscard]] Anchor anchorOf(const Vec& bindPoint) const;
  [[nodiscard]] Answer swell(const Site& site) const;
  [[nodiscard]] Answer replace(const Site& site) const;
  [[nodiscard]] Hit project(const PatchPoint& flat, const Vec& anchor, const std::vector<double>& weights) const;
  [[nodiscard]] Vec anchorInWorld(const Site& site) const;
  /// Along the normal, of a vertex inside the implicit surface: the body is not wrapped.
  [[nodiscard]] Hit projectOutwards(const PatchPoint& flat, const std::vector<double>& weights) const;
  void findOmegas();
  [[nodiscard]] bool findWhetherWrapped() const;

  const Character& character_;
  Rig rig_;
  ProjectionKind projection_;
  Field field_;
  double height_ = 1.0;
  bool wraps_ = false;                              ///< `replace`: muscles wrap the body.
  std::vector<std::vector<double>> vertexWeights_;  ///< [V][primitives]
  std::vector<double> omega_;                       ///< [V]
  std::vector<Vec> riseInBind_;                     ///< [V]
  std::vector<double> inverseLimits_;               ///< [V]
  std::vector<Affine> bones_;                       ///< [bones] posed.
  std::vector<Vec> positions_;                      ///< [V] posed.
  std::vector<Vec> normals_;                        ///< [V] posed.
  std::vector<Vec> rise_;                           ///< [V] posed.
};

}  // namespace sinew::oracle
