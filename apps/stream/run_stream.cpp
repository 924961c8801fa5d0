#include "stream/run_stream.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <set>
#include <utility>

#include "io/failure.h"
#include "io/gis/geojson_crs.h"
#include "io/gis/polygon_writers.h"
#include "io/interrupt.h"
#include "io/message.h"
#include "io/npy_header.h"
#include "rbpa/shape/polygons.h"
#include "stream/budget.h"
#include "stream/cell_counts.h"
#include "stream/compute_tiles.h"
#include "stream/cut_tiles.h"
#include "stream/input_blocks.h"
#include "stream/manifest.h"
#include "stream/pass_progress.h"
#include "stream/plan_tiles.h"
#include "stream/refuse_dense.h"
#include "stream/room_on_disk.h"

namespace rbpa::app {
namespace {

using Pass = Manifest::Pass;

/// Adds up what goes to a writer.
class Adding final : public PolygonSink {
 public:
  explicit Adding(PolygonSink& to) : to_(to) {}
  void begin(const PolygonFacts& facts) override {
    ++polygons_;
    sums_.add(facts.holes, facts.area, facts.perimeter);
    to_.begin(facts);
  }
  void ring(std::span<const Point> points) override { to_.ring(points); }
  void end() override { to_.end(); }
  void finish() override { to_.finish(); }

  void tell(StreamResult& result) const {
    result.polygons = polygons_;
    const PolygonTotals totals = sums_.totals();
    result.holes = totals.holes;
    result.area = totals.area;
    result.perimeter = totals.perimeter;
  }

 private:
  PolygonSink& to_;
  std::uint64_t polygons_ = 0;
  RunningTotals sums_ = {};
};

class Run {
 public:
  Run(const StreamRequest& request, OutputSet& outputs)
      : request_(request), outputs_(outputs), question_(question_of(request)), scratch_(request) {}

  StreamResult run(const std::function<void(const StreamResult&)>& before_names) {
    begin();
    return_freed_memory(request_.memory, budget_.workers);
    if (manifest_.pass == Pass::count) count();
    result_.count_seconds = lap();
    if (manifest_.pass == Pass::cut) cut();
    return_free_pages();  // of the points that waited for their tiles
    result_.cut_seconds = lap();
    compute();
    result_.compute_seconds = lap();
    write();
    result_.write_seconds = lap();
    before_names(result_);
    outputs_.publish();
    scratch_.clear(request_.keep_tiles);
    return result_;
  }

 private:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

  void begin() {
    manifest_.question = question_;
    budget_ = divide(request_.memory, request_.threads);
    manifest_.workers = budget_.workers;
    if (!scratch_.has_run()) return save(manifest_, scratch_);
    manifest_ = load_manifest(scratch_, question_);
    // Tiles are as large as memory allows for so many at a time.
    budget_ = divide(request_.memory, manifest_.workers);
    budget_.workers = std::min(budget_.workers, std::max(request_.threads, 1U));
  }

  void remark(const PointFile& about, const std::string& name) {
    for (const std::string& text : about.remarks)
      if (remarks_.insert(text).second && !request_.quiet) say("rbpa", name + ": " + text);
  }

  void take_crs(const InputBlock& block) {
    const std::string& name = request_.sources[block.file].path;
    const std::optional<Crs>& crs = block.about.crs;
    if (crs && manifest_.crs && crs->text() != manifest_.crs->text())
      bad_input(name, crs->text(), manifest_.crs->text() + " as files before (--crs says one for all)");
    if (crs) manifest_.crs = crs;
    manifest_.degrees = manifest_.degrees || block.about.degrees;
    remark(block.about, name);
  }

  void count() {
    std::uint64_t bytes = 0;
    for (const InputFile& file : question_.inputs) bytes += file.size;
    CellCounts counts(budget_.cells);
    PackedSample sample;
    {
      PassProgress progress(request_.shows_progress, "1/4 counting", bytes);
      InputBlocks input(request_.sources, 0, 0);
      for (InputBlock block; input.next(block);) {
        stop_if_interrupted();
        counts.add(block.points);
        sample.add(block.points, block.first);
        progress.at(input.bytes_read(), counts.points());
        if (block.ends_file) take_crs(block);
      }
    }
    manifest_.points = counts.points();
    manifest_.least = counts.least();
    manifest_.greatest = counts.greatest();
    try {
      TilePlan plan = plan_for(counts);
      manifest_.tree = std::move(plan.tree);
      require_room_for_tiles(scratch_, plan.points, sample);
    } catch (const TooDense& dense) {
      refuse_dense(dense, request_, budget_);
    }
    manifest_.pass = Pass::cut;
    save(manifest_, scratch_);
  }

  /// Small tiles are computed fastest, as long as there is not much around them.
  TilePlan plan_for(const CellCounts& counts) const {
    constexpr std::uint64_t small = 1U << 17U;
    TileLimits limits{budget_.tile_points, std::min(request_.tile_size.value_or(small), budget_.tile_points),
                      reach_of(request_.alpha)};
    while (true) {
      TilePlan plan = plan_tiles(counts, limits);
      constexpr double much = 1.25;
      const bool is_lean = plan.points <= much * static_cast<double>(counts.points());
      if (is_lean || request_.tile_size || limits.owned == budget_.tile_points) return plan;
      limits.owned = std::min(4 * limits.owned, budget_.tile_points);
    }
  }

  void cut() {
    try {
      cut_tiles(request_, budget_, scratch_, manifest_);
    } catch (const Damaged&) {  // by whatever has happened since the run before
      manifest_.files_done = manifest_.next_index = 0;
      manifest_.tiles.clear();
      cut_tiles(request_, budget_, scratch_, manifest_);
    }
    manifest_.pass = Pass::compute;
    save(manifest_, scratch_);
  }

  void compute() {
    cut_smaller(request_, budget_, scratch_, manifest_);
    rows_.emplace(scratch_, manifest_.points, budget_.sort_bytes / 2);
    polygons_.emplace(scratch_);
    result_.counts = compute_tiles(request_, budget_, scratch_, manifest_, *rows_, *polygons_).counts;
    result_.tiles = manifest_.tiles.size();
  }

  void write() {
    const ProgressLine line("rbpa", request_.shows_progress, "4/4 writing");
    for (const StreamTarget& target : request_.targets) {
      stop_if_interrupted();
      if (target.format == StreamFormat::ply) continue;  // with each tile
      OutputFile& file = outputs_.add(target.path);
      target.format == StreamFormat::npy ? write_rows(file, target.path) : write_polygons(file, target.format);
      file.finish();
    }
  }

  void write_rows(OutputFile& file, const std::string& path) {
    const std::uint64_t rows = result_.counts.triangles;
    require_room_for_output(path, rows * (rows_->are_short() ? 12 : 24));
    file.write(npy_header(rows_->are_short() ? "<u4" : "<u8", rows, ", 3"));
    rows_->sorted(budget_.sort_bytes, [&](std::string_view bytes) { file.write(bytes); });
  }

  void write_polygons(OutputFile& file, StreamFormat format) {
    if (format == StreamFormat::wkt) {
      WktWriter writer(file);
      return write_polygons(writer);
    }
    GeojsonWriter writer(file, manifest_.crs);
    write_polygons(writer);
    const std::array<Point, 2> corners = {manifest_.least, manifest_.greatest};
    const Shape box{corners, {}, {}, manifest_.crs, manifest_.degrees};
    if (const std::optional<std::string> why = geojson_caution(box)) result_.caution = file.name() + ": " + *why;
  }
  void write_polygons(PolygonSink& writer) {
    Adding adding(writer);
    polygons_->sorted(budget_.sort_bytes, adding);
    adding.tell(result_);
  }

  const StreamRequest& request_;
  OutputSet& outputs_;
  Question question_;
  Scratch scratch_;
  Budget budget_ = {};
  Manifest manifest_ = {};
  std::optional<TriangleRows> rows_ = std::nullopt;
  std::optional<PolygonLog> polygons_ = std::nullopt;
  std::set<std::string> remarks_ = {};
  StreamResult result_ = {};
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

StreamResult run_stream(const StreamRequest& request, OutputSet& outputs,
                        const std::function<void(const StreamResult&)>& before_names) {
  return Run(request, outputs).run(before_names);
}

}  // namespace rbpa::app
