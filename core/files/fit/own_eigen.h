// core/files/fit/own_eigen.h: Eigen under a name of Sinew's own.
#pragma once

// Eigen is templates alone. A program that links Sinew may have its own, of another version or made for other vectors,
// and the linker keeps one of each name.
#define Eigen sinew_eigen
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#undef Eigen

namespace sinew {
namespace Eigen = ::sinew_eigen;
}
