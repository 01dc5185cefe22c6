// core/bodies/sculpt_settling.cpp: Levenberg-Marquardt.
#include "core/bodies/sculpt_settling.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew {
namespace {

constexpr double kEdgeWeight = 0.01;  ///< Of differences over an edge's length, times H.
constexpr double kLeastGain = 3e-4;   ///< Of the cost, for a further step.
constexpr int kMostDampings = 7;
constexpr std::size_t kEquationParts = 8;  ///< Added up in order, whatever the number of threads.

}  // namespace

SculptResiduals::SculptResiduals(const SkinPoints& points, const SculptHeights& sculpt, float height)
    : points_(points), sculpt_(sculpt) {
  for (std::size_t v = 0; v < points.size(); ++v) {
    const bool isCompared = points.movable[v] != 0 && sculpt.known[v] != 0;
    areas_.push_back(isCompared ? static_cast<double>(points.areas[v]) : 0.0);
    along_.push_back(static_cast<double>(std::max(glm::dot(points.normals[v], points.directions[v]), 0.2f)));
  }
  for (const auto& [a, b] : points.edges) {
    const double length = static_cast<double>(glm::distance(at(points.positions, a), at(points.positions, b)));
    const double area = at(areas_, a) > 0.0 && at(areas_, b) > 0.0 ? (at(areas_, a) + at(areas_, b)) / 6.0 : 0.0;
    ofEdge_.push_back(length > 0.0 ? kEdgeWeight * static_cast<double>(height) / length * std::sqrt(area) : 0.0);
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double bare = along_[v] * static_cast<double>(sculpt.heights[v]);
    whole_ += areas_[v] * bare * bare;
  }
}

double SculptResiduals::left(std::size_t point, std::span<const float> heights) const {
  return along_[point] * static_cast<double>(sculpt_.heights[point] - heights[point]);
}

double SculptResiduals::cost(std::span<const float> heights) const {
  double sum = 0.0;
  for (std::size_t v = 0; v < areas_.size(); ++v) {
    const double own = left(v, heights);
    sum += areas_[v] * own * own;
  }
  for (std::size_t e = 0; e < ofEdge_.size(); ++e) {
    if (ofEdge_[e] == 0.0) continue;
    const auto& [a, b] = points_.edges[e];
    const double difference = ofEdge_[e] * (left(toIndex(a), heights) - left(toIndex(b), heights));
    sum += difference * difference;
  }
  return sum;
}

void SculptResiduals::addTo(FitEquations& equations, std::span<const ResidualRow> rows,
                            std::span<const float> heights) const {
  const std::size_t points = areas_.size();
  const std::size_t count = points + ofEdge_.size();
  std::vector<FitEquations> parts(kEquationParts, FitEquations(equations.size() / kFitNumbers));
  forEachIndex(kEquationParts, 1, [&](std::size_t part) {
    for (std::size_t i = count * part / kEquationParts; i < count * (part + 1) / kEquationParts; ++i) {
      if (i < points) {
        if (areas_[i] > 0.0) parts[part].add(rows[i], std::sqrt(areas_[i]) * along_[i], left(i, heights) / along_[i]);
        continue;
      }
      const std::size_t e = i - points;
      const auto a = toIndex(points_.edges[e][0]);
      const auto b = toIndex(points_.edges[e][1]);
      if (ofEdge_[e] == 0.0 || (rows[a].empty() && rows[b].empty())) continue;
      const ResidualRow row = sumOfRows(rows[a], static_cast<float>(-along_[b] / along_[a]), rows[b]);
      parts[part].add(row, ofEdge_[e] * along_[a], (left(a, heights) - left(b, heights)) / along_[a]);
    }
  });
  for (const FitEquations& part : parts) equations.add(part);
}

SculptSettling::SculptSettling(HeightModel& model, const SculptResiduals& residuals, const FitMuscles& muscles, Rig rig,
                               float hold)
    : model_(model), residuals_(residuals), muscles_(muscles), rig_(std::move(rig)) {
  pull_ = static_cast<double>(hold) * static_cast<double>(hold) * residuals.wholeCost() /
          static_cast<double>(std::max<std::size_t>(muscles.size(), 1));
  cost_ = cost(rig_);
}

double SculptSettling::cost(const Rig& rig) const {
  double drifted = 0.0;
  for (const double each : muscles_.drift(rig)) drifted += each * each;
  return residuals_.cost(model_.heights()) + pull_ * drifted;
}

FitEquations SculptSettling::equations() const {
  const auto changes = model_.changes();
  std::vector<ResidualRow> rows(changes.size());
  forEachIndex(rows.size(), 256, [&](std::size_t v) { rows[v] = muscles_.rowOf(changes[v]); });
  FitEquations out(muscles_.size());
  residuals_.addTo(out, rows, model_.heights());
  const std::vector<double> drift = muscles_.drift(rig_);
  const std::vector<double> rates = muscles_.driftRates();
  for (std::size_t i = 0; i < drift.size(); ++i) {
    out.addToNumber(i, pull_ * rates[i] * rates[i], -pull_ * rates[i] * drift[i]);
  }
  return out;
}

bool SculptSettling::step() {
  const FitEquations now = equations();
  const std::vector<double> rates = muscles_.driftRates();
  double most = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) most = std::max(most, now.diagonalAt(i) / (rates[i] * rates[i]));
  if (!(most > 0.0)) return false;
  for (int round = 0; round < kMostDampings; ++round, damping_ *= 4.0) {
    std::vector<double> added;
    for (std::size_t i = 0; i < now.size(); ++i) {
      added.push_back(damping_ * (now.diagonalAt(i) + 1e-6 * most * rates[i] * rates[i]));
    }
    Rig trial = muscles_.moved(rig_, now.solved(added));
    if (!model_.raise(trial)) continue;
    const double next = cost(trial);
    if (!(next < cost_)) continue;
    const double gain = (cost_ - next) / cost_;
    rig_ = std::move(trial);
    cost_ = next;
    damping_ = std::max(damping_ / 4.0, 1e-6);
    return gain >= kLeastGain;
  }
  (void)model_.raise(rig_);
  return false;
}

}  // namespace sinew
