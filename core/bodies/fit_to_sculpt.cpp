// core/bodies/fit_to_sculpt.cpp: settles the muscles, then holds back those that the check would find.
#include "core/bodies/fit_to_sculpt.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/bodies/carve_places.h"
#include "core/bodies/check.h"
#include "core/bodies/fit_muscles.h"
#include "core/bodies/sculpt_heights.h"
#include "core/bodies/sculpt_settling.h"
#include "core/geometry/at.h"
#include "core/rig/sheet_edit.h"

namespace sinew {
namespace {

constexpr int kMostFitSteps = 40;
constexpr int kStepsOfRound = 12;
constexpr int kHoldRounds = 3;
constexpr int kCarveRounds = 2;
constexpr float kHoldMore = 4.0f;  ///< Factor on the pull of a muscle that is held back, a round.

std::set<int> musclesOf(const Rig& rig, const std::vector<Finding>& findings) {
  std::set<int> out;
  for (const Finding& finding : findings) {
    out.insert(finding.primitive);
    // Of a line the first muscle on it is named.
    const std::string& line = at(rig.primitives, finding.primitive).line;
    for (std::size_t i = 0; i < rig.primitives.size() && !line.empty(); ++i) {
      if (rig.primitives[i].line == line) out.insert(static_cast<int>(i));
    }
  }
  return out;
}

/// One fit, from its start to its report.
class SculptFitting {
 public:
  SculptFitting(const Rig& start, const SculptFitOptions& options, HeightModel& model, const SculptHeights& sculpt,
                const Motions& motions, float height)
      : options_(options),
        model_(model),
        motions_(motions),
        height_(static_cast<double>(height)),
        residuals_(model.points(), sculpt, height),
        foundBefore_(musclesOf(start, check(start, motions))) {}

  /// False: cancelled.
  [[nodiscard]] bool settle(FitMuscles& muscles, Rig& rig, int most, double from, double to) const {
    SculptSettling settling(model_, residuals_, muscles, rig, options_.hold);
    for (int step = 0; step < most; ++step) {
      if (!goesOn(from + (to - from) * step / most)) return false;
      if (!settling.step()) break;
    }
    rig = settling.rig();
    return true;
  }

  /// Adds carves, half of them first, and settles again. `start`: the same rig with the muscles as they were, which
  /// gets the same carves. False: cancelled.
  [[nodiscard]] bool addCarves(FitMuscles& muscles, Rig& start, Rig& rig, const Character& character,
                               const MirrorPlan* plan, double from, double to) const {
    for (int round = 0; round < kCarveRounds; ++round) {
      const int most = options_.carves * (round + 1) / kCarveRounds - options_.carves * round / kCarveRounds;
      const std::size_t before = rig.primitives.size();
      std::vector<float> hollows = left();
      for (float& each : hollows) each *= static_cast<float>(height_);
      start = withCarves(std::move(start), most, model_.points(), hollows, character, plan);
      Rig next = start;
      for (std::size_t i = 0; i < before; ++i) next.primitives[i] = rig.primitives[i];
      rig = std::move(next);
      muscles = FitMuscles(start, character, plan);
      if (!model_.raise(rig)) return false;
      const double begin = from + (to - from) * round / kCarveRounds;
      if (!settle(muscles, rig, kStepsOfRound, begin, begin + (to - from) / kCarveRounds)) return false;
    }
    return true;
  }

  /// Pulls muscles with new findings back to their start, at last all the way. False: cancelled.
  [[nodiscard]] bool holdBack(FitMuscles& muscles, Rig& rig, double from, std::set<int>& heldBack) const {
    for (int round = 0; round <= kHoldRounds; ++round) {
      const double share = from + (1.0 - from) * round / (kHoldRounds + 1);
      if (!goesOn(share)) return false;
      const std::set<int> found = newIn(rig);
      if (found.empty()) break;
      for (const int primitive : found) {
        const int unknown = muscles.unknownOf(primitive);
        if (unknown < 0) continue;
        heldBack.insert(at(muscles.all(), unknown).leader);
        at(muscles.all(), unknown).hold *= kHoldMore;
        if (round == kHoldRounds) muscles.restore(rig, toIndex(unknown));
      }
      if (!model_.raise(rig)) return false;
      if (round == kHoldRounds) break;
      if (!settle(muscles, rig, kStepsOfRound, share, share)) return false;
    }
    return true;
  }

  [[nodiscard]] SculptMatch match() const {
    double left = 0.0;
    double all = 0.0;
    for (std::size_t v = 0; v < model_.points().size(); ++v) {
      const double own = residuals_.left(v, model_.heights());
      left += residuals_.area(v) * own * own;
      all += residuals_.area(v);
    }
    const double whole = residuals_.wholeCost();
    return {whole > 0.0 ? 1.0 - left / whole : 0.0, all > 0.0 ? std::sqrt(left / all) / height_ : 0.0};
  }

  [[nodiscard]] std::vector<float> left() const {
    std::vector<float> out;
    for (int v = 0; v < model_.points().controlVertices; ++v) {
      const bool known = residuals_.area(toIndex(v)) > 0.0;
      out.push_back(known ? static_cast<float>(residuals_.left(toIndex(v), model_.heights()) / height_) : 0.0f);
    }
    return out;
  }

  [[nodiscard]] bool goesOn(double share) const { return !options_.progress || options_.progress(share); }

 private:
  [[nodiscard]] std::set<int> newIn(const Rig& rig) const {
    std::set<int> found = musclesOf(rig, check(rig, motions_));
    std::erase_if(found, [&](int primitive) { return foundBefore_.contains(primitive); });
    return found;
  }

  const SculptFitOptions& options_;
  HeightModel& model_;
  const Motions& motions_;
  double height_;
  SculptResiduals residuals_;
  std::set<int> foundBefore_;
};

/// Mean way of the centers of changed muscles, and their number.
void measureWays(const Rig& from, const FitMuscles& muscles, const Character& character, SculptFit& out) {
  double ways = 0.0;
  for (const FitMuscle& muscle : muscles.all()) {
    const glm::dvec3 way = muscle.carrier * glm::dvec3(at(out.rig.primitives, muscle.leader).placement.center -
                                                       at(from.primitives, muscle.leader).placement.center);
    ways += glm::length(way) / static_cast<double>(character.height);
    out.muscles += muscle.follower < 0 ? 1 : 2;
  }
  out.moved = muscles.empty() ? 0.0 : ways / static_cast<double>(muscles.size());
}

}  // namespace

Result<SculptFit> fitToSculpt(const Rig& rig, const std::shared_ptr<const Character>& character, const MirrorPlan& plan,
                              const Motions& motions, const ControlMesh& sculpt, const SculptFitOptions& options) {
  const Error canceled = errorAt("", std::string(kFitCanceled));
  Rig start = rig;
  while (!start.sheets.empty()) start = breakIntoStrips(std::move(start), 0);
  const MirrorPlan* mirror = options.mirror && plan.usable() ? &plan : nullptr;
  for (Primitive& primitive : start.primitives) {
    if (!options.mirror) primitive.mirror.clear();
  }
  FitMuscles muscles(start, *character, mirror);
  if (muscles.empty()) return errorAt("primitives", "there is no muscle to fit");
  Result<HeightModel> model = HeightModel::create(character, start);
  if (!model) return model.error();
  const Result<SculptHeights> heights = sculptHeights(model->points(), sculpt, character->height);
  if (!heights) return heights.error();
  SculptFitting fitting(start, options, model.value(), heights.value(), motions, character->height);
  SculptFit out;
  out.covered = static_cast<double>(heights->covered);
  out.before = fitting.match();
  out.rig = start;
  std::set<int> heldBack;
  const double half = options.carves > 0 ? 0.4 : 0.8;
  if (!fitting.settle(muscles, out.rig, kMostFitSteps, 0.0, half)) return canceled;
  if (options.carves > 0 && !fitting.addCarves(muscles, start, out.rig, *character, mirror, half, 0.8)) return canceled;
  if (!fitting.holdBack(muscles, out.rig, 0.8, heldBack)) return canceled;
  out.after = fitting.match();
  out.left = fitting.left();
  out.carves = static_cast<int>(out.rig.primitives.size() - rig.primitives.size());
  for (const int primitive : heldBack) out.heldBack.push_back(at(out.rig.primitives, primitive).name);
  measureWays(start, muscles, *character, out);
  return out;
}

}  // namespace sinew
