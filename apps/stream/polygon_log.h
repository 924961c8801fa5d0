// What: stores polygons in a file of scratch in the order in which they are finished, and in another file the holes
//       that are finished before the polygon around them; reads polygons in canonical order.
// Cost: each polygon is written and read once, or twice if all polygons together exceed the memory; each hole of the
//       other file twice more. The largest ring has to fit into memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/polygon/write_shapes.h"
#include "rbpa/plane/partial.h"
#include "stream/record_log.h"
#include "stream/scratch.h"

namespace rbpa::app {

/// Polygons and holes that no other tile can change.
struct Finished {
  std::vector<CornerPolygon> polygons;
  std::vector<TakenHoles> holes;
};
/// Removes finished polygons, and finished holes of at least 256 corners, from `partial`, and returns both.
Finished take_finished(Partial& partial);

/// The state of both files, from which writing can be resumed.
struct LogState {
  RecordState polygons = {}, holes = {};
};

class PolygonLog {
 public:
  explicit PolygonLog(const Scratch& scratch);

  /// Continues from a state that flush() returned: cuts off bytes that were written later. Throws BadInput if a file is
  /// shorter than its state tells; Failure.
  void resume(const LogState& state);
  void add(std::span<const CornerPolygon> polygons);
  /// Adds holes, with the names of their polygons. Requires: the polygon around each hole is added, before or after.
  void add(std::span<const TakenHoles> holes);
  /// Writes all added polygons and holes to the files, and returns the state of the files. Throws Failure, Cancelled.
  LogState flush();

  /// Returns the size of the written polygons and holes in bytes: 16 for each corner, and heads of records.
  std::uint64_t bytes() const { return polygons_.state().bytes + holes_.state().bytes; }
  /// Gives all polygons to `sink` in canonical order, and calls sink.finish(). Uses about `memory` bytes. Requires:
  /// flush() after the last add(). Throws BadInput if a file is damaged, perhaps after some polygons were given;
  /// Failure, Cancelled, and what `sink` throws.
  void sorted(std::uint64_t memory, PolygonSink& sink) const;

 private:
  const Scratch& scratch_;
  RecordLog polygons_, holes_;
};

}  // namespace rbpa::app
