// core/geometry/flatness.h: whether a matrix leaves three dimensions.
#pragma once

#include <glm/mat3x3.hpp>

namespace sinew {

/// The columns span no volume, but for what rounding to float leaves: their determinant is at most a millionth of the
/// product of their lengths. Scale, even or uneven along the columns, does not matter. True for what is not finite.
/// One answer for all: a bone whose muscles can be edited is one whose muscles can be mirrored and are seen.
[[nodiscard]] bool isFlat(const glm::dmat3& matrix);

}  // namespace sinew
