#include "stream/budget.h"

#include <sys/stat.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <numeric>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "io/bytes/available_memory.h"
#include "io/failure.h"
#include "io/polygon/ogr.h"
#include "stream/pack_block.h"

namespace rbpa::app {
namespace {

/// Returns the memory that tiles may not use, in bytes: that of the program, and three sixteenths of `memory`: one for
/// freed memory that the allocator keeps, one for triangles that wait, one for unfinished parts between tiles.
std::uint64_t reserve_of(std::uint64_t memory) { return program_bytes() + memory / 16 * 3; }

/// Throws Failure if the disk of `folder` has less room than `needed` bytes. Does nothing if the room is unknown.
void require_room(const std::string& folder, double needed, const std::string& where, const std::string& what) {
  struct statvfs status {};
  if (statvfs(folder.c_str(), &status) != 0) return;
  const double free = static_cast<double>(std::uint64_t{status.f_bavail} * status.f_frsize);
  if (free >= needed) return;
  throw Failure(where + ": found " + bytes_text(free) + " free on its disk, expected " + bytes_text(needed) + " for " +
                what);
}

}  // namespace

std::uint64_t program_bytes() {
  // GDAL and its libraries take 31 MiB more. The other parts leave some 20 of these unused.
  return std::uint64_t{has_gdal() ? 35U : 24U} << 20U;
}

Budget divide(std::uint64_t memory, unsigned threads) {
  const std::uint64_t left = memory - std::min(memory, reserve_of(memory));
  // Prefer fewer workers to smaller tiles: a small tile has more points around it than in it.
  constexpr std::uint64_t points_worth_a_worker = 50'000;
  const std::uint64_t most = std::max<std::uint64_t>(left / (points_worth_a_worker * bytes_of_tile_point), 1);
  Budget budget{};
  budget.workers = static_cast<unsigned>(std::min<std::uint64_t>(most, std::max(threads, 1U)));
  budget.tile_points = left / budget.workers / bytes_of_tile_point;
  budget.cells = std::clamp<std::size_t>(left / 256, std::size_t{1} << 12U, std::size_t{1} << 17U);
  budget.waiting = left / 64;
  budget.sort_bytes = left / 2;
  return budget;
}

void return_freed_memory([[maybe_unused]] std::uint64_t memory, [[maybe_unused]] unsigned workers) {
#ifdef __GLIBC__
  // Set the size from which arrays are mapped separately, so that freeing returns them to the system. Each thread,
  // including the reading thread, may keep twice this size of smaller arrays: all threads together a sixteenth of
  // `memory`. A size above the upper limit gains nothing.
  const std::uint64_t share = memory / 32 / (workers + 1);
  const auto size =
      static_cast<int>(std::clamp<std::uint64_t>(share, std::uint64_t{1} << 17U, std::uint64_t{1} << 23U));
  mallopt(M_MMAP_THRESHOLD, size);
  mallopt(M_TRIM_THRESHOLD, 2 * size);
#endif
}

void return_free_pages() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

std::string in_megabytes(std::uint64_t bytes) {
  constexpr std::uint64_t megabyte = std::uint64_t{1} << 20U;
  return std::to_string((bytes + megabyte - 1) / megabyte) + "M";
}

std::uint64_t memory_for(std::uint64_t tile_points, unsigned threads) {
  const std::uint64_t used = program_bytes() + tile_points * bytes_of_tile_point * std::max(threads, 1U);
  return std::max(least_memory, used * 16 / 13 + used / 16);
}

void PackedSample::add(std::span<const Point> points, std::uint64_t first) {
  if (points.empty()) return;
  // Sample the first nine blocks, no block up to the 18th, and every second block from the 19th on.
  if (blocks_++ < 2 * taken_ && taken_ > 8) return;
  ++taken_;
  const std::span<const Point> some = points.first(std::min(points.size(), most_in_packed_block));
  std::vector<std::uint64_t> indices(some.size());
  std::iota(indices.begin(), indices.end(), first);
  PackingHint hint;
  std::string bytes;
  pack_block(some, indices, hint, bytes);
  points_ += some.size();
  bytes_ += bytes.size();
}

double PackedSample::bytes_per_point() const {
  return points_ == 0 ? 0 : static_cast<double>(bytes_) / static_cast<double>(points_);
}

void require_room_for_tiles(const std::string& folder, double points, const PackedSample& sample) {
  // Multiply the bytes for each point of the sample by 0.8, a lower estimate: in the file of a tile indices are farther
  // apart and coordinates closer than in the input.
  require_room(folder, points * sample.bytes_per_point() * 0.8, folder,
               "the files of tiles (--scratch DIR on another disk)");
}

void require_room_for_output(const std::string& path, std::uint64_t bytes) {
  struct stat file {};
  if (path == "-" || (stat(path.c_str(), &file) == 0 && !S_ISREG(file.st_mode))) return;
  const std::string folder = path.rfind('/') == std::string::npos ? "." : path.substr(0, path.rfind('/') + 1);
  require_room(folder, static_cast<double>(bytes), path, "the triangles");
}

}  // namespace rbpa::app
