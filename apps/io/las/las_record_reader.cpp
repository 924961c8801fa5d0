#include "io/las/las_record_reader.h"

#include <cmath>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

/// No double is larger than what the largest integers become: then no point is infinite.
void require_range(const LasHeader& header, std::size_t axis, const std::string& name) {
  constexpr double largest = 0x1p31;
  if (!std::isfinite(largest * std::abs(header.scale[axis]) + std::abs(header.offset[axis])))
    bad_input(name,
              "a scale of " + in_quotes(ShortestText(header.scale[axis])) + " and an offset of " +
                  in_quotes(ShortestText(header.offset[axis])),
              "coordinates within the range of a double");
}

}  // namespace

LasRecordReader::LasRecordReader(const LasHeader& header, const std::optional<Condition>& where,
                                 const std::string& name)
    : length_(header.length),
      x_(header.scale[0], header.offset[0]),
      y_(header.scale[1], header.offset[1]),
      z_(header.scale[2], header.offset[2]),
      withheld_(find_las_field("withheld", header.format, header.minor)),
      red_(find_las_field("red", header.format, header.minor)) {
  for (const std::size_t axis : {0U, 1U}) require_range(header, axis, name);
  if (where) selects_.emplace(*where, LasRecords{header.format, header.minor, {x_, y_, z_}}, name);
}

template <typename P, typename Load>
void LasRecordReader::take_all(const char* records, std::size_t count, std::vector<P>& points, const Load& load) {
  const std::size_t before = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    const char* record = records + i * length_;
    if (selects_ && !(*selects_)(record)) continue;
    points.push_back(load(record));
    if (withheld_ && withheld_->value(record) != 0) ++withheld_points_;
  }
  records_ += count;
  taken_ += points.size() - before;
}

void LasRecordReader::take(const char* records, std::size_t count, std::vector<Point>& points) {
  take_all(records, count, points, [this](const char* record) {
    return Point{x_(las_value<std::int32_t>(record)), y_(las_value<std::int32_t>(record + 4))};
  });
}

void LasRecordReader::take(const char* records, std::size_t count, std::vector<Point3>& points,
                           std::vector<std::array<std::uint16_t, 3>>& colors) {
  take_all(records, count, points, [&](const char* record) {
    if (red_) {
      const char* const at = record + red_->offset;
      colors.push_back(
          {las_value<std::uint16_t>(at), las_value<std::uint16_t>(at + 2), las_value<std::uint16_t>(at + 4)});
    }
    return Point3{x_(las_value<std::int32_t>(record)), y_(las_value<std::int32_t>(record + 4)),
                  z_(las_value<std::int32_t>(record + 8))};
  });
}

void LasRecordReader::require_height(const LasHeader& header, const std::string& name) const {
  require_las_axis(header, 2, name);
  require_range(header, 2, name);
}

void LasRecordReader::tell(std::vector<std::string>& remarks) const {
  if (selects_)
    remarks.push_back(std::to_string(taken_) + " of " + counted(records_, "point") + " are as --where asks");
  if (withheld_points_ > 0)
    remarks.push_back(counted(withheld_points_, "point") + (withheld_points_ == 1 ? " is" : " are") +
                      " marked as withheld (--where \"not withheld\" leaves them out)");
}

}  // namespace rbpa::app
