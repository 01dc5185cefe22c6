// core/files/fit/own_eigen.h: Eigen under another name.
#pragma once

// A program may link another Eigen, or one for other vectors; the linker would keep one template of each name.
#define Eigen sinew_eigen
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#undef Eigen

namespace sinew {
namespace Eigen = ::sinew_eigen;
}
