#include "io/cloud/table_layout.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <iterator>
#include <string_view>

#include "io/failure.h"
#include "io/formats.h"
#include "io/text/fields.h"

namespace rbpa::app {
namespace {

using FieldTexts = std::vector<std::string_view>;

std::string found_columns(const FieldTexts& fields, const TableLines& lines) {
  return counted(fields.size(), "column") + " (" + in_quotes(lines.line()) + ")";
}

bool is_text_only(const FieldTexts& fields) { return std::none_of(fields.begin(), fields.end(), is_number); }

std::vector<std::size_t> chosen(const std::vector<Column>& columns, const FieldTexts& fields, const TableLines& lines) {
  std::vector<std::size_t> places;
  for (const Column& column : columns)
    places.push_back(column.number > 0 ? column.number - 1
                                       : find_column(fields, column.name, lines.lines(), lines.name()));
  return places;
}

/// Where one of them is a number, or says that there is none, the line is data.
bool is_header(const FieldTexts& fields, const std::vector<std::size_t>& places) {
  std::size_t missing = 0;
  for (const std::size_t i : places) {
    if (i >= fields.size() || is_number(fields[i])) return false;
    if (is_missing(fields[i])) ++missing;
  }
  return missing < places.size();
}

/// A column that is called so may have something else in it, such as the bytes of a geometry, or nothing.
bool next_line_has_geometry(const TableLines& lines) {
  const std::string_view rest = lines.rest();
  const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size()));
  constexpr std::string_view kinds[] = {"POINT", "LINESTRING", "POLYGON", "GEOMETRYCOLLECTION"};
  const auto same = [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; };
  return line.find('(') != std::string_view::npos &&
         std::any_of(std::begin(kinds), std::end(kinds), [&](std::string_view kind) {
           return std::search(line.begin(), line.end(), kind.begin(), kind.end(), same) != line.end();
         });
}

/// Whether the line is a header with names that say where the points of the plane are.
bool find_by_header(const FieldTexts& fields, const TableLines& lines, TableLayout& layout,
                    std::vector<std::string>& remarks) {
  const std::optional<std::size_t> geometries = find_wkt(fields);
  const std::optional<NamedColumns> found = find_coordinates(fields);
  if (found && geometries && next_line_has_geometry(lines)) {
    remarks.push_back("the geometries of column " + in_quotes(fields[*geometries]) + " are read, and not " +
                      in_quotes(fields[found->x]) + " and " + in_quotes(fields[found->y]) +
                      " (--columns chooses these)");
    layout.wkt = geometries;
    return true;
  }
  if (!found) {
    layout.wkt = geometries;
    return layout.wkt.has_value();
  }
  layout.numbers = {found->x, found->y};
  layout.degrees = found->degrees;
  if (found->x != 0 || found->y != 1)
    remarks.push_back("x is column " + std::to_string(found->x + 1) + ", " + in_quotes(fields[found->x]) +
                      ", and y is column " + std::to_string(found->y + 1) + ", " + in_quotes(fields[found->y]) +
                      ", as the header says (--columns chooses others)");
  return true;
}

void find_height_column(const FieldTexts& fields, TableLayout& layout) {
  if (layout.wkt) return;
  layout.height = find_height(fields);
  if (std::find(layout.numbers.begin(), layout.numbers.end(), layout.height) != layout.numbers.end())
    layout.height.reset();
}

/// What a table of a kind has in so many columns, by names; nothing where it has none of that width.
FieldTexts names_of_kind(TableKind kind, std::size_t width) {
  if (kind == TableKind::atoms) return {atom_columns.begin(), atom_columns.end()};
  FieldTexts names;
  const auto append = [&](bool has, std::initializer_list<std::string_view> more) {
    for (const std::string_view name : more)
      if (has) names.push_back(name);
  };
  append(true, {"x", "y", "z"});
  append(kind == TableKind::xyzn, {"nx", "ny", "nz"});
  append(kind == TableKind::pts && (width == 4 || width == 7), {"intensity"});
  append(kind == TableKind::xyzrgb || (kind == TableKind::pts && width >= 6), {"red", "green", "blue"});
  return names.size() == width ? names : FieldTexts();
}

/// The first line is of numbers, and its columns have these names.
void lay_out_by_names(const FieldTexts& names, bool in_space, TableLayout& layout) {
  layout.names = names;
  if (in_space) {
    layout.numbers = find_space_columns(names);
    layout.colors = find_color_columns(names);
    return;
  }
  layout.numbers = {0, 1};
  layout.height = 2;
}

/// Whether the table is of a kind, and its columns those of that.
bool find_by_kind(const FieldTexts& fields, const TableLines& lines, TableKind kind, bool in_space,
                  TableLayout& layout) {
  if (kind == TableKind::any) return false;
  const FieldTexts names = names_of_kind(kind, fields.size());
  if (names.empty())
    bad_input(at_line(lines.name(), lines.number()), found_columns(fields, lines),
              kind == TableKind::xyzn     ? "6: x, y, z, nx, ny, nz"
              : kind == TableKind::xyzrgb ? "6: x, y, z, red, green, blue"
                                          : "3, 4, 6 or 7: x, y, z, intensity, red, green, blue");
  lay_out_by_names(names, in_space, layout);
  return true;
}

TableLayout lay_out_plane(const FieldTexts& fields, const TableLines& lines, TableKind kind,
                          const CloudRequest& request, std::vector<std::string>& remarks) {
  TableLayout layout{.width = fields.size(), .numbers = {0, 1}};
  if (request.columns) {
    layout.numbers = chosen(*request.columns, fields, lines);
  } else if (find_by_header(fields, lines, layout, remarks)) {
    layout.header = true;
    find_height_column(fields, layout);
    return layout;
  } else if (!is_text_only(fields) && find_by_kind(fields, lines, kind, false, layout)) {
    return layout;
  }
  const std::size_t x = layout.numbers[0], y = layout.numbers[1], needed = std::max(x, y) + 1;
  if (fields.size() < needed)
    bad_input(at_line(lines.name(), lines.number()),
              is_text_only(fields) ? in_quotes(lines.line()) : counted(fields.size(), "column"),
              needed == 2 ? (is_text_only(fields) ? "two numbers" : "two columns")
                          : "at least " + counted(needed, "column") + ", as --columns asks");
  if (x == y) refuse_one_column(fields[x]);  // under two names, or by name and by number
  layout.header = is_by_name(request.columns) || is_header(fields, layout.numbers);
  if (!layout.header) {
    // Only the ending .xyz makes a third number a height; elsewhere it may be anything, unless heights are asked for.
    const bool has_number = is_number(fields[x]) || is_number(fields[y]);
    const bool is_xyz = input_ending(lines.name()) == "xyz",
               may_be_z = request.heights && fields.size() == 3 && is_number(fields.back());
    if (has_number && !request.columns && fields.size() > 2 && (is_xyz || may_be_z)) layout.height = 2;
    if (layout.height && !is_xyz) remarks.emplace_back("column 3 is read as z (--columns 1,2 leaves it out)");
    return layout;
  }
  layout.degrees = is_longitude(fields[x]) && is_latitude(fields[y]);
  if (is_latitude(fields[x]) && is_longitude(fields[y]))
    remarks.push_back("x is the latitude " + in_quotes(fields[x]) + " and y the longitude " + in_quotes(fields[y]) +
                      ", as --columns asks");
  find_height_column(fields, layout);
  return layout;
}

void choose_in_space(const FieldTexts& fields, const TableLines& lines, const std::vector<Column>& columns,
                     TableLayout& layout) {
  layout.numbers = chosen(columns, fields, lines);
  const std::size_t needed = *std::max_element(layout.numbers.begin(), layout.numbers.end()) + 1;
  if (fields.size() < needed)
    bad_input(at_line(lines.name(), lines.number()), found_columns(fields, lines),
              "at least " + counted(needed, "column") + ", as --columns asks");
  for (std::size_t i = 0; i < layout.numbers.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (layout.numbers[i] == layout.numbers[k])
        refuse_repeated_column(fields[layout.numbers[i]]);  // under two names, or by name and by number
}

/// Where names are not known, the number of columns decides what they are.
void find_by_space_header(const FieldTexts& fields, const TableLines& lines, TableLayout& layout,
                          std::vector<std::string>& remarks) {
  layout.numbers = find_space_columns(fields);
  if (layout.numbers.empty() && fields.size() == 3) layout.numbers = {0, 1, 2};
  if (layout.numbers.empty())
    bad_input(at_line(lines.name(), lines.number()), in_quotes(lines.line()),
              "a header with columns x, y and z (--columns X,Y,Z chooses others)");
  std::string names;
  bool in_order = true;
  for (std::size_t i = 0; i < layout.numbers.size(); ++i) {
    in_order = in_order && layout.numbers[i] == i;
    names += (names.empty() ? "" : ", ") + in_quotes(fields[layout.numbers[i]]);
  }
  if (!in_order) remarks.push_back("the columns " + names + " are read, as the header says (--columns chooses others)");
}

/// Whether the comment before the first line, which is of numbers, names the columns.
bool find_by_comment(const FieldTexts& fields, const TableLines& lines, TableLayout& layout,
                     std::vector<std::string>& remarks) {
  const std::string_view comment = lines.comment_before();
  const FieldTexts names = split(comment, separator_of(comment));
  if (names.size() != fields.size() || find_space_columns(names).empty()) return false;
  lay_out_by_names(names, true, layout);
  layout.degrees = is_longitude(names[layout.numbers[0]]) && is_latitude(names[layout.numbers[1]]);
  remarks.push_back("the comment " + in_quotes(comment) + " names the columns (--columns chooses others)");
  return true;
}

[[noreturn]] void refuse_width(const FieldTexts& fields, const TableLines& lines) {
  if (is_text_only(fields)) bad_input(at_line(lines.name(), lines.number()), in_quotes(lines.line()), "3 or 6 numbers");
  bad_input(at_line(lines.name(), lines.number()), found_columns(fields, lines),
            fields.size() > 3 ? "3 or 6 (--columns X,Y,Z chooses some of more)" : "3 or 6");
}

TableLayout lay_out_space(const FieldTexts& fields, const TableLines& lines, TableKind kind,
                          const CloudRequest& request, std::vector<std::string>& remarks) {
  TableLayout layout{.width = fields.size()};
  if (request.columns) {
    choose_in_space(fields, lines, *request.columns, layout);
  } else if (is_header(fields, {0, 1, 2})) {
    find_by_space_header(fields, lines, layout, remarks);
  } else if (find_by_kind(fields, lines, kind, true, layout) || find_by_comment(fields, lines, layout, remarks)) {
    return layout;
  } else {
    if (fields.size() != 3 && fields.size() != 6) refuse_width(fields, lines);
    for (std::size_t i = 0; i < fields.size(); ++i) layout.numbers.push_back(i);
    layout.unnamed = fields.size() == 6;
  }
  layout.header = is_by_name(request.columns) || is_header(fields, layout.numbers);
  if (!layout.header) return layout;
  layout.degrees = is_longitude(fields[layout.numbers[0]]) && is_latitude(fields[layout.numbers[1]]);
  layout.colors = find_color_columns(fields);
  const auto is_taken = [&](std::size_t color) {  // meant to be something else
    return std::find(layout.numbers.begin(), layout.numbers.end(), color) != layout.numbers.end();
  };
  if (std::any_of(layout.colors.begin(), layout.colors.end(), is_taken)) layout.colors.clear();
  return layout;
}

}  // namespace

bool is_by_name(const std::optional<std::vector<Column>>& columns) {
  return columns && std::any_of(columns->begin(), columns->end(), [](const Column& c) { return c.number == 0; });
}

TableLayout lay_out_table(const TableLines& lines, TableKind kind, const CloudRequest& request,
                          std::vector<std::string>& remarks) {
  const FieldTexts fields = split(lines.line(), separator_of(lines.line()));
  return request.in_space ? lay_out_space(fields, lines, kind, request, remarks)
                          : lay_out_plane(fields, lines, kind, request, remarks);
}

}  // namespace rbpa::app
