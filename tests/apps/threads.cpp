// `--threads`: the same files, at most this many threads, its statistics, wrong usage.
#include <dirent.h>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "rbpa/rbpa.h"
#include "support/las_file.h"
#include "support/laz_file.h"
#include "support/program.h"

using namespace apps_test;

namespace {

/// Writes a file of random points.
std::string scattered(const Folder& folder, std::size_t count) {
  std::string bytes(count * 2 * sizeof(double), '\0');
  double* values = reinterpret_cast<double*>(bytes.data());
  unsigned state = 1;
  for (std::size_t i = 0; i < 2 * count; ++i) values[i] = (state = state * 1664525u + 1013904223u) >> 8;
  return folder.file("p.f64xy", bytes);
}

constexpr std::size_t many = 20'000;  // enough for several threads to share

/// All ways to triangulate points.
const std::vector<std::string> runs = {
    "mesh p.f64xy --alpha 60000 -o m.off -o m.npy -o m.png",
    "mesh p.f64xy --alpha 60000 --method hrbpa --leaf-capacity 100 -o m.off -o m.npy",
    "mesh p.f64xy --alpha 60000 --complex full -o m.obj -o m.npy -o m.svg",
    "mesh p.f64xy --alpha auto -o m.off",
    "shape p.f64xy --alpha 60000 -o s.geojson",
    "shape p.f64xy --alpha min --method hrbpa -o s.geojson",
    "alpha p.f64xy --json --persistence -o a.svg",
};

/// The messages and all files of a run.
std::vector<std::string> left_by(const Folder& folder, const std::string& run) {
  const Outcome outcome = folder.rbpa(run, 0);
  std::vector<std::string> left = {outcome.out, outcome.err};
  for (const std::string& name : folder.names()) left.push_back(folder.content(name));
  return left;
}

std::size_t threads_of(pid_t process) {
  DIR* const folder = opendir(("/proc/" + std::to_string(process) + "/task").c_str());
  if (!folder) return 0;
  std::size_t count = 0;
  while (const dirent* const entry = readdir(folder)) count += entry->d_name[0] != '.';
  closedir(folder);
  return count;
}

/// Returns the most threads seen in `rbpa ARGUMENTS`; arguments are words separated by blanks.
std::size_t most_threads_seen(const Folder& folder, const std::string& arguments) {
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.path("").c_str()) != 0) _exit(126);
    dup2(open("/dev/null", O_WRONLY), 1);
    const std::string command = "exec '" RBPA_PROGRAM "' " + arguments;
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  std::size_t most = 0;
  for (int status = 0;; usleep(200)) {
    most = std::max(most, threads_of(child));
    if (waitpid(child, &status, WNOHANG) != child) continue;
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    return most;
  }
}

}  // namespace

TEST_SUITE("threads") {
  TEST_CASE("the number of threads changes no byte") {
    const Folder folder;
    scattered(folder, many);
    for (const std::string& run : runs) {
      CAPTURE(run);
      const std::vector<std::string> expected = left_by(folder, run);
      for (const char* threads : {" --threads 1", " --threads 2", " --threads 1024"}) {
        CAPTURE(threads);
        CHECK(left_by(folder, run + threads) == expected);
      }
    }
  }

  TEST_CASE("at most the requested number of threads run") {
    const Folder folder;
    scattered(folder, 4 * many);
    for (const std::string& run : runs) {
      CAPTURE(run);
      CHECK(most_threads_seen(folder, run + " -q --threads 1") == 1);
    }
    // More threads would have been seen: a look may come at the wrong moment, but not each time.
    if (rbpa::threads_used(many, 0) == 1) return;
    std::size_t most = 0;
    for (int attempt = 0; attempt < 50 && most < 2; ++attempt) most = most_threads_seen(folder, runs[0] + " -q");
    CHECK(most >= 2);
  }

  TEST_CASE("points are decompressed by at most the requested number of threads") {
    const Folder folder;
    LasFile las{.points = std::vector<LasPoint>(200'000)};
    for (std::size_t i = 0; i < las.points.size(); ++i) las.points[i].x = static_cast<std::int32_t>(i * i % 1000);
    folder.file("p.laz",
                laz_of(bytes_of(las), {.items = {{0, 20, 2}}, .chunks = std::vector<std::size_t>(20, 10'000)}));
    CHECK(most_threads_seen(folder, "info p.laz -q --threads 1") == 1);
    CHECK(folder.rbpa("info p.laz --threads 1").out == folder.rbpa("info p.laz --threads 7").out);
    if (std::thread::hardware_concurrency() < 2) return;
    std::size_t most = 0;
    for (int attempt = 0; attempt < 50 && most < 2; ++attempt) most = most_threads_seen(folder, "info p.laz -q");
    CHECK(most >= 2);
  }

  TEST_CASE("statistics have the number of threads") {
    const Folder folder;
    const auto said = [&](const std::string& run) {
      CAPTURE(run);
      REQUIRE(folder.rbpa(run + " -q --stats s.json").code == 0);
      return nlohmann::json::parse(folder.content("s.json"))["threads"].get<unsigned>();
    };
    scattered(folder, many);
    const unsigned processors = rbpa::threads_used(many, 0);
    for (const std::string& run : runs) {
      CHECK(said(run) == processors);
      CHECK(said(run + " --threads 1") == 1);
      CHECK(said(run + " --threads 2") == std::min(2u, processors));
      CHECK(said(run + " --threads 1024") == processors);
    }
    CHECK(said("info p.f64xy") == 1);
    scattered(folder, 100);
    CHECK(said(runs[0] + " --threads 2") == 1);
  }

  TEST_CASE("a wrong number of threads is refused before anything is read") {
    const Folder folder;
    for (const std::string verb :
         {"mesh none.xy --alpha 1 -o m.off", "shape none.xy --alpha 1 -o s.wkt", "alpha none.xy"})
      for (const std::string wrong :
           {"0", "-1", "1025", "99999999999999999999", "2.0", "1e1", "2x", "+2", " 2", "all"}) {
        CAPTURE(wrong);
        refuses(folder, verb + " --threads '" + wrong + "'", 2,
                "--threads: found '" + wrong + "', expected a whole number from 1 to 1024");
        CHECK(folder.names().empty());
      }
  }
}
