// What: polygons in a file of scratch in the order in which they are finished, their holes perhaps before them in another,
//       and from there in canonical order.
// Cost: each polygon is written once and read once, or twice each where they do not fit into memory together; each hole
//       that comes before its polygon twice more. The largest ring has to fit.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "io/gis/polygon_writers.h"
#include "rbpa/partial/partial.h"
#include "stream/record_log.h"
#include "stream/scratch.h"

namespace rbpa::app {

/// How far the files have come.
struct LogState {
  RecordState polygons = {}, holes = {};
};

class PolygonLog {
 public:
  explicit PolygonLog(const Scratch& scratch);

  /// Goes on where the files had come to. Throws Failure when there is less.
  void resume(const LogState& state);
  void add(std::span<const CornerPolygon> polygons);
  /// Holes of polygons that will be added, with the names of these.
  void add(std::span<const TakenHoles> holes);
  /// All that was added is in the files.
  LogState flush();

  /// Gives all to `sink` in order. Throws Failure when a file is not as it was written, Cancelled.
  void sorted(std::uint64_t memory, PolygonSink& sink) const;

 private:
  void add(const CornerPolygon& polygon);

  const Scratch& scratch_;
  RecordLog polygons_, holes_;
};

}  // namespace rbpa::app
