// What: divides the memory that a run may take, and checks whether a disk has room for the next files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// Memory of the program with its libraries before it reads a point, in bytes.
constexpr std::uint64_t program_bytes = std::uint64_t{24} << 20U;
/// Peak memory per point of a tile in work, in bytes: its input, triangulation, sorting and result.
constexpr std::uint64_t bytes_of_tile_point = 330;
/// The least --memory, in bytes.
constexpr std::uint64_t least_memory = std::uint64_t{64} << 20U;

struct Budget {
  unsigned workers;           ///< tiles in work at a time
  std::uint64_t tile_points;  ///< the most points of a tile, those around it included
  std::size_t cells;          ///< the most cells in which points are counted
  std::uint64_t waiting;      ///< the most points that wait to be written while tiles are cut
  std::uint64_t sort_bytes;   ///< memory for sorting the result at the end
};

/// Divides the memory. Requires: memory >= least_memory.
Budget divide(std::uint64_t memory, unsigned threads);

/// Makes the allocator of the whole process return freed memory to the system, except for a small part of `memory`. By
/// default it keeps the memory of the largest arrays for each thread, several times what is in use.
void return_freed_memory(std::uint64_t memory, unsigned workers);

/// Returns free memory between blocks in use, which the allocator would keep, to the system. Cost: a pass over all free
/// memory.
void return_free_pages();

/// Returns the memory with which tiles may have so many points, with so many threads.
std::uint64_t memory_for(std::uint64_t tile_points, unsigned threads);

/// Estimates from a sample how many bytes points take in the files of tiles.
class PackedSample {
 public:
  void add(std::span<const Point> points, std::uint64_t first);
  double bytes_per_point() const;

 private:
  std::uint64_t blocks_ = 0, taken_ = 0, points_ = 0, bytes_ = 0;
};

/// Throws Failure if the files of tiles need more room than is free; it names both amounts.
void require_room_for_tiles(const std::string& folder, double points, const PackedSample& sample);

/// Throws Failure if the file at `path` needs more room than is free; names both amounts. Ignores a path that is not a
/// regular file.
void require_room_for_output(const std::string& path, std::uint64_t bytes);

}  // namespace rbpa::app
