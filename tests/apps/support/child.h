// A program that runs at the same time as the test, which can watch, hinder and end it.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace apps_test {

/// The end of a process: its exit code, or the signal that ended it.
struct Ending {
  int code = -1;   ///< exit code; -1: by a signal
  int signal = 0;  ///< 0: by itself

  bool by_itself() const { return signal == 0; }
  friend bool operator==(const Ending&, const Ending&) = default;
};

/// Runs `command`, whose first word is the path of the program, with the signals of a login shell. The destructor kills
/// it and waits for it if it still runs.
class Child {
 public:
  using Command = std::vector<std::string>;

  /// `prepare` runs in the new process before the program, to redirect and to limit. Standard error goes to /dev/null
  /// unless `prepare` redirects it.
  explicit Child(
      const Command& command, const std::function<void()>& prepare = [] {});
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t id() const { return id_; }
  void send(int signal) const;
  Ending wait();
  bool has_ended();  ///< wait() returns at once then

 private:
  void take(int status);

  pid_t id_;
  bool ended_ = false;
  Ending ending_ = {};
};

/// For `prepare`: redirect a descriptor to an open file, or to a path.
void redirect(int number, int descriptor);
void redirect(int number, const std::string& path, int flags);

}  // namespace apps_test
