// tests/support/oracle/math.cpp: plain textbook formulas in double; nothing is shared with the code under test.

#include "tests/support/oracle/math.h"

#include <algorithm>

namespace sinew::oracle {
namespace {

double component(const Vec& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

double bisect(const Function& f, double a, double b) {
  const bool positiveAtA = f(a) > 0.0;
  for (int i = 0; i < 200 && std::abs(b - a) > 1e-15 * (1.0 + std::abs(a) + std::abs(b)); ++i) {
    const double middle = 0.5 * (a + b);
    ((f(middle) > 0.0) == positiveAtA ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

/// Where side * f is least on [a, b], by ternary search; one dip is assumed.
double extremum(const Function& f, double side, double a, double b) {
  for (int i = 0; i < 60; ++i) {
    const double left = a + (b - a) / 3.0;
    const double right = b - (b - a) / 3.0;
    const bool lowerOnTheLeft = side * f(left) < side * f(right);
    (lowerOnTheLeft ? b : a) = lowerOnTheLeft ? right : left;
  }
  return 0.5 * (a + b);
}

}  // namespace

Vec unitOr(const Vec& v, const Vec& fallback) {
  const double size = length(v);
  return size > 1e-300 && std::isfinite(size) ? (1.0 / size) * v : fallback;
}

Vec operator*(const Mat& m, const Vec& v) { return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)}; }

Mat transpose(const Mat& m) {
  return {{{{m.row[0].x, m.row[1].x, m.row[2].x},
            {m.row[0].y, m.row[1].y, m.row[2].y},
            {m.row[0].z, m.row[1].z, m.row[2].z}}}};
}

Mat operator*(const Mat& a, const Mat& b) {
  const Mat columns = transpose(b);
  Mat out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.row[i] = {dot(a.row[i], columns.row[0]), dot(a.row[i], columns.row[1]), dot(a.row[i], columns.row[2])};
  }
  return out;
}

Mat cofactors(const Mat& m) {
  Mat out;
  std::array<double, 9> c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec& r1 = m.row[(i + 1) % 3];
      const Vec& r2 = m.row[(i + 2) % 3];
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      c[3 * i + static_cast<std::size_t>(j)] =
          component(r1, j1) * component(r2, j2) - component(r1, j2) * component(r2, j1);
    }
    out.row[i] = {c[3 * i], c[3 * i + 1], c[3 * i + 2]};
  }
  return out;
}

double determinant(const Mat& m) { return dot(m.row[0], cofactors(m).row[0]); }

Mat inverse(const Mat& m) {
  Mat out = transpose(cofactors(m));
  const double scale = 1.0 / determinant(m);
  for (Vec& row : out.row) row = scale * row;
  return out;
}

Mat rotation(const glm::quat& q) {
  const double w = static_cast<double>(q.w);
  const Vec v{static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z)};
  const double n = w * w + dot(v, v);
  // (w^2 - v.v) I + 2 v v^T + 2 w [v]x, over the squared length.
  const double d = (w * w - dot(v, v)) / n;
  const double s = 2.0 / n;
  return {{{{d + s * v.x * v.x, s * (v.x * v.y - w * v.z), s * (v.x * v.z + w * v.y)},
            {s * (v.x * v.y + w * v.z), d + s * v.y * v.y, s * (v.y * v.z - w * v.x)},
            {s * (v.x * v.z - w * v.y), s * (v.y * v.z + w * v.x), d + s * v.z * v.z}}}};
}

Affine affine(const glm::mat4& m) {
  const auto at = [&](int row, int column) { return static_cast<double>(m[column][row]); };
  Affine out;
  for (int i = 0; i < 3; ++i) out.linear.row[static_cast<std::size_t>(i)] = {at(i, 0), at(i, 1), at(i, 2)};
  out.offset = {at(0, 3), at(1, 3), at(2, 3)};
  return out;
}

Vec apply(const Affine& a, const Vec& point) { return a.linear * point + a.offset; }

Affine compose(const Affine& outer, const Affine& inner) {
  return {outer.linear * inner.linear, apply(outer, inner.offset)};
}

Affine scaledSum(const Affine& sum, double weight, const Affine& term) {
  Affine out = sum;
  for (std::size_t i = 0; i < 3; ++i) out.linear.row[i] = sum.linear.row[i] + weight * term.linear.row[i];
  out.offset = sum.offset + weight * term.offset;
  return out;
}

Affine zeroAffine() { return {{{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}}, {0, 0, 0}}; }

std::vector<double> signChanges(const Function& f, double from, double to, int steps, int most) {
  std::vector<double> roots;
  const auto take = [&](double a, double b) {
    if (static_cast<int>(roots.size()) < most) roots.push_back(bisect(f, a, b));
  };
  const double step = (to - from) / steps;
  double t0 = from;
  double t1 = from;
  double f0 = f(from);
  double f1 = f0;
  // A start on the surface takes the sign it has just after it.
  if (f1 == 0.0) f0 = f1 = f(from + 1e-9 * (to - from));
  for (int i = 1; i <= steps && static_cast<int>(roots.size()) < most; ++i) {
    const double t2 = i == steps ? to : from + i * step;
    const double f2 = f(t2);
    const double side = f1 > 0.0 ? 1.0 : -1.0;
    if ((f2 > 0.0) != (f1 > 0.0)) {
      take(t1, t2);
    } else if (i > 1 && (f0 > 0.0) == (f1 > 0.0) && side * f1 < side * f0 && side * f1 <= side * f2) {
      // No sign change seen, but the middle sample comes nearest to zero: a pair may hide around it.
      const double dip = extremum(f, side, t0, t2);
      if ((f(dip) > 0.0) != (f1 > 0.0)) {
        take(t0, dip);
        take(dip, t2);
      }
    }
    t0 = t1;
    f0 = f1;
    t1 = t2;
    f1 = f2;
  }
  return roots;
}

}  // namespace sinew::oracle
