// What: one line on the terminal that shows the progress of a run.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace rbpa::app {

/// Returns three digits and a unit: "950", "1.23 k", "45.6 M".
std::string short_number(double value);
/// Returns a duration as text: "3 s", "12 min", "5 h".
std::string short_duration(double seconds);

/// One line on standard error, rewritten a few times a second by its own thread, and erased with this object. It also
/// runs while the program waits for a disk or for a library that reports no progress.
class ProgressLine {
 public:
  /// Returns the text of the line after a time in seconds.
  using Text = std::function<std::string(double)>;

  /// Shows "PROGRAM: DOING, 0 s" if `wanted` and standard error is a terminal; otherwise nothing, ever.
  ProgressLine(std::string program, bool wanted, const std::string& doing);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows `text` from now on. It is called from this and from another thread, never from both at once.
  void say(Text text);

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  void show();

  std::string program_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;  // guards the members below
  std::condition_variable wake_;
  Text text_;
  bool ended_ = false;
  std::optional<std::thread> thread_ = std::nullopt;  // absent if nothing is shown
};

/// Returns whether a path to read, or one of the paths to write, is "-" and that stream is a terminal, where a progress
/// line would disturb.
bool read_from_terminal(const std::string& path);
bool written_to_terminal(const std::vector<std::string>& paths);

}  // namespace rbpa::app
