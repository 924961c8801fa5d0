#include "io/las/las_header.h"
#include "io/las/las_record_reader.h"
#include "io/space/readers.h"

namespace rbpa::app {

SpacePoints read_las_space(std::string_view bytes, const std::string& name, const std::optional<Condition>& where) {
  const LasHeader header = read_las_header(bytes, name);
  LasRecordReader reader(header, where, name);
  reader.require_height(header, name);
  SpacePoints file;
  if (!where) file.points.reserve(header.count);  // whose records are all there
  reader.take(bytes.data() + header.begin, header.count, file.points);
  reader.tell(file.remarks);
  return file;
}

}  // namespace rbpa::app
