// app/document/sculpt_fit_job.h: a fit to a sculpt on a thread of its own.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/bodies/check.h"
#include "core/bodies/fit_to_sculpt.h"

namespace sinew::app {

/// Owns all that its fit needs: later edits do not change it.
struct SculptFitOrder {
  Rig rig;
  std::shared_ptr<const Character> character;
  std::shared_ptr<const MirrorPlan> plan;
  std::shared_ptr<const Motions> motions;
  std::shared_ptr<const ControlMesh> sculpt;
  SculptFitOptions options;  ///< Without progress.
};

struct SculptFitOutcome {
  Result<SculptFit> fit;
  std::vector<Finding> findings;  ///< Of check() on the fitted rig.
};

/// Call from one thread; only the destructor waits, after canceling.
class SculptFitJob {
 public:
  explicit SculptFitJob(SculptFitOrder order);
  ~SculptFitJob();
  SculptFitJob(SculptFitJob&&) noexcept;
  SculptFitJob& operator=(SculptFitJob&&) noexcept;

  [[nodiscard]] double share() const;  ///< Done, 0..1.
  void cancel();                       ///< The outcome is then most likely the error kFitCanceled.
  [[nodiscard]] bool isDone() const;
  [[nodiscard]] SculptFitOutcome take();  ///< Only when done, once.

 private:
  struct Run;
  std::unique_ptr<Run> run_;
};

}  // namespace sinew::app
