// What: runs work in a process of its own: its memory, its time in fresh memory, and files for other programs.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rbpa_bench {

/// Calls work(). Returns the peak rise of the resident memory of this process, in bytes; NaN when the system does not
/// report it.
double rise_of_peak(const std::function<void()>& work);

/// Forks; the child calls work(). Returns its result; nothing when the child fails. The child lacks the threads of this
/// process, so call it before anything that starts some.
template <typename Result>
std::optional<Result> in_child(const std::function<Result()>& work) {
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child < 0) return std::nullopt;
  if (child == 0) {
    try {
      const Result result = work();
      _exit(write(ends[1], &result, sizeof result) == sizeof result ? 0 : 1);
    } catch (...) {
      _exit(1);  // nothing is reported
    }
  }
  close(ends[1]);
  Result result;
  const bool is_complete = read(ends[0], &result, sizeof result) == sizeof result;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return is_complete ? std::optional(result) : std::nullopt;
}

/// Keeps freed memory in this process from now on. On a virtual machine, the price of fresh memory depends on the host
/// and can vary tenfold from moment to moment: warm measurements do not pay it.
void keep_memory();

/// Starts this program again with the arguments, in a fresh process, whose first memory is provided page by page, as
/// for the user of a program. Returns the numbers that it prints. Throws std::runtime_error when it prints another
/// count.
std::vector<double> run_again(const std::string& arguments, std::size_t numbers);

/// Temporary folder, removed with its files.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Writes values as native bytes. Throws std::runtime_error when that fails.
template <typename Value>
void write_values(const std::string& path, const std::vector<Value>& values) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(Value)));
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

/// Reads such a file. Throws std::runtime_error when it cannot be read, or its last value is incomplete.
template <typename Value>
std::vector<Value> read_values(const std::string& path) {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(path, error);
  if (error || bytes % sizeof(Value) != 0) throw std::runtime_error(path + ": cannot be read, or is incomplete");
  std::vector<Value> values(bytes / sizeof(Value));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(bytes));
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return values;
}

/// A program that takes part in a benchmark, from an argument NAME=COMMAND.
class PeerProgram {
 public:
  /// Throws std::invalid_argument when the argument has no name or no command.
  explicit PeerProgram(const std::string& argument);

  const std::string& name() const { return name_; }
  /// Writes `points` as native numbers, and lets the shell run the command with two file names behind it: that file,
  /// and one that the command writes. Returns the indices in that file, in rows, native uint32, and the time: the value
  /// of a line `seconds VALUE` on standard error, or else that of the whole process, files included. Throws
  /// std::runtime_error when the command ended with a code or a signal, wrote no rows or an incomplete one, or named a
  /// point that does not exist.
  template <typename Row, typename Point>
  std::pair<std::vector<Row>, double> run(std::span<const Point> points) const {
    const Folder folder;
    write_values(folder / "points", std::vector(points.begin(), points.end()));
    const double seconds = run_in(folder);
    std::vector<Row> rows = read_values<Row>(folder / "result");
    for (const Row& row : rows)
      for (const std::uint32_t corner : row)
        if (corner >= points.size())
          throw std::runtime_error("named point " + std::to_string(corner) + " of " + std::to_string(points.size()));
    return {std::move(rows), seconds};
  }

 private:
  double run_in(const Folder& folder) const;

  std::string name_, command_;
};

}  // namespace rbpa_bench
