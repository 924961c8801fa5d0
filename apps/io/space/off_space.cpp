#include "io/failure.h"
#include "io/interrupt.h"
#include "io/off_header.h"
#include "io/space/readers.h"
#include "io/space/text_colors.h"
#include "io/vertex_lines.h"

namespace rbpa::app {

SpacePoints read_off_space(std::string_view text, const std::string& name) {
  const OffHeader header = read_off_header(text, name);
  Lines lines = header.lines;
  SpacePoints file;
  reserve_points(file, header.vertices, header.normals, false);
  TextColors colors;
  for (std::size_t i = 0; i < header.vertices; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (!lines.next_with_content())
      bad_input(name, counted(i, "vertex line"), announced(header, header.vertices, "vertex line"));
    std::string_view rest = lines.line();
    const auto [x, y, z] = take_position(rest, lines, name);
    file.points.push_back({x, y, z});
    if (header.normals) {
      const auto [nx, ny, nz] = take_position(rest, lines, name);
      file.normals.push_back({nx, ny, nz});
    }
    if (header.colors) colors.take(rest.substr(0, rest.find('#')), lines.number());
  }
  colors.settle(header.colors && header.vertices > 0, file);
  return file;
}

}  // namespace rbpa::app
