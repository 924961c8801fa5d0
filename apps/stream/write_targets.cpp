#include "stream/passes.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/bytes/npy.h"
#include "io/interrupt.h"
#include "io/polygon/shape_files.h"
#include "io/progress_line.h"
#include "rbpa/plane/outline_polygons.h"
#include "stream/budget.h"
#include "stream/filtered_polygons.h"

namespace rbpa::app {
namespace {

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
