#include "bench/peer.h"

#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <type_traits>

#include "bench/memory.h"

namespace rbpa_bench {
namespace {

/// A folder for the files of one run.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "bench_peer_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

template <typename Value>
void write_all(const std::filesystem::path& path, std::span<const Value> values) {
  static_assert(std::is_trivially_copyable_v<Value>);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

struct Ended {
  int status;
  double seconds;
  double peak_bytes;
};

Ended run_shell(const std::string& command, const std::filesystem::path& said) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    const int nothing = open("/dev/null", O_RDWR), errors = creat(said.c_str(), 0600);
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

/// What it said on standard error: its time, and the last line for those who ask why it failed.
struct Said {
  std::optional<double> seconds;
  std::string last_line;
};

Said read_said(const std::filesystem::path& path) {
  Said said;
  std::ifstream file(path);
  constexpr std::string_view key = "seconds ";
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) said.last_line = line;
    if (!line.starts_with(key)) continue;
    double value = 0;
    const char* const end = line.data() + line.size();
    const auto [rest, error] = std::from_chars(line.data() + key.size(), end, value);
    if (error != std::errc{} || rest != end || !(value > 0) || !std::isfinite(value))
      throw std::runtime_error("said '" + line + "', expected seconds and a number above 0");
    said.seconds = value;
  }
  return said;
}

void refuse_failure(int status, const Said& said) {
  const std::string why = said.last_line.empty() ? "" : ": " + said.last_line;
  if (WIFSIGNALED(status)) throw std::runtime_error("ended by signal " + std::to_string(WTERMSIG(status)) + why);
  if (WEXITSTATUS(status) != 0) throw std::runtime_error("ended with " + std::to_string(WEXITSTATUS(status)) + why);
}

Triangles read_triangles(const std::filesystem::path& path, std::size_t points) {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(path, error);
  if (error) throw std::runtime_error("wrote no triangles");
  if (bytes % sizeof(rbpa_test::Triangle) != 0)
    throw std::runtime_error("wrote " + std::to_string(bytes) + " bytes, expected 12 for each triangle");
  Triangles triangles(bytes / sizeof(rbpa_test::Triangle));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(triangles.data()), static_cast<std::streamsize>(bytes));
  if (!file) throw std::runtime_error("its triangles cannot be read");
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t corner : triangles[t])
      if (corner >= points)
        throw std::runtime_error("triangle " + std::to_string(t) + " has point " + std::to_string(corner) + " of " +
                                 std::to_string(points));
  return triangles;
}

}  // namespace

Run run_peer(const std::string& command, std::span<const rbpa::Point> points, Triangles* list) {
  const Folder folder;
  const auto in = folder / "points", out = folder / "triangles", said_here = folder / "said";
  static_assert(sizeof(rbpa::Point) == 2 * sizeof(double));
  write_all(in, points);
  malloc_trim(0);  // what this process has at the start of another counts as the other's
  const std::optional<double> own_bytes = resident_bytes();
  const Ended ended = run_shell(command + " " + quoted(in.string()) + " " + quoted(out.string()), said_here);
  const Said said = read_said(said_here);
  refuse_failure(ended.status, said);

  Triangles triangles = read_triangles(out, points.size());
  Run run{said.seconds.value_or(ended.seconds), triangles.size(), said.seconds ? Clock::peer : Clock::process};
  if (own_bytes && ended.peak_bytes > *own_bytes) run.process_bytes = ended.peak_bytes;
  if (list) *list = std::move(triangles);
  return run;
}

Contestant peer(const std::string& name, const std::string& command) {
  return {name,
          [command](std::span<const rbpa::Point> points, double, Triangles* list) {
            return run_peer(command, points, list);
          },
          /*takes_alpha=*/false, /*is_program=*/true};
}

}  // namespace rbpa_bench
