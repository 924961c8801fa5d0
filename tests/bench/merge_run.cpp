#include "bench/merge_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/lidar_points.h"
#include "bench/stopwatch.h"
#include "rbpa/partial.h"
#include "rbpa/partial_bytes.h"

namespace rbpa_bench {
namespace {

double corner_bytes(const rbpa::CornerRing& ring) { return 16 * static_cast<double>(ring.size()); }

class Merging {
 public:
  explicit Merging(const MergePlan& plan) : plan_(plan), ground_(Ground::jittered, 0, plan.seed) {}

  MergeRun run() {
    rbpa::Partial whole = merged(plan_.all(), 0);
    const rbpa::WholeComplex rest = rbpa::finish(std::move(whole));
    run_.triangles = static_cast<double>(rest.counts.triangles);
    return std::move(run_);
  }

 private:
  rbpa::Partial merged(const TileBlock& block, std::size_t depth) {
    rbpa::Partial part;
    if (block.tiles() == 1) {
      part = tile(block);
    } else {
      const auto [first, second] = halves_of(block);
      rbpa::Partial a = merged(first, depth + 1), b = merged(second, depth + 1);
      const Stopwatch watch;
      part = rbpa::merge(std::move(a), std::move(b));
      run_.merge_seconds += watch.processor_seconds();
    }
    return sent(std::move(part), block, depth);
  }

  rbpa::Partial tile(const TileBlock& block) {
    const auto margin = static_cast<std::int64_t>(std::ceil(2 * plan_.alpha)) + 1;
    const std::int64_t end = plan_.across * plan_.side;
    const auto clamped = [&](std::int64_t at) { return std::clamp<std::int64_t>(at, 0, end); };
    const std::int64_t column = block.column * plan_.side, row = block.row * plan_.side;
    ground_.in_squares({clamped(column - margin), clamped(row - margin), clamped(column + plan_.side + margin),
                        clamped(row + plan_.side + margin)},
                       points_, indices_);
    const Stopwatch watch;
    rbpa::Partial made = rbpa::partial(region_of(block), {points_, indices_}, plan_.alpha, {.threads = 1});
    run_.tile_seconds += watch.processor_seconds();
    run_.points += static_cast<double>(made.counts().points);
    return made;
  }

  /// Returns the region of a block. Tiles at the end of the ground include everything beyond.
  rbpa::Region region_of(const TileBlock& block) const {
    const rbpa::Point low = LidarPoints::corner_of(block.column * plan_.side, block.row * plan_.side),
                      high = LidarPoints::corner_of(block.last_column * plan_.side, block.last_row * plan_.side);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {block.column == 0 ? -infinity : low.x, block.row == 0 ? -infinity : low.y,
            block.last_column == plan_.across ? infinity : high.x, block.last_row == plan_.across ? infinity : high.y};
  }

  /// Returns a Partial as the next machine receives it: finished parts go to storage, as in rbpa stream.
  rbpa::Partial sent(rbpa::Partial part, const TileBlock& block, std::size_t depth) {
    constexpr std::size_t many_corners = 256;
    const Stopwatch watch;
    for (const rbpa::CornerPolygon& polygon : rbpa::take_settled(part)) {
      run_.taken_bytes += corner_bytes(polygon.shell);
      for (const rbpa::CornerRing& hole : polygon.holes) run_.taken_bytes += corner_bytes(hole);
    }
    for (const rbpa::TakenHoles& taken : rbpa::take_holes(part, many_corners))
      for (const rbpa::CornerRing& hole : taken.holes) run_.taken_bytes += corner_bytes(hole);
    const std::vector<std::uint8_t> bytes = rbpa::to_bytes(part);
    run_.parts.push_back({block, depth, static_cast<double>(bytes.size()), static_cast<double>(part.counts().points)});
    part = rbpa::partial_from_bytes(bytes);
    run_.merge_seconds += watch.processor_seconds();
    return part;
  }

  const MergePlan& plan_;
  LidarPoints ground_;
  MergeRun run_ = {};
  std::vector<rbpa::Point> points_ = {};
  std::vector<std::uint64_t> indices_ = {};
};

}  // namespace

double MergePlan::inner_border(const TileBlock& block) const {
  const auto wide = static_cast<double>(block.last_column - block.column),
             high = static_cast<double>(block.last_row - block.row);
  return 2 * (wide + high) * static_cast<double>(side) - outer_border(block);
}

double MergePlan::outer_border(const TileBlock& block) const {
  const std::int64_t wide = block.last_column - block.column, high = block.last_row - block.row;
  std::int64_t length = 0;
  if (block.column == 0) length += high;
  if (block.last_column == across) length += high;
  if (block.row == 0) length += wide;
  if (block.last_row == across) length += wide;
  return static_cast<double>(length * side);
}

Halves halves_of(const TileBlock& block) {
  Halves halves{block, block};
  if (block.last_column - block.column >= block.last_row - block.row) {
    halves.first.last_column = halves.second.column = (block.column + block.last_column) / 2;
  } else {
    halves.first.last_row = halves.second.row = (block.row + block.last_row) / 2;
  }
  return halves;
}

MergeRun run_merges(const MergePlan& plan) { return Merging(plan).run(); }

}  // namespace rbpa_bench
