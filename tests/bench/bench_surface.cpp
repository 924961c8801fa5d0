// Measures ball pivoting in space: rbpa::surface(), the policy on the engine, Open3D and any other program.
//   bench_surface [OPTIONS]; an unknown option prints the list of options
// Contestants run in turn in one process, as in bench_report; with --cold each run has a process of its own, as in
// bench_cold. docs/reference/performance.md.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/arguments.h"
#include "bench/machine.h"
#include "bench/memory.h"
#include "bench/shell_run.h"
#include "bench/surface_contest.h"
#include "bench/tables.h"
#include "bench/targets.h"

namespace rbpa_bench {
namespace {

struct SurfaceArguments {
  std::size_t points = 1000000, growth = 0;
  int runs = 5;
  double patience = 60;
  double radius = 0;     // 0: all radii
  std::string set = {};  // only the set of this name; empty: all sets
  bool cold = false, by_processor = false, without_engine = false, slow = false;
  std::vector<SurfaceContestant> programs = {};
};

std::optional<SurfaceArguments> parse_surface(int argc, char** argv) {
  SurfaceArguments arguments;
  const auto take = [&](const std::string& given) {
    constexpr std::size_t fewest = 1000;
    if (const auto text = behind(given, "--points="))
      return read_number(*text, arguments.points) && arguments.points >= fewest;
    if (const auto text = behind(given, "--growth="))
      return read_number(*text, arguments.growth) && arguments.growth >= fewest;
    if (const auto text = behind(given, "--runs=")) return read_number(*text, arguments.runs) && arguments.runs > 0;
    if (const auto text = behind(given, "--patience="))
      return read_number(*text, arguments.patience) && arguments.patience > 0;
    if (const auto text = behind(given, "--program=")) {
      const std::string program(*text);
      const std::size_t sign = program.find('=');
      if (sign == std::string::npos || sign == 0) return false;
      arguments.programs.push_back(surface_program(program.substr(0, sign), program.substr(sign + 1)));
      return true;
    }
    if (const auto text = behind(given, "--radius="))
      return read_number(*text, arguments.radius) &&
             (arguments.radius == 1 || arguments.radius == 2 || arguments.radius == 4);
    if (const auto text = behind(given, "--set=")) {
      arguments.set = *text;
      return !arguments.set.empty();
    }
    if (given == "--cold") return arguments.cold = true;
    if (given == "--by-processor") return arguments.by_processor = true;
    if (given == "--without-engine") return arguments.without_engine = true;
    if (given == "--slow") return arguments.slow = true;
    return false;
  };
  for (int i = 1; i < argc; ++i) {
    std::string given = argv[i];
    if (given == "--program" && i + 1 < argc) given += std::string("=") + argv[++i];
    std::string why;
    try {
      if (take(given)) continue;
      why = "found '" + given + "'";
    } catch (const std::invalid_argument& error) {
      why = error.what();
    }
    std::fprintf(
        stderr,
        "%s: %s\n"
        "usage: %s [OPTIONS]\n"
        "  --points=N              1000000\n"
        "  --runs=N                5\n"
        "  --slow                  measure the sets on which a point may cost more: lines, outliers, a street, a grid\n"
        "  --set=NAME              measure only this set, such as street\n"
        "  --radius=2              measure only this radius, in spacings: 1, 2 or 4\n"
        "  --growth=N              also measure spheres of 100000 points, twice as many, and so on up to N\n"
        "  --patience=S            60; a contestant that took longer is not run again in a contest\n"
        "  --by-processor          measure processor seconds, of all threads\n"
        "  --cold                  run each contestant in a process of its own\n"
        "  --without-engine        leave out the policy on the engine, which is slower\n"
        "  --program NAME=COMMAND  COMMAND has {in}, {out} and may have {radius} (tests/bench/surface_contest.h)\n",
        argv[0], why.c_str(), argv[0]);
    return std::nullopt;
  }
  return arguments;
}

enum { one_thread, two_threads, mesh };  // indices of contestants

std::vector<SurfaceContestant> contestants_of(const SurfaceArguments& arguments) {
  std::vector<SurfaceContestant> all = {surface_with(1), surface_with(2), surface_mesh_with(1)};
  if (!arguments.without_engine) all.push_back(ball_pivoting_on_engine());
  for (const SurfaceContestant& contestant : open3d()) all.push_back(contestant);
  for (const SurfaceContestant& program : arguments.programs) all.push_back(program);
  return all;
}

// A single run in a process of its own
// -----------------------------------------------------------------------------------

void write_samples(const std::filesystem::path& path, const SurfacePoints& samples, double radius) {
  std::ofstream file(path, std::ios::binary);
  const auto write = [&](const auto* values, std::size_t count) {
    file.write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof *values));
  };
  const std::size_t count = samples.points.size();
  write(&count, 1);
  write(&radius, 1);
  write(samples.points.data(), count);
  write(samples.normals.data(), count);
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

SurfacePoints read_samples(const std::string& path, double& radius) {
  SurfacePoints samples{"", {}, {}, 1};
  std::ifstream file(path, std::ios::binary);
  const auto read = [&](auto* values, std::size_t count) {
    file.read(reinterpret_cast<char*>(values), static_cast<std::streamsize>(count * sizeof *values));
  };
  std::size_t count = 0;
  read(&count, 1);
  read(&radius, 1);
  if (file) {
    samples.points.resize(count);
    samples.normals.resize(count);
    read(samples.points.data(), count);
    read(samples.normals.data(), count);
  }
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return samples;
}

/// Runs in the child process: prints seconds, processor seconds, triangles and bytes.
int one(std::string_view name, const std::string& path) {
  const std::vector<SurfaceContestant> all = contestants_of({});
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& contestant) { return contestant.name == name; });
  if (found == all.end()) return 2;
  double radius = 0;
  const SurfacePoints samples = read_samples(path, radius);
  Run run{};
  const std::optional<double> bytes = rise_of_peak([&] { run = found->run(samples, radius); });
  std::printf("%.9g %.9g %zu %.0f\n", run.seconds, run.processor_seconds.value_or(NAN), run.triangles,
              bytes.value_or(NAN));
  return 0;
}

Run run_alone(const std::string& contestant, const std::filesystem::path& samples) {
  const std::string command = "/proc/self/exe", name = "--one=" + contestant;
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe can be made");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    if (dup2(ends[1], STDOUT_FILENO) >= 0)
      execl(command.c_str(), command.c_str(), name.c_str(), samples.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  FILE* const said = fdopen(ends[0], "r");
  Run run{};
  double processor = NAN, bytes = NAN;
  const bool told = std::fscanf(said, "%lf %lf %zu %lf", &run.seconds, &processor, &run.triangles, &bytes) == 4;
  std::fclose(said);
  int status = 0;
  waitpid(child, &status, 0);
  if (!told || !WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("the process reported nothing");
  run.processor_seconds = processor;
  run.process_bytes = bytes;
  return run;
}

/// Returns the same contestants, each run in a fresh process; other programs are run in this way anyway.
std::vector<SurfaceContestant> alone(std::vector<SurfaceContestant> all) {
  for (SurfaceContestant& contestant : all)
    if (!contestant.is_program)
      contestant.run = [name = contestant.name](const SurfacePoints& samples, double radius) {
        const RunFolder folder;
        write_samples(folder / "samples", samples, radius);
        return run_alone(name, folder / "samples");
      };
  return all;
}

void print_head(const std::vector<SurfaceContestant>& all) {
  std::printf("| points | number | radius | triangles |");
  for (const SurfaceContestant& contestant : all) std::printf(" %s |", contestant.name.c_str());
  std::printf("\n|---|--:|--:|--:|");
  for (std::size_t i = 0; i < all.size(); ++i) std::printf("--:|");
  std::printf("\n");
}

/// Adds the target of a contest: the factor by which it must be faster than Open3D.
void add_targets(const Contest& contest, double times, bool by_processor, std::vector<Target>& targets) {
  const std::string what = contest.set + ", radius " + contest.alpha_text + ": ";
  const std::string first = surface_with(1).name, second = surface_with(2).name, whole = surface_mesh_with(1).name;
  targets.push_back({what + "Open3D / " + first, Sense::at_least, times, speedup(contest, first, "Open3D")});
  if (!by_processor)
    targets.push_back({what + "one thread / two", Sense::at_least, 1.7, speedup(contest, second, first)});
  if (const Outcome* outcome = contest.of(whole); outcome && outcome->bytes)
    targets.push_back(
        {what + "bytes a point, mesh", Sense::at_most, 250, *outcome->bytes / static_cast<double>(contest.points)});
}

/// Prints numbers of triangles. Contestants have different definitions, so that different numbers are no error.
void print_triangles(const std::vector<Contest>& contests) {
  for (const Contest& contest : contests) {
    std::printf("- %s, radius %s:", contest.set.c_str(), contest.alpha_text.c_str());
    for (const Outcome& outcome : contest.outcomes)
      if (outcome.failure.empty()) std::printf(" %s %zu;", outcome.contestant.c_str(), outcome.triangles);
    std::printf("\n");
  }
}

void report(const SurfaceArguments& arguments) {
  std::vector<SurfaceContestant> all = contestants_of(arguments);
  const Settings settings{arguments.runs, !arguments.cold, false, arguments.by_processor, arguments.patience};
  if (open3d().empty()) std::printf("Open3D was not there when this was compiled (libopen3d-dev).\n\n");
  if (arguments.cold)
    std::printf("%s; %d processes of each in turn, one run each.\n\n", machine_and_build().c_str(), arguments.runs);
  else
    print_machine(arguments.runs);
  std::printf(
      "Nanoseconds a point%s: median (least–most); how many times as long as the first. The radius is in spacings.\n\n",
      arguments.by_processor ? ", by the processor's time of all threads" : "");
  std::vector<Contest> contests;
  std::vector<Target> targets;
  print_head(all);
  struct Wanted {
    SurfacePoints samples;
    double radius, times;
  };
  const std::size_t n = arguments.points;
  std::vector<Wanted> all_wanted;
  if (arguments.slow) {
    for (const SurfacePoints& samples :
         {on_sphere(n, 0), on_scan_lines(n), with_outliers(n), on_street(n), on_grid(n), ten_times(n)})
      for (const double radius : {1.0, 2.0, 4.0}) all_wanted.push_back({samples, radius, 1});
  } else {
    const SurfacePoints sphere = on_sphere(n, 0), torus = on_double_torus(n), noisy = on_sphere(n, 0.1);
    all_wanted = {{sphere, 2, 15}, {sphere, 4, 25}, {torus, 2, 15}, {torus, 4, 25}, {noisy, 2, 12}};
  }
  for (const auto& [samples, radius, times] : all_wanted) {
    if (arguments.radius != 0 && arguments.radius != radius) continue;
    if (!arguments.set.empty() && arguments.set != samples.name) continue;
    const std::vector<SurfaceContestant> fresh = alone(all);
    contests.push_back(measure_surface(samples, radius, arguments.cold ? fresh : all, settings));
    if (!arguments.cold)
      for (std::size_t i = 0; i < all.size(); ++i)
        if (Outcome& outcome = contests.back().outcomes[i]; outcome.failure.empty() && !all[i].is_program)
          outcome.bytes = fresh[i].run(samples, radius * samples.spacing).process_bytes;
    print_time_row(contests.back());
    add_targets(contests.back(), times, arguments.by_processor, targets);
  }
  if (arguments.growth > 0) {
    all.resize(mesh + 1);
    std::vector<double> each;
    for (std::size_t count = 100000; count <= arguments.growth; count *= 2) {
      const Contest contest = measure_surface(on_sphere(count, 0), 2, all, settings);
      if (const Outcome& outcome = contest.outcomes[one_thread]; outcome.is_good())
        each.push_back(contest.nanoseconds_a_point(outcome));
      print_time_row(contest);
    }
    if (each.size() > 1)
      targets.push_back(
          {"sphere, a point: the most points / the fewest", Sense::at_most, 1.35, each.back() / each.front()});
  }
  std::printf("\nTriangles:\n\n");
  print_triangles(contests);
  std::printf(
      "\nBytes a point: how far resident memory rises above what it was with the points in it, in a process of its "
      "own.\n\n");
  print_memory(contests);
  print_clocks(contests);
  std::printf("\n");
  print(targets);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  if (argc == 3)
    if (const auto name = behind(argv[1], "--one=")) return one(*name, argv[2]);
  const auto arguments = parse_surface(argc, argv);
  if (!arguments) return 2;
  if (!arguments->cold) keep_memory();
  report(*arguments);
}
