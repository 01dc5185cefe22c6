// tests/geometry/flatness_test.cpp: matrices that span no volume.

#include "core/geometry/normals.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

TEST(IsFlat, DoesNotDependOnScale) {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::dmat3 turned(glm::mat3_cast(random.rotation()));
    for (const double scale : {1e-20, 1e-4, 1.0, 1e4, 1e20}) {
      EXPECT_FALSE(isFlat(scale * turned));
      // Columns may differ in length.
      EXPECT_FALSE(isFlat(glm::dmat3(scale * turned[0], turned[1], turned[2])));
      // Two columns in a line, up to float precision.
      EXPECT_TRUE(isFlat(scale * glm::dmat3(turned[0], turned[0] + 1e-7 * turned[1], turned[2])));
      EXPECT_FALSE(isFlat(scale * glm::dmat3(turned[0], turned[0] + 1e-4 * turned[1], turned[2])));
    }
  }
}

TEST(IsFlat, ZeroAndNonFiniteMatricesAreFlat) {
  EXPECT_TRUE(isFlat(glm::dmat3(0.0)));
  glm::dmat3 squashed(1.0);
  squashed[1] = glm::dvec3(0.0);
  EXPECT_TRUE(isFlat(squashed));
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    glm::dmat3 matrix(1.0);
    matrix[2][0] = bad;
    EXPECT_TRUE(isFlat(matrix));
  }
}

}  // namespace
}  // namespace sinew
