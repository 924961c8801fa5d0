#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "io/las/las_header.h"
#include "io/las/las_projection.h"
#include "io/las/las_record_reader.h"
#include "io/points/longitude.h"
#include "io/space/readers.h"

namespace rbpa::app {

namespace {

using Wide = std::array<std::uint16_t, 3>;

/// Channels have 16 bits, but many programs write 8: where none of the file is above 255 they are taken so. Programs that
/// have no colours write black.
std::vector<std::array<std::uint8_t, 3>> colors_of(const std::vector<Wide>& wide) {
  std::uint16_t greatest = 0;
  for (const Wide& color : wide) greatest = std::max({greatest, color[0], color[1], color[2]});
  if (greatest == 0) return {};
  const unsigned shift = greatest > 255 ? 8 : 0;
  const auto byte = [shift](std::uint16_t channel) { return static_cast<std::uint8_t>(channel >> shift); };
  std::vector<std::array<std::uint8_t, 3>> colors;
  colors.reserve(wide.size());
  for (const auto& [red, green, blue] : wide) colors.push_back({byte(red), byte(green), byte(blue)});
  return colors;
}

}  // namespace

SpacePoints read_las_space(std::string_view bytes, const std::string& name, const SpaceChoice& choice) {
  const LasHeader header = read_las_header(bytes, name);
  LasRecordReader reader(header, choice.where, name);
  reader.require_height(header, name);
  SpacePoints file;
  const std::size_t count = header.count.settle(choice.skip_invalid, name, file.remarks);
  if (!choice.where) file.points.reserve(count);  // whose records are all there
  std::vector<Wide> colors;
  reader.take(bytes.data() + header.begin, count, file.points, colors);
  file.colors = colors_of(colors);
  if (const LasCrs system = las_crs(bytes, header); system.crs && system.crs->degrees && !file.points.empty())
    file.remarks.push_back(remark_on_degrees(file.points));
  reader.tell(file.remarks);
  return file;
}

}  // namespace rbpa::app
