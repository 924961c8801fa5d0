// What: stores polygons in a file of scratch in the order in which they are finished, and holes that come before their
//       polygon in another file; reads them in canonical order.
// Cost: each polygon is written and read once, or twice if all do not fit into memory; each hole that comes before its
//       polygon twice more. The largest ring has to fit into memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/polygon/shape_files.h"
#include "rbpa/plane/partial.h"
#include "stream/record_log.h"
#include "stream/scratch.h"

namespace rbpa::app {

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
  /// Adds holes, with the names of their polygons, which will be added later.
  void add(std::span<const TakenHoles> holes);
  /// Writes everything that was added to the files, and returns their state.
  LogState flush();

  /// Gives all polygons to `sink` in canonical order. Throws BadInput if a file is damaged, Cancelled.
  void sorted(std::uint64_t memory, PolygonSink& sink) const;

 private:
  const Scratch& scratch_;
  RecordLog polygons_, holes_;
};

}  // namespace rbpa::app
