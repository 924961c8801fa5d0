#include "bench/shell_run.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace rbpa_bench {
namespace {

struct Ended {
  int status;
  double seconds;
  double peak_bytes;
};

Ended wait_for_shell(const std::string& command, const std::filesystem::path& output) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    const int nothing = open("/dev/null", O_RDWR), errors = creat(output.c_str(), 0600);
    if (nothing >= 0 && errors >= 0 && dup2(nothing, 0) >= 0 && dup2(nothing, 1) >= 0 && dup2(errors, 2) >= 0)
      execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  Ended ended{};
  rusage used{};
  if (wait4(child, &ended.status, 0, &used) != child) throw std::runtime_error("its process was lost");
  ended.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ended.peak_bytes = 1024 * static_cast<double>(used.ru_maxrss);
  return ended;
}

/// Contents of standard error: the time, and the last line, which is the reason for a failure.
struct ErrorOutput {
  std::optional<double> seconds;
  std::string last_line;
};

ErrorOutput read_error_output(const std::filesystem::path& path) {
  ErrorOutput output;
  std::ifstream file(path);
  constexpr std::string_view key = "seconds ";
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) output.last_line = line;
    if (!line.starts_with(key)) continue;
    double value = 0;
    const char* const end = line.data() + line.size();
    const auto [rest, error] = std::from_chars(line.data() + key.size(), end, value);
    if (error != std::errc{} || rest != end || !(value > 0) || !std::isfinite(value))
      throw std::runtime_error("said '" + line + "', expected seconds and a number above 0");
    output.seconds = value;
  }
  return output;
}

void refuse_failure(int status, const ErrorOutput& output) {
  const std::string why = output.last_line.empty() ? "" : ": " + output.last_line;
  if (WIFSIGNALED(status)) throw std::runtime_error("ended by signal " + std::to_string(WTERMSIG(status)) + why);
  if (WEXITSTATUS(status) != 0) throw std::runtime_error("ended with " + std::to_string(WEXITSTATUS(status)) + why);
}

}  // namespace

RunFolder::RunFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "bench_peer_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
  path_ = name;
}
RunFolder::~RunFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

ShellRun run_shell(const std::string& command, const std::filesystem::path& error_file) {
  const Ended ended = wait_for_shell(command, error_file);
  const ErrorOutput output = read_error_output(error_file);
  refuse_failure(ended.status, output);
  return {output.seconds.value_or(ended.seconds), output.seconds ? Clock::peer : Clock::process, ended.peak_bytes};
}

}  // namespace rbpa_bench
