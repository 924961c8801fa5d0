#include "io/cloud/read_points.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <utility>

#include "io/box.h"
#include "io/bytes/input_bytes.h"
#include "io/cloud/units.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/ogr.h"
#include "io/polygon/read_geojson.h"
#include "io/polygon/wkt.h"
#include "io/text/plain_text.h"
#include "io/text/signature.h"

namespace rbpa::app {
namespace {

/// Returns `file` without the points that are not in `window`. Throws BadInput.
PointFile in_window(PointFile file, const std::string& name, const PointWindow& window) {
  if (!window.selects()) return file;
  if (file.z.empty() && window.bounds && window.bounds->has_heights()) refuse_flat_points(name);
  WindowFilter filter(window, false, true);
  const std::size_t all = file.points.size();
  std::vector<std::uint32_t> index;
  std::vector<std::uint8_t> kept(all);
  for (std::size_t i = 0; i < all; ++i) {
    if (!filter.keeps({file.points[i].x, file.points[i].y, file.z.empty() ? 0 : file.z[i]})) continue;
    kept[i] = 1;
    const std::size_t to = index.size();
    index.push_back(file.index.empty() ? static_cast<std::uint32_t>(i) : file.index[i]);
    file.points[to] = file.points[i];
    if (!file.z.empty()) file.z[to] = file.z[i];
    for (std::vector<double>& field : file.fields) field[to] = field[i];
  }
  file.points.resize(index.size());
  if (!file.z.empty()) file.z.resize(index.size());
  for (std::vector<double>& field : file.fields) field.resize(index.size());
  keep_values(file.kept, 0, kept);
  file.all_points = std::max(file.all_points, all);
  file.warnings.push_back(warning_on_window(window, index.size(), all));
  file.index = unless_identity(std::move(index));
  return file;
}

/// Reads points by the reader of their format; geometries and pixels, which are not columns, have readers of their own.
PointFile parse(std::string_view bytes, const std::string& name, const PointSource& source) {
  const Format format = source.format;
  const auto within = [&](PointFile file) { return in_window(std::move(file), name, source.window); };
  if (format == Format::png) return within({{}, read_png_points(bytes, name, source.pixels)});
  if (format == Format::pgm) return within({{}, read_pgm_points(bytes, name, source.pixels)});
  if (format == Format::geojson)
    return within(read_geojson_points(bytes, name, source.vertices, source.where, source.keeps));
  if (format == Format::wkt) return within(read_wkt_points(bytes, name, source.vertices));
  return read_plane_points(*open_plane_cloud(Content(bytes, name), source));
}

}  // namespace

std::string warning_on_equal(std::size_t points, const Point& p) {
  return "all " + std::to_string(points) + " points are (" + text_of(p.x) + ", " + text_of(p.y) +
         "): were digits lost?";
}

namespace {

/// Adds a warning if all points are equal; or if points such as (0, 0) or (-9999, -9999) are far from the others:
/// farther outside of the bounding box of the others than its longer side.
void warn_of_odd_points(PointFile& file) {
  const auto stands_for_nothing = [](const Point& p) {
    constexpr double signs[] = {0, 999, 9999, 99999, 999999};
    return p.x == p.y && std::find(std::begin(signs), std::end(signs), std::abs(p.x)) != std::end(signs);
  };
  const Point first = file.points.empty() ? Point{} : file.points.front();
  if (file.points.size() > 2 &&
      std::all_of(file.points.begin(), file.points.end(), [&](const Point& p) { return p == first; }))
    return file.warnings.push_back(warning_on_equal(file.points.size(), first));
  std::vector<Point> odd;
  Box box;
  InterruptibleSteps step;
  for (const Point& p : file.points) {
    step();
    if (stands_for_nothing(p)) {
      odd.push_back(p);
      continue;
    }
    box.add(p);
  }
  if (file.points.size() < odd.size() + 3) return;
  const Point &least = box.least, &greatest = box.greatest;
  const double side = std::max(greatest.x - least.x, greatest.y - least.y);
  std::erase_if(odd, [&](const Point& p) {
    return std::max({least.x - p.x, p.x - greatest.x, least.y - p.y, p.y - greatest.y}) <= side;
  });
  if (odd.empty()) return;
  file.warnings.push_back(counted(odd.size(), "point") + (odd.size() == 1 ? " is" : ", the first of them") + " (" +
                          text_of(odd.front().x) + ", " + text_of(odd.front().y) +
                          "), far from all others, as where a number is missing (--where leaves points out)");
}

/// Returns whether a field that may be the height is chosen by its name.
bool chooses_height(const std::optional<FieldChoice>& choice) {
  return choice && choice->names &&
         std::any_of(choice->names->begin(), choice->names->end(),
                     [](const std::string& name) { return find_height({name}).has_value(); });
}

/// Adds the heights to the kept fields if they are chosen, as z or by the name of their column.
void keep_heights(PointFile& file, const std::optional<FieldChoice>& choice) {
  if (!choice || !choice->names || file.z.empty()) return;
  for (const std::string& name : *choice->names) {
    if (find_column(file.kept, name) || !(same_letters(name, file.height_name) || same_letters(name, "z"))) continue;
    PointColumn& column = file.kept.emplace_back();
    column.name = name;
    for (const double z : file.z) column.append(z);
  }
}

/// Returns `file` with its system of coordinates, with shifted longitudes and heights as requested, and with warnings.
PointFile settled(PointFile file, const std::string& name, const PointSource& source) {
  settle_crs(file, source.crs);
  file.index = unless_identity(std::move(file.index));  // readers of geometries always fill it in if they select
  settle_columns(file.kept, file.warnings);
  if (source.shift_longitude) {
    shift_longitude(file.points, name);
    file.degrees = true;
  }
  if (file.degrees && !source.beside_points) warning_on_degrees(file);
  warn_of_odd_points(file);
  keep_heights(file, source.keeps);
  if (!source.heights) file.z = {};  // readers of geometries always fill in z
  return file;
}

}  // namespace

std::unique_ptr<Cloud> open_plane_cloud(Content content, const PointSource& source) {
  if (content.size() == 0) bad_input(content.name(), "an empty file", "points");
  return open_cloud(*cloud_format(source.format), std::move(content),
                    {.columns = source.columns,
                     .where = source.where,
                     .heights = source.heights || chooses_height(source.keeps),
                     .skip_invalid = source.skip_invalid,
                     .vertices = source.vertices,
                     .keeps = source.keeps,
                     .window = source.window,
                     .scan_counts = source.scan_counts,
                     .threads = source.threads});
}

bool reads_parts(const std::string& path, Format format, const PointWindow& window) {
  std::error_code error;
  return window.selects() && is_las(format) && std::filesystem::is_regular_file(path, error);
}

PointFile read_plane_points(Cloud& cloud) {
  PointFile& file = cloud.facts().file;
  file.points.reserve(cloud.facts().expected);
  CloudBlock block;
  while (cloud.next(block)) {
    append_points(block, file.points);
    append_fields(block, file.fields);
    file.z.insert(file.z.end(), block.heights.begin(), block.heights.end());
    append_index(block, file.index);
  }
  cloud.finish();
  file.index = unless_identity(std::move(file.index));
  file.all_points = std::max(file.all_points, file.points.size());
  return std::move(file);
}

void append_points(const CloudBlock& block, std::vector<Point>& points) {
  const double* const x = block.column[CloudBlock::x].data();
  const double* const y = block.column[CloudBlock::y].data();
  const std::size_t before = points.size();
  points.resize(before + block.count);
  for (std::size_t i = 0; i < block.count; ++i) points[before + i] = {x[i], y[i]};
}

void settle_crs(PointFile& file, const std::optional<Crs>& said) {
  if (said && file.crs && file.crs->text() != said->text())
    file.warnings.push_back((file.crs->implied ? "GeoJSON without a crs member means " : "the file names ") +
                            file.crs->text() + ", but --crs " + said->text() + " overrides it");
  PointFile of_said;
  of_said.crs = said;
  if (said && !said->degrees && file.degrees && !file.crs && unit_of(of_said))
    file.warnings.push_back("the columns are longitudes and latitudes, which --crs " + said->text() +
                            ", a projected system, contradicts");
  if (said) file.crs = said;
  if (file.crs && file.crs->degrees) file.degrees = true;
}

void require_readable(Use use, Format format, const OptionNames& options, const std::string& found) {
  const auto require = [&](const char* option, bool fits, const char* without, const std::string& expected) {
    if (option != nullptr && !fits) bad_usage(option, found + without, expected);
  };
  const auto skips_invalid = [](const CloudFormat& reader) { return reader.skips_invalid; };
  require(options.columns, is_table(format), " with fixed columns", "text");
  require(options.skip_invalid, format == Format::by_content || has(format, &CloudFormat::skips_invalid),
          " without points that can be left out", readable(use, skips_invalid));
  require(options.vertices, use == Use::points && has_lines(format), " without lines and polygons",
          "points in the plane in one of " + endings(Use::points, has_lines));
  require(options.fields, fields_of(format).has_value(), " without fields", with_fields(use));
}

void require_readable_input(Use use, Format format, bool columns, bool skip_invalid, bool vertices,
                            const std::optional<Condition>& where) {
  require_readable(use, format,
                   {.columns = columns ? "--columns" : nullptr,
                    .skip_invalid = skip_invalid ? "--skip-invalid" : nullptr,
                    .vertices = vertices ? "--vertices" : nullptr,
                    .fields = where ? "--where" : nullptr},
                   "standard input in a format");
  if (!where) return;
  const FieldNames names = *fields_of(format);
  for (const std::string& field : where->fields())
    if (!names.are(field))
      bad_usage(std::string(where->option_of(field)), in_quotes(field) + ", but standard input has no such field",
                names.described);
  if (!names.texts && !where->texts().empty())
    bad_usage("--where", "the text " + in_quotes(where->texts().front().text),
              "numbers, as the fields of standard input have no texts");
}

PointFile read_points(const PointSource& source) {
  if (source.format == Format::ogr)
    return settled(in_window(read_ogr_points(source.path, source.layer, source.vertices), source.path, source.window),
                   source.path, source);
  if (reads_parts(source.path, source.format, source.window))
    return settled(read_plane_points(*open_plane_cloud(Content::of_file(source.path, true), source)), source.path,
                   source);
  const InputBytes input(source.path, source.beside_points ? "a file of lines" : "a file of points",
                         decompression_of(source.format, source.path,
                                          " (rbpa stream reads " + streamed_formats() + " a block at a time)"));
  if (source.format != Format::by_content) return points_in(input.bytes(), input.name(), source);
  PointSource known = source;
  known.format = format_of_content(Use::points, input.bytes(), input.name(), Format::text);
  require_readable_input(Use::points, known.format, known.columns.has_value(), known.skip_invalid, known.vertices,
                         known.where);
  return points_in(input.bytes(), input.name(), known);
}

PointFile points_in(std::string_view bytes, const std::string& name, const PointSource& source) {
  // Refuse an empty file, the result of an earlier command that failed; a file without points may be intended.
  if (bytes.empty()) bad_input(name, "an empty file", "points");
  std::string room;
  return reading_as(Use::points, source.format, bytes, [&] {
    if (!is_table(source.format)) bytes = plain_text(bytes, name, source.format, room);
    return settled(parse(bytes, name, source), name, source);
  });
}

}  // namespace rbpa::app
