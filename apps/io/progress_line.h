// What: shows the progress of a run in one line on the terminal.
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

/// Returns "950", "1.23 k", "45.6 M": a number below 1000, with a unit and three digits from 1 k on.
std::string short_number(double value);
/// Returns a duration as text, rounded down: "3 s" below 2 min, "12 min" below 2 h, "5 h".
std::string short_duration(double seconds);

/// A line on standard error that shows progress. A thread of its own rewrites the line every 0.2 seconds, also while
/// the program waits for a disk or for a library that reports no progress. The destructor erases the line.
class ProgressLine {
 public:
  /// A function that returns the text of the line after a time in seconds.
  using Text = std::function<std::string(double)>;

  /// Shows "PROGRAM: DOING, 0 s" if `wanted` and standard error is a terminal; otherwise never shows anything.
  ProgressLine(std::string program, bool wanted, const std::string& doing);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows text(seconds) from now on. The caller and the thread of the line call text(), one at a time.
  void say(Text text);

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  void show();

  std::string program_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;  // guards text_ and ended_
  std::condition_variable wake_;
  Text text_;
  bool ended_ = false;
  std::optional<std::thread> thread_ = std::nullopt;  // absent if nothing is shown
};

/// Return whether `path` is "-" and standard input is a terminal, or whether one of `paths` is "-" and standard output
/// is a terminal. A progress line would disturb the text on the terminal.
bool read_from_terminal(const std::string& path);
bool written_to_terminal(const std::vector<std::string>& paths);

}  // namespace rbpa::app
