// What: a queue of items that other threads make and work on while the caller processes earlier items.
// Law:  the items come in the order in which they are made. An exception of an item comes in its place, after all
//       earlier items, so that what the caller sees does not depend on the number of threads.
// Cost: the threads, and the memory of the items in the queue. Without other threads next() makes each item, as always
//       with RBPA_SERIAL.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace rbpa {

/// Queue of items. `Item` can be constructed without arguments and moved.
template <typename Item>
class ReadAhead {
 public:
  /// Starts `others` threads. They and the caller of next() call make(item) for one item after another, in any thread
  /// but one call at a time, until make() returns false or an exception is thrown; then work(item), several at a time.
  /// At most `most` items are in the queue. Threads that the system refuses are done without.
  /// Requires: most ≥ 1; not checked.
  ReadAhead(
      std::size_t others, std::size_t most, std::function<bool(Item&)> make,
      std::function<void(Item&)> work = [](Item&) {})
      : make_(std::move(make)), work_(std::move(work)), entries_(most) {
#ifndef RBPA_SERIAL
    threads_.reserve(others);
    try {
      while (threads_.size() < others) threads_.emplace_back([this] { run(); });
    } catch (const std::exception&) {  // those that have started suffice, as even none does
    }
#endif
  }
  /// Stops the threads after the current calls, and waits for them.
  ~ReadAhead() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// Moves the next item to `item`; makes items while it is not there. Returns false after the last item.
  /// Throws: the exception of make() or work(), after all earlier items have been returned.
  bool next(Item& item) {
    std::unique_lock lock(mutex_);
    while (returned_ == made_ || !entry(returned_).is_done) {
      if (returned_ == made_ && ended_) return false;
      is_wanted() ? make_next(lock) : changed_.wait(lock);
    }
    if (entry(returned_).failure) std::rethrow_exception(entry(returned_).failure);
    item = std::move(entry(returned_++).item);
    changed_.notify_all();
    return true;
  }

 private:
  struct Entry {
    Item item = Item();
    bool is_done = false;
    std::exception_ptr failure = nullptr;
  };

  Entry& entry(std::size_t i) { return entries_[i % entries_.size()]; }
  bool is_wanted() const { return !is_making_ && !ended_ && made_ < returned_ + entries_.size(); }

  /// Makes an item and works on it. Requires: is_wanted(), and the lock.
  void make_next(std::unique_lock<std::mutex>& lock) {
    Entry& next = entry(made_) = Entry();
    bool is_there = true;
    const auto call_unlocked = [&](const auto& call) {
      lock.unlock();
      try {
        call();
      } catch (...) {
        next.failure = std::current_exception();
      }
      lock.lock();
      changed_.notify_all();
      ended_ = ended_ || !is_there || next.failure;
    };
    is_making_ = true;
    call_unlocked([&] { is_there = make_(next.item); });
    is_making_ = false;
    if (!is_there) return;
    ++made_;
    if (!next.failure) call_unlocked([&] { work_(next.item); });
    next.is_done = true;
  }

  void run() {
    std::unique_lock lock(mutex_);
    while (!ended_) is_wanted() ? make_next(lock) : changed_.wait(lock);
  }

  std::function<bool(Item&)> make_;
  std::function<void(Item&)> work_;
  std::mutex mutex_;  // guards the members below
  std::condition_variable changed_;
  std::vector<Entry> entries_;              // item i is in entry(i)
  std::size_t made_ = 0, returned_ = 0;     // numbers of items
  bool is_making_ = false, ended_ = false;  // ended_: no more items are made
  std::vector<std::jthread> threads_ = {};  // the last member, as they use the others
};

}  // namespace rbpa
