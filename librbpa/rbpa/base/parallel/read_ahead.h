// What: items that one thread makes while another works on those before.
// Law:  they come in the order in which they are made; so does what making one throws.
// Cost: a thread; some items wait.
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

template <typename Item>
class ReadAhead {
 public:
  /// Calls make(item), one call at a time and in any thread, which returns false when there is no further one. At most `most`
  /// items wait.
  ReadAhead(std::size_t most, std::function<bool(Item&)> make) : most_(most), make_(std::move(make)) {
#ifndef RBPA_SERIAL
    thread_ = std::jthread([this] { run(); });
#endif
  }
  ~ReadAhead() {
    const std::lock_guard lock(mutex_);
    unwanted_ = true;
    changed_.notify_all();
  }
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// False at the end.
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
  /// False when nobody wants more.
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
  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::deque<Item> waiting_ = {};
  bool ended_ = false, unwanted_ = false;
  std::exception_ptr failure_ = nullptr;
  std::jthread thread_;  // the last, as it uses the others
};

}  // namespace rbpa
