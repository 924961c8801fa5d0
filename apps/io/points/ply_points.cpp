#include "io/points/ply_points.h"

#include <algorithm>
#include <optional>

#include "io/failure.h"
#include "io/lines.h"
#include "io/number.h"
#include "io/ply_data.h"
#include "io/points/binary_points.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Where x and y are among the properties of a vertex, and z if it is.
struct Position {
  std::size_t x, y;
  std::optional<std::size_t> z;
};

void take_heights(const PlyHeader& header, const PlyElement& vertex, std::size_t place, const char* at,
                  Heights& heights) {
  for (std::size_t i = 0; i < place; ++i) at += size_of(vertex.properties[i].type);
  for (std::size_t i = 0; i < vertex.count && !heights.differ(); ++i, at += vertex.least_size())
    heights.take(load_number(vertex.properties[place].type, at, *header.binary));
}

PointFile read_binary(const PlyHeader& header, const PlyElement& vertex, const Position& position,
                      const std::string& name) {
  const Scalar x_type = vertex.properties[position.x].type, y_type = vertex.properties[position.y].type;
  PointFile file;
  std::vector<Point>& points = file.points;
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
        if (position.z)
          file.heights.take(load_number(vertex.properties[*position.z].type, offsets[*position.z], *header.binary));
      });
    } else {
      std::size_t offset[2] = {0, 0};
      for (std::size_t i = 0; i < position.x; ++i) offset[0] += size_of(vertex.properties[i].type);
      for (std::size_t i = 0; i < position.y; ++i) offset[1] += size_of(vertex.properties[i].type);
      points = load_points({vertex.count, data.at() + offset[0], data.at() + offset[1], vertex.least_size(), x_type,
                            y_type, *header.binary},
                           name);
      if (position.z) take_heights(header, vertex, *position.z, data.at(), file.heights);
      data.skip(vertex);
    }
  }
  return file;
}

/// Whether there may be more. Lists before it are none of a file with heights that we would know.
bool take_height(const PlyElement& vertex, std::size_t place, std::string_view line, Heights& heights) {
  if (vertex.has_lists()) return false;
  for (std::size_t k = 0; k < place; ++k) take_word(line);
  const ParsedNumber z = parse_whole_number(take_word(line));
  if (z.fault == NumberFault::none) heights.take(z.value);
  return !heights.differ();
}

PointFile read_ascii(const PlyHeader& header, const PlyElement& vertex, const Position& position,
                     const std::string& name) {
  const std::size_t used = std::max(position.x, position.y) + 1;
  PlyText data(header, name);
  for (const PlyElement& element : header.elements) {
    if (&element == &vertex) break;
    data.skip(element);
  }
  data.require_room(vertex);
  PointFile file{.points = std::vector<Point>(vertex.count)};
  std::vector<Point>& points = file.points;
  bool has_z = position.z.has_value();
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
    if (has_z) has_z = take_height(vertex, *position.z, data.lines().line(), file.heights);
  });
  return file;
}

}  // namespace

PointFile read_ply_points(std::string_view bytes, const std::string& name) {
  const PlyHeader header = read_ply_header(bytes, name);
  const PlyElement& vertex = vertices_of(header, name);
  const Position position = {find_number(vertex, "x", "x and y", name), find_number(vertex, "y", "x and y", name),
                             number_place(vertex, "z")};
  return header.binary ? read_binary(header, vertex, position, name) : read_ascii(header, vertex, position, name);
}

}  // namespace rbpa::app
