// tests/sanitizers/on_threads.cpp: the task system of every test in a build without oneTBB.
//
// Loops run on std::thread, all of whose steps ThreadSanitizer sees.
#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sinew/base/task_system.h"

namespace sinew::test {
namespace {

constexpr int kThreads = 4;  ///< The calling one among them; more than cores do no harm.

/// A game's task system: a queue of loops, which the caller and all threads take tasks from.
class ThreadPool {
 public:
  explicit ThreadPool(int threads) {
    for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { serve(); });
  }
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool() {
    {
      const std::scoped_lock lock(mutex_);
      stops_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  static void run(void* user, int tasks, void (*task)(void*, int), void* work) {
    static_cast<ThreadPool*>(user)->runLoop(std::make_shared<Loop>(tasks, task, work));
  }

 private:
  struct Loop {
    Loop(int count, void (*function)(void*, int), void* argument)
        : tasks(count), task(function), work(argument), left(count) {}
    const int tasks;
    void (*const task)(void*, int);
    void* const work;
    std::atomic<int> next{0};
    int left;  ///< Tasks that have not returned yet. Under the mutex.
  };

  void runLoop(const std::shared_ptr<Loop>& loop) {
    {
      const std::scoped_lock lock(mutex_);
      loops_.push_back(loop);
    }
    wake_.notify_all();
    workOn(*loop);
    std::unique_lock lock(mutex_);
    std::erase(loops_, loop);
    done_.wait(lock, [&] { return loop->left == 0; });
  }

  void workOn(Loop& loop) {
    for (int i = loop.next++; i < loop.tasks; i = loop.next++) {
      loop.task(loop.work, i);
      const std::scoped_lock lock(mutex_);
      if (--loop.left == 0) done_.notify_all();
    }
  }

  void serve() {
    std::unique_lock lock(mutex_);
    for (;;) {
      wake_.wait(lock, [this] { return stops_ || !loops_.empty(); });
      if (stops_) return;
      const std::shared_ptr<Loop> loop = loops_.front();
      lock.unlock();
      workOn(*loop);
      lock.lock();
      std::erase(loops_, loop);
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  std::deque<std::shared_ptr<Loop>> loops_;  ///< That may have tasks left to begin.
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
