// core/files/fit/weight_fit.h: weights fitted to the live surface, pose by pose, then solved for at once.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/files/fit/fit_kernel.h"
#include "core/files/fit/four_weights.h"
#include "core/files/fit/poses.h"

namespace sinew::exporting {

/// Weights of a vertex by least squares over poses: w minimizes sum_f |sum_j w_j (M_jf v - y_f)|^2, where M_jf are the
/// skinning matrices and y_f the live vertex, with w >= 0, sum w = 1 and at most four not 0. The sum is a quadratic
/// form, so only its Gram matrix over the candidates is kept, however many poses there are, and the form is minimized
/// exactly (best_weights.h). Vertices 0..count of the refinement take part. docs/export.md, "How weights are fitted".
class WeightFit {
 public:
  /// @param rest        [count] the bind pose that is exported
  /// @param candidates  [count] bindings, those of `start` among them
  /// @param start       [count] weights to begin with; the fit is never worse than they are
  WeightFit(std::vector<glm::vec3> rest, std::vector<std::vector<int>> candidates, std::vector<FourWeights> start);

  /// Adds a pose: where the live surface has the vertices.
  /// @param further  one of those that solve() may count less
  void add(std::span<const glm::dmat4> matrices, std::span<const glm::vec3> live, bool further);

  /// The weights: first the best of all candidates, then two sweeps that draw each vertex's a little to the mean of its
  /// neighbors', with the candidates that it, they, or the weights it starts with follow. Over all poses, each counted
  /// alike, no vertex is farther off than with the weights it starts with (but for the rounding of weights to floats).
  /// @param furtherShare  what a further pose counts beside any other, above 0, at most 1; more where that is needed
  /// @param tolerance  a distance; vertices that come as near with the weights they start with keep them
  /// @param triangles  between the vertices; those with a corner beyond `count` are skipped
  [[nodiscard]] std::vector<FourWeights> solve(std::span<const std::array<int, 3>> triangles, double furtherShare,
                                               double tolerance, const StageProgress& progress);

 private:
  struct Vertex;

  /// A pose's own copy: poses are added to the sums in blocks.
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
  [[nodiscard]] CandidateWeights startOf(std::size_t vertex) const;
  [[nodiscard]] FourWeights fourOf(std::size_t vertex, const CandidateWeights& weights) const;

  std::vector<glm::vec3> rest_;
  std::vector<std::vector<int>> candidates_;
  std::vector<FourWeights> start_;
  std::vector<std::size_t> begin_;  ///< [count+1] into own_ and further_.
  double poses_ = 0.0;
  std::vector<Kept> kept_;       ///< Up to kPosesAtOnce.
  std::size_t used_ = 0;         ///< So many of them are not in the sums yet.
  std::vector<double> own_;      ///< Lower triangles of the Gram matrices, row by row.
  std::vector<double> further_;  ///< The same over further poses.
};

}  // namespace sinew::exporting
