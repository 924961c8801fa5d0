// What: divides the memory that a run may use, and checks whether a disk has room for the next files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// Memory of the program with its libraries before it reads any point, in bytes.
constexpr std::uint64_t program_bytes = std::uint64_t{24} << 20U;
/// Peak memory for each point of a tile that is computed, in bytes: for input, triangulation, sorting and result.
constexpr std::uint64_t bytes_of_tile_point = 330;
/// The least --memory, in bytes.
constexpr std::uint64_t least_memory = std::uint64_t{64} << 20U;

struct Budget {
  unsigned workers;           ///< number of tiles that are computed at the same time
  std::uint64_t tile_points;  ///< the most points of a tile, including the points around it
  std::size_t cells;          ///< the most cells in which points are counted
  std::uint64_t waiting;      ///< the most points that wait in memory while tiles are cut
  std::uint64_t sort_bytes;   ///< memory for sorting the result at the end, in bytes
};

/// Divides `memory`, in bytes, among at most `threads` workers. Requires: memory ≥ least_memory.
Budget divide(std::uint64_t memory, unsigned threads);

/// Makes the allocator of the whole process return freed memory to the system, except for a small part of `memory`. By
/// default the allocator keeps the memory of the largest arrays of each thread, several times as much as is in use.
void return_freed_memory(std::uint64_t memory, unsigned workers);

/// Returns to the system the free memory between used blocks, which the allocator would keep. Cost: a pass over all
/// free memory.
void return_free_pages();

/// Returns memory, in bytes, that suffices for tiles of `tile_points` points with `threads` threads.
std::uint64_t memory_for(std::uint64_t tile_points, unsigned threads);

/// Estimates from a sample how many bytes points take in the files of tiles.
class PackedSample {
 public:
  void add(std::span<const Point> points, std::uint64_t first);
  double bytes_per_point() const;

 private:
  std::uint64_t blocks_ = 0, taken_ = 0, points_ = 0, bytes_ = 0;
};

/// Throws Failure that names both amounts if the files of tiles, with `points` points, need more room than is free in
/// `folder`.
void require_room_for_tiles(const std::string& folder, double points, const PackedSample& sample);

/// Throws Failure that names both amounts if a file of `bytes` bytes at `path` needs more room than is free. Ignores a
/// path that exists and is not a regular file.
void require_room_for_output(const std::string& path, std::uint64_t bytes);

}  // namespace rbpa::app
