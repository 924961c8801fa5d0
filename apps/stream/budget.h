// What: divides the memory that a run may use, and checks whether a disk has room for files that a run will write.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// Returns the memory that the program takes with its libraries before it reads any point, in bytes.
std::uint64_t program_bytes();
/// Peak memory for each point of a tile while the tile is computed, in bytes: input, triangulation, sorting and result.
constexpr std::uint64_t bytes_of_tile_point = 330;
/// The least value of --memory, in bytes.
constexpr std::uint64_t least_memory = std::uint64_t{64} << 20U;

struct Budget {
  unsigned workers;           ///< number of tiles that are computed at the same time
  std::uint64_t tile_points;  ///< the most points of a tile, including the points around the tile
  std::size_t cells;          ///< the most grid cells in which points are counted
  std::uint64_t waiting;      ///< the most points that wait in memory while the input is cut into tiles
  std::uint64_t sort_bytes;   ///< memory for sorting the result at the end, in bytes
};

/// Divides `memory`, in bytes, among at most `threads` workers. Requires: memory ≥ least_memory.
Budget divide(std::uint64_t memory, unsigned threads);

/// Makes the allocator return freed memory to the system, except for a sixteenth of `memory`, for `workers` threads and
/// the reading thread. By default each thread keeps the memory of its largest arrays, several times the memory in use.
/// Does nothing without glibc.
void return_freed_memory(std::uint64_t memory, unsigned workers);

/// Returns the free memory between used blocks to the system; the allocator would keep this memory. Cost: a pass over
/// all free memory.
void return_free_pages();

/// Returns a value of --memory as text, such as "1024M", rounded up.
std::string in_megabytes(std::uint64_t bytes);

/// Returns a value of --memory, in bytes, that suffices for tiles of `tile_points` points and `threads` threads.
std::uint64_t memory_for(std::uint64_t tile_points, unsigned threads);

/// Estimates from a sample of the input how many bytes a point takes in the file of a tile.
class PackedSample {
 public:
  void add(std::span<const Point> points, std::uint64_t first);
  double bytes_per_point() const;

 private:
  std::uint64_t blocks_ = 0, taken_ = 0, points_ = 0, bytes_ = 0;
};

/// Throws Failure that names both amounts if the estimated size of the files of tiles, for `points` points, exceeds the
/// free room on the disk of `folder`.
void require_room_for_tiles(const std::string& folder, double points, const PackedSample& sample);

/// Throws Failure that names both amounts if a file of `bytes` bytes at `path` needs more room than its disk has free.
/// Does nothing if `path` is "-" or exists and is no regular file.
void require_room_for_output(const std::string& path, std::uint64_t bytes);

}  // namespace rbpa::app
