#include "shared/point_arguments.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/cloud/atoms.h"
#include "io/failure.h"
#include "io/number.h"
#include "shared/arguments.h"

namespace rbpa::app {
namespace {

/// Parses --foreground ("dark" or "light") and --threshold (a number > 0 and <= 1).
PixelRule parse_pixel_rule(const PointArguments& arguments) {
  PixelRule rule;
  if (arguments.foreground) {
    if (*arguments.foreground != "dark" && *arguments.foreground != "light")
      bad_usage("--foreground", in_quotes(*arguments.foreground), "dark or light");
    rule.foreground = *arguments.foreground == "dark" ? Foreground::dark : Foreground::light;
  }
  if (arguments.threshold) {
    rule.threshold =
        parse_real("--threshold", *arguments.threshold, {above_0.least, 1}, "a share of white: a number > 0 and <= 1");
  }
  return rule;
}

}  // namespace

void require_molecule(Format format, const std::string& option, const std::string& found) {
  require_format(has(format, &CloudFormat::is_molecule), option, found,
                 readable(Use::space, [](const CloudFormat& reader) { return reader.is_molecule; }));
}

BallRadii parse_ball_radii(const BallRadiiArguments& arguments) {
  std::optional<double> otherwise;
  if (arguments.radius_default)
    otherwise = parse_real("--radius-default", *arguments.radius_default, {}, "a length, at least 0");
  return BallRadii(arguments.radii, otherwise);
}

bool GroupArguments::has_groups() const {
  if (group_by && group_by_file) throw WrongUsage("--group-by-file cannot be combined with --group-by");
  if (inputs.size() > 1 && !group_by && !group_by_file)
    bad_usage(
        "POINTS", counted(inputs.size(), "file") + ", the last " + in_quotes(inputs.back()),
        "one, or --group-by-file (each is a group), or --group-by COLUMN (-o OUT names a file to write; a list such "
        "as X,Y has no blanks)");
  return group_by || group_by_file;
}

PointSource parse_source(const PointArguments& arguments, const GroupColumns& columns) {
  PointSource source{.path = arguments.points,
                     .pixels = parse_pixel_rule(arguments),
                     .skip_invalid = arguments.skip_invalid,
                     .vertices = arguments.vertices,
                     .shift_longitude = arguments.shift_longitude,
                     .window = parse_window(arguments.bounds, arguments.resolution)};
  if (arguments.columns) source.columns = parse_columns(*arguments.columns, arguments.columns_may_have_z);
  if (arguments.crs) source.crs = parse_crs(*arguments.crs);
  source.layer = arguments.layer;
  source.format = parse_format(Use::points, arguments.points, arguments.format, "POINTS");

  const Format format = source.format;
  const bool ogr = format == Format::ogr;
  if (ogr && source.path == "-") bad_usage("POINTS", "-, standard input, which GDAL cannot read", "a file name");
  const bool of_groups = columns.keys || columns.radius;
  OptionNames options{.columns = arguments.columns ? "--columns" : nullptr,
                      .skip_invalid = arguments.skip_invalid ? "--skip-invalid" : nullptr,
                      .vertices = arguments.vertices ? "--vertices" : nullptr,
                      .fields = arguments.where ? "--where" : nullptr};
  if (of_groups) options.fields = columns.keys ? "--group-by" : "--alpha column";
  require_readable(Use::points, format, options);
  if (of_groups)
    source.where = Condition::of_groups(columns, arguments.where.value_or(""), *fields_of(format));
  else if (arguments.where)
    source.where = Condition(*arguments.where, *fields_of(format));
  if (arguments.layer) require_format(ogr, "--layer", "without layers", "a file that GDAL reads (--format ogr)");
  for (const auto& [given, option] :
       {std::pair(&arguments.foreground, "--foreground"), std::pair(&arguments.threshold, "--threshold")})
    if (*given) require_format(is_image(format), option, "without pixels", "one of " + endings(Use::points, is_image));
  return source;
}

SpacePointSource parse_space_source(const SpacePointArguments& arguments, std::vector<WantedColumn> columns,
                                    const std::string& option) {
  SpacePointSource source{.path = arguments.points,
                          .format = parse_format(Use::space, arguments.points, arguments.format, "POINTS")};
  if (arguments.columns) source.choice.columns = parse_space_columns(*arguments.columns);
  source.choice.skip_invalid = arguments.skip_invalid;
  source.choice.needs_normals = false;
  source.choice.window = parse_window(arguments.bounds, arguments.resolution);
  source.choice.waters = arguments.waters ? Waters::counted : Waters::left_out;
  if (arguments.waters) require_molecule(source.format, "--waters", "without atoms");
  const std::optional<FieldNames> names = fields_of(source.format);
  if (!names || !names->texts) std::erase_if(columns, [](const WantedColumn& column) { return column.if_there; });
  const bool any = arguments.where || !columns.empty();
  require_readable(Use::space, source.format,
                   {.columns = arguments.columns ? "--columns" : nullptr,
                    .skip_invalid = arguments.skip_invalid ? "--skip-invalid" : nullptr,
                    .fields = !any              ? nullptr
                              : arguments.where ? "--where"
                                                : option.c_str()});
  if (!any) return source;
  if (arguments.where && arguments.where->empty())
    source.choice.where = Condition("", *names);  // refuses the empty condition
  source.choice.where = Condition(arguments.where.value_or(""), *names, columns, option);
  return source;
}

UnitCell parse_box(const std::string& text, Format format) {
  if (text == "auto") {
    require_molecule(format, "--box auto", "without a cell");
    return {};
  }
  std::vector<double> numbers;
  for (const std::string_view part : split_at_commas(text)) {
    const ParsedNumber number = parse_whole_number(part);
    numbers.push_back(number.fault == NumberFault::none ? number.value : 0);
  }
  if (numbers.size() == 1) numbers.resize(3, numbers.front());
  if (numbers.size() == 3) numbers.resize(6, 90);
  std::array<double, 6> lengths_and_angles{};
  if (numbers.size() == 6) std::copy(numbers.begin(), numbers.end(), lengths_and_angles.begin());
  UnitCell cell = unit_cell("a cell", lengths_and_angles);
  if (!cell.edges)
    bad_usage("--box", in_quotes(text),
              "the sides of the box, Lx,Ly,Lz, one length for all, or the lengths and angles of a cell, "
              "a,b,c,alpha,beta,gamma; or auto, the cell of the file");
  return cell;
}

std::vector<WantedColumn> columns_of_names() {
  std::vector<WantedColumn> columns;
  for (std::size_t k = 0; k < names_of_atom; ++k)
    columns.push_back({.name = std::string(atom_columns[k]), .kind = WantedColumn::Kind::text, .if_there = true});
  return columns;
}

}  // namespace rbpa::app
