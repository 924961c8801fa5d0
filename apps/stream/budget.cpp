#include "stream/budget.h"

#include <algorithm>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace rbpa::app {
namespace {

/// What there is beside tiles: a sixteenth that the allocator may keep (return_freed_memory), as much for triangles that wait
/// to be written to their files, and as much for what is open between tiles.
std::uint64_t reserve_of(std::uint64_t memory) { return program_bytes + memory / 16 * 3; }

}  // namespace

Budget divide(std::uint64_t memory, unsigned threads) {
  const std::uint64_t left = memory - std::min(memory, reserve_of(memory));
  // Tiles that are too small have more around them than in them.
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
  // Arrays from this size on are mapped by themselves, and go when they are freed. Of the rest each thread, the one that
  // reads included, may keep twice as much: together a sixteenth of the memory. More than the last bound gains nothing.
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

std::uint64_t memory_for(std::uint64_t tile_points, unsigned threads) {
  const std::uint64_t used = program_bytes + tile_points * bytes_of_tile_point * std::max(threads, 1U);
  return std::max(least_memory, used * 16 / 13 + used / 16);
}

}  // namespace rbpa::app
