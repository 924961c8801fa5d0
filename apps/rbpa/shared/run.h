// What: provides the steps that all verbs share: reading, computing and writing, with progress, Ctrl-C and timing.
// Law:  no output file has its name before all are complete. After Ctrl-C no output file remains.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/cloud/read_points.h"
#include "io/interrupt.h"
#include "io/progress_line.h"
#include "rbpa/base/duplicate.h"
#include "shared/arguments.h"

namespace rbpa::app {

struct SpacePoints;
struct SpacePointSource;

struct RunOptions {
  unsigned threads = 0;  ///< the most threads; 0: one for each processor
  bool quiet = false;
  std::optional<std::string> stats = std::nullopt;  ///< path of a file for the report of --stats

  unsigned threads_or_all() const;
  /// Returns a progress line that shows `doing`. The line shows nothing if `quiet` or `in_the_way` is true.
  ProgressLine line(const std::string& doing, bool in_the_way = false) const {
    return {"rbpa", !quiet && !in_the_way, doing};
  }
};

/// The largest accepted --threads. The number may exceed the number of processors, so that one command line serves any
/// machine.
constexpr unsigned max_threads = 1024;

/// Parses the options; --threads is a whole number from 1 to max_threads. Throws WrongUsage that names the value.
RunOptions parse_run(const RunArguments& arguments);

class Run {
 public:
  /// Stores the names of the input and of the output files as on the command line; "-" is a standard stream. Opens no
  /// file.
  Run(std::string input, std::vector<std::string> outputs, const RunOptions& options)
      : input_(std::move(input)), outputs_(std::move(outputs)), options_(options) {}

  const RunOptions& options() const { return options_; }
  /// Returns the name of the input for messages.
  std::string input() const { return input_name(input_); }

  /// Calls read() while a progress line is shown, and returns the result of read().
  template <typename Read>
  auto read(const Read& read) const {
    const ProgressLine line = options_.line("reading", read_from_terminal(input_));
    return read();
  }
  /// Print one or several warnings about the input, unless quiet.
  void warning(const std::string& text) const { summarize(input() + ": " + text); }
  void warning(const std::vector<std::string>& texts) const {
    for (const std::string& text : texts) warning(text);
  }
  /// Reads the points. Prints, unless quiet, the warnings about them, and a warning if their heights are ignored.
  /// Throws as read_points() of io/cloud does.
  PointFile read_points(const PointSource& source) const;
  /// Reads points in space. Prints, unless quiet, the warnings about them. Throws as read_space_points() does.
  SpacePoints read_points(const SpacePointSource& source) const;
  /// Prints, unless quiet, the fields that a target cannot hold, and the number of points that lie on others: a mesh
  /// does not use their fields.
  void warning_on_fields(const std::vector<PointColumn>& columns, const std::vector<Target>& targets,
                         std::size_t duplicates) const;
  /// Replaces the missing heights in `z`, which are not finite, by 0, and prints their number unless quiet. Clears `z`
  /// instead if all heights are missing.
  void complete_heights(std::vector<double>& z) const;

  /// Lets the lowest of several heights at one place count, as take_lowest() does, and prints the number of these
  /// places unless quiet. `z` may be empty.
  void take_lowest_heights(std::span<const Duplicate> duplicates, std::vector<double>& z) const;

  /// Returns the progress line that is shown while files are written.
  ProgressLine writing() const { return options_.line("writing", written_to_terminal(outputs_)); }
  /// Adds a file, and calls write(file), which writes the content. Throws as OutputFile does, and what write() throws.
  template <typename Write>
  void add(const std::string& path, const Write& write) {
    OutputFile& file = files_.add(path);
    write(file);
    file.finish();
  }
  /// Adds a file for each target, and calls write(file, target), which writes the content. Throws Cancelled, as
  /// OutputFile does, and what write() throws.
  template <typename Write>
  void add(const std::vector<Target>& targets, const Write& write) {
    for (const Target& target : targets) {
      stop_if_interrupted();
      add(target.path, [&](OutputFile& file) { write(file, target); });
    }
  }
  /// Adds the report of --stats, if it is requested, as add() does.
  template <typename Write>
  void add_stats(const Write& write) {
    if (options_.stats) add(*options_.stats, write);
  }
  /// Adds a world file as add() does, which list_of() then lists.
  template <typename Write>
  void add_world_file(const std::string& path, const Write& write) {
    add(path, write);
    world_files_ += ", " + path;
  }
  /// Returns " -> a.png, standard output, a.pgw": the targets and their world files.
  template <typename Targets>
  std::string list_of(const Targets& targets) const {
    return rbpa::app::list_of(targets) + world_files_;
  }
  OutputSet& files() { return files_; }
  /// Gives all added files their names. Throws as OutputSet::publish() does.
  void publish() { files_.publish(); }

  /// Prints a line about the result, unless quiet.
  void summarize(const std::string& text) const;

  /// Returns the seconds since the last call of lap(), or since the start of the run in the first call.
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
  std::string world_files_ = {};
  Clock::time_point start_ = Clock::now();
};

}  // namespace rbpa::app
