#include "io/las/las_points.h"

#include <cmath>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/las/las_header.h"
#include "io/las/las_projection.h"
#include "io/las/selection.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

/// No double is larger than what the largest integers become: then no point is infinite.
void require_range(const LasHeader& header, const std::string& name) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    constexpr double largest = 0x1p31;
    if (!std::isfinite(largest * std::abs(header.scale[axis]) + std::abs(header.offset[axis])))
      bad_input(name,
                "a scale of " + in_quotes(ShortestText(header.scale[axis])) + " and an offset of " +
                    in_quotes(ShortestText(header.offset[axis])),
                "coordinates within the range of a double");
  }
}

}  // namespace

PointFile read_las_points(std::string_view bytes, const std::string& name, const std::optional<Condition>& where) {
  const LasHeader header = read_las_header(bytes, name);
  require_range(header, name);
  const LasCrs system = las_crs(bytes, header);
  PointFile file{.crs = system.crs};
  if (!system.remark.empty()) file.remarks.push_back(system.remark);
  const ScaledInteger x(header.scale[0], header.offset[0]), y(header.scale[1], header.offset[1]),
      z(header.scale[2], header.offset[2]);
  std::optional<Selection> selects;
  if (where) selects.emplace(*where, LasRecords{header.format, header.minor, {x, y, z}}, name);
  const std::optional<LasField> withheld = find_las_field("withheld", header.format, header.minor);

  std::size_t withheld_points = 0;
  if (!where) file.points.reserve(header.count);  // whose records are all there
  for (std::size_t i = 0; i < header.count; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    const char* record = header.points + i * header.length;
    if (selects && !(*selects)(record)) continue;
    file.points.push_back({x(las_value<std::int32_t>(record)), y(las_value<std::int32_t>(record + 4))});
    if (withheld && withheld->value(record) != 0) ++withheld_points;
  }
  if (where)
    file.remarks.push_back(std::to_string(file.points.size()) + " of " + counted(header.count, "point") +
                           " are as --where asks");
  if (withheld_points > 0)
    file.remarks.push_back(counted(withheld_points, "point") + (withheld_points == 1 ? " is" : " are") +
                           " marked as withheld (--where \"not withheld\" leaves them out)");
  return file;
}

}  // namespace rbpa::app
