#include "python/watched.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "rbpa/base/error.h"

namespace rbpa::python {
namespace {

/// A new thread that runs work. The destructor waits for its end.
class Running {
 public:
  Running(const std::function<void(Watch&)>& work, Watch& watch)
      : thread_([this, &work, &watch] {
          try {
            work(watch);
          } catch (...) {
            failure_ = std::current_exception();
          }
          const std::lock_guard lock(mutex_);
          is_done_ = true;
          done_.notify_one();
        }) {}
  ~Running() { thread_.join(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  bool wait_for(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return done_.wait_for(lock, time, [&] { return is_done_; });
  }
  /// Returns the exception that the work has thrown, or null. Requires: the work has ended.
  const std::exception_ptr& failure() const { return failure_; }

 private:
  std::mutex mutex_;
  std::condition_variable done_;
  bool is_done_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  // the last member, as the thread uses the others
};

/// Checks signals, and calls `progress` if `is_time_to_tell`. Requires: this thread holds Python's lock.
/// Throws: the exceptions that a signal handler or `progress` raises; Cancelled if `progress` returns a false value
///         other than None.
void ask(const Watch& watch, const py::object& progress, bool is_time_to_tell) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (progress.is_none() || !is_time_to_tell) return;
  const Progress now = watch.last();
  const py::object answer = progress(now.triangles, now.points);
  if (answer.is_none()) return;
  const int goes_on = PyObject_IsTrue(answer.ptr());
  if (goes_on < 0) throw py::error_already_set();
  if (goes_on == 0) throw Cancelled();
}

}  // namespace

void run_watched(const std::function<void(Watch&)>& work, bool is_short, const py::object& progress) {
  constexpr std::chrono::milliseconds between_looks(20);
  constexpr int looks_to_tell = 5;
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress: found " + py::repr(progress).cast<std::string>() + ", expected a function or None");
  Watch watch;
  std::exception_ptr stopped, failed;
  if (is_short) {
    const py::gil_scoped_release unlocked;
    work(watch);
    return;
  }
  {
    const py::gil_scoped_release unlocked;
    Running running(work, watch);
    for (int looks = 1; !running.wait_for(between_looks); ++looks) {
      if (stopped) continue;
      const py::gil_scoped_acquire locked;
      const bool is_first = looks == 1 && watch.last().points > 0;  // soon, if there is something to tell
      try {
        ask(watch, progress, is_first || looks % looks_to_tell == 0);
      } catch (...) {
        stopped = std::current_exception();
        watch.stop();
      }
    }
    failed = running.failure();
  }
  if (stopped) std::rethrow_exception(stopped);
  if (failed) std::rethrow_exception(failed);
}

}  // namespace rbpa::python
