// What: stores polygons in a file of scratch in the order in which they are finished, and holes that come before their
//       polygon in another file; reads them in canonical order.
// Cost: each polygon is written and read once, or twice if all do not fit into memory; each hole that comes before its
//       polygon twice more. The largest ring has to fit into memory.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/polygon/shape_files.h"
#include "rbpa/partial.h"
#include "stream/record_log.h"
#include "stream/scratch.h"

namespace rbpa::app {

// Polygons, and holes that come before their polygons, as bytes: for the log and for files of tasks.

/// The key by which polygons, and the holes of one, are sorted: the first two points of a ring.
struct RingKey {
  Point first, second;
  friend auto operator<=>(const RingKey&, const RingKey&) = default;
};

/// The head of a polygon's record. The rings that are with it follow: each is its number of points and the points.
struct PolygonHead {
  std::uint64_t size;   // bytes of the rings with their numbers
  std::uint64_t taken;  // number of holes that are in the other file
  PolygonFacts facts;
};
static_assert(sizeof(PolygonHead) == 48 && std::is_trivially_copyable_v<PolygonHead>);

/// The head of a hole's record. The points of the hole follow, or, if `points` is 0, the key of the polygon that has
/// holes of this name.
struct HoleHead {
  std::uint64_t points;
  ComponentName name;
};
static_assert(sizeof(HoleHead) == 32 && std::is_trivially_copyable_v<HoleHead>);

template <typename T>
std::string_view bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// Calls put(bytes) with the record of a polygon piece by piece, and put_hole(bytes) with the records that its holes
/// need.
template <typename Put, typename PutHole>
void put_record(const CornerPolygon& polygon, Put put, PutHole put_hole) {
  const auto put_ring = [&](const CornerRing& ring) {
    put(bytes_of(std::uint64_t{ring.size()}));
    for (const Corner& corner : ring) put(bytes_of(corner.at));
  };
  std::uint64_t corners = polygon.shell.size();
  for (const CornerRing& hole : polygon.holes) corners += hole.size();
  const std::uint64_t rings = polygon.holes.size() + 1;
  put(bytes_of(PolygonHead{rings * sizeof(std::uint64_t) + corners * sizeof(Point),
                           polygon.taken_holes,
                           {polygon.area, polygon.perimeter, rings - 1 + polygon.taken_holes, polygon.points}}));
  put_ring(polygon.shell);
  for (const CornerRing& hole : polygon.holes) put_ring(hole);
  for (const ComponentName& name : polygon.names) {
    put_hole(bytes_of(HoleHead{0, name}));
    put_hole(bytes_of(RingKey{polygon.shell[0].at, polygon.shell[1].at}));
  }
}

/// Calls put_hole(bytes) with the records of holes piece by piece.
template <typename PutHole>
void put_record(const TakenHoles& taken, PutHole put_hole) {
  for (const CornerRing& hole : taken.holes) {
    put_hole(bytes_of(HoleHead{hole.size(), taken.component}));
    for (const Corner& corner : hole) put_hole(bytes_of(corner.at));
  }
}

/// Polygons and holes that need not wait for other tiles.
struct Finished {
  std::vector<CornerPolygon> polygons;
  std::vector<TakenHoles> holes;
};
/// Removes the finished polygons and holes from `partial` and returns them.
Finished take_finished(Partial& partial);

/// The state of the files, from which they are resumed.
struct LogState {
  RecordState polygons = {}, holes = {};
};

class PolygonLog {
 public:
  explicit PolygonLog(const Scratch& scratch);

  /// Resumes the files from a state. Throws BadInput if there is less in them.
  void resume(const LogState& state);
  void add(std::span<const CornerPolygon> polygons);
  /// Adds holes of polygons that will be added later, with the names of these.
  void add(std::span<const TakenHoles> holes);
  /// Append bytes of records.
  void add_polygon_records(std::string_view bytes) { polygons_.append(bytes); }
  void add_hole_records(std::string_view bytes) { holes_.append(bytes); }
  /// Writes everything that was added to the files, and returns their state.
  LogState flush();

  /// Gives all polygons to `sink` in canonical order. Throws BadInput if a file is damaged, Cancelled.
  void sorted(std::uint64_t memory, PolygonSink& sink) const;

 private:
  const Scratch& scratch_;
  RecordLog polygons_, holes_;
};

}  // namespace rbpa::app
