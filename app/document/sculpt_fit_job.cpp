// app/document/sculpt_fit_job.cpp: the thread of a fit, its progress and its end.
#include "app/document/sculpt_fit_job.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "sinew/geometry/threads.h"

namespace sinew::app {

struct SculptFitJob::Run {
  explicit Run(SculptFitOrder wanted) : order(std::move(wanted)) {}

  void work() {
    const ThreadLimit limit(std::max(1, threadCount() - 1));  // The editor stays live.
    SculptFitOptions options = order.options;
    options.progress = [this](double fraction) {
      share = fraction;
      return !canceled.load();
    };
    outcome.emplace(SculptFitOutcome{
        fitToSculpt(order.rig, order.character, *order.plan, *order.motions, *order.sculpt, options), {}});
    if (outcome->fit) outcome->findings = check(outcome->fit->rig, *order.motions);
    done = true;
  }

  const SculptFitOrder order;
  std::atomic<double> share = 0.0;
  std::atomic<bool> canceled = false;
  std::atomic<bool> done = false;
  std::optional<SculptFitOutcome> outcome;
  std::jthread thread;  ///< Last, so that it ends first.
};

SculptFitJob::SculptFitJob(SculptFitOrder order) : run_(std::make_unique<Run>(std::move(order))) {
  try {
    run_->thread = std::jthread([run = run_.get()] { run->work(); });
  } catch (const std::system_error& error) {
    run_->outcome.emplace(SculptFitOutcome{Error{{}, {}, std::string("no thread for it: ") + error.what()}, {}});
    run_->done = true;
  }
}

SculptFitJob::~SculptFitJob() {
  if (run_) run_->canceled = true;
}
SculptFitJob::SculptFitJob(SculptFitJob&&) noexcept = default;
SculptFitJob& SculptFitJob::operator=(SculptFitJob&&) noexcept = default;

double SculptFitJob::share() const { return run_->share; }
void SculptFitJob::cancel() { run_->canceled = true; }
bool SculptFitJob::isDone() const { return run_->done; }

SculptFitOutcome SculptFitJob::take() {
  assert(isDone() && run_->outcome);
  if (run_->thread.joinable()) run_->thread.join();
  return std::move(*run_->outcome);
}

}  // namespace sinew::app
