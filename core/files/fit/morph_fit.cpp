// core/files/fit/morph_fit.cpp: the residual of skinning as displacements in the bind pose, and the search for targets.
#include "core/files/fit/morph_fit.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/files/fit/own_eigen.h"
#include "core/files/fit/played_surface.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew::exporting {
namespace {

/// Determinant of a blend, relative to a rotation of the same size, below which its inverse is damped ...
constexpr double kSingular = 0.01;
constexpr double kDamping = 1e-4;  ///< ... by this, of the mean square of its singular values.
constexpr double kReaders = 1e-6;  ///< Fraction of the height that other readers' arithmetic may differ by ...
/// ... and of the distance from the origin: products of matrices, and a sum for each vertex.
constexpr double kReadersFar = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
constexpr std::size_t kLeastMorphRange = 1024;  ///< Vertices per thread, at least.

/// B^-1 way, damped where the blend B is nearly singular.
glm::dvec3 beforeSkinning(const glm::dmat3& blend, const glm::dvec3& way) {
  const double square =
      (glm::dot(blend[0], blend[0]) + glm::dot(blend[1], blend[1]) + glm::dot(blend[2], blend[2])) / 3;
  if (square <= 0.0) return glm::dvec3(0.0);
  if (std::abs(glm::determinant(blend)) > kSingular * square * std::sqrt(square)) return glm::inverse(blend) * way;
  const glm::dmat3 transposed = glm::transpose(blend);
  return glm::inverse(transposed * blend + glm::dmat3(kDamping * square)) * (transposed * way);
}

}  // namespace

glm::dmat3 blendedMatrix(std::span<const glm::dmat4> matrices, const FourWeights& weights) {
  glm::dmat3 blend(0.0);
  for (std::size_t i = 0; i < kMostWeights && weights.binding[i] >= 0; ++i) {
    blend += static_cast<double>(weights.weight[i]) * glm::dmat3(at(matrices, weights.binding[i]));
  }
  return blend;
}

MorphFit::MorphFit(std::vector<MorphVertex> vertices, std::vector<glm::dmat3> meshToBind, double height)
    : vertices_(std::move(vertices)), meshToBind_(std::move(meshToBind)), height_(height) {
  for (const glm::dmat3& matrix : meshToBind_) bindToMesh_.push_back(glm::inverse(matrix));
  for (const MorphVertex& vertex : vertices_) {
    reach_ = std::max({reach_, vertex.reach, glm::length(vertex.rest)});
  }
}

void MorphFit::add(std::vector<glm::dmat4> matrices, std::span<const glm::vec3> live) {
  Frame frame{std::move(matrices), {}, {}};
  frame.live.resize(vertices_.size());
  frame.wanted.resize(3 * vertices_.size());
  forEachIndex(vertices_.size(), kLeastMorphRange, [&](std::size_t v) {
    const MorphVertex& vertex = vertices_[v];
    const glm::vec3& place = live[toIndex(vertex.refined)];
    const glm::dvec3 way = glm::dvec3(place) - skinPoint(frame.matrices, vertex.weights, vertex.rest);
    const glm::dvec3 wanted = beforeSkinning(blendedMatrix(frame.matrices, vertex.weights), way);
    frame.live[v] = place;
    for (int axis = 0; axis < 3; ++axis) frame.wanted[3 * v + toIndex(axis)] = static_cast<float>(wanted[axis]);
  });
  for (const glm::vec3& place : frame.live) reach_ = std::max(reach_, glm::length(glm::dvec3(place)));
  frames_.push_back(std::move(frame));
}

double MorphFit::coarseness() const { return std::max(kReaders * height_, kReadersFar * reach_); }

ErrorFigures MorphFit::skinnedFigures() const {
  ErrorMeter meter(height_);
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    const Frame& frame = frames_[f];
    meter.addPose(0, static_cast<float>(f));
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      const MorphVertex& vertex = vertices_[v];
      meter.add(glm::distance(skinPoint(frame.matrices, vertex.weights, vertex.rest), glm::dvec3(frame.live[v])),
                vertex.refined);
    }
  }
  return meter.figures();
}

// The search: principal components over time, as few as are enough.

namespace {

constexpr int kSearchRounds = 24;  ///< Rounds of reweighting.
/// Approximate limit of products for all Gram matrices: with many vertices and frames fewer rounds, at least 1.
constexpr double kMostProducts = 3e10;
constexpr int kFutile = 6;            ///< Rounds without improvement before the search ends.
constexpr double kLeastShare = 0.05;  ///< Least weight factor of a vertex, relative to one at the bound.
constexpr double kSparsest = 0.25;    ///< Entries below this fraction of the bound are dropped, if the bound allows.
constexpr double kDensest = 1.0 / 256.0;
constexpr std::size_t kBlock = 2048;  ///< Vertices in a block of a thread.
constexpr Eigen::Index kRows = 768;   ///< Rows in a block of the Gram matrix.

}  // namespace

/// The fewest morph targets that keep every vertex in every frame within a bound.
///
/// The residual of skinning is a matrix of displacements, vertices by frames. Its principal components are the best
/// targets by least squares; they come from the eigenvectors of its Gram matrix over frames, which is small. The bound
/// is on the maximum, though, so vertices that are far off get more weight and the components are computed again
/// (Lawson's iteratively reweighted least squares, 1961), which needs fewer targets. Distances are those of a reader of
/// the file's numbers, so that the bound holds there.
class MorphSearch {
 public:
  MorphSearch(const MorphFit& fit, double bound, const StageProgress& progress)
      : fit_(fit), progress_(progress), asked_(bound), bound_(bound - fit.coarseness()) {}

  std::optional<MorphTargets> run() {
    if (isWithin(Shapes{})) return targetsOf({});
    squares_ = Eigen::VectorXd::Ones(vertexCount());
    const auto frames = static_cast<double>(frameCount());
    const double affordable = kMostProducts / (static_cast<double>(rows()) * frames * frames);
    const int rounds = static_cast<int>(std::clamp(affordable, 1.0, static_cast<double>(kSearchRounds)));
    for (int round = 0, futile = 0; round < rounds && futile < kFutile && best_ != 1; ++round, ++futile) {
      part_ = round / (rounds + 1.0);
      Basis basis = principal();
      const Eigen::Index most = best_ > 0 ? best_ - 1 : frameCount();
      Eigen::Index targets = 1;
      while (targets <= most && !isWithin(basis.first(targets, *this))) ++targets;
      if (targets > most && best_ == 0) return exact(basis);
      if (targets <= most) {
        best_ = targets;
        whole_ = std::move(basis);
        futile = -1;
      }
      if (round + 1 < rounds) countFarOnesMore((futile < 0 ? whole_ : basis).first(best_ - 1, *this));
    }
    part_ = rounds / (rounds + 1.0);
    return targetsOf(sparsest());
  }

 private:
  /// Weights over time, 0..1, and shapes, rounded as in the file.
  struct Shapes {
    Eigen::MatrixXf weights;  ///< [frames, targets]
    Eigen::MatrixXf deltas;   ///< [3 vertices, targets] in the bind pose.

    Eigen::Index targets() const { return weights.cols(); }
  };
  struct ShapesView {
    ShapesView(const Shapes& shapes) : weights(shapes.weights), deltas(shapes.deltas) {}  // NOLINT: as a span
    ShapesView(const Eigen::Ref<const Eigen::MatrixXf>& w, const Eigen::Ref<const Eigen::MatrixXf>& d)
        : weights(w), deltas(d) {}
    Eigen::Ref<const Eigen::MatrixXf> weights;
    Eigen::Ref<const Eigen::MatrixXf> deltas;
  };

  /// A constant target, then the components of the motion, the largest first, computed on demand.
  struct Basis {
    Eigen::MatrixXd over;    ///< [frames, frames - 1] orthonormal columns of sum 0.
    Eigen::MatrixXf exact;   ///< [3 vertices, made ...] in the bind pose; the first: the mean.
    Shapes shapes;           ///< `exact` rounded as in files; columns beyond `made` are undefined.
    std::vector<float> low;  ///< [made] offset at a weight of 0, in units of the shape.

    ShapesView first(Eigen::Index targets, const MorphSearch& search) {
      constexpr Eigen::Index kAhead = 16;
      for (auto made = static_cast<Eigen::Index>(low.size()); made < targets; ++made) {
        if (made == exact.cols()) {
          exact.conservativeResize(search.rows(), made + kAhead);
          shapes.deltas.conservativeResize(search.rows(), made + kAhead);
          shapes.weights.conservativeResize(search.frameCount(), made + kAhead);
        }
        low.push_back(made == 0 ? search.makeStill(shapes.weights.col(0), exact.col(0))
                                : search.makeComponent(over.col(made - 1), shapes.weights.col(made), exact.col(made)));
        shapes.deltas.col(made) = exact.col(made);
        search.round(shapes.deltas.col(made), kDensest * search.asked_);
      }
      shapes.deltas.col(0) = still(targets);
      search.round(shapes.deltas.col(0), kDensest * search.asked_);
      return {shapes.weights.leftCols(targets), shapes.deltas.leftCols(targets)};
    }

    /// Drops entries below a length.
    [[nodiscard]] Shapes dropSmall(Eigen::Index targets, const MorphSearch& search, double below) const {
      Shapes result{shapes.weights.leftCols(targets), exact.leftCols(targets)};
      result.deltas.col(0) = still(targets);
      for (Eigen::Index k = 0; k < targets; ++k) search.round(result.deltas.col(k), below);
      return result;
    }

    /// The mean and the offsets of the other targets at weights of 0.
    [[nodiscard]] Eigen::VectorXf still(Eigen::Index targets) const {
      const Eigen::Map<const Eigen::VectorXf> parts(low.data(), targets);
      return exact.leftCols(targets) * parts;
    }
  };

  [[nodiscard]] Eigen::Index frameCount() const { return static_cast<Eigen::Index>(fit_.frames_.size()); }
  [[nodiscard]] Eigen::Index vertexCount() const { return static_cast<Eigen::Index>(fit_.vertices_.size()); }
  [[nodiscard]] Eigen::Index rows() const { return 3 * vertexCount(); }

  [[nodiscard]] Eigen::Map<const Eigen::VectorXf> wanted(Eigen::Index frame) const {
    return {fit_.frames_[static_cast<std::size_t>(frame)].wanted.data(), rows()};
  }

  [[nodiscard]] Basis principal() const {
    const Eigen::Index frames = frameCount();
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(frames, frames);
    for (Eigen::Index row = 0; row < rows(); row += kRows) {
      const Eigen::Index count = std::min(kRows, rows() - row);
      Eigen::MatrixXd block(count, frames);
      for (Eigen::Index f = 0; f < frames; ++f) block.col(f) = wanted(f).segment(row, count).cast<double>();
      for (Eigen::Index r = 0; r < count; ++r) block.row(r) *= std::sqrt(squares_[(row + r) / 3]);
      gram.selfadjointView<Eigen::Lower>().rankUpdate(block.transpose());
    }
    gram.triangularView<Eigen::Upper>() = gram.transpose();
    const Eigen::VectorXd means = gram.rowwise().mean();
    gram.colwise() -= means;
    gram.rowwise() -= (means.array() - means.mean()).matrix().transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
    return {solver.eigenvectors().rowwise().reverse().leftCols(frames - 1), {}, {}, {}};
  }

  /// The mean, with weights of 1.
  float makeStill(Eigen::Ref<Eigen::VectorXf> weights, Eigen::Ref<Eigen::VectorXf> mean) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(rows());
    for (Eigen::Index f = 0; f < frameCount(); ++f) sum += wanted(f).cast<double>();
    mean = (sum / static_cast<double>(frameCount())).cast<float>();
    weights.setOnes();
    return 1.0f;
  }

  /// A component with weights from 0 to 1: programs clamp others, and they bound the loss of a dropped entry. Returns
  /// the offset at 0.
  float makeComponent(const Eigen::VectorXd& over, Eigen::Ref<Eigen::VectorXf> weights,
                      Eigen::Ref<Eigen::VectorXf> deltas) const {
    const double low = over.minCoeff();
    const double range = std::max(over.maxCoeff() - low, std::numeric_limits<double>::min());
    weights = ((over.array() - low) / range).matrix().cast<float>();
    forEachBlock([&](std::size_t begin, std::size_t end) {
      const auto row = static_cast<Eigen::Index>(3 * begin);
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * (end - begin)));
      for (Eigen::Index f = 0; f < frameCount(); ++f) {
        sum += range * over[f] * wanted(f).segment(row, sum.size()).cast<double>();
      }
      deltas.segment(row, sum.size()) = sum.cast<float>();
    });
    return static_cast<float>(low / range);
  }

  [[nodiscard]] glm::vec3 inMesh(std::size_t vertex, const float* delta) const {
    const glm::dvec3 way(static_cast<double>(delta[0]), static_cast<double>(delta[1]), static_cast<double>(delta[2]));
    return glm::vec3(at(fit_.bindToMesh_, fit_.vertices_[vertex].space) * way);
  }

  /// Rounds a target as the file does in its mesh spaces.
  void round(Eigen::Ref<Eigen::VectorXf> target, double drop) const {
    forEachIndex(fit_.vertices_.size(), kBlock, [&](std::size_t v) {
      float* delta = target.data() + 3 * v;
      const glm::vec3 written = inMesh(v, delta);
      const glm::dvec3 read = at(fit_.meshToBind_, fit_.vertices_[v].space) * glm::dvec3(written);
      const bool isDropped = glm::length(read) < drop;
      for (int axis = 0; axis < 3; ++axis) delta[axis] = isDropped ? 0.0f : static_cast<float>(read[axis]);
    });
  }

  /// Calls use(vertex, distance) for vertices of a frame until it returns false. True if it never does.
  template <class Use>
  bool forEachDistance(const ShapesView& shapes, std::size_t frame, std::size_t begin, std::size_t end, Use use) const {
    const MorphFit::Frame& at = fit_.frames_[frame];
    const auto firstRow = static_cast<Eigen::Index>(3 * begin);
    Eigen::VectorXf moved = Eigen::VectorXf::Zero(static_cast<Eigen::Index>(3 * (end - begin)));
    if (shapes.weights.cols() > 0) {
      moved.noalias() = shapes.deltas.middleRows(firstRow, moved.size()) *
                        shapes.weights.row(static_cast<Eigen::Index>(frame)).transpose();
    }
    for (std::size_t v = begin; v < end; ++v) {
      const MorphVertex& vertex = fit_.vertices_[v];
      const float* delta = moved.data() + 3 * (v - begin);
      const glm::dvec3 point = vertex.rest + glm::dvec3(glm::vec3(delta[0], delta[1], delta[2]));
      if (!use(v, glm::distance(skinPoint(at.matrices, vertex.weights, point), glm::dvec3(at.live[v])))) return false;
    }
    return true;
  }

  /// Calls use(begin, end) for blocks of vertices that fit the cache for all frames.
  template <class Use>
  void forEachBlock(Use use) const {
    const std::size_t count = fit_.vertices_.size();
    forEachIndex((count + kBlock - 1) / kBlock, 1,
                 [&](std::size_t block) { use(block * kBlock, std::min(count, (block + 1) * kBlock)); });
  }

  /// Number of consecutive frames within the bound, from `worst_` on, of `frames`.
  [[nodiscard]] std::size_t framesWithin(const ShapesView& shapes, std::size_t frames) const {
    std::atomic<std::size_t> within = frames;
    forEachBlock([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = 0; i < within; ++i) {
        const std::size_t frame = (worst_ + i) % fit_.frames_.size();
        const auto isNear = [&](std::size_t, double distance) { return distance <= bound_; };
        if (forEachDistance(shapes, frame, begin, end, isNear)) continue;
        std::size_t now = within;
        while (i < now && !within.compare_exchange_weak(now, i)) {
        }
        return;
      }
    });
    return within;
  }

  /// Tests the frame that failed last first: it rejects most candidates.
  [[nodiscard]] bool isWithin(const ShapesView& shapes) {
    progress_.tell(part_);
    const std::size_t frames = fit_.frames_.size();
    if (framesWithin(shapes, std::min<std::size_t>(frames, 1)) == 0) return frames == 0;
    const std::size_t within = framesWithin(shapes, frames);
    if (within == frames) return true;
    worst_ = (worst_ + within) % frames;
    return false;
  }

  /// Lawson's step from least squares to the minimal maximum.
  void countFarOnesMore(const ShapesView& shapes) {
    Eigen::VectorXd farthest = Eigen::VectorXd::Zero(vertexCount());
    forEachBlock([&](std::size_t begin, std::size_t end) {
      for (std::size_t frame = 0; frame < fit_.frames_.size(); ++frame) {
        forEachDistance(shapes, frame, begin, end, [&](std::size_t v, double distance) {
          double& own = farthest[static_cast<Eigen::Index>(v)];
          own = std::max(own, distance);
          return true;
        });
      }
    });
    squares_ = squares_.cwiseProduct((farthest / bound_).cwiseMax(kLeastShare));
    squares_ *= static_cast<double>(vertexCount()) / squares_.sum();
  }

  /// Drops entries as large as the bound allows.
  Shapes sparsest() {
    for (double share = kSparsest; share > kDensest; share /= 2.0) {
      Shapes shapes = whole_.dropSmall(best_, *this, share * asked_);
      if (isWithin(shapes)) return shapes;
    }
    return whole_.dropSmall(best_, *this, kDensest * asked_);
  }

  /// One target per frame, nothing dropped.
  std::optional<MorphTargets> exact(const Basis& basis) {
    const Shapes shapes = basis.dropSmall(frameCount(), *this, 0.0);
    if (!isWithin(shapes)) return std::nullopt;
    return targetsOf(shapes);
  }

  [[nodiscard]] MorphTargets targetsOf(const Shapes& shapes) const {
    MorphTargets result;
    result.count = static_cast<int>(shapes.targets());
    ErrorMeter meter(fit_.height_);
    std::vector<double> distances(fit_.vertices_.size());
    for (std::size_t frame = 0; frame < fit_.frames_.size(); ++frame) {
      meter.addPose(0, static_cast<float>(frame));
      forEachBlock([&](std::size_t begin, std::size_t end) {
        forEachDistance(shapes, frame, begin, end, [&](std::size_t v, double distance) {
          distances[v] = distance;
          return true;
        });
      });
      for (std::size_t v = 0; v < distances.size(); ++v) meter.add(distances[v], fit_.vertices_[v].refined);
    }
    result.figures = meter.figures();
    if (result.count == 0) return result;
    for (Eigen::Index f = 0; f < frameCount(); ++f) {
      for (Eigen::Index k = 0; k < shapes.targets(); ++k) result.weights.push_back(shapes.weights(f, k));
    }
    const Eigen::MatrixXd over = shapes.weights.cast<double>();
    const Eigen::MatrixXd shares = (over.transpose() * over).ldlt().solve(over.transpose());
    for (Eigen::Index k = 0; k < shapes.targets(); ++k) {
      for (Eigen::Index f = 0; f < frameCount(); ++f) result.shares.push_back(shares(k, f));
      std::vector<glm::vec3>& deltas = result.deltas.emplace_back();
      for (std::size_t v = 0; v < fit_.vertices_.size(); ++v) {
        deltas.push_back(inMesh(v, shapes.deltas.col(k).data() + 3 * v));
      }
    }
    return result;
  }

  const MorphFit& fit_;
  const StageProgress& progress_;
  double asked_;
  double bound_;
  Eigen::VectorXd squares_;  ///< [vertices] weights.
  double part_ = 0.0;        ///< Fraction of the search that is done.
  Eigen::Index best_ = 0;    ///< Fewest targets so far; 0: none found yet.
  Basis whole_;              ///< Their basis.
  std::size_t worst_ = 0;
};

std::optional<MorphTargets> MorphFit::solve(double bound, const StageProgress& progress) const {
  return MorphSearch(*this, bound, progress).run();
}

}  // namespace sinew::exporting
