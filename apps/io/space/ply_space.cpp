#include <algorithm>
#include <array>
#include <cmath>

#include "io/failure.h"
#include "io/number.h"
#include "io/ply_data.h"
#include "io/space/readers.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Where things are among the properties of a vertex.
struct PlyColumns {
  std::vector<std::size_t> numbers = {};  ///< of x, y, z and, when there are six, of the normal
  std::vector<std::size_t> colors = {};   ///< none, or three
};

PlyColumns lay_out(const PlyElement& vertex, const std::string& name, std::vector<std::string>& remarks) {
  PlyColumns layout;
  for (const std::string_view axis : {"x", "y", "z"})
    layout.numbers.push_back(find_number(vertex, axis, "x, y and z", name));
  std::vector<std::size_t> normal;
  for (const std::string_view axis : {"nx", "ny", "nz"})
    if (const std::optional<std::size_t> place = number_place(vertex, axis)) normal.push_back(*place);
  if (normal.size() == 3) layout.numbers.insert(layout.numbers.end(), normal.begin(), normal.end());
  if (normal.size() == 1 || normal.size() == 2)
    remarks.emplace_back("normals are left out, as not all of nx, ny and nz are there");
  for (const std::string_view channel : {"red", "green", "blue"})
    if (const std::optional<std::size_t> place = number_place(vertex, channel)) layout.colors.push_back(*place);
  const bool bytes = std::all_of(layout.colors.begin(), layout.colors.end(),
                                 [&](std::size_t place) { return vertex.properties[place].type == Scalar::uint8; });
  if (!layout.colors.empty() && (layout.colors.size() < 3 || !bytes)) {
    remarks.emplace_back("colours are left out, as red, green and blue are not three of type uchar");
    layout.colors.clear();
  }
  return layout;
}

void read_binary(const PlyHeader& header, const PlyElement& vertex, const PlyColumns& layout, const std::string& name,
                 SpacePoints& file) {
  std::array<double, 6> value{};
  const std::span<const double> values(value.data(), layout.numbers.size());
  /// `at(k)` is where property k of the vertex is.
  const auto take = [&](const auto& at) {
    for (std::size_t k = 0; k < values.size(); ++k)
      value[k] = load_number(vertex.properties[layout.numbers[k]].type, at(layout.numbers[k]), *header.binary);
    append_numbers(values, file, name);
    if (layout.colors.empty()) return;
    const auto channel = [&](std::size_t k) { return static_cast<std::uint8_t>(*at(layout.colors[k])); };
    file.colors.push_back({channel(0), channel(1), channel(2)});
  };
  PlyBinary data(header, name);
  for (const PlyElement& element : header.elements) {
    data.require_room(element);
    if (&element != &vertex) {
      data.skip(element);
      continue;
    }
    reserve_points(file, vertex.count, values.size() == 6, !layout.colors.empty());
    if (vertex.has_lists()) {
      data.pass(vertex, [&](std::size_t, const std::vector<const char*>& offsets) {
        take([&](std::size_t k) { return offsets[k]; });
      });
      continue;
    }
    std::vector<std::size_t> offsets;
    std::size_t size = 0;
    for (const PlyProperty& property : vertex.properties) {
      offsets.push_back(size);
      size += size_of(property.type);
    }
    for (std::size_t i = 0; i < vertex.count; ++i) {
      if (i % 16384 == 0) stop_if_interrupted();
      take([&](std::size_t k) { return data.at() + i * size + offsets[k]; });
    }
    data.skip(vertex);
  }
}

void read_ascii(const PlyHeader& header, const PlyElement& vertex, const PlyColumns& layout, const std::string& name,
                SpacePoints& file) {
  PlyText data(header, name);
  for (const PlyElement& element : header.elements) {
    if (&element == &vertex) break;
    data.skip(element);
  }
  data.require_room(vertex);
  reserve_points(file, vertex.count, layout.numbers.size() == 6, !layout.colors.empty());
  // What each property is: a number, by its place among them, behind them a channel of the colour, or nothing.
  constexpr std::size_t first_channel = 6, nothing = 9;
  std::vector<std::size_t> role(vertex.properties.size(), nothing);
  for (std::size_t k = 0; k < layout.numbers.size(); ++k) role[layout.numbers[k]] = k;
  for (std::size_t k = 0; k < layout.colors.size(); ++k) role[layout.colors[k]] = first_channel + k;
  while (role.back() == nothing) role.pop_back();  // what is behind the last that counts is not looked at

  std::array<double, 6> value{};
  std::array<std::uint8_t, 3> color{};
  data.pass(vertex, [&](std::size_t, std::string_view& rest) {
    for (std::size_t k = 0; k < role.size(); ++k) {
      if (role[k] == nothing) {
        data.pass_words(vertex.properties[k], rest);
        continue;
      }
      const double number = take_coordinate(rest, data.lines(), name);
      if (role[k] < first_channel) {
        value[role[k]] = number;
        continue;
      }
      if (!(number >= 0 && number <= 255 && number == std::floor(number)))
        bad_input(at_line(name, data.lines().number()), in_quotes(ShortestText(number)),
                  "a channel of a colour, from 0 to 255");
      color[role[k] - first_channel] = static_cast<std::uint8_t>(number);
    }
    append_numbers({value.data(), layout.numbers.size()}, file, name);
    if (!layout.colors.empty()) file.colors.push_back(color);
  });
}

}  // namespace

SpacePoints read_ply_space(std::string_view bytes, const std::string& name) {
  const PlyHeader header = read_ply_header(bytes, name);
  const PlyElement& vertex = vertices_of(header, name);
  SpacePoints file;
  const PlyColumns layout = lay_out(vertex, name, file.remarks);
  header.binary ? read_binary(header, vertex, layout, name, file) : read_ascii(header, vertex, layout, name, file);
  return file;
}

}  // namespace rbpa::app
