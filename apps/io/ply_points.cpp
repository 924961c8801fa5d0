#include "io/ply_points.h"

#include <algorithm>

#include "io/binary_points.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/lines.h"
#include "io/number.h"
#include "io/ply_header.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

std::string announced(const PlyElement& element) {
  return counted(element.count, element.name + " element") + " as line " + std::to_string(element.line) + " says";
}

/// Where x and y are among the properties of a vertex.
struct Position {
  std::size_t x, y;
};

Position find_position(const PlyElement& vertex, const std::string& name) {
  const auto find = [&](std::string_view wanted) {
    for (std::size_t i = 0; i < vertex.properties.size(); ++i)
      if (vertex.properties[i].name == wanted && !vertex.properties[i].count_type) return i;
    bad_input(at_line(name, vertex.line), "vertices without " + in_quotes(wanted), "number properties x and y");
  };
  return {find("x"), find("y")};
}

/// Walks over the elements of a binary file.
class BinaryWalk {
 public:
  BinaryWalk(const PlyHeader& header, const std::string& name)
      : order_(*header.binary), at_(header.data.data()), end_(at_ + header.data.size()), name_(name) {}

  void require_room(const PlyElement& element) const {
    const std::size_t size = element.least_size();
    if (size > 0 && element.count > left() / size) bad_input(name_, counted(left(), "byte") + " of data", announced(element));
  }

  /// Passes over all of `element`, which has room. `visit(index, offsets)` gets where each property begins.
  template <typename Visit>
  void pass(const PlyElement& element, Visit&& visit) {
    if (!element.has_lists()) {
      at_ += element.count * element.least_size();
      return;
    }
    std::vector<const char*> offsets(element.properties.size());
    for (std::size_t i = 0; i < element.count; ++i) {
      if (i % 16384 == 0) stop_if_interrupted();
      for (std::size_t k = 0; k < offsets.size(); ++k) {
        offsets[k] = at_;
        pass(element.properties[k], element, i);
      }
      visit(i, offsets);
    }
  }

  const char* at() const { return at_; }

 private:
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

  void pass(const PlyProperty& property, const PlyElement& element, std::size_t index) {
    std::size_t values = 1;
    if (property.count_type) {
      const char* length = at_;
      take(size_of(*property.count_type), element, index);
      const double count = load_number(*property.count_type, length, order_);
      if (count < 0) bad_input(name_ + ": " + element.name + " " + std::to_string(index), "a negative list length", "none");
      values = count > static_cast<double>(left()) ? left() + 1 : static_cast<std::size_t>(count);
    }
    take(values * size_of(property.type), element, index);
  }
  void take(std::size_t size, const PlyElement& element, std::size_t index) {
    if (size > left()) bad_input(name_, counted(index, "whole " + element.name + " element"), announced(element));
    at_ += size;
  }

  std::endian order_;
  const char* at_;
  const char* end_;
  const std::string& name_;
};

std::vector<Point> read_binary(const PlyHeader& header, const PlyElement& vertex, const std::string& name) {
  const Position position = find_position(vertex, name);
  const Scalar x_type = vertex.properties[position.x].type, y_type = vertex.properties[position.y].type;
  std::vector<Point> points;
  BinaryWalk walk(header, name);
  for (const PlyElement& element : header.elements) {
    walk.require_room(element);
    if (&element != &vertex) {
      walk.pass(element, [](std::size_t, const std::vector<const char*>&) {});
    } else if (vertex.has_lists()) {
      points.resize(vertex.count);
      walk.pass(vertex, [&](std::size_t i, const std::vector<const char*>& offsets) {
        points[i] = {load_number(x_type, offsets[position.x], *header.binary),
                     load_number(y_type, offsets[position.y], *header.binary)};
        require_finite(points[i], i, name);
      });
    } else {
      std::size_t offset[2] = {0, 0};
      for (std::size_t i = 0; i < position.x; ++i) offset[0] += size_of(vertex.properties[i].type);
      for (std::size_t i = 0; i < position.y; ++i) offset[1] += size_of(vertex.properties[i].type);
      points = load_points({vertex.count, walk.at() + offset[0], walk.at() + offset[1], vertex.least_size(), x_type,
                            y_type, *header.binary},
                           name);
      walk.pass(vertex, [](std::size_t, const std::vector<const char*>&) {});
    }
  }
  return points;
}

/// Passes over the words of one property in a line of an ASCII file.
void pass_words(const PlyProperty& property, std::string_view& rest, const Lines& lines, const std::string& name) {
  double values = 1;
  if (property.count_type) values = take_coordinate(rest, lines, name);
  for (double i = 0; i < values; ++i)
    if (take_word(rest).empty()) bad_input(at_line(name, lines.number()), in_quotes(lines.line()), "more values");
}

std::vector<Point> read_ascii(const PlyHeader& header, const PlyElement& vertex, const std::string& name) {
  const Position position = find_position(vertex, name);
  const std::size_t used = std::max(position.x, position.y) + 1;
  Lines lines(header.data, header.lines);
  for (const PlyElement& element : header.elements) {
    if (&element == &vertex) break;
    for (std::size_t i = 0; i < element.count; ++i)
      if (!lines.next_with_content()) bad_input(name, counted(i, element.name + " element"), announced(element));
  }
  // Each value takes a character, and another behind it unless it is the last of the file.
  if (vertex.count > (lines.rest().size() + 1) / (2 * vertex.properties.size()))
    bad_input(name, counted(lines.rest().size(), "byte") + " of data", announced(vertex));
  std::vector<Point> points(vertex.count);
  for (std::size_t i = 0; i < vertex.count; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (!lines.next_with_content()) bad_input(name, counted(i, "vertex element"), announced(vertex));
    std::string_view rest = lines.line();
    for (std::size_t k = 0; k < used; ++k) {
      if (k == position.x) {
        points[i].x = take_coordinate(rest, lines, name);
      } else if (k == position.y) {
        points[i].y = take_coordinate(rest, lines, name);
      } else {
        pass_words(vertex.properties[k], rest, lines, name);
      }
    }
  }
  return points;
}

}  // namespace

std::vector<Point> read_ply_points(std::string_view bytes, const std::string& name) {
  const PlyHeader header = read_ply_header(bytes, name);
  const auto vertex = std::find_if(header.elements.begin(), header.elements.end(),
                                   [](const PlyElement& element) { return element.name == "vertex"; });
  if (vertex == header.elements.end()) bad_input(name, "a header without vertices", "an element 'vertex'");
  return header.binary ? read_binary(header, *vertex, name) : read_ascii(header, *vertex, name);
}

}  // namespace rbpa::app
