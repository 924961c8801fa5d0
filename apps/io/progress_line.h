// What: how far a run has come, said on a terminal.
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

/// Three digits and a unit: "950", "1.23 k", "45.6 M".
std::string short_number(double value);
/// "3 s", "12 min", "5 h".
std::string short_duration(double seconds);

/// One line on standard error, rewritten a few times a second, and gone with this object. It goes on by itself, also
/// while the program waits for a disk or is in a library that reports nothing.
class ProgressLine {
 public:
  /// What the line says after so many seconds.
  using Text = std::function<std::string(double)>;

  /// Silent unless `wanted` and standard error is a terminal. Begins with "PROGRAM: DOING, 0 s".
  ProgressLine(std::string program, bool wanted, const std::string& doing);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// From now on the line says `text`, which is called in this and in another thread, one at a time.
  void say(Text text);

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  void show();

  std::string program_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;  // of what follows
  std::condition_variable wake_;
  Text text_;
  bool ended_ = false;
  std::optional<std::thread> thread_ = std::nullopt;  // none: nothing is shown
};

/// Whether "-" is among what is read, among what is written, and is a terminal: a line would be in the way there.
bool read_from_terminal(const std::string& path);
bool written_to_terminal(const std::vector<std::string>& paths);

}  // namespace rbpa::app
