// What: the library's two ways to share work among threads, with the standard library alone.
// Why:  for the thread sanitizer. It cannot see how oneTBB, which is not built with it, puts one piece of work before
//       another, and would report that instead of our mistakes.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#if defined(__SANITIZE_THREAD__)
#define RBPA_PLAIN_THREADS 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define RBPA_PLAIN_THREADS 1
#endif
#endif

namespace rbpa::plain_threads {

/// The state shared by threads at one job.
class Shared {
 public:
  explicit Shared(std::size_t count) : count_(count) {}

  /// The next number, or `count` when there is none or someone has failed.
  std::size_t take() {
    const std::lock_guard lock(mutex_);
    return failure_ ? count_ : next_ < count_ ? next_++ : count_;
  }
  /// Waits until all before `i` have passed on. Returns false when someone has failed.
  bool wait_for_turn(std::size_t i) {
    std::unique_lock lock(mutex_);
    turned_.wait(lock, [&] { return failure_ || turn_ == i; });
    return !failure_;
  }
  void pass_on() {
    const std::lock_guard lock(mutex_);
    ++turn_;
    turned_.notify_all();
  }
  void fail() {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    turned_.notify_all();
  }

  /// Runs loop() in some threads; throws the first failure.
  template <typename Loop>
  void run(std::size_t threads, Loop loop) {
    const auto guarded = [&] {
      try {
        loop();
      } catch (...) {
        fail();
      }
    };
    {
      std::vector<std::jthread> others;
      for (std::size_t i = 1; i < threads; ++i) others.emplace_back(guarded);
      guarded();
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_, next_ = 0, turn_ = 0;
  std::exception_ptr failure_;
  std::mutex mutex_;
  std::condition_variable turned_;
};

template <typename Visit>
void for_each_index(std::size_t threads, std::size_t count, Visit& visit) {
  Shared shared(count);
  shared.run(threads, [&] {
    for (std::size_t i = shared.take(); i < count; i = shared.take()) visit(i);
  });
}

template <typename Workspace, typename Work, typename Join, typename Finish>
void in_order(std::size_t threads, std::size_t count, Work& work, Join& join, Finish& finish) {
  Shared shared(count);
  shared.run(threads, [&] {
    Workspace workspace;
    for (std::size_t i = shared.take(); i < count; i = shared.take()) {
      work(i, workspace);
      if (!shared.wait_for_turn(i)) return;
      join(i, workspace);
      shared.pass_on();
      finish(i, workspace);
    }
  });
}

}  // namespace rbpa::plain_threads
