// Measures points that do not fit into memory: `rbpa stream` on files made for it, beside reading the input twice,
// writing the output once, and computing in memory, on the same machine at the same time. Prints the tables of
// docs/how_to/more_points_than_memory.md, section 2, as Markdown.
//   bench_stream [--points=1G] [--memory=1G] [--threads=2] [--scratch=DIR] …      --help for all
#include <sys/statvfs.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "bench/stopwatch.h"
#include "bench/stream_arguments.h"
#include "bench/stream_input.h"
#include "bench/tables.h"
#include "bench/targets.h"
#include "bench/warm_run.h"
#include "bench/watched_run.h"

namespace rbpa_bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double gigabyte = 1e9;

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Run of one of our programs, with the statistics that it writes.
struct ProgramRun {
  WatchedRun run;
  Json stats;
  double output_bytes = 0;

  double seconds(const char* part) const { return stats.at("seconds").at(part).get<double>(); }
};

class StreamBench {
 public:
  explicit StreamBench(const StreamArguments& arguments)
      : arguments_(arguments),
        folder_(arguments.scratch + "/bench_stream"),
        few_(std::min(arguments.points, arguments.in_memory)) {}

  ~StreamBench() {
    std::error_code error;
    if (!arguments_.keep) fs::remove_all(folder_, error);
  }
  StreamBench(const StreamBench&) = delete;
  StreamBench& operator=(const StreamBench&) = delete;

  void run() {
    fs::create_directories(folder_);
    print_machine();
    require_room();
    const Stopwatch watch;
    input_ = write_files({arguments_.ground, arguments_.points, arguments_.seed, arguments_.input, arguments_.files},
                         folder_ + "/input");
    sample_ = write_files({arguments_.ground, few_, arguments_.seed, "f64xy", 1}, folder_ + "/sample");
    std::fprintf(stderr, "input: %.0f s\n", watch.seconds());
    compare_before();
    stream();
    compare_after();
    print_report();
    write_trace();
  }

 private:
  double points() const { return static_cast<double>(arguments_.points); }
  bool wants_triangles() const { return arguments_.target == "npy"; }

  void print_machine() const {
    std::printf("%s; %s.\n\n", today().c_str(), machine_and_build().c_str());
    std::fflush(stdout);
  }

  /// Checks that the disk has room for all files to be written.
  void require_room() const {
    constexpr double of_input = 16, of_tile = 10, of_row = 12, rows = 2;
    double bytes = points() * (of_input + of_tile) + static_cast<double>(few_) * of_input;
    // Polygons are few; triangles are both in the scratch folder and in the target.
    const double row = arguments_.points < std::uint64_t{1} << 32U ? of_row : 2 * of_row;
    bytes += points() * (wants_triangles() ? 2 * rows * row : 1);
    struct statvfs status {};
    if (statvfs(folder_.c_str(), &status) != 0) throw std::runtime_error(folder_ + ": found no disk");
    const double free = static_cast<double>(status.f_bavail) * static_cast<double>(status.f_frsize);
    std::fprintf(stderr, "disk: about %.1f GB are needed at %s, %.1f GB are free\n", bytes / gigabyte, folder_.c_str(),
                 free / gigabyte);
    const double kept = arguments_.keep ? bytes : 0;  // some of the input may exist already
    if (free + kept < bytes)
      throw std::runtime_error(folder_ + ": found " + number("%.1f", free / gigabyte) + " GB free, expected " +
                               number("%.1f", bytes / gigabyte));
  }

  ProgramRun run_program(const std::string& verb, const PointFiles& input, const std::vector<std::string>& more,
                         const std::string& scratch) const {
    const std::string output = folder_ + "/" + verb + "." + arguments_.target, stats = folder_ + "/stats.json";
    std::vector<std::string> command = {arguments_.program, verb};
    command.insert(command.end(), input.paths.begin(), input.paths.end());
    for (const std::string& word :
         {std::string("--alpha"), number("%.17g", arguments_.alpha), std::string("--threads"),
          std::to_string(arguments_.threads), std::string("--quiet"), std::string("--crs"), std::string("EPSG:25832"),
          std::string("--stats"), stats, std::string("-o"), output})
      command.push_back(word);
    command.insert(command.end(), more.begin(), more.end());
    ProgramRun ended{run_watched(command, scratch), {}};
    std::ifstream file(stats);
    ended.stats = Json::parse(file);
    ended.output_bytes = static_cast<double>(fs::file_size(output));
    fs::remove(output);
    fs::remove(stats);
    return ended;
  }

  const char* verb_in_memory() const { return wants_triangles() ? "mesh" : "shape"; }

  void compute_in_memory() {
    memory_runs_.push_back(run_program(verb_in_memory(), sample_, {}, ""));
    warm_runs_.push_back(compute_warm(sample_.paths[0], arguments_.alpha, arguments_.threads, !wants_triangles()));
  }

  void read_once() {
    cached_.push_back(forget(input_));
    const Stopwatch watch;
    reads_.push_back(seconds_to_read(input_));
    read_processor_seconds_.push_back(watch.processor_seconds());
    std::fprintf(stderr, "read: %.1f s\n", reads_.back());
  }
  void compare_before() {
    read_once();
    compute_in_memory();
    std::fprintf(stderr, "in memory: %.1f s\n", memory_runs_.back().run.seconds);
  }
  void stream() {
    forget(input_);
    const std::string scratch = folder_ + "/tiles";
    fs::remove_all(scratch);
    stream_ = run_program("stream", input_, {"--memory", arguments_.memory, "--scratch", scratch}, scratch);
    std::fprintf(stderr, "stream: %.1f s\n", stream_.run.seconds);
  }
  /// The comparison runs once before and once after, so that it shows if the machine became slower.
  void compare_after() {
    compute_in_memory();
    read_once();
    write_seconds_ = seconds_to_write(folder_ + "/written", stream_.output_bytes);
  }

  void print_report() const {
    std::printf(
        "%.0f points, %s, of mean spacing 1 in whole hundredths, in %zu files (.%s, %.2f GB); α = %g; `--memory %s`, "
        "`--threads %u`; to `.%s`.\n\n",
        points(), arguments_.ground == Ground::jittered ? "jittered, row by row" : "uniform, strip by strip",
        arguments_.files, arguments_.input.c_str(), input_.bytes / gigabyte, arguments_.alpha,
        arguments_.memory.c_str(), arguments_.threads, arguments_.target.c_str());
    print_passes();
    print_bytes();
    print_sum();
    print_more();
  }

  /// Prints an estimate, from the numbers above, for more points on more such machines
  /// (docs/how_to/more_points_than_memory.md, section 2).
  void print_more() const {
    const double tiles = most(&Moment::tile_bytes) / points(), output = stream_.output_bytes / points();
    const double bytes = 2 * input_.bytes / points() + 2 * tiles;
    const double computing = stream_.run.processor_seconds / points() / arguments_.threads;
    std::printf(
        "By these numbers, on machines with %u threads each, and a disk of so much a second:\n\n"
        "| points | machines | hours, 0.5 GB/s | hours, 2 GB/s | computing alone | disk of each, TB | output, GB |\n"
        "|--:|--:|--:|--:|--:|--:|--:|\n",
        arguments_.threads);
    struct Row {
      double points, machines;
    };
    for (const Row& row : {Row{1e9, 1}, Row{1e10, 1}, Row{1e10, 10}, Row{1e12, 10}, Row{1e12, 100}, Row{1e12, 1000}}) {
      const double each = row.points / row.machines;
      // One machine writes the output.
      const auto hours = [&](double disk) {
        return (each * (bytes / disk + computing) + row.points * output / disk) / 3600;
      };
      std::printf("| %.0e | %.0f | %.3g | %.3g | %.3g | %.3g | %.3g |\n", row.points, row.machines, hours(0.5e9),
                  hours(2e9), each * computing / 3600, each * (input_.bytes / points() + tiles) / 1e12,
                  row.points * output / gigabyte);
    }
    std::printf("\n");
  }

  void print_passes() const {
    std::printf("| pass | seconds | ns a point | processor, s | at work |\n|---|--:|--:|--:|--:|\n");
    double from = 0;
    const auto row = [&](const char* name, double seconds) {
      const double used = stream_.run.processor_seconds_at(from + seconds) - stream_.run.processor_seconds_at(from);
      std::printf("| %s | %.1f | %.1f | %.1f | %.2f |\n", name, seconds, 1e9 * seconds / points(), used,
                  seconds > 0 ? used / seconds : 0);
      from += seconds;
    };
    row("1 count", stream_.seconds("count"));
    row("2 cut", stream_.seconds("cut"));
    row("3 compute", stream_.seconds("build"));
    row("4 write", stream_.seconds("write"));
    const double all = stream_.run.seconds;
    std::printf("| all, with start and end | %.1f | %.1f | %.1f | %.2f |\n\n", all, 1e9 * all / points(),
                stream_.run.processor_seconds, stream_.run.processor_seconds / all);
  }

  double most(double Moment::*bytes) const {
    double found = 0;
    for (const Moment& moment : stream_.run.moments) found = std::max(found, moment.*bytes);
    return found;
  }

  void print_bytes() const {
    std::printf("| | bytes | a point |\n|---|--:|--:|\n");
    const auto row = [&](const char* name, double bytes) {
      std::printf("| %s | %.0f | %.2f |\n", name, bytes, bytes / points());
    };
    row("input", input_.bytes);
    row("files of tiles, at most", most(&Moment::tile_bytes));
    row("scratch, at most", most(&Moment::scratch_bytes));
    row("output", stream_.output_bytes);
    row("resident, at most", stream_.run.peak_bytes);
    std::printf("\n%zu tiles, %zu triangles, %zu isolated points", stream_.stats.at("tiles").get<std::size_t>(),
                stream_.stats.at("triangles").get<std::size_t>(), stream_.stats.at("isolated").get<std::size_t>());
    if (stream_.stats.contains("polygons"))
      std::printf(", %zu polygons with %zu holes, area %.9g", stream_.stats.at("polygons").get<std::size_t>(),
                  stream_.stats.at("polygon_holes").get<std::size_t>(), stream_.stats.at("area").get<double>());
    std::printf(".\n\n");
  }

  /// Returns the mean of both rounds, before and after.
  template <typename Value>
  static double mean(Value value) {
    return (value(0) + value(1)) / 2;
  }

  void print_sum() const {
    const double few = static_cast<double>(few_);
    const auto cold = [&](std::size_t i) { return memory_runs_[i].seconds("build") / few; };
    const auto warm = [&](std::size_t i) { return warm_runs_[i].seconds / few; };
    const double read = mean([&](std::size_t i) { return reads_[i]; });
    const double other = 2 * read + write_seconds_;
    const double sum = other + mean(cold) * points(), warm_sum = other + mean(warm) * points();
    std::printf("| what it would take | seconds | measured before and after |\n|---|--:|---|\n");
    std::printf(
        "| reading the input twice | %.1f | once: %.1f s, %.1f s; %.0f %% and %.0f %% of it in the system's memory |\n",
        2 * read, reads_[0], reads_[1], 100 * cached_[0], 100 * cached_[1]);
    std::printf("| writing the output | %.1f | with waiting for the disk |\n", write_seconds_);
    std::printf("| computing as `rbpa %s` | %.1f | ns a point: %.1f, %.1f, of %.0f points; %.0f bytes a point |\n",
                verb_in_memory(), mean(cold) * points(), 1e9 * cold(0), 1e9 * cold(1), few,
                memory_runs_[0].run.peak_bytes / few);
    std::printf("| or in warm memory | %.1f | ns a point: %.1f, %.1f; `alpha_complex()`%s, third run |\n",
                mean(warm) * points(), 1e9 * warm(0), 1e9 * warm(1),
                wants_triangles() ? "" : " and `outline_polygons()`");
    std::printf("| together; with warm memory | %.1f; %.1f | |\n| `rbpa stream` | %.1f | |\n\n", sum, warm_sum,
                stream_.run.seconds);
    std::printf(
        "The reader is that of `rbpa stream`, in one thread. Before each reading, and before the run, the system "
        "dropped the files from its cache.\n\n");
    const Json& memory = memory_runs_[0].stats;
    if (few_ == arguments_.points)
      std::printf("In memory there are %s triangles%s.\n\n",
                  memory.at("triangles") == stream_.stats.at("triangles") ? "as many" : "**other**",
                  memory.value("area", 0.0) == stream_.stats.value("area", 0.0) ? ", and the area is the same"
                                                                                : "; **the area is another**");
    // Other processes on the machine disturb processor time less than wall-clock time.
    const double once = mean([&](std::size_t i) { return read_processor_seconds_[i]; });
    const double warm_processor =
        2 * once + mean([&](std::size_t i) { return warm_runs_[i].processor_seconds; }) / few * points();
    const double ratio = stream_.run.seconds / warm_sum;
    print({{"`rbpa stream` / together", Sense::at_most, 1.6, stream_.run.seconds / sum},
           {"`rbpa stream` / together, with warm memory", Sense::at_most, 1.6, ratio},
           {"the same by the processor's time, without writing", Sense::at_most, 1.6,
            stream_.run.processor_seconds / warm_processor},
           {"resident, at most / --memory", Sense::at_most, 1, stream_.run.peak_bytes / bytes_of_memory()}});
  }

  double bytes_of_memory() const {
    char* end = nullptr;
    const double value = std::strtod(arguments_.memory.c_str(), &end);
    switch (*end) {
      case 'K':
        return value * 0x1p10;
      case 'M':
        return value * 0x1p20;
      case 'G':
        return value * 0x1p30;
      case 'T':
        return value * 0x1p40;
      default:
        return value;
    }
  }

  /// Writes, for draw_figures, one row per pixel of the picture, with the largest values of each.
  void write_trace() const {
    if (arguments_.trace.empty()) return;
    std::ofstream file(arguments_.trace);
    const double counted = stream_.seconds("count"), cut = counted + stream_.seconds("cut"),
                 computed = cut + stream_.seconds("build");
    file << "# " << today() << "; " << processor() << "; " << memory() << "; " << compiler() << " " << compiler_flags()
         << "\n# rbpa stream, " << number("%.0f", points()) << " points, --memory " << arguments_.memory << ", "
         << arguments_.threads << " threads\nseconds,resident,scratch,pass,memory\n";
    constexpr double most_rows = 400;
    const double step = stream_.run.seconds / most_rows;
    const std::vector<Moment>& moments = stream_.run.moments;
    for (std::size_t i = 0; i < moments.size();) {
      const double begin = moments[i].seconds;
      double resident = 0, scratch = 0;
      for (; i < moments.size() && moments[i].seconds < begin + step; ++i) {
        resident = std::max(resident, moments[i].resident_bytes);
        scratch = std::max(scratch, moments[i].scratch_bytes);
      }
      const int pass = begin < counted ? 1 : begin < cut ? 2 : begin < computed ? 3 : 4;
      file << number("%.3f", std::max(begin, 1e-3)) << number(",%.0f", resident)
           << number(",%.0f", std::max(scratch, 1.0)) << ',' << pass << number(",%.0f", bytes_of_memory()) << '\n';
    }
    if (!file.flush()) throw std::runtime_error(arguments_.trace + ": cannot be written");
  }

  const StreamArguments& arguments_;
  std::string folder_;
  std::uint64_t few_;  // number of points of the sample that is computed in memory
  PointFiles input_ = {}, sample_ = {};
  std::vector<double> reads_ = {}, read_processor_seconds_ = {}, cached_ = {};
  std::vector<ProgramRun> memory_runs_ = {};
  std::vector<WarmRun> warm_runs_ = {};
  ProgramRun stream_ = {};
  double write_seconds_ = 0;
};

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse_stream(argc, argv);
  if (!arguments) return 2;
  std::printf("`bench_stream");
  for (int i = 1; i < argc; ++i) std::printf(" %s", argv[i]);
  std::printf("`, ");
  try {
    rbpa_bench::StreamBench(*arguments).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_stream: %s\n", error.what());
    return 1;
  }
  return 0;
}
