#include "io/points/off_points.h"

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/off_header.h"
#include "io/vertex_lines.h"

namespace rbpa::app {

std::vector<Point> read_off_points(std::string_view text, const std::string& name) {
  const OffHeader header = read_off_header(text, name);
  Lines lines = header.lines;
  std::vector<Point> points(header.vertices);
  for (std::size_t i = 0; i < header.vertices; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (!lines.next_with_content())
      bad_input(name, counted(i, "vertex line"), announced(header, header.vertices, "vertex line"));
    std::string_view line = lines.line();
    points[i].x = take_coordinate(line, lines, name);
    points[i].y = take_coordinate(line, lines, name);
  }
  return points;
}

}  // namespace rbpa::app
