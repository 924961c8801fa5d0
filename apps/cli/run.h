// What: the run that all verbs share: it reads, computes and writes, watched and timed.
// Law:  no file takes its name before all are whole; after Ctrl-C nothing is left behind.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/arguments.h"
#include "io/bytes/output_file.h"
#include "io/cloud/read_points.h"
#include "io/interrupt.h"
#include "io/progress_line.h"

namespace rbpa::app {

/// How a verb runs, which does not change its result: the arguments, as text.
struct RunArguments {
  std::optional<std::string> threads;
  bool quiet = false;
};

struct RunOptions {
  unsigned threads = 0;  ///< at most this many; 0: one for each processor
  bool quiet = false;

  unsigned threads_or_all() const;
  /// What is done, on a terminal, unless quiet or where the line would be in the way.
  ProgressLine line(const std::string& doing, bool in_the_way = false) const {
    return {"rbpa", !quiet && !in_the_way, doing};
  }
};

/// The largest --threads that is accepted: more than processors, so that one command line serves any machine.
constexpr unsigned max_threads = 1024;

/// `threads`: a whole number from 1 to max_threads. Throws WrongUsage naming the value.
RunOptions parse_run(const RunArguments& arguments);

class Run {
 public:
  /// Of an input and of files to write as the command line names them; "-" is a standard stream.
  Run(std::string input, std::vector<std::string> outputs, const RunOptions& options)
      : input_(std::move(input)), outputs_(std::move(outputs)), options_(options) {}

  const RunOptions& options() const { return options_; }
  /// What messages call the input.
  std::string input() const { return input_name(input_); }

  /// What `read` returns.
  template <typename Read>
  auto read(const Read& read) const {
    const ProgressLine line = options_.line("reading", read_from_terminal(input_));
    return read();
  }
  /// Prints a remark about the input, unless quiet.
  void remark(const std::string& text) const { summarize(input() + ": " + text); }
  void remark(const std::vector<std::string>& texts) const {
    for (const std::string& text : texts) remark(text);
  }
  /// The points, with what there is to remark, and that heights are left out where they are not asked for.
  PointFile read_points(const PointSource& source) const;
  /// Gives points without a height, where others have one, the height 0, and says how many they are.
  void complete_heights(std::vector<double>& z) const;

  /// While files are written.
  ProgressLine writing() const { return options_.line("writing", written_to_terminal(outputs_)); }
  /// A file with what `write(file)` puts into it.
  template <typename Write>
  void add(const std::string& path, const Write& write) {
    OutputFile& file = files_.add(path);
    write(file);
    file.finish();
  }
  /// One for each target, with what `write(file, target)` puts into it.
  template <typename Write>
  void add(const std::vector<Target>& targets, const Write& write) {
    for (const Target& target : targets) {
      stop_if_interrupted();
      add(target.path, [&](OutputFile& file) { write(file, target); });
    }
  }
  OutputSet& files() { return files_; }
  /// All files take their names.
  void publish() { files_.publish(); }

  /// Prints a line about the result, unless quiet.
  void summarize(const std::string& text) const;

  /// Seconds since it was made, or since the last lap.
  double lap() {
    const Clock::time_point before = std::exchange(start_, Clock::now());
    return std::chrono::duration<double>(start_ - before).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string input_;
  std::vector<std::string> outputs_;
  RunOptions options_;
  OutputSet files_ = {};
  Clock::time_point start_ = Clock::now();
};

}  // namespace rbpa::app
