// shaders/compute/numbers.glsl: the number types of the formulas (core/geometry/formulas.h): Real, which is float where a
// shader has not defined another, and Real3.
#ifndef Real
#define Real float
#define Real3 vec3
#endif
#define formula
#define constant const
#define Mask bool
#define num(x) Real(x)
#define any(mask) (mask)

bool both(bool a, bool b) { return a && b; }
Real select(bool mask, Real yes, Real no) { return mask ? yes : no; }
Real3 select(bool mask, Real3 yes, Real3 no) { return mask ? yes : no; }
