#include "stream/filtered_polygons.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/plane/polygon_of_points.h"
#include "stream/budget.h"
#include "stream/input_blocks.h"
#include "stream/pass_progress.h"

namespace rbpa::app {
namespace {

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

}  // namespace

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

}  // namespace rbpa::app
