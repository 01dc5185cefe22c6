// core/files/fit/weight_fit.h: at most four weights a vertex, fitted to the live surface over many poses.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/files/fit/poses.h"
#include "core/geometry/instruction_set.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew::exporting {

// One vertex: at most four weights, >= 0, sum 1, least squares.

inline constexpr std::size_t kMostCandidates = 16;

/// Symmetric; rows and columns are candidates.
using Gram = std::array<std::array<double, kMostCandidates>, kMostCandidates>;
using CandidateWeights = std::array<double, kMostCandidates>;

/// w^T G w: the sum of squared distances, where G holds the dot products of the candidates' offsets from the target.
[[nodiscard]] double energyOf(const Gram& gram, const CandidateWeights& weights, std::size_t count);

/// Minimizes w^T G w + mu |w - near|^2 with w >= 0, sum 1 and at most four not 0. Exact: tries every choice of up to
/// four candidates, and takes the best of those whose own minimum has no weight below 0.
/// @param gram  positive semidefinite  @param count  candidates in use, 1..kMostCandidates  @param mu  > 0
[[nodiscard]] CandidateWeights bestWeights(const Gram& gram, std::size_t count, double mu,
                                           const CandidateWeights& near);

inline constexpr int kMostWeights = 4;  ///< Per vertex, as engines support.

/// Weights of one vertex, the largest first, > 0, sum 1 up to rounding; unused ones are 0 on binding -1. Bindings of
/// the skeleton are followed by the joints that the export adds, in order (HelperJoint).
struct FourWeights {
  std::array<int, kMostWeights> binding{-1, -1, -1, -1};
  std::array<float, kMostWeights> weight{};

  friend bool operator==(const FourWeights&, const FourWeights&) = default;
};

/// One binding's weight, before rounding.
struct Share {
  int binding = 0;
  double weight = 0.0;
};

/// Adds to the weight of a binding. @param shares  sorted by binding
void addShare(std::vector<Share>& shares, int binding, double weight);

/// The four largest (the lower binding of equals), scaled to sum 1. @param shares  each binding once; some weight > 0
[[nodiscard]] FourWeights fourLargest(std::vector<Share> shares);

/// [refined vertices] barycentric mean of the weights of the control triangle's corners. Sorted by binding.
[[nodiscard]] std::vector<std::vector<Share>> interpolatedWeights(const ControlMesh& mesh,
                                                                  const Refinement& refinement);

/// [bindings] from the bind pose to a pose.
void bindingMatrices(const Skeleton& skeleton, const Pose& pose, std::vector<glm::dmat4>& out);

/// The affine matrix times (x, y, z, 1). Inline, where glm's product is a call.
[[nodiscard]] inline glm::dvec3 carryPoint(const glm::dmat4& matrix, const glm::dvec3& point) {
  return (glm::dvec3(matrix[0]) * point.x + glm::dvec3(matrix[1]) * point.y) +
         (glm::dvec3(matrix[2]) * point.z + glm::dvec3(matrix[3]));
}

/// Linear blend skinning of a point of the bind pose.
[[nodiscard]] glm::dvec3 skinPoint(std::span<const glm::dmat4> matrices, const FourWeights& weights,
                                   const glm::dvec3& point);

// Sums over poses, by instruction set.

struct PoseToFit {
  std::span<const glm::dmat4> matrices;  ///< [bindings, helpers] world of the bind pose -> world now.
  std::span<const glm::vec3> live;       ///< [count] vertices of the live surface; world.
  bool further = false;                  ///< May count less.
};

/// Poses in a block: their matrices stay in the cache while it visits all vertices.
inline constexpr std::size_t kPosesAtOnce = 16;

/// Gram matrices, and poses to add to them.
struct GramSums {
  std::span<const glm::vec3> rest;          ///< [count]
  std::span<const std::vector<int>> lists;  ///< [count] at most kMostCandidates each.
  std::span<const std::size_t> begin;       ///< [count+1] into `own` and `further`.
  double* own = nullptr;                    ///< Lower triangles, row by row.
  double* further = nullptr;                ///< The same of further poses.
  std::span<const PoseToFit> poses;
};

inline constexpr std::size_t kHelperGroup = 8;  ///< Helpers in a group.

/// How much of a vertex's error each helper alone could remove, summed over poses.
struct GainSums {
  std::span<const glm::vec3> rest;       ///< [count]
  std::span<const FourWeights> weights;  ///< [count]
  std::span<const PoseToFit> poses;      ///< Further ones are skipped.
  std::size_t stride = 0;                ///< Helpers, rounded up to groups.
  const double* helpers = nullptr;       ///< [poses][4 columns][3 rows][stride] their matrices.
  double* toward = nullptr;              ///< [count][stride] sums of (live - now) . (helper's - now).
  double* length = nullptr;              ///< [count][stride] sums of |helper's - now|^2.
};

/// For the vertices first..end. All sets give the same bits.
struct FitKernels {
  void (*addGrams)(const GramSums& sums, std::size_t first, std::size_t end) = nullptr;
  void (*addGains)(const GainSums& sums, std::size_t first, std::size_t end) = nullptr;
};

[[nodiscard]] FitKernels fitKernels(InstructionSet set);

// The fit.

/// Weights of a vertex by least squares over poses: w minimizes sum_f |sum_j w_j (M_jf v - y_f)|^2, where M_jf are the
/// skinning matrices and y_f the live vertex, with w >= 0, sum w = 1 and at most four not 0. The sum is a quadratic
/// form, so only its Gram matrix over the candidates is kept, whatever the number of poses, and minimized exactly by
/// bestWeights(). Covers vertices 0..count of the refinement. docs/export.md, "How weights are fitted".
class WeightFit {
 public:
  /// @param rest        [count] the exported bind pose
  /// @param candidates  [count] bindings, including those of `start`
  /// @param start       [count] initial weights; the fit is never worse
  WeightFit(std::vector<glm::vec3> rest, std::vector<std::vector<int>> candidates, std::vector<FourWeights> start);

  /// Adds a pose with the vertices of the live surface. @param further  solve() may count it less
  void add(std::span<const glm::dmat4> matrices, std::span<const glm::vec3> live, bool further);

  /// First the best weights of all candidates, then two sweeps that pull each vertex slightly towards the mean of its
  /// neighbors, among the candidates that it, they or its initial weights use. Over all poses, counted alike, no vertex
  /// is farther off than with its initial weights (up to rounding to floats).
  /// @param furtherShare  weight of a further pose relative to others, above 0, at most 1; increased where necessary
  /// @param tolerance  a distance; vertices this near with their initial weights keep them
  /// @param triangles  between the vertices; those with a corner beyond `count` are skipped
  [[nodiscard]] std::vector<FourWeights> solve(std::span<const std::array<int, 3>> triangles, double furtherShare,
                                               double tolerance, const StageProgress& progress);

 private:
  struct Vertex;

  /// A copy of a pose: poses are added to the sums in blocks.
  struct Kept {
    std::vector<glm::dmat4> matrices;
    std::vector<glm::vec3> live;
    bool further = false;
  };

  void addKept();
  [[nodiscard]] Gram gramOf(std::size_t vertex, double ownShare, double furtherShare) const;
  [[nodiscard]] CandidateWeights solveAmong(const Vertex& vertex, const Gram& gram, const CandidateWeights& near) const;
  [[nodiscard]] CandidateWeights notWorse(std::size_t index, const Vertex& vertex, const CandidateWeights& near,
                                          double furtherShare) const;
  [[nodiscard]] CandidateWeights meanOf(std::size_t vertex, const std::vector<int>& neighbors,
                                        const std::vector<FourWeights>& current) const;
  [[nodiscard]] FourWeights fourOf(std::size_t vertex, const CandidateWeights& weights) const;

  std::vector<glm::vec3> rest_;
  std::vector<std::vector<int>> candidates_;
  std::vector<FourWeights> start_;
  std::vector<std::size_t> begin_;  ///< [count+1] into own_ and further_.
  double poses_ = 0.0;
  std::vector<Kept> kept_;       ///< Up to kPosesAtOnce.
  std::size_t used_ = 0;         ///< Number of poses not in the sums yet.
  std::vector<double> own_;      ///< Lower triangles of the Gram matrices, row by row.
  std::vector<double> further_;  ///< Over further poses.
};

}  // namespace sinew::exporting
