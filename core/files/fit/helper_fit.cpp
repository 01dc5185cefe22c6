// core/files/fit/helper_fit.cpp: places helpers where the error is, then alternates between weights and motions.
#include "core/files/fit/helper_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew::exporting {
namespace {

constexpr double kSpare = 0.5;                 ///< Extra rigid helpers; the least useful joints are dropped.
constexpr double kHelperFitReach = 0.08;       ///< Times H: initial reach of a helper around its seed.
constexpr int kRounds = 4;                     ///< Rounds of placing helpers.
constexpr int kDrops = 3;                      ///< Rounds of dropping the least useful ones.
constexpr int kTurns = 3;                      ///< Solutions for weights and motions after each round.
constexpr int kLastTurns = 8;                  ///< After all rounds.
constexpr std::size_t kMostSeeds = 400;        ///< Vertices to consider as seeds.
constexpr std::size_t kMostGains = 4;          ///< New helpers that a vertex may use after a turn.
constexpr double kTolerance = 1e-5;            ///< Times H: vertices this near are not fitted.
constexpr std::size_t kLeastHelperRange = 64;  ///< Vertices per thread, at least.
constexpr float kAlmostAlone = 0.99f;          ///< A weight that leaves nothing to the others.

/// Smooth skinning decomposition (Le and Deng, "Smooth Skinning Decomposition with Rigid Bones", 2012) with given
/// joints: solves weights and rigid motions in turn, each by least squares with the other fixed. The paper starts from
/// clusters of vertices; here a helper starts where the joints leave the largest error. More are placed than asked for,
/// and the least useful are dropped in rounds, since the best ones show only after fitting.
class HelperFit {
 public:
  HelperFit(const HelperTask& task, std::vector<FourWeights> start)
      : task_(task),
        start_(std::move(start)),
        weights_(start_),
        first_(static_cast<int>(task.skeleton.bindings.size())),
        lines_(static_cast<int>(task.lines.size())),
        dropped_(task.lines.size(), false) {
    for (const FitPose& pose : task.poses) {
      matrices_.push_back(pose.matrices);
      locals_.emplace_back();
    }
  }

  HelperResult run(int most, const StageProgress& progress) {
    const int wanted = most == 0 ? 0 : most + static_cast<int>(kSpare * most);
    const int turns = kRounds * kTurns + kDrops * kTurns + kLastTurns;
    int done = 0;
    const auto turn = [&] {
      progress.tell(static_cast<double>(done++) / turns);
      solveWeights();
      solveMotions();
    };
    for (int round = 0; round < kRounds; ++round) {
      place(wanted * (round + 1) / kRounds - static_cast<int>(rigid_.size()));
      for (int i = 0; i < kTurns; ++i) turn();
    }
    const int all = inUse();
    for (int round = 0; round < kDrops; ++round) {
      drop(inUse() - most - (all - most) * (kDrops - 1 - round) / kDrops);
      for (int i = 0; i < kTurns; ++i) turn();
    }
    for (int i = 0; i < kLastTurns; ++i) turn();
    solveWeights();
    drop(inUse() - most);
    return result();
  }

 private:
  [[nodiscard]] int inUse() const { return static_cast<int>(std::ranges::count(dropped_, false)); }
  [[nodiscard]] std::size_t helpers() const { return dropped_.size(); }

  /// Calls use(pose, vertex) for all, with the poses of each vertex in order.
  template <class Use>
  void forEachInEachPose(const Use& use) const {
    forRanges(task_.rest.size(), kLeastHelperRange, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = 0; f < task_.poses.size(); ++f) {
        for (std::size_t v = begin; v < end; ++v) use(f, v);
      }
    });
  }

  /// Calls use(poses) for blocks of poses, in order.
  template <class Use>
  void forBlocks(const Use& use) const {
    std::vector<PoseToFit> block;
    for (std::size_t f = 0; f < task_.poses.size(); ++f) {
      block.push_back({matrices_[f], task_.poses[f].live, task_.poses[f].further});
      if (block.size() < kPosesAtOnce && f + 1 < task_.poses.size()) continue;
      use(block);
      block.clear();
    }
  }

  /// The helpers' matrices for GainSums.
  [[nodiscard]] std::vector<double> helperNumbers(std::span<const PoseToFit> poses, std::size_t stride) const {
    std::vector<double> numbers(poses.size() * 12 * stride, 0.0);
    double* row = numbers.data();
    for (const PoseToFit& pose : poses) {
      const auto own = pose.matrices.subspan(toIndex(first_));
      for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 3; ++r, row += stride) {
          for (std::size_t h = 0; h < own.size(); ++h) row[h] = own[h][c][r];
        }
      }
    }
    return numbers;
  }

  /// Drops the least useful helpers; their vertices keep their other weights.
  void drop(int many) {
    if (many <= 0) return;
    const std::vector<double> losses = lossesWithout();
    std::vector<int> order;
    for (std::size_t h = 0; h < helpers(); ++h) {
      if (!dropped_[h]) order.push_back(static_cast<int>(h));
    }
    std::ranges::sort(order, {}, [&](int h) { return std::pair(losses[toIndex(h)], -h); });
    order.resize(toIndex(std::min(many, static_cast<int>(order.size()))));
    for (const int h : order) dropped_[toIndex(h)] = true;
    for (std::size_t v = 0; v < weights_.size(); ++v) {
      std::vector<Share> shares;
      for (std::size_t i = 0; i < kMostWeights && weights_[v].binding[i] >= 0; ++i) {
        const int binding = weights_[v].binding[i];
        if (binding < first_ || !dropped_[toIndex(binding - first_)])
          shares.push_back({binding, static_cast<double>(weights_[v].weight[i])});
      }
      weights_[v] = shares.empty() ? start_[v] : fourLargest(std::move(shares));
    }
  }

  /// [helpers] approximate increase of the sum of squared distances without each.
  [[nodiscard]] std::vector<double> lossesWithout() const {
    std::vector<double> losses(helpers(), 0.0);
    const std::size_t n = task_.rest.size();
    std::vector<double> now(n, 0.0);
    std::vector<double> plain(n, 0.0);
    std::vector<std::array<double, kMostWeights>> shared(n);
    for (auto& four : shared) four.fill(0.0);
    forEachInEachPose([&](std::size_t f, std::size_t v) {
      const double counts = task_.poses[f].further ? task_.furtherShare : 1.0;
      const FourWeights& w = weights_[v];
      if (std::ranges::none_of(w.binding, [&](int b) { return b >= first_; })) return;
      const glm::dvec3 point(task_.rest[v]);
      const glm::dvec3 live(task_.poses[f].live[v]);
      const glm::dvec3 off = skinPoint(matrices_[f], w, point) - live;
      const glm::dvec3 offPlain = skinPoint(matrices_[f], start_[v], point) - live;
      now[v] += counts * glm::dot(off, off);
      plain[v] += counts * glm::dot(offPlain, offPlain);
      for (std::size_t i = 0; i < kMostWeights && w.binding[i] >= 0; ++i) {
        if (w.binding[i] < first_ || w.weight[i] > kAlmostAlone) continue;
        const auto share = static_cast<double>(w.weight[i]);
        const glm::dvec3 own = carryPoint(matrices_[f][toIndex(w.binding[i])], point);
        const glm::dvec3 rest = (off - share * (own - live)) / (1.0 - share);
        shared[v][i] += counts * glm::dot(rest, rest);
      }
    });
    for (std::size_t v = 0; v < n; ++v) {
      for (std::size_t i = 0; i < kMostWeights && weights_[v].binding[i] >= 0; ++i) {
        if (weights_[v].binding[i] < first_) continue;
        const double without = weights_[v].weight[i] > kAlmostAlone ? plain[v] : std::min(plain[v], shared[v][i]);
        losses[toIndex(weights_[v].binding[i] - first_)] += without - now[v];
      }
    }
    return losses;
  }

  /// Renumbers the helpers in use.
  [[nodiscard]] HelperResult result() {
    HelperResult result;
    std::vector<int> place(helpers(), -1);
    int next = first_;
    for (std::size_t h = 0; h < helpers(); ++h) {
      if (!dropped_[h]) place[h] = next++;
    }
    for (int line = 0; line < lines_; ++line) result.keptLines.push_back(!dropped_[toIndex(line)]);
    for (std::size_t h = 0; h < rigid_.size(); ++h) {
      if (!dropped_[toIndex(lines_) + h]) result.helpers.push_back(rigid_[h]);
    }
    for (FourWeights& weights : weights_) {
      for (int& binding : weights.binding) {
        if (binding >= first_) binding = place[toIndex(binding - first_)];
      }
    }
    for (std::size_t h = 0; h < result.helpers.size(); ++h) {
      result.helpers[h].name = "muscle helper " + std::to_string(h + 1);
    }
    result.weights = std::move(weights_);
    return result;
  }

  /// [vertices] squared distances to the live surface over all poses except further ones.
  [[nodiscard]] std::vector<double> energies() const {
    std::vector<double> energies(task_.rest.size(), 0.0);
    forEachInEachPose([&](std::size_t f, std::size_t v) {
      if (task_.poses[f].further) return;
      const glm::dvec3 off =
          skinPoint(matrices_[f], weights_[v], glm::dvec3(task_.rest[v])) - glm::dvec3(task_.poses[f].live[v]);
      energies[v] += glm::dot(off, off);
    });
    return energies;
  }

  /// Weight of a vertex around a seed, 0..1.
  [[nodiscard]] double nearness(std::size_t vertex, int place) const {
    const double reach = kHelperFitReach * task_.height;
    const double distance = glm::distance(glm::dvec3(task_.rest[vertex]), glm::dvec3(task_.rest[toIndex(place)]));
    return std::max(0.0, 1.0 - distance / reach);
  }

  /// Places up to `many` helpers where the error is largest, far enough apart.
  void place(int many) {
    std::vector<double> energy = energies();
    for (int i = 0; i < many; ++i) {
      const int seed = bestSeed(energy);
      if (seed < 0) return;
      begin(seed, energy);
      for (std::size_t v = 0; v < energy.size(); ++v) energy[v] *= 1.0 - std::min(1.0, 2.0 * nearness(v, seed));
    }
  }

  [[nodiscard]] int bestSeed(const std::vector<double>& energy) const {
    const double tolerance = kTolerance * task_.height;
    const double least = tolerance * tolerance * static_cast<double>(task_.poses.size());
    std::vector<int> order;
    for (std::size_t v = 0; v < energy.size(); ++v) {
      if (energy[v] > least) order.push_back(static_cast<int>(v));
    }
    const std::size_t looked = std::min(order.size(), kMostSeeds);
    std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(looked), std::ranges::greater{},
                              [&](int v) { return std::pair(energy[toIndex(v)], -v); });
    int best = -1;
    double most = 0.0;
    for (std::size_t i = 0; i < looked; ++i) {
      double sum = 0.0;
      for (std::size_t v = 0; v < energy.size(); ++v) {
        if (energy[v] > 0.0) sum += energy[v] * nearness(v, order[i]);
      }
      if (sum > most) {
        most = sum;
        best = order[i];
      }
    }
    return best;
  }

  /// Adds a helper that moves as the live surface around a vertex.
  void begin(int seed, const std::vector<double>& energy) {
    std::vector<std::pair<int, double>> around;
    std::map<int, double> bones;
    glm::dvec3 middle(0.0);
    double all = 0.0;
    for (std::size_t v = 0; v < energy.size(); ++v) {
      const double counts = energy[v] * nearness(v, seed);
      if (!(counts > 0.0)) continue;
      around.emplace_back(static_cast<int>(v), counts);
      middle += counts * glm::dvec3(task_.rest[v]);
      all += counts;
      for (std::size_t i = 0; i < kMostWeights && start_[v].binding[i] >= 0; ++i) {
        bones[at(task_.skeleton.bindings, start_[v].binding[i]).bone] +=
            counts * static_cast<double>(start_[v].weight[i]);
      }
    }
    const int bone = std::ranges::max_element(bones, {}, [](const auto& entry) { return entry.second; })->first;
    const glm::dmat4 intoBone(at(task_.skeleton.bones, bone).inverseBindInWorld);
    Trs rest;
    rest.translation = carryPoint(intoBone, middle / all);
    rigid_.push_back(makeHelper({}, bone, rest, task_.skeleton));
    dropped_.push_back(false);
    const HelperJoint& helper = rigid_.back();
    const glm::dvec3 place = helper.rest.translation;
    for (std::size_t f = 0; f < task_.poses.size(); ++f) {
      const FitPose& pose = task_.poses[f];
      Trs local = helper.rest;
      const std::optional<glm::dmat4> intoPosed = fromWorld(pose.pose, bone);
      if (!pose.further && intoPosed) {
        RigidMotion motion;
        for (const auto& [v, counts] : around) {
          motion.add(carryPoint(intoBone, glm::dvec3(task_.rest[toIndex(v)])) - place,
                     carryPoint(*intoPosed, glm::dvec3(pose.live[toIndex(v)])) - place, counts);
        }
        const RigidMotion::Motion best = motion.best();
        local = roundToFloats({place + best.translation, best.rotation, glm::dvec3(1.0)});
      }
      locals_[f].push_back(local);
      matrices_[f].push_back(helperMatrix(helper, pose.pose, local));
    }
  }

  /// [vertices] candidates: bindings of the initial and current weights, and the helpers that alone remove most error.
  [[nodiscard]] std::vector<std::vector<int>> choices() const {
    const std::size_t n = task_.rest.size();
    const std::size_t helpers = this->helpers();
    const std::size_t stride = (helpers + kHelperGroup - 1) / kHelperGroup * kHelperGroup;
    std::vector<double> toward(n * stride, 0.0);
    std::vector<double> length(n * stride, 0.0);
    forBlocks([&](std::span<const PoseToFit> poses) {
      const std::vector<double> numbers = helperNumbers(poses, stride);
      const GainSums sums{task_.rest, weights_, poses, stride, numbers.data(), toward.data(), length.data()};
      const FitKernels kernels = fitKernels(chosenVectorSet());
      forRanges(n, kLeastHelperRange, [&](std::size_t first, std::size_t end) { kernels.addGains(sums, first, end); });
    });
    std::vector<std::vector<int>> result(n);
    for (std::size_t v = 0; v < n; ++v) {
      const auto add = [&](int binding) {
        if (std::ranges::find(result[v], binding) == result[v].end()) result[v].push_back(binding);
      };
      for (const FourWeights* follows : {&weights_[v], &start_[v]}) {
        for (std::size_t i = 0; i < kMostWeights && follows->binding[i] >= 0; ++i) add(follows->binding[i]);
      }
      std::vector<std::pair<double, int>> gains;
      for (std::size_t h = 0; h < helpers; ++h) {
        const double t = toward[v * stride + h];
        if (t > 0.0 && !dropped_[h]) gains.emplace_back(-t * t / length[v * stride + h], static_cast<int>(h));
      }
      std::ranges::sort(gains);
      for (std::size_t i = 0; i < std::min(kMostGains, gains.size()); ++i) add(first_ + gains[i].second);
    }
    return result;
  }

  void solveWeights() {
    WeightFit fit(std::vector<glm::vec3>(task_.rest.begin(), task_.rest.end()), choices(), weights_);
    for (std::size_t f = 0; f < task_.poses.size(); ++f) {
      fit.add(matrices_[f], task_.poses[f].live, task_.poses[f].further);
    }
    weights_ = fit.solve(task_.triangles, task_.furtherShare, kTolerance * task_.height, StageProgress({}));
  }

  void solveMotions() {
    const int firstRigid = first_ + lines_;
    const HelperMotion motion(task_.skeleton, task_.rest, weights_, rigid_, firstRigid);
    forEachIndex(task_.poses.size(), 1, [&](std::size_t f) {
      const FitPose& pose = task_.poses[f];
      if (pose.further) return;
      motion.solve(pose.pose, pose.matrices, pose.live, 1, locals_[f]);
      for (std::size_t h = 0; h < rigid_.size(); ++h) {
        matrices_[f][toIndex(firstRigid) + h] = helperMatrix(rigid_[h], pose.pose, locals_[f][h]);
      }
    });
  }

  const HelperTask& task_;
  std::vector<FourWeights> start_;
  std::vector<FourWeights> weights_;
  int first_ = 0;  ///< Binding of the first helper.
  int lines_ = 0;  ///< Joints of lines; rigid helpers come after them.
  std::vector<HelperJoint> rigid_;
  std::vector<bool> dropped_;                      ///< [helpers]
  std::vector<std::vector<Trs>> locals_;           ///< [poses][rigid helpers]
  std::vector<std::vector<glm::dmat4>> matrices_;  ///< [poses][bindings, helpers]
};

}  // namespace

HelperResult fitHelpers(const HelperTask& task, std::vector<FourWeights> start, int most,
                        const StageProgress& progress) {
  return HelperFit(task, std::move(start)).run(most, progress);
}

}  // namespace sinew::exporting
