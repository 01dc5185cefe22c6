// tests/support/oracle/line.h: the virtual bone of docs/muscles.md, formula by formula, in double.
#pragma once

#include "core/rig/line_rest.h"

namespace sinew::oracle {

struct Line {
  glm::dmat4 deformation{1.0};
  glm::dvec3 origin{0.0};
  glm::dvec3 insertion{0.0};
  glm::dvec3 via{0.0};
  glm::dvec3 height{0.0};
  double stretch = 1.0;
  double bellyStretch = 1.0;
  double activation = 0.0;
  double agreement = 1.0;  ///< Cosine of half the angle between the frames that both bones carry: 0 has no mixture.
};

double girth(double bellyStretch, const LineSettings& settings);

/// In a pose whose bones are all usable. Motions are BoneMotion's.
Line posedLine(const LineRest& rest, const Skeleton& skeleton, const Pose& pose, double flex);

}  // namespace sinew::oracle
