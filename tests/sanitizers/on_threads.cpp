// tests/sanitizers/on_threads.cpp: the task system of every test in a build without oneTBB.
//
// Loops run on std::thread, all of whose steps ThreadSanitizer sees.
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sinew/geometry/task_system.h"

namespace sinew::test {
namespace {

constexpr int kThreads = 4;  ///< The calling one among them; more than cores do no harm.

/// A game's task system that lets races show. Threads that are free join a loop before it begins, and its tasks are
/// dealt out among them: a caller that took whatever was left would often do all of a short loop alone. It allocates
/// nothing for a loop, as some tests count allocations.
class ThreadPool {
 public:
  explicit ThreadPool(int threads) : free_(threads - 1) {
    for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { serve(); });
  }
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool() {
    {
      const std::scoped_lock lock(mutex_);
      stops_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  static void run(void* user, int tasks, void (*task)(void*, int), void* work) {
    Loop loop{.tasks = tasks, .task = task, .work = work};
    static_cast<ThreadPool*>(user)->runLoop(loop);
  }

 private:
  /// What changes does so under the mutex, but for `begun`.
  struct Loop {
    int tasks;
    void (*task)(void*, int);
    void* work;
    int joined = 1;  ///< Threads, the caller among them.
    int working = 1;
    std::atomic<bool> begun = false;  ///< The mutex would order what threads do, so that no race shows.
    Loop* after = nullptr;
  };

  void runLoop(Loop& loop) {
    const int wanted = std::min(loop.tasks, kThreads);
    std::unique_lock lock(mutex_);
    loop.after = first_;
    first_ = &loop;
    changed_.notify_all();
    changed_.wait(lock, [&] { return loop.joined == wanted || free_ == 0; });
    unlink(loop);
    lock.unlock();
    loop.begun = true;
    loop.begun.notify_all();
    workOn(loop, 0);
    lock.lock();
    --loop.working;
    changed_.wait(lock, [&] { return loop.working == 0; });
  }

  static void workOn(const Loop& loop, int place) {
    for (int i = place; i < loop.tasks; i += loop.joined) loop.task(loop.work, i);
  }

  /// No further thread joins it.
  void unlink(const Loop& loop) {
    for (Loop** link = &first_; *link != nullptr; link = &(*link)->after) {
      if (*link != &loop) continue;
      *link = loop.after;
      return;
    }
  }

  void serve() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return stops_ || first_ != nullptr; });
      if (stops_) return;
      --free_;
      Loop& loop = *first_;
      const int place = loop.joined++;
      ++loop.working;
      if (loop.joined == std::min(loop.tasks, kThreads)) unlink(loop);
      changed_.notify_all();
      lock.unlock();
      loop.begun.wait(false);
      workOn(loop, place);
      lock.lock();
      ++free_;
      --loop.working;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  Loop* first_ = nullptr;  ///< A list of those that have not begun.
  int free_;               ///< Threads that wait for a loop.
  bool stops_ = false;
  std::vector<std::thread> threads_;
};

class OnThreads : public testing::Environment {
 public:
  void SetUp() override {
    pool_ = std::make_unique<ThreadPool>(kThreads);
    setTaskSystem({&ThreadPool::run, pool_.get(), kThreads});
  }
  void TearDown() override {
    setTaskSystem({});
    pool_.reset();
  }

 private:
  std::unique_ptr<ThreadPool> pool_;
};

// GoogleTest deletes it.
const testing::Environment* const onThreads = testing::AddGlobalTestEnvironment(new OnThreads);

}  // namespace
}  // namespace sinew::test
