#include "bench/peer.h"

#include <malloc.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <type_traits>

#include "bench/memory.h"
#include "bench/shell_run.h"

namespace rbpa_bench {
namespace {

template <typename Value>
void write_all(const std::filesystem::path& path, std::span<const Value> values) {
  static_assert(std::is_trivially_copyable_v<Value>);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
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
  const RunFolder folder;
  const auto in = folder / "points", out = folder / "triangles", said_here = folder / "said";
  static_assert(sizeof(rbpa::Point) == 2 * sizeof(double));
  write_all(in, points);
  malloc_trim(0);  // memory of this process at the start of another counts as the other's
  const std::optional<double> own_bytes = resident_bytes();
  const ShellRun ended = run_shell(command + " " + quoted(in.string()) + " " + quoted(out.string()), said_here);

  Triangles triangles = read_triangles(out, points.size());
  Run run{ended.seconds, triangles.size(), ended.clock};
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
