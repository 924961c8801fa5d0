// What: polygons in a file of scratch in the order in which they are finished, and from there in canonical order.
// Cost: each polygon is written once and read once, or twice each where they do not fit into memory together; the largest
//       ring has to fit.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/gis/polygon_writers.h"
#include "rbpa/partial/partial.h"
#include "stream/scratch.h"

namespace rbpa::app {

/// How far the file has come.
struct LogState {
  std::uint64_t bytes = 0, polygons = 0;
  std::uint32_t checksum = 0;
};

class PolygonLog {
 public:
  explicit PolygonLog(const Scratch& scratch) : scratch_(scratch) {}

  /// Goes on where the file had come to. Throws Failure when there is less.
  void resume(const LogState& state);
  void add(std::span<const CornerPolygon> polygons);
  /// Some of the bytes of records (polygon_record.h), in which so many polygons end.
  void add_records(std::string_view bytes, std::uint64_t polygons);
  /// All that was added is in the file.
  LogState flush();

  /// Gives all to `sink` in order. Throws Failure when the file is not as it was written, Cancelled.
  void sorted(std::uint64_t memory, PolygonSink& sink) const;

 private:
  void append(std::string_view bytes);

  const Scratch& scratch_;
  LogState state_ = {};
  std::string waiting_ = {};
};

}  // namespace rbpa::app
