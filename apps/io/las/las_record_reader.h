// What: points from the records of a LAS file, in any number of parts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/las/las_header.h"
#include "io/las/selection.h"
#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

class LasRecordReader {
 public:
  /// Throws BadInput when not all coordinates can be doubles, or when the records lack what `where` asks for.
  LasRecordReader(const LasHeader& header, const std::optional<Condition>& where, const std::string& name);

  /// Appends the points of `count` records, of those that count. Throws Cancelled.
  void take(const char* records, std::size_t count, std::vector<Point>& points);
  /// The same with their heights, and red, green and blue where the records have them. Requires require_height().
  void take(const char* records, std::size_t count, std::vector<Point3>& points,
            std::vector<std::array<std::uint16_t, 3>>& colors);
  /// Throws BadInput when not all heights can be doubles.
  void require_height(const LasHeader& header, const std::string& name) const;
  /// Adds what there is to remark on all records so far.
  void tell(std::vector<std::string>& remarks) const;

 private:
  template <typename P, typename Load>
  void take_all(const char* records, std::size_t count, std::vector<P>& points, const Load& load);

  std::size_t length_, records_ = 0, taken_ = 0, withheld_points_ = 0;
  ScaledInteger x_, y_, z_;
  std::optional<Selection> selects_ = std::nullopt;
  std::optional<LasField> withheld_;
  std::optional<LasField> red_;  // green and blue are behind it
};

}  // namespace rbpa::app
