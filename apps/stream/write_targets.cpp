#include "stream/passes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/npy.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/polygon/write_shapes.h"
#include "io/progress_line.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/polygon_of_points.h"
#include "stream/budget.h"
#include "stream/input_blocks.h"
#include "stream/pass_progress.h"
#include "stream/polygon_log.h"
#include "stream/request.h"

namespace rbpa::app {
namespace {

/// Peak memory for each corner of a polygon while polygons are filtered and points are located, in bytes.
constexpr std::uint64_t bytes_of_corner = 180;

/// The polygons of a run after --min-hole-area and --min-part-area. Polygons and numbers of points are those that
/// `rbpa shape` writes with the same options. All corners are in memory; the input is read once more to count points of
/// polygons.
class FilteredPolygons {
 public:
  /// Reads all polygons and applies request.filter. Throws Failure that names a sufficient --memory if `memory` bytes
  /// do not suffice for all corners; as PolygonLog::sorted().
  FilteredPolygons(const StreamRequest& request, const PolygonLog& log, std::uint64_t memory);

  /// Counts the points of the input in each polygon. `bytes` is the size of the input, for the progress. Throws as
  /// read_points(); Cancelled.
  void count_points(const StreamRequest& request, std::uint64_t bytes, std::uint64_t memory);

  /// Gives all polygons to `sink` in canonical order, and calls sink.finish().
  void show(PolygonSink& sink) const;

 private:
  std::vector<Point> corners_ = {};
  std::vector<Polygon> polygons_ = {};
  std::vector<std::uint64_t> points_ = {};  // number of points of each polygon
};

class Collecting final : public PolygonSink {
 public:
  Collecting(std::vector<Point>& corners, std::vector<Polygon>& polygons) : corners_(corners), polygons_(polygons) {}
  void begin(const PolygonFacts&) override { polygons_.emplace_back(); }
  void ring(std::span<const Point> points) override {
    Polygon& polygon = polygons_.back();
    Ring& ring = polygon.shell.points.empty() ? polygon.shell : polygon.holes.emplace_back();
    ring.points.resize(points.size());
    std::iota(ring.points.begin(), ring.points.end(), static_cast<std::uint32_t>(corners_.size()));
    corners_.insert(corners_.end(), points.begin(), points.end());
  }
  void end() override {}
  void finish() override {}

 private:
  std::vector<Point>& corners_;
  std::vector<Polygon>& polygons_;
};

FilteredPolygons::FilteredPolygons(const StreamRequest& request, const PolygonLog& log, std::uint64_t memory) {
  const std::uint64_t most =
      std::min<std::uint64_t>(memory / bytes_of_corner, std::numeric_limits<std::int32_t>::max());
  const std::uint64_t corners = log.bytes() / sizeof(Point);  // and the heads of records
  if (corners > most)
    throw Failure("--memory " + in_megabytes(request.memory) + ": found about " + std::to_string(corners) +
                  " corners of polygons, expected at most " + std::to_string(most) +
                  " with --min-hole-area or --min-part-area (--memory " +
                  in_megabytes(memory_for(2 * corners * bytes_of_corner / bytes_of_tile_point + 1, 1)) + " suffices)");
  corners_.reserve(corners);
  Collecting collecting(corners_, polygons_);
  log.sorted(memory, collecting);
  filter_polygons(polygons_, corners_, request.filter, until_interrupted());
  points_.resize(polygons_.size());
}

void FilteredPolygons::count_points(const StreamRequest& request, std::uint64_t bytes, std::uint64_t memory) {
  constexpr std::uint64_t bytes_of_query = 128;
  const std::size_t most = memory / bytes_of_query;
  std::vector<Point> waiting;
  const auto count = [&] {
    for (const std::optional<std::uint32_t>& polygon :
         polygon_of_points(polygons_, corners_, waiting, until_interrupted()))
      if (polygon) ++points_[*polygon];
    waiting.clear();
  };
  PassProgress progress(request.shows_progress, "4/4 counting points", bytes);
  for_each_input_block(request.sources, {}, progress, [&](const InputBlock& block) {
    waiting.insert(waiting.end(), block.points.begin(), block.points.end());
    if (waiting.size() >= most) count();
  });
  count();
}

void FilteredPolygons::show(PolygonSink& sink) const {
  std::vector<Point> points;
  const auto show_ring = [&](const Ring& ring) {
    points.clear();
    for (const std::uint32_t corner : ring.points) points.push_back(corners_[corner]);
    sink.ring(points);
  };
  for (std::size_t p = 0; p < polygons_.size(); ++p) {
    stop_if_interrupted();
    const Polygon& polygon = polygons_[p];
    sink.begin({polygon.area, polygon.perimeter, polygon.holes.size(), points_[p]});
    show_ring(polygon.shell);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), show_ring);
    sink.end();
  }
  sink.finish();
}

/// Passes polygons to a sink, if there is one, and sums up the numbers of polygons and holes, areas and perimeters.
class Adding final : public PolygonSink {
 public:
  explicit Adding(PolygonSink* to) : to_(to) {}
  void begin(const PolygonFacts& facts) override {
    ++polygons_;
    sums_.add(facts.holes, facts.area, facts.perimeter);
    if (to_ != nullptr) to_->begin(facts);
  }
  void ring(std::span<const Point> points) override {
    if (to_ != nullptr) to_->ring(points);
  }
  void end() override {
    if (to_ != nullptr) to_->end();
  }
  void finish() override {
    if (to_ != nullptr) to_->finish();
  }

  void report_to(StreamResult& result) const {
    result.polygons = polygons_;
    const PolygonTotals totals = sums_.totals();
    result.holes = totals.holes;
    result.area = totals.area;
    result.perimeter = totals.perimeter;
  }

 private:
  PolygonSink* to_;
  std::uint64_t polygons_ = 0;
  RunningTotals sums_ = {};
};

void write_rows(OutputFile& file, const std::string& path, const TriangleRows& rows, std::uint64_t count,
                std::uint64_t sort_bytes) {
  require_room_for_output(path, count * (rows.are_short() ? 12 : 24));
  file.write(npy_header(rows.are_short() ? "<u4" : "<u8", count, ", 3"));
  rows.sorted(sort_bytes, [&](std::string_view bytes) { file.write(bytes); });
}

void write_polygons(OutputFile& file, StreamFormat format, const PointsFacts& facts, const ShowPolygons& show,
                    StreamResult& result) {
  const bool is_wkt = format == StreamFormat::wkt;
  const std::array<Point, 2> corners = {facts.least, facts.greatest};
  PolygonWriter writer(file, is_wkt ? Format::wkt : Format::geojson, facts.crs,
                       is_cut_in_geojson(corners, facts.crs, facts.degrees));
  add_up(show, &writer, result);
  if (is_wkt) return;
  const Shape box{corners, {}, {}, facts.crs, facts.degrees};
  if (const std::optional<std::string> why = geojson_caution(box)) result.caution = file.name() + ": " + *why;
}

}  // namespace

ShowPolygons shown_polygons(const StreamRequest& request, const Manifest& manifest, const PolygonLog& polygons,
                            std::uint64_t sort_bytes, bool counts_points) {
  if (!request.filters()) return [&, sort_bytes](PolygonSink& sink) { polygons.sorted(sort_bytes, sink); };
  const auto filtered = std::make_shared<FilteredPolygons>(request, polygons, sort_bytes);
  if (counts_points) filtered->count_points(request, manifest.run_key.bytes(), sort_bytes / 2);
  return [filtered](PolygonSink& sink) { filtered->show(sink); };
}

void add_up(const ShowPolygons& show, PolygonSink* sink, StreamResult& result) {
  Adding adding(sink);
  show(adding);
  adding.report_to(result);
}

void write_targets(const StreamRequest& request, const Manifest& manifest, const TriangleRows& rows,
                   const PolygonLog& polygons, std::uint64_t sort_bytes, OutputSet& outputs, StreamResult& result) {
  ShowPolygons show;
  if (request.wants_polygons())
    show = shown_polygons(request, manifest, polygons, sort_bytes, request.wants(StreamFormat::geojson));
  const ProgressLine line("rbpa", request.shows_progress, "4/4 writing");
  for (const StreamTarget& target : request.targets) {
    stop_if_interrupted();
    if (target.format == StreamFormat::ply) continue;
    OutputFile& file = outputs.add(target.path);
    if (target.format == StreamFormat::npy)
      write_rows(file, target.path, rows, result.counts.triangles, sort_bytes);
    else
      write_polygons(file, target.format, manifest.facts, show, result);
    file.finish();
  }
}

}  // namespace rbpa::app
