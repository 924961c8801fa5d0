// What: polygons in a file of scratch in the order in which they are finished, their holes perhaps before them in
//       another, and from there in canonical order.
// Cost: each polygon is written once and read once, or twice each where they do not fit into memory together; each hole
//       that comes before its polygon twice more. The largest ring has to fit.
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

// Polygons, and holes that come before theirs, as bytes: those of the log and of files of tasks.

/// What decides the order of polygons, and of the holes of one: the first two points of a ring.
struct RingKey {
  Point first, second;
  friend auto operator<=>(const RingKey&, const RingKey&) = default;
};

/// Before the rings of a polygon that are with it, each of which is the number of its points and these.
struct PolygonHead {
  std::uint64_t size;   // of the rings with their numbers
  std::uint64_t taken;  // holes that are elsewhere
  PolygonFacts facts;
};
static_assert(sizeof(PolygonHead) == 48 && std::is_trivially_copyable_v<PolygonHead>);

/// Before the points of a hole, or without points before the key of the polygon that has holes of this name.
struct HoleHead {
  std::uint64_t points;
  ComponentName name;
};
static_assert(sizeof(HoleHead) == 32 && std::is_trivially_copyable_v<HoleHead>);

template <typename T>
std::string_view bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// Calls put(bytes) with the record piece by piece, and put_hole(bytes) with what is known by it of holes.
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

/// The same of holes.
template <typename PutHole>
void put_record(const TakenHoles& taken, PutHole put_hole) {
  for (const CornerRing& hole : taken.holes) {
    put_hole(bytes_of(HoleHead{hole.size(), taken.component}));
    for (const Corner& corner : hole) put_hole(bytes_of(corner.at));
  }
}

/// What need not wait for other tiles.
struct Finished {
  std::vector<CornerPolygon> polygons;
  std::vector<TakenHoles> holes;
};
/// Removes them from `partial`.
Finished take_finished(Partial& partial);

/// How far the files have come.
struct LogState {
  RecordState polygons = {}, holes = {};
};

class PolygonLog {
 public:
  explicit PolygonLog(const Scratch& scratch);

  /// Goes on where the files had come to. Throws BadInput when there is less.
  void resume(const LogState& state);
  void add(std::span<const CornerPolygon> polygons);
  /// Holes of polygons that will be added, with the names of these.
  void add(std::span<const TakenHoles> holes);
  /// Some bytes of such records.
  void add_polygon_records(std::string_view bytes) { polygons_.append(bytes); }
  void add_hole_records(std::string_view bytes) { holes_.append(bytes); }
  /// All that was added is in the files.
  LogState flush();

  /// Gives all to `sink` in order. Throws BadInput when a file is not as it was written, Cancelled.
  void sorted(std::uint64_t memory, PolygonSink& sink) const;

 private:
  const Scratch& scratch_;
  RecordLog polygons_, holes_;
};

}  // namespace rbpa::app
