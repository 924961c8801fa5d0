// What: polygons in a file of scratch in the order in which they are finished, their holes perhaps before them in another,
//       and from there in canonical order.
// Cost: each polygon is written once and read once, or twice each where they do not fit into memory together; each hole
//       that comes before its polygon twice more. The largest ring has to fit.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/polygon/shape_files.h"
#include "rbpa/partial.h"
#include "stream/record_log.h"
#include "stream/scratch.h"

namespace rbpa::app {

/// The polygons and holes that are finished.
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
  /// Some bytes of records (polygon_record.h).
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
