#include "io/las/las_points.h"

#include "io/las/las_header.h"
#include "io/las/las_projection.h"
#include "io/las/las_record_reader.h"

namespace rbpa::app {

PointFile read_las_points(std::string_view bytes, const std::string& name, const std::optional<Condition>& where,
                          bool skip_invalid) {
  const LasHeader header = read_las_header(bytes, name);
  LasRecordReader reader(header, where, name);
  const LasCrs system = las_crs(bytes, header);
  PointFile file{.crs = system.crs};
  const std::size_t count = header.count.settle(skip_invalid, name, file.remarks);
  if (!system.remark.empty()) file.remarks.push_back(system.remark);
  if (!where) file.points.reserve(count);  // whose records are all there
  reader.take(bytes.data() + header.begin, count, file.points);
  reader.tell(file.remarks);
  return file;
}

}  // namespace rbpa::app
