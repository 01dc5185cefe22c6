// core/surface/crowd_smoother.cpp: lends each thread a smoother.
#include "sinew/surface/crowd_smoother.h"

#include <atomic>
#include <cassert>
#include <mutex>
#include <optional>

#include "core/geometry/parallel.h"

namespace sinew {

struct CrowdSmoother::State {
  explicit State(std::shared_ptr<const Character> character) : first(std::move(character)) {}

  Smoother first;
  std::mutex mutex;
  std::vector<std::unique_ptr<Smoother>> idle;  ///< Twins of `first`, prepared as it is.

  std::unique_ptr<Smoother> take() {
    const std::scoped_lock lock(mutex);
    if (idle.empty()) return std::make_unique<Smoother>(first.twin());
    std::unique_ptr<Smoother> taken = std::move(idle.back());
    idle.pop_back();
    return taken;
  }
  void giveBack(std::unique_ptr<Smoother> smoother) {
    const std::scoped_lock lock(mutex);
    idle.push_back(std::move(smoother));
  }
};

CrowdSmoother::CrowdSmoother(std::shared_ptr<const Character> character)
    : state_(std::make_unique<State>(std::move(character))) {}

CrowdSmoother::~CrowdSmoother() = default;
CrowdSmoother::CrowdSmoother(CrowdSmoother&&) noexcept = default;
CrowdSmoother& CrowdSmoother::operator=(CrowdSmoother&&) noexcept = default;

Result<void> CrowdSmoother::prepare(const Rig& rig, std::span<const int> hidden, const Region& region) {
  if (auto prepared = state_->first.prepare(rig, hidden, region); !prepared) return prepared;
  state_->idle.clear();
  return {};
}

bool CrowdSmoother::smooth(std::span<const Pose> poses, std::span<Surface> out) {
  assert(poses.size() == out.size());
  const bool enough = poses.size() >= static_cast<std::size_t>(threadCount());  // One surface for each thread.
  std::atomic<bool> all{true};
  forRanges(poses.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::optional<ThreadLimit> one;
    if (enough) one.emplace(1);
    std::unique_ptr<Smoother> smoother = state_->take();
    for (std::size_t i = begin; i < end; ++i) {
      if (!smoother->smooth(poses[i], out[i])) all = false;
    }
    state_->giveBack(std::move(smoother));
  });
  return all;
}

}  // namespace sinew
