// app/document/export_queue.cpp: a thread for the export that runs; three atomics between it and the interface.
#include "app/document/export_queue.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "sinew/geometry/threads.h"

namespace sinew::app {

/// `result` is the thread's until `done` is set, then the owner's.
struct ExportQueue::Run {
  explicit Run(ExportOrder what) : order(std::move(what)) {}
  ~Run() { canceled = true; }

  void work() {
    const ExportProgress progress = [this](double part) {
      share = part;
      return !canceled;
    };
    if (order.pictures) result = pictures(progress);
    else result = runExport(*order.kind, order.source, order.settings, order.file, progress);
    done = true;
  }

  Result<ExportReport> pictures(const ExportProgress& progress) const {
    const Result<void> made = runPictureJob(*order.pictures, order.file, progress);
    if (!made) return made.error();
    return ExportReport{};
  }

  const ExportOrder order;
  std::atomic<double> share = 0.0;
  std::atomic<bool> canceled = false;
  std::atomic<bool> done = false;
  std::optional<Result<ExportReport>> result;
  std::jthread thread;  ///< Last: it ends before what it uses.
};

ExportQueue::ExportQueue() = default;
ExportQueue::~ExportQueue() = default;
ExportQueue::ExportQueue(ExportQueue&&) noexcept = default;
ExportQueue& ExportQueue::operator=(ExportQueue&&) noexcept = default;

void ExportQueue::add(ExportOrder order) {
  waiting_.push_back(std::move(order));
  if (!run_) startNext();
}

void ExportQueue::startNext() {
  run_.reset();
  while (!waiting_.empty() && !run_) {
    run_ = std::make_unique<Run>(std::move(waiting_.front()));
    waiting_.erase(waiting_.begin());
    try {
      run_->thread = std::jthread([run = run_.get()] {
        const ThreadLimit limit(std::max(1, threadCount() - 1));  // The editor stays live.
        run->work();
      });
    } catch (const std::system_error& error) {
      done_.push_back(
          {run_->order.file, Error{run_->order.file.string(), {}, std::string("no thread for it: ") + error.what()}});
      run_.reset();
    }
  }
}

void ExportQueue::cancel() {
  if (run_) run_->canceled = true;
}

std::vector<ExportStand> ExportQueue::stands() const {
  std::vector<ExportStand> stands;
  if (run_) stands.push_back({run_->order.file, run_->share, true, run_->canceled});
  for (const ExportOrder& order : waiting_) stands.push_back({order.file});
  return stands;
}

bool ExportQueue::empty() const { return !run_ && done_.empty(); }

std::vector<ExportOutcome> ExportQueue::takeDone() {
  if (run_ && run_->done) {
    run_->thread.join();
    const bool canceled = !run_->result->ok() && run_->result->error().reason == kCanceled;
    done_.push_back({run_->order.file, std::move(*run_->result), canceled, run_->order});
    startNext();
  }
  return std::exchange(done_, {});
}

}  // namespace sinew::app
