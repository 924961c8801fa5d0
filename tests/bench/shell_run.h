// What: runs and times a command of the shell, with files that it reads and writes.
// Time: the value of a line `seconds VALUE` on its standard error, or else of its whole process, files included.
#pragma once

#include <filesystem>
#include <string>

#include "bench/contest.h"

namespace rbpa_bench {

/// Folder for the files of one run, removed with it.
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

/// Returns a word quoted for the shell.
std::string quoted(const std::string& word);

struct ShellRun {
  double seconds;
  Clock clock;        ///< clock of the seconds
  double peak_bytes;  ///< peak memory of its process
};

/// Runs the command and waits. Its standard output is dropped; its standard error goes to the file `said_here`.
/// Throws std::runtime_error when it ended with a code or a signal, or its line of seconds is not a number.
ShellRun run_shell(const std::string& command, const std::filesystem::path& said_here);

}  // namespace rbpa_bench
