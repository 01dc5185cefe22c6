// core/files/fit/fit_kernel.h: the sums over poses that fits ask for most, by instruction set.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/files/fit/four_weights.h"
#include "core/geometry/instruction_set.h"

namespace sinew::exporting {

/// A pose that weights are fitted to.
struct PoseToFit {
  std::span<const glm::dmat4> matrices;  ///< [bindings, helpers] from the bind pose's world to the pose's.
  std::span<const glm::vec3> live;       ///< [count] where the live surface has the vertices; world.
  bool further = false;                  ///< One that may count less.
};

/// So many poses at a time: their matrices stay in the cache while the vertices go by.
inline constexpr std::size_t kPosesAtOnce = 16;

/// Gram matrices, to which poses are added.
struct GramSums {
  std::span<const glm::vec3> rest;          ///< [count]
  std::span<const std::vector<int>> lists;  ///< [count] candidates, at most kMostCandidates.
  std::span<const std::size_t> begin;       ///< [count+1] into the two below.
  double* own = nullptr;                    ///< Lower triangles, row by row.
  double* further = nullptr;                ///< The same of further poses.
  std::span<const PoseToFit> poses;
};

/// Helpers are looked at in groups of so many.
inline constexpr std::size_t kHelperGroup = 8;

/// What each helper alone could do about a vertex's error, summed over poses.
struct GainSums {
  std::span<const glm::vec3> rest;       ///< [count]
  std::span<const FourWeights> weights;  ///< [count]
  std::span<const PoseToFit> poses;      ///< Further ones are passed over.
  std::size_t stride = 0;                ///< Helpers, rounded up to whole groups.
  const double* helpers = nullptr;       ///< [poses][4 columns][3 rows][stride] their matrices.
  double* toward = nullptr;              ///< [count][stride] sums of (live - now) . (helper's - now).
  double* length = nullptr;              ///< [count][stride] sums of |helper's - now|^2.
};

/// Each for the vertices first..end. All sets give the same bits.
struct FitKernels {
  void (*addGrams)(const GramSums& sums, std::size_t first, std::size_t end) = nullptr;
  void (*addGains)(const GainSums& sums, std::size_t first, std::size_t end) = nullptr;
};

[[nodiscard]] FitKernels fitKernels(InstructionSet set);

}  // namespace sinew::exporting
