// What: a polygon as bytes, as the log of polygons and files of tasks have it.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "io/gis/polygon_writers.h"
#include "rbpa/partial/corner_polygon.h"

namespace rbpa::app {

/// Before the rings of a polygon, each of which is the number of its points and these.
struct RecordHead {
  std::uint64_t size;  // of the record without this number
  PolygonFacts facts;
};
static_assert(sizeof(RecordHead) == 40 && std::is_trivially_copyable_v<RecordHead>);

/// Calls put(bytes) with the record piece by piece, as it lies in memory of a little-endian machine.
template <typename Put>
void put_record(const CornerPolygon& polygon, Put put) {
  const auto put_value = [&](const auto& value) {
    put(std::string_view(reinterpret_cast<const char*>(&value), sizeof value));
  };
  const auto put_ring = [&](const CornerRing& ring) {
    put_value(std::uint64_t{ring.size()});
    for (const Corner& corner : ring) put_value(corner.at);
  };
  std::uint64_t corners = polygon.shell.size();
  for (const CornerRing& hole : polygon.holes) corners += hole.size();
  const std::uint64_t rings = polygon.holes.size() + 1;
  put_value(RecordHead{sizeof(PolygonFacts) + rings * sizeof(std::uint64_t) + corners * sizeof(Point),
                       {polygon.area, polygon.perimeter, rings - 1, polygon.points}});
  put_ring(polygon.shell);
  for (const CornerRing& hole : polygon.holes) put_ring(hole);
}

}  // namespace rbpa::app
