// core/geometry/formulas.h: the formulas of core/geometry/formulas as scalars, in single and in double precision.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

// Each formula is one text for three number types: scalars here, lanes in core/geometry/lanes.h, and shaders in
// shaders/compute/numbers.glsl. It is a function over Real, Real3 and Mask, without references, templates or branches
// on data: select() in their place, num() around literals. `formula` and `constant` stand for what each compiler wants
// there.
#define formula [[maybe_unused]] [[nodiscard]] inline
#define constant constexpr

namespace sinew::scalar_operations {

using std::abs;
using std::clamp;
using std::max;
using std::min;
using std::sqrt;

using glm::cross;
using glm::dot;

using Mask = bool;
constexpr bool both(bool a, bool b) { return a && b; }
constexpr bool any(bool mask) { return mask; }
template <class T>
constexpr T select(bool mask, const T& yes, const T& no) {
  return mask ? yes : no;
}
/// 0 up to `from`, 1 from `to` on, between them 3 t^2 - 2 t^3. from < to.
template <class T>
T smoothstep(T from, T to, T x) {
  const T t = std::clamp((x - from) / (to - from), T(0), T(1));
  return t * t * (T(3) - T(2) * t);
}

}  // namespace sinew::scalar_operations

namespace sinew::in_float {
using namespace scalar_operations;
using Real = float;
using Real3 = glm::vec3;
constexpr Real num(double value) { return static_cast<Real>(value); }
#include "core/geometry/formulas/finish.h"
#include "core/geometry/formulas/potential.h"
#include "core/geometry/formulas/rise.h"
#include "core/geometry/formulas/shape.h"
}  // namespace sinew::in_float

namespace sinew::in_double {
using namespace scalar_operations;
using Real = double;
using Real3 = glm::dvec3;
constexpr Real num(double value) { return value; }
#include "core/geometry/formulas/finish.h"
#include "core/geometry/formulas/potential.h"
#include "core/geometry/formulas/rise.h"
#include "core/geometry/formulas/shape.h"
}  // namespace sinew::in_double

#undef formula
#undef constant
