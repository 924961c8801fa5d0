// What: a queue of items that a separate thread produces while the caller processes earlier items.
// Law:  the items come in the order in which they are produced; an exception of the producer comes after all items.
// Cost: one thread, and the memory of the waiting items. With RBPA_SERIAL there is no thread: next() produces the item.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace rbpa {

/// Queue of items. `Item` can be constructed without arguments and moved.
template <typename Item>
class ReadAhead {
 public:
  /// Starts a thread that calls make(item) for one item after another until make() returns false or throws. The thread
  /// pauses while `most` items wait.
  /// Requires: most ≥ 1; not checked. Throws: std::system_error if the thread cannot start.
  ReadAhead(std::size_t most, std::function<bool(Item&)> make) : most_(most), make_(std::move(make)) {
#ifndef RBPA_SERIAL
    thread_ = std::jthread([this] { run(); });
#endif
  }
  /// Stops the thread after the current call of make(), and waits for it.
  ~ReadAhead() {
    const std::lock_guard lock(mutex_);
    unwanted_ = true;
    changed_.notify_all();
  }
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// Waits for the next item and moves it to `item`. Returns false after the last item; `item` is then unspecified.
  /// Throws: the exception of make(), after all earlier items have been returned.
  bool next(Item& item) {
#ifdef RBPA_SERIAL
    return make_(item = Item());
#endif
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !waiting_.empty() || ended_; });
    if (waiting_.empty() && failure_) std::rethrow_exception(failure_);
    if (waiting_.empty()) return false;
    item = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    return true;
  }

 private:
  void run() {
    std::exception_ptr failure;
    try {
      for (Item item; make_(item) && put(std::move(item)); item = Item()) continue;
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    failure_ = failure;
    ended_ = true;
    changed_.notify_all();
  }
  /// Appends an item to the queue once there is room. Returns false when the queue is being destroyed.
  bool put(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.size() < most_ || unwanted_; });
    if (unwanted_) return false;
    waiting_.push_back(std::move(item));
    changed_.notify_all();
    return true;
  }

  std::size_t most_;
  std::function<bool(Item&)> make_;
  std::mutex mutex_;  // guards the members below
  std::condition_variable changed_;
  std::deque<Item> waiting_ = {};
  bool ended_ = false, unwanted_ = false;
  std::exception_ptr failure_ = nullptr;
  std::jthread thread_;  // the last member, as it uses the others
};

}  // namespace rbpa
