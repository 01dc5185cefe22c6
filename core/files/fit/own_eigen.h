// core/files/fit/own_eigen.h: Eigen under another name.
#pragma once

// A program that links Sinew may use another version of Eigen, or one for other vectors. Eigen is templates, and the
// linker would keep one of each name.
#define Eigen sinew_eigen
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#undef Eigen

namespace sinew {
namespace Eigen = ::sinew_eigen;
}
