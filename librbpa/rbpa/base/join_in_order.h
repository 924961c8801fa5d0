// What: processes numbered items that take long, in threads of the standard library, and joins the results in order.
// Law:  join(i, result) is called once for each i, ascending, one call at a time, in any of the threads. The joined
//       result therefore does not depend on the threads.
// Cost: a few locks of one mutex for each item. About two items for each thread are processed or wait for their turn.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace rbpa {

/// A queue of the items 0 … count − 1 for several threads: hands out item numbers in order, gives each item its turn,
/// and stops all threads when one has failed.
class SharedWork {
 public:
  explicit SharedWork(std::size_t count) : count_(count) {}

  /// Returns the number of the next item, or `count` when no item is left or a thread has failed.
  std::size_t take() {
    const std::lock_guard lock(mutex_);
    return failure_ ? count_ : next_ < count_ ? next_++ : count_;
  }
  /// Waits until all items before `i` have had their turn. Returns false when a thread has failed.
  bool wait_for_turn(std::size_t i) {
    std::unique_lock lock(mutex_);
    turned_.wait(lock, [&] { return failure_ || turn_ == i; });
    return !failure_;
  }
  /// Ends the turn of the current item, so that the next item has its turn.
  void pass_on() {
    const std::lock_guard lock(mutex_);
    ++turn_;
    turned_.notify_all();
  }
  /// Stores the result of item i in `waiting`. Before that, blocks while `most` or more results wait there and item i
  /// does not have its turn. If no other thread is joining, then calls join(number, result) for each result whose turn
  /// it is, ascending. Returns false when a thread has failed.
  template <typename Result, typename Join>
  bool hand_in(std::size_t i, Result made, std::map<std::size_t, Result>& waiting, std::size_t most, Join& join) {
    std::unique_lock lock(mutex_);
    turned_.wait(lock, [&] { return failure_ || turn_ == i || waiting.size() < most; });
    if (failure_) return false;
    waiting.emplace(i, std::move(made));
    if (is_joining_) return true;
    is_joining_ = true;
    while (!failure_ && !waiting.empty() && waiting.begin()->first == turn_) {
      auto next = waiting.extract(waiting.begin());
      lock.unlock();
      join(next.key(), std::move(next.mapped()));
      lock.lock();
      ++turn_;
      turned_.notify_all();
    }
    is_joining_ = false;
    return !failure_;
  }

  /// Runs loop() in `threads` threads, the calling one included, and waits for their ends. Rethrows the first
  /// exception.
  template <typename Loop>
  void run(std::size_t threads, Loop loop) {
    const auto guarded = [&] {
      try {
        loop();
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        turned_.notify_all();
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
  bool is_joining_ = false;
  std::exception_ptr failure_ = nullptr;
  std::mutex mutex_;
  std::condition_variable turned_;
};

/// Calls work(i) for each i below `count` in one of `threads` threads (0 counts as 1), the calling one included, and
/// join(i, result) in ascending order of i, in any of these threads. After work(i), a thread waits for the turn of item
/// i; if is_small(i) returns true, it waits only while `threads` or more results wait. With RBPA_SERIAL there is one
/// thread.
/// Throws: the first exception of any call; then some calls are never made. std::system_error if a thread cannot start.
template <typename Work, typename IsSmall, typename Join>
void join_in_order(std::size_t threads, std::size_t count, Work work, IsSmall is_small, Join join) {
#ifdef RBPA_SERIAL
  threads = 1;
#endif
  SharedWork shared(count);
  std::map<std::size_t, std::invoke_result_t<Work&, std::size_t>> waiting;
  shared.run(std::min(threads, count), [&] {
    for (std::size_t i = shared.take(); i < count; i = shared.take())
      if (!shared.hand_in(i, work(i), waiting, is_small(i) ? threads : 0, join)) return;
  });
}

}  // namespace rbpa
