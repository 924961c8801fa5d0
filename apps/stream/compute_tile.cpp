#include "stream/compute_tile.h"

#include "io/interrupt.h"

namespace rbpa::app {

IndexedPoints read_tile(TileReader& reader) {
  IndexedPoints points;
  points.points.reserve(reader.summary().points);
  points.indices.reserve(reader.summary().points);
  while (reader.next(points)) stop_if_interrupted();
  return points;
}

PartialAndItems compute_tile(const Box& box, const IndexedPoints& points, double alpha, unsigned threads) {
  PartialOptions options{.threads = threads};
  options.progress = [](const Progress&) { return !interrupted(); };
  const Region region{box.low.x, box.low.y, box.high.x, box.high.y};
  return partial_and_items(region, {points.points, points.indices}, alpha, options);
}

}  // namespace rbpa::app
