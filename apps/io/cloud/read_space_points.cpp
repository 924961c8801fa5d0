#include "io/cloud/read_space_points.h"

#include <algorithm>
#include <utility>

#include "io/bytes/input_bytes.h"
#include "io/cloud/colors.h"
#include "io/cloud/read_points.h"
#include "io/cloud/units.h"
#include "io/failure.h"
#include "io/text/plain_text.h"
#include "io/text/signature.h"

namespace rbpa::app {
namespace {

using Channel3 = std::array<float, 3>;

/// Appends columns `first` to `first` + 2 of a block as vectors.
void append_vectors(const CloudBlock& block, std::size_t first, std::vector<Point3>& vectors) {
  for (std::size_t i = 0; i < block.count; ++i)
    vectors.push_back({block.column[first][i], block.column[first + 1][i], block.column[first + 2][i]});
}

std::array<std::uint8_t, 3> bytes_of(double red, double green, double blue, Channels channels) {
  return {channel_byte(red, channels), channel_byte(green, channels), channel_byte(blue, channels)};
}

/// Reads all points; returns nothing if the file must be read again with last_are_normals.
std::optional<SpacePoints> read_cloud(Cloud& cloud) {
  CloudFacts& facts = cloud.facts();
  SpacePoints space;
  space.points.reserve(facts.expected);
  if (facts.normals) space.normals.reserve(facts.expected);
  std::vector<Channel3> colors;  // as in the file: the range of channels is not known before its end
  if (facts.colors) colors.reserve(facts.expected);
  CloudBlock block;
  while (cloud.next(block)) {
    append_vectors(block, CloudBlock::x, space.points);
    append_fields(block, facts.file.fields);
    append_index(block, facts.file.index);
    if (facts.normals) append_vectors(block, CloudBlock::normal, space.normals);
    for (std::size_t i = 0; facts.colors && i < block.count; ++i) {
      const auto channel = [&](std::size_t k) { return static_cast<float>(block.column[CloudBlock::color + k][i]); };
      colors.push_back({channel(0), channel(1), channel(2)});
    }
  }
  if (facts.last_have_no_direction) return std::nullopt;
  if (facts.last_are_colors) {
    for (const Point3& color : std::exchange(space.normals, {}))
      space.colors.push_back(bytes_of(color.x, color.y, color.z, *facts.colors));
  } else if (facts.colors) {
    space.colors.reserve(colors.size());
    for (const auto& [red, green, blue] : colors)
      space.colors.push_back(
          bytes_of(static_cast<double>(red), static_cast<double>(green), static_cast<double>(blue), *facts.colors));
  }
  if (facts.file.degrees && !space.points.empty()) facts.file.warnings.push_back(warning_on_degrees(space.points));
  cloud.finish();
  static_cast<PointFacts&>(space) = std::move(facts.file);
  space.cell = std::move(facts.cell);
  space.index = unless_identity(std::move(space.index));
  space.all_points = std::max(space.all_points, space.points.size());
  return space;
}

/// Throws BadInput for a normal of length 0, which has no direction.
void require_directions(const SpacePoints& file, const std::string& name) {
  for (std::size_t i = 0; i < file.normals.size(); ++i)
    if (file.normals[i] == Point3{})
      bad_input(name + ": normal of point " + std::to_string(i), "'0 0 0'", "a vector of another length than 0");
}

/// Reads the points of `content`, which is not empty.
SpacePoints read_content(const Content& content, Format format, const CloudRequest& request) {
  CloudRequest in_space = request;
  in_space.in_space = true;
  const CloudFormat& known = *cloud_format(format);
  std::optional<SpacePoints> file = read_cloud(*open_cloud(known, content.again(), in_space));
  in_space.last_are_normals = true;
  if (!file) file = read_cloud(*open_cloud(known, content.again(), in_space));
  if (request.needs_normals) require_directions(*file, content.name());
  settle_columns(file->kept, file->warnings);
  return std::move(*file);
}

}  // namespace

SpacePoints read_space_points(const std::string& path, Format format, const CloudRequest& request) {
  if (reads_parts(path, format, request.window)) return read_content(Content::of_file(path, true), format, request);
  const InputBytes input(path, "a file of points", decompression_of(format, path));
  if (format == Format::by_content) {
    format = format_of_content(Use::space, input.bytes(), input.name(), Format::text);
    require_readable_input(Use::space, format, request.columns.has_value(), request.skip_invalid, false, request.where);
  }
  return space_points_in(input.bytes(), input.name(), format, request);
}

SpacePoints space_points_in(std::string_view bytes, const std::string& name, Format format,
                            const CloudRequest& request) {
  // Refuse an empty file, the result of an earlier command that failed; a file without points may be intended.
  if (bytes.empty()) bad_input(name, "an empty file", "points");
  std::string room;
  return reading_as(Use::space, format, bytes, [&] {
    if (!is_table(format)) bytes = plain_text(bytes, name, format, room);
    return read_content(Content(bytes, name), format, request);
  });
}

}  // namespace rbpa::app
