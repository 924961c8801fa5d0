#include "io/points/ply_points.h"

#include <algorithm>

#include "io/failure.h"
#include "io/ply_data.h"
#include "io/points/binary_points.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Where x and y are among the properties of a vertex.
struct Position {
  std::size_t x, y;
};

std::vector<Point> read_binary(const PlyHeader& header, const PlyElement& vertex, const Position& position,
                               const std::string& name) {
  const Scalar x_type = vertex.properties[position.x].type, y_type = vertex.properties[position.y].type;
  std::vector<Point> points;
  PlyBinary data(header, name);
  for (const PlyElement& element : header.elements) {
    data.require_room(element);
    if (&element != &vertex) {
      data.skip(element);
    } else if (vertex.has_lists()) {
      points.resize(vertex.count);
      data.pass(vertex, [&](std::size_t i, const std::vector<const char*>& offsets) {
        points[i] = {load_number(x_type, offsets[position.x], *header.binary),
                     load_number(y_type, offsets[position.y], *header.binary)};
        require_finite(points[i], i, name);
      });
    } else {
      std::size_t offset[2] = {0, 0};
      for (std::size_t i = 0; i < position.x; ++i) offset[0] += size_of(vertex.properties[i].type);
      for (std::size_t i = 0; i < position.y; ++i) offset[1] += size_of(vertex.properties[i].type);
      points = load_points({vertex.count, data.at() + offset[0], data.at() + offset[1], vertex.least_size(), x_type,
                            y_type, *header.binary},
                           name);
      data.skip(vertex);
    }
  }
  return points;
}

std::vector<Point> read_ascii(const PlyHeader& header, const PlyElement& vertex, const Position& position,
                              const std::string& name) {
  const std::size_t used = std::max(position.x, position.y) + 1;
  PlyText data(header, name);
  for (const PlyElement& element : header.elements) {
    if (&element == &vertex) break;
    data.skip(element);
  }
  data.require_room(vertex);
  std::vector<Point> points(vertex.count);
  data.pass(vertex, [&](std::size_t i, std::string_view& rest) {
    for (std::size_t k = 0; k < used; ++k) {
      if (k == position.x) {
        points[i].x = take_coordinate(rest, data.lines(), name);
      } else if (k == position.y) {
        points[i].y = take_coordinate(rest, data.lines(), name);
      } else {
        data.pass_words(vertex.properties[k], rest);
      }
    }
  });
  return points;
}

}  // namespace

std::vector<Point> read_ply_points(std::string_view bytes, const std::string& name) {
  const PlyHeader header = read_ply_header(bytes, name);
  const PlyElement& vertex = vertices_of(header, name);
  const Position position = {find_number(vertex, "x", "x and y", name), find_number(vertex, "y", "x and y", name)};
  return header.binary ? read_binary(header, vertex, position, name) : read_ascii(header, vertex, position, name);
}

}  // namespace rbpa::app
