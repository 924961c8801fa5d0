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

PartialAndItems compute_tile(const Box& box, const IndexedPoints& points, const TileWork& work) {
  PartialOptions options{.threads = work.threads};
  options.progress = [](const Progress&) { return !interrupted(); };
  const Region region{box.low.x, box.low.y, box.high.x, box.high.y};
  const RegionPoints given{points.points, points.indices};
  if (!work.wants_triangles) return {partial(region, given, work.alpha, options), {}};
  return partial_and_items(region, given, work.alpha, options);
}

}  // namespace rbpa::app
