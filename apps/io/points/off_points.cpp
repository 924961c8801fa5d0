#include "io/points/off_points.h"

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/off_header.h"
#include "io/vertex_lines.h"

namespace rbpa::app {

PointFile read_off_points(std::string_view text, const std::string& name) {
  const OffHeader header = read_off_header(text, name);
  Lines lines = header.lines;
  PointFile file{.points = std::vector<Point>(header.vertices)};
  std::vector<Point>& points = file.points;
  for (std::size_t i = 0; i < header.vertices; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (!lines.next_with_content())
      bad_input(name, counted(i, "vertex line"), announced(header, header.vertices, "vertex line"));
    std::string_view line = lines.line();
    points[i].x = take_coordinate(line, lines, name);
    points[i].y = take_coordinate(line, lines, name);
    if (file.heights.differ()) continue;
    if (const ParsedNumber z = parse_whole_number(take_word(line)); z.fault == NumberFault::none)
      file.heights.take(z.value);
  }
  return file;
}

}  // namespace rbpa::app
