// What: how the memory that a run may take is divided, and whether a disk has room for what is about to be written, as
//       far as that can be known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// Bytes of the program with its libraries, before it has a point.
constexpr std::uint64_t program_bytes = std::uint64_t{24} << 20U;
/// The most bytes per point of a tile in work: its input, triangulation, sorting and result.
constexpr std::uint64_t bytes_of_tile_point = 330;
/// The least --memory.
constexpr std::uint64_t least_memory = std::uint64_t{64} << 20U;

struct Budget {
  unsigned workers;           ///< tiles in work at a time
  std::uint64_t tile_points;  ///< that a tile may have, those around it included
  std::size_t cells;          ///< in which points are counted
  std::uint64_t waiting;      ///< points that wait to be written while tiles are cut
  std::uint64_t sort_bytes;   ///< for what is put in order at the end
};

/// Requires at least least_memory.
Budget divide(std::uint64_t memory, unsigned threads);

/// Makes the allocator return freed memory to the system, but for a small part of `memory`. By default it keeps the
/// memory of the largest arrays, for each thread: several times what is in use. Of the whole process.
void return_freed_memory(std::uint64_t memory, unsigned workers);

/// Returns free memory between blocks in use to the system, which the allocator keeps otherwise. Cost: a pass over all
/// free memory.
void return_free_pages();

/// The memory with which a tile of so many points would do, by so many threads.
std::uint64_t memory_for(std::uint64_t tile_points, unsigned threads);

/// How many bytes points take in the files of tiles, by some of them.
class PackedSample {
 public:
  void add(std::span<const Point> points, std::uint64_t first);
  double bytes_per_point() const;

 private:
  std::uint64_t blocks_ = 0, taken_ = 0, points_ = 0, bytes_ = 0;
};

/// Throws Failure saying how much is free and how much is needed, here as below.
void require_room_for_tiles(const std::string& folder, double points, const PackedSample& sample);

/// For the file at `path`, unless that is no file.
void require_room_for_output(const std::string& path, std::uint64_t bytes);

}  // namespace rbpa::app
