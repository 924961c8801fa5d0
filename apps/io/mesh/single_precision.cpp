#include "io/mesh/single_precision.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/zero_area.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

/// The bounding box of positions that triangles use; `are_floats` tells whether all coordinates are floats.
struct BoxOfUsed {
  Position least, greatest;
  bool are_floats = true;

  BoxOfUsed() {
    least.fill(std::numeric_limits<double>::infinity());
    greatest.fill(-std::numeric_limits<double>::infinity());
  }
  void take(const Position& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], p[k]);
      greatest[k] = std::max(greatest[k], p[k]);
      are_floats = are_floats && std::abs(p[k]) <= std::numeric_limits<float>::max() &&
                   static_cast<double>(static_cast<float>(p[k])) == p[k];
    }
  }
  Position middle_in_floats() const {
    Position middle;
    for (std::size_t k = 0; k < 3; ++k) {
      const double half = least[k] / 2 + greatest[k] / 2;
      middle[k] = std::abs(half) <= std::numeric_limits<float>::max() ? static_cast<float>(half) : 0;
    }
    return middle;
  }
};

/// Returns the offset that `format` subtracts from the vertices before it rounds them.
Position subtracted(Format format, std::span<const Point3> vertices, Triangles triangles,
                    const std::optional<Shift>& shift) {
  if (shift && shift->by) return *shift->by;
  if (!shift && format != Format::glb) return {};
  BoxOfUsed box;
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle) box.take(position_of(vertices[corner]));
  return box.are_floats ? Position{} : box.middle_in_floats();
}

}  // namespace

Shift parse_shift(const std::string& option, const std::string& text) {
  if (text == "auto") return {};
  Position by{};
  const std::vector<std::string_view> parts = split_at_commas(text);
  bool is_good = parts.size() == by.size();
  for (std::size_t k = 0; is_good && k < by.size(); ++k) {
    const ParsedNumber number = parse_whole_number(parts[k]);
    is_good = number.fault == NumberFault::none;
    by[k] = number.value;
  }
  if (!is_good) bad_usage(option, in_quotes(text), "three numbers, such as 500000,4649000,0, or auto");
  return {by};
}

std::vector<Position> SinglePositions::positions() const {
  std::vector<Position> result;
  result.reserve(at.size());
  for (const auto& [x, y, z] : at) result.push_back({x, y, z});
  return result;
}

SinglePositions single_positions(Format format, std::span<const Point3> vertices, Triangles triangles,
                                 const std::optional<Shift>& shift, const std::string& file) {
  std::vector<bool> is_used(vertices.size(), false);
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle) is_used[corner] = true;
  SinglePositions result{.at = std::vector<std::array<float, 3>>(vertices.size()),
                         .shift = subtracted(format, vertices, triangles, shift)};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!is_used[i]) continue;
    const Position p = position_of(vertices[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = p[k] - result.shift[k];
      if (!(std::abs(x) <= std::numeric_limits<float>::max()))
        bad_input(file,
                  "the coordinate " + text_of(p[k]) + (result.shift[k] != 0 ? " less " + text_of(result.shift[k]) : ""),
                  std::string("at most 3.4e38 in size, as ") + (format == Format::stl ? "STL" : "GLB") +
                      " is in single precision (.ply keeps doubles)");
      result.at[i][k] = static_cast<float>(x);
    }
  }
  return result;
}

Lost lost(std::span<const Point3> vertices, Triangles triangles, const SinglePositions& rounded) {
  Lost result;
  const std::vector<Position> after = rounded.positions();
  std::size_t done = 0;
  const auto go_on = [&] {
    if (++done % 16384 == 0) stop_if_interrupted();
  };
  for (const auto& triangle : triangles) {
    go_on();
    if (!is_on_a_line(triangle, after)) continue;
    constexpr std::array<std::uint32_t, 3> corners = {0, 1, 2};
    const std::array before = {position_of(vertices[triangle[0]]), position_of(vertices[triangle[1]]),
                               position_of(vertices[triangle[2]])};
    if (!is_on_a_line(corners, before)) ++result.areas;
  }
  EqualPositions places(after.size());
  std::vector<bool> is_seen(vertices.size(), false);
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle) {
      if (is_seen[corner]) continue;
      is_seen[corner] = true;
      ++result.used;
      go_on();
      const std::uint32_t first = places.first_at(after, corner);
      if (first != corner && position_of(vertices[first]) != position_of(vertices[corner])) ++result.vertices;
    }
  return result;
}

std::string why_not_kept(const SinglePositions& rounded, Format format, std::span<const Point3> vertices,
                         Triangles triangles, const std::string& file) {
  const Lost found = lost(vertices, triangles, rounded);
  if (!found.any()) return "";
  std::string what;
  if (found.areas > 0)
    what = "leaves " + std::to_string(found.areas) + " of " + counted(triangles.size(), "triangle") + " without area";
  if (found.vertices > 0)
    what += (what.empty() ? "moves " : " and moves ") + std::to_string(found.vertices) + " of " +
            std::to_string(found.used) + " vertices onto others";
  const SinglePositions shifted = single_positions(format, vertices, triangles, Shift(), file);
  return file + ": single precision " + what +
         way_to_keep(shifted.shift != rounded.shift && !lost(vertices, triangles, shifted).any());
}

std::string text_of_shift(Format format, std::span<const Point3> vertices, Triangles triangles,
                          const std::optional<Shift>& shift, const std::string& file) {
  if (!shift || !has_single_precision(format)) return "";
  const Position by = subtracted(format, vertices, triangles, shift);
  return by == Position{} ? "" : file + ": " + text_of(by) + " is subtracted from all coordinates";
}

std::string text_of(const Position& position) {
  std::string text;
  for (const double x : position) {
    const bool is_short = x == 0 || (std::abs(x) >= 1e-3 && std::abs(x) < 1e15);
    char number[number_room];
    const auto [end, error] = std::to_chars(number, number + sizeof number, x, std::chars_format::fixed);
    if (!text.empty()) text += ',';
    text += is_short && error == std::errc() ? std::string(number, end) : text_of(x);
  }
  return text;
}

std::string way_to_keep(bool shift_keeps) {
  return shift_keeps ? " (not with --shift auto, nor as .ply, .obj or .off)"
                     : " (not as .ply, .obj or .off, in double precision)";
}

}  // namespace rbpa::app
