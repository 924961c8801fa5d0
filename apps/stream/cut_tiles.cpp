#include "stream/passes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "stream/input_blocks.h"
#include "stream/pass_progress.h"
#include "stream/plan_tiles.h"
#include "stream/scratch_file.h"
#include "stream/tile_file.h"

namespace rbpa::app {
namespace {

/// Returns the part of the box of a tile that is farther than `reach` from the border of the box. Points in this part
/// do not matter for other tiles.
Region inside_of(const Region& box, double reach) {
  const auto low = [&](double at) { return std::isinf(at) ? at : above(above(at, reach), 0); };
  const auto high = [&](double at) { return std::isinf(at) ? at : below(below(at, reach), 0); };
  return {low(box.x0), low(box.y0), high(box.x1), high(box.y1)};
}

class Cutter {
 public:
  Cutter(const TileTree& tree, double alpha, const Scratch& scratch, std::uint64_t most_waiting)
      : tree_(tree), reach_(reach_of(alpha)), most_waiting_(most_waiting) {
    for (std::uint32_t tile = 0; tile < tree.tiles(); ++tile) {
      writers_.emplace_back(scratch.tile(tile), tree.box(tile), alpha);
      inside_.push_back(inside_of(tree.box(tile), reach_));
    }
  }

  /// Continues the files of tiles from the state `tiles`.
  void resume(const std::vector<TileSummary>& tiles) {
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) writers_[tile].resume(tiles[tile]);
  }
  /// Makes later calls of add() write only the points of `tile`.
  void want_only(std::uint32_t tile) { wanted_ = tile; }

  void add(const std::vector<Point>& points, std::uint64_t first) {
    for (const Point& p : points) {
      if (!inside_[last_].contains(p)) {
        last_ = tree_.tile_of(p);
        if (!inside_[last_].contains(p)) {
          tree_.for_each_near(p, reach_, [&](std::uint32_t tile) { put(tile, p, first, tile == last_); });
          ++first;
          continue;
        }
      }
      put(last_, p, first++, true);
    }
    if (waiting_ > most_waiting_) write_the_fullest();
  }

  void flush() {
    for (TileWriter& writer : writers_) {
      stop_if_interrupted();
      writer.flush();
    }
    waiting_ = 0;
  }
  std::vector<TileSummary> summaries() const {
    std::vector<TileSummary> found;
    for (const TileWriter& writer : writers_) found.push_back(writer.summary());
    return found;
  }
  TileSummary finish(std::uint32_t tile) { return writers_[tile].finish(); }

 private:
  static constexpr std::size_t enough = 4 * most_in_packed_block;

  void put(std::uint32_t tile, const Point& p, std::uint64_t index, bool owned) {
    if (wanted_ && tile != *wanted_) return;
    TileWriter& writer = writers_[tile];
    writer.add(p, index, owned);
    ++waiting_;
    if (writer.waiting() >= enough) flush(writer);
  }
  void flush(TileWriter& writer) {
    waiting_ -= writer.waiting();
    writer.flush();
  }
  void write_the_fullest() {
    const std::size_t average = waiting_ / writers_.size();
    for (TileWriter& writer : writers_)
      if (writer.waiting() >= average) flush(writer);
  }

  const TileTree& tree_;
  double reach_;
  std::size_t most_waiting_, waiting_ = 0;
  std::vector<TileWriter> writers_;
  std::vector<Region> inside_;
  std::uint32_t last_ = 0;  // tile of the last point: successive points are usually close to each other
  std::optional<std::uint32_t> wanted_ = std::nullopt;
};

/// Time between two saves; each save writes all waiting points.
constexpr std::chrono::seconds time_between_saves(10);

/// A line that cuts the points of a tile at the median coordinate of the axis of their larger extent.
struct Line {
  TileTree::Part::Kind kind;
  double at;
};
std::optional<Line> middle_of(std::vector<Point>& sample) {
  const auto along = [&](double Point::*axis) {
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    const auto less = [&](const Point& a, const Point& b) { return a.*axis < b.*axis; };
    std::nth_element(sample.begin(), middle, sample.end(), less);
    const double least = (*std::min_element(sample.begin(), middle + 1, less)).*axis;
    const double greatest = (*std::max_element(middle, sample.end(), less)).*axis;
    double line = (*middle).*axis;
    if (line == least) {  // take the next larger coordinate
      line = greatest;
      for (const Point& p : sample)
        if (p.*axis > least) line = std::min(line, p.*axis);
    }
    return std::pair(greatest / 2 - least / 2, line);
  };
  if (sample.empty()) return std::nullopt;
  const auto [wide, x] = along(&Point::x);
  const auto [high, y] = along(&Point::y);
  if (wide == 0 && high == 0) return std::nullopt;
  if (wide >= high) return Line{TileTree::Part::Kind::cut_x, x};
  return Line{TileTree::Part::Kind::cut_y, y};
}

/// Approximate number of sampled points that determine the median.
constexpr std::size_t sample_size = 1U << 14U;

class SmallerCutter {
 public:
  SmallerCutter(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest)
      : request_(request), budget_(budget), scratch_(scratch), manifest_(manifest) {}

  void run() {
    for (std::uint32_t tile = 0; tile < manifest_.tiles.size(); ++tile) {
      bool any = false;
      while (is_too_large(manifest_.tiles[tile]) && cut_or_repair(tile)) any = true;
      if (any) save(manifest_, scratch_);
    }
  }

 private:
  bool is_too_large(const TileSummary& tile) const {
    return tile.points > budget_.tile_points || tile.owned > request_.tile_size.value_or(budget_.tile_points);
  }

  /// Returns an even sample of the points that the tile owns. Sets `extent` to the bounding box of all owned points.
  std::vector<Point> sample_of(std::uint32_t tile, Region& extent) const {
    const Region box = manifest_.tree.box(tile);
    const std::uint64_t step = manifest_.tiles[tile].owned / sample_size + 1;
    TileReader reader(scratch_.tile(tile), box, request_.alpha);
    std::vector<Point> sample;
    std::uint64_t count = 0;
    for_each_block(reader, [&](const IndexedPoints& block) {
      for (const Point& p : block.points) {
        if (!box.contains(p)) continue;
        if (count == 0) extent = {p.x, p.y, p.x, p.y};
        extent.x0 = std::min(extent.x0, p.x);
        extent.y0 = std::min(extent.y0, p.y);
        extent.x1 = std::max(extent.x1, p.x);
        extent.y1 = std::max(extent.y1, p.y);
        if (count++ % step == 0) sample.push_back(p);
      }
    });
    return sample;
  }

  /// Returns the number of points in the file within reach of `extent`, the bounding box of the owned points.
  std::uint64_t count_near(std::uint32_t tile, const Region& extent) const {
    const double reach = reach_of(request_.alpha);
    TileReader reader(scratch_.tile(tile), manifest_.tree.box(tile), request_.alpha);
    std::uint64_t count = 0;
    for_each_block(reader, [&](const IndexedPoints& block) {
      for (const Point& p : block.points)
        if (above(p.x, reach) >= extent.x0 && below(p.x, reach) <= extent.x1 && above(p.y, reach) >= extent.y0 &&
            below(p.y, reach) <= extent.y1)
          ++count;
    });
    return count;
  }

  bool cut_or_repair(std::uint32_t tile) {
    try {
      return cut(tile);
    } catch (const Damaged&) {  // a killed run has left the files of two parts in different states
      cut_again(request_, budget_, scratch_, manifest_, tile);
      return cut(tile);
    }
  }

  /// Cuts a tile in two. Returns false if no cut helps. Throws Failure if too many points are within reach of a point.
  bool cut(std::uint32_t tile) {
    Region extent;
    std::vector<Point> sample = sample_of(tile, extent);
    const TileSummary& summary = manifest_.tiles[tile];
    const std::optional<Line> line = middle_of(sample);
    // Refuse a small extent: any part of it has about the same points around it, so that a cut does not help.
    const double size = std::max(extent.x1 - extent.x0, extent.y1 - extent.y0);
    const bool hopeless = !line || size < reach_of(request_.alpha) / 8;
    if (hopeless && summary.points > budget_.tile_points) {
      const std::uint64_t near = count_near(tile, extent);
      if (near > budget_.tile_points) refuse_dense({{extent.x0, extent.y0}, near}, request_, budget_);
      return false;  // a cut leaves most of the points, which are around the box, in one half
    }
    if (!line) return false;  // all points are equal, so that one tile contains them
    split(tile, *line);
    return true;
  }

  void split(std::uint32_t tile, const Line& line) {
    TileTree tree = manifest_.tree;
    const Region before = tree.box(tile);
    const std::uint32_t other = tree.cut(tile, line.kind, line.at);
    const double reach = reach_of(request_.alpha);
    const bool x = line.kind == TileTree::Part::Kind::cut_x;
    // Write the first part to a new file. Replace the old file by it when both parts are complete.
    const std::string whole = scratch_.tile(tile), part = whole + ".new";
    TileWriter first(part, tree.box(tile), request_.alpha),
        second(scratch_.tile(other), tree.box(other), request_.alpha);
    TileReader reader(whole, before, request_.alpha);
    for_each_block(reader, [&](const IndexedPoints& block) {
      for (std::size_t i = 0; i < block.size(); ++i) {
        const Point& p = block.points[i];
        const double at = x ? p.x : p.y;
        const bool owned = before.contains(p);
        if (below(at, reach) < line.at) first.add(p, block.indices[i], owned && at < line.at);
        if (above(at, reach) >= line.at) second.add(p, block.indices[i], owned && at >= line.at);
      }
      if (first.waiting() >= 4 * most_in_packed_block) first.flush();
      if (second.waiting() >= 4 * most_in_packed_block) second.flush();
    });
    const TileSummary of_first = first.finish(), of_second = second.finish();
    manifest_.tree = std::move(tree);
    manifest_.tiles[tile] = of_first;
    manifest_.tiles.push_back(of_second);
    rename_scratch(part, whole);
  }

  const StreamRequest& request_;
  const Budget& budget_;
  const Scratch& scratch_;
  Manifest& manifest_;
};

}  // namespace

void cut_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest) {
  PassProgress progress(request.shows_progress, "2/4 cutting", manifest.run_key.bytes());
  Cutter cutter(manifest.tree, request.alpha, scratch, budget.waiting);
  if (manifest.files_done > 0) cutter.resume(manifest.tiles);
  InputPlace from{manifest.files_done, manifest.next_index};
  for (std::size_t file = 0; file < from.files; ++file) from.bytes += manifest.run_key.inputs[file].size;
  using Clock = std::chrono::steady_clock;
  Clock::time_point saved = Clock::now();
  for_each_input_block(request.sources, from, progress, [&](const InputBlock& block) {
    cutter.add(block.points, block.first);
    if (!block.ends_file || Clock::now() - saved < time_between_saves) return;
    saved = Clock::now();
    cutter.flush();
    manifest.files_done = block.file + 1;
    manifest.next_index = block.first;
    manifest.tiles = cutter.summaries();
    save(manifest, scratch);
  });
  manifest.tiles.clear();
  for (std::uint32_t tile = 0; tile < manifest.tree.tiles(); ++tile) {
    stop_if_interrupted();
    manifest.tiles.push_back(cutter.finish(tile));
  }
}

void cut_again(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
               std::uint32_t tile) {
  PassProgress progress(request.shows_progress, "cutting a tile again", manifest.run_key.bytes());
  Cutter cutter(manifest.tree, request.alpha, scratch, budget.waiting);
  cutter.want_only(tile);
  for_each_input_block(request.sources, {}, progress,
                       [&](const InputBlock& block) { cutter.add(block.points, block.first); });
  manifest.tiles[tile] = cutter.finish(tile);
}

void cut_smaller(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest) {
  SmallerCutter(request, budget, scratch, manifest).run();
}

}  // namespace rbpa::app
