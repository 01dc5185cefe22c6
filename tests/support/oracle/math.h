// tests/support/oracle/math.h: the oracle's own double-precision vectors, matrices and root search.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace sinew::oracle {

struct Vec {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

inline Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(const Vec& a) { return std::sqrt(dot(a, a)); }
inline Vec vec(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// v / |v|, or `fallback` where v has no direction.
Vec unitOr(const Vec& v, const Vec& fallback);

/// 3x3 by rows.
struct Mat {
  std::array<Vec, 3> row{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

Vec operator*(const Mat& m, const Vec& v);
Mat operator*(const Mat& a, const Mat& b);
Mat transpose(const Mat& m);
double determinant(const Mat& m);
/// Cofactors: determinant(m) times the inverse transpose.
Mat cofactors(const Mat& m);
/// The determinant must not be 0.
Mat inverse(const Mat& m);
/// Rotation by a quaternion of any length but 0.
Mat rotation(const glm::quat& q);

/// x -> linear x + offset.
struct Affine {
  Mat linear;
  Vec offset;
};

Affine affine(const glm::mat4& m);
Vec apply(const Affine& a, const Vec& point);
Affine compose(const Affine& outer, const Affine& inner);
Affine scaledSum(const Affine& sum, double weight, const Affine& term);  ///< sum + weight * term
Affine zeroAffine();

using Function = std::function<double(double)>;

/// Sign changes of f between `from` and `to` (either order), nearest to `from` first: `steps` even samples, every dip
/// or bump between samples that comes near zero is searched for hidden pairs, and each change is halved down to 1e-13
/// of the range. A zero at `from` itself is no change. Stops after `most` roots.
std::vector<double> signChanges(const Function& f, double from, double to, int steps, int most);

}  // namespace sinew::oracle
