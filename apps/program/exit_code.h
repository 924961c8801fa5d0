// What: defines the exit codes of rbpa and meshtopo, and prints their results and messages.
#pragma once

#include <functional>
#include <string>

namespace rbpa::app {

/// Exit codes. `cancelled` and `closed_pipe` are the codes that a shell reports for a process that SIGINT or SIGPIPE
/// has ended.
enum ExitCode {
  done = 0,
  failed = 1,
  wrong_usage = 2,
  bad_input_given = 3,
  check_failed = 4,
  cancelled = 130,
  closed_pipe = 141
};

constexpr const char* exit_codes =
    "Exit codes: 0 done, 1 failure while running, 2 wrong usage, 3 bad input, 4 a --check of "
    "meshtopo fails, 130 cancelled, 141 the reader of the output is gone.";

/// Prints "PROGRAM: MESSAGE" on standard error, and returns `code`.
int report(const std::string& program, const std::string& message, ExitCode code);

/// Writes `text` to standard output. Throws Failure, ClosedPipe, Cancelled.
void print(const std::string& text);

/// Calls `work` and returns the exit code `done`. If `work` throws, prints one line on standard error (none for
/// ClosedPipe) and returns the exit code of the exception.
int run(const std::string& program, const std::function<void()>& work);

}  // namespace rbpa::app
