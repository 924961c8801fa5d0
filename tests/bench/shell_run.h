// What: a command of the shell that is timed, and the files that it reads and writes.
// Time: the value of a line `seconds VALUE` on its standard error, or else of its whole process, files included.
#pragma once

#include <filesystem>
#include <string>

#include "bench/contest.h"

namespace rbpa_bench {

/// A folder for the files of one run, gone with it.
class RunFolder {
 public:
  RunFolder();
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// One word for the shell.
std::string quoted(const std::string& word);

struct ShellRun {
  double seconds;
  Clock clock;        ///< whose they are
  double peak_bytes;  ///< of its process
};

/// Runs the command and waits. What it writes on standard output is dropped, on standard error goes to the file.
/// Throws std::runtime_error: it ended with a code or a signal, or its line of seconds is not a number.
ShellRun run_shell(const std::string& command, const std::filesystem::path& said_here);

}  // namespace rbpa_bench
