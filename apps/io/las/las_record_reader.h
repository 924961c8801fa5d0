// What: points from the records of a LAS file, in any number of parts.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/las/las_header.h"
#include "io/las/selection.h"
#include "io/point_file.h"

namespace rbpa::app {

class LasRecordReader {
 public:
  /// Throws BadInput when not all coordinates can be doubles, or when the records lack what `where` asks for.
  LasRecordReader(const LasHeader& header, const std::optional<Condition>& where, const std::string& name);

  /// Appends the points of `count` records, of those that count. Throws Cancelled.
  void take(const char* records, std::size_t count, std::vector<Point>& points);
  /// Adds what there is to remark on all records so far.
  void tell(PointFile& file) const;

 private:
  std::size_t length_, records_ = 0, taken_ = 0, withheld_points_ = 0;
  ScaledInteger x_, y_;
  std::optional<Selection> selects_ = std::nullopt;
  std::optional<LasField> withheld_;
};

}  // namespace rbpa::app
