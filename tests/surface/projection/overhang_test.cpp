// tests/surface/projection/overhang_test.cpp: heights change no faster than psi, even where its root jumps.

#include "core/surface/projection/swell.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

using Psi = in_double::Sample;

constexpr double kBlendWidth = 0.4;

template <class Along>
double heightBelowOverhangs(double root, double sigma, const Along& psi) {
  return in_double::Overhangs<Along>::heightBelowOverhangs(psi, root, sigma, kBlendWidth, true);
}

/// (t - dip)^2 + least, times a factor that falls to 0 at 1.
struct Dipped {
  double dip = 0.0;
  double least = 0.0;

  Psi operator()(double t) const {
    const double squared = (t - dip) * (t - dip) + least;
    return {squared * (1.0 - t), 2.0 * (t - dip) * (1.0 - t) - squared};
  }
  /// The first root.
  [[nodiscard]] double root() const { return least < 0.0 ? dip - std::sqrt(-least) : 1.0; }
  [[nodiscard]] double height(double sigma) const { return heightBelowOverhangs(root(), sigma, *this); }
};

TEST(Overhang, SteepPsiKeepsTheRoot) {
  for (const double root : {1e-6, 0.05, 0.3, 2.0}) {
    const auto falls = [&](double t) { return Psi{root * root - t * t + root - t, -2.0 * t - 1.0}; };
    EXPECT_EQ(heightBelowOverhangs(root, 1.0, falls), root);
  }
}

TEST(Overhang, ShallowPsiGivesTheMinimumOfTheSum) {
  for (const double sigma : {0.03, 0.1, 0.4}) {
    for (const double dip : {0.11, 0.25, 0.4, 0.63}) {
      for (const double least : {-1e-2, -1e-6, 1e-6, 0.02, 0.2}) {
        const Dipped psi{dip, least};
        double expected = psi.root();
        for (double t = 0.0; t < psi.root(); t += 1e-5) expected = std::min(expected, t + psi(t).value / sigma);
        EXPECT_NEAR(psi.height(sigma), expected, 1e-4) << sigma << ' ' << dip << ' ' << least;
      }
    }
  }
}

// The root behaves like a square root up to the dip and jumps from there to 1.
TEST(Overhang, HeightIsLipschitzInPsiOverSigma) {
  constexpr double kChange = 1e-4;
  for (const double sigma : {0.1, 0.4}) {
    for (const double dip : {0.11, 0.25, 0.4, 0.63}) {
      double before = Dipped{dip, -0.01}.height(sigma);
      for (double least = -0.01 + kChange; least < 0.3; least += kChange) {
        const double height = Dipped{dip, least}.height(sigma);
        EXPECT_GE(height, before - 1e-6) << dip << ' ' << least;
        EXPECT_LE(height, before + 1.05 * kChange / sigma) << dip << ' ' << least;
        before = height;
      }
      EXPECT_EQ((Dipped{dip, 3.0}.height(sigma)), 1.0) << "and so it comes to the root";
    }
  }
}

/// Falls steeply due to one muscle, then slowly due to a second one before it rises: the maximum counts, as for
/// unlinked muscles.
struct Kinked {
  double kink = 0.0;
  double curvature = 0.0;
  double least = 0.0;

  Psi operator()(double t) const {
    const Psi steep{12.0 * (kink - t) + 0.01, -12.0};
    const double dip = kink + 0.03;
    const Psi slow{curvature * (t - dip) * (t - dip) * (1.0 - t) + least,
                   curvature * (t - dip) * (2.0 * (1.0 - t) - (t - dip))};
    return steep.value > slow.value ? steep : slow;
  }
  [[nodiscard]] double root() const {
    double t = 0.0;
    while (t < 2.0 && (*this)(t).value > 0.0) t += 1e-5;
    return t;
  }
  [[nodiscard]] double height(double sigma) const { return heightBelowOverhangs(root(), sigma, *this); }
};

// For unlinked muscles psi has kinks, and the derivatives on both sides may differ a hundredfold.
TEST(Overhang, MinimumIsFoundAtAKink) {
  for (const double sigma : {1.0, 2.0}) {
    for (const double kink : {0.11, 0.153, 0.17, 0.31}) {
      for (const double curvature : {1.0, 10.0, 60.0}) {
        double before = 0.0;
        for (const double least : {-1e-3, -1e-4, 1e-4, 1e-3, 2e-3}) {
          const Kinked psi{kink, curvature, least};
          const double root = psi.root();
          double expected = root;
          for (double t = 0.0; t < root; t += 1e-5) expected = std::min(expected, t + psi(t).value / sigma);
          const double height = psi.height(sigma);
          EXPECT_NEAR(height, expected, 2e-5) << sigma << ' ' << kink << ' ' << curvature << ' ' << least;
          if (before > 0.0) {
            EXPECT_NEAR(height, before, 1.2e-3 / sigma + 2e-5) << kink << ' ' << least;
          }
          before = height;
        }
      }
    }
  }
}

/// A muscle's field flattens towards its peak: steps based on derivatives alone get stuck there.
struct Peaked {
  double kink = 0.0;
  double steep = 0.0;
  double peak = 0.0;  ///< Half a wavelength.

  Psi operator()(double t) const {
    const Psi falls{steep * (kink - t) + 0.02, -steep};
    const double angle = 0.5 * 3.14159265358979 * (t - kink) / peak;
    const Psi hangs{0.02 + 0.4 * std::sin(angle), 0.4 * 0.5 * 3.14159265358979 / peak * std::cos(angle)};
    return falls.value > hangs.value ? falls : hangs;
  }
};

TEST(Overhang, MinimumIsFoundAtAKinkBelowAPeak) {
  for (const double steep : {2.0, 6.0, 20.0}) {
    for (const double kink : {0.11, 0.12, 0.153, 0.17}) {
      for (const double peak : {0.09, 0.12, 0.3}) {
        const Peaked psi{kink, steep, peak};
        const double root = kink + 2.0 * peak;  // Approximate; only what lies before it matters.
        EXPECT_NEAR(heightBelowOverhangs(root, 1.0, psi), kink + 0.02, 5e-3) << steep << ' ' << kink << ' ' << peak;
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
