#include "io/cloud/table_layout.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "io/cloud/table_doubts.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/text/fields.h"
#include "io/text/line_selection.h"
#include "io/text/odd_fields.h"

namespace rbpa::app {
namespace {

using FieldTexts = std::vector<std::string_view>;

/// Columns that a table of a kind has without a header.
struct KindRow {
  TableKind kind;
  std::array<std::string_view, 7> columns;  ///< if there are fewer, the others are empty

  constexpr std::ptrdiff_t width() const { return std::find(columns.begin(), columns.end(), "") - columns.begin(); }
};

/// The columns of all kinds but `any`; those of a kind from the fewest to the most.
constexpr KindRow kind_rows[] = {{TableKind::pts, {"x", "y", "z"}},
                                 {TableKind::pts, {"x", "y", "z", "intensity"}},
                                 {TableKind::pts, {"x", "y", "z", "red", "green", "blue"}},
                                 {TableKind::pts, {"x", "y", "z", "intensity", "red", "green", "blue"}},
                                 {TableKind::xyzn, {"x", "y", "z", "nx", "ny", "nz"}},
                                 {TableKind::xyzrgb, {"x", "y", "z", "red", "green", "blue"}}};

std::string found_fields(const TableBeginning& table) { return found_columns(table.fields.size(), table.lines.line()); }
std::string here(const TableBeginning& table) { return at_line(table.lines.name(), table.lines.number()); }

bool is_text_only(const FieldTexts& fields) { return std::none_of(fields.begin(), fields.end(), is_number); }

std::vector<std::size_t> chosen(const std::vector<Column>& columns, const FieldTexts& fields,
                                const TableBeginning& table) {
  std::vector<std::size_t> places;
  for (const Column& column : columns)
    places.push_back(column.number > 0 ? column.number - 1
                                       : find_column(fields, column.name, table.lines.lines(), table.lines.name()));
  return places;
}

/// Returns whether the fields at `places` are names: none looks like a number, and not all stand for missing values.
bool is_header(const FieldTexts& fields, const std::vector<std::size_t>& places) {
  std::size_t missing = 0;
  for (const std::size_t i : places) {
    if (i >= fields.size() || is_nearly_number(fields[i])) return false;
    if (is_missing(fields[i])) ++missing;
  }
  return missing < places.size();
}

/// Returns whether a line without known names is a header: all its fields are texts, and none is a geometry.
bool is_unknown_header(const FieldTexts& fields, const std::vector<std::size_t>& places) {
  return is_header(fields, places) && is_text_only(fields) && std::none_of(fields.begin(), fields.end(), is_geometry);
}

/// Returns whether a line with known names is a header. Fields may be whole numbers, such as years; any other number
/// shows that the line is data.
bool may_be_known_header(const FieldTexts& fields) {
  const auto numbers = std::count_if(fields.begin(), fields.end(), is_number);
  const auto whole = std::count_if(fields.begin(), fields.end(), [](std::string_view f) { return !!parse_count(f); });
  return numbers < 2 || (numbers == whole && !is_number(fields.front()));
}

/// Returns whether the first line is data, and the comment before it has a name for each column, x, y and, `in_space`,
/// z among them.
bool has_names(const TableBeginning& table, bool in_space) {
  return table.names.size() == table.fields.size() && !is_text_only(table.fields) &&
         (in_space ? !find_space_columns(table.names).empty() : find_coordinates(table.names).has_value());
}

/// Returns whether the line is a header with known names for x and y, or for geometries; if so, sets `layout`.
bool find_by_header(const FieldTexts& fields, const TableBeginning& table, TableLayout& layout,
                    std::vector<std::string>& warnings) {
  if (!may_be_known_header(fields)) return false;
  const std::optional<std::size_t> geometries = find_wkt(fields);
  const std::optional<NamedColumns> found = find_coordinates(fields);
  if (found && geometries && table.choice.geometry == geometries) {
    warnings.push_back("the geometries of column " + in_quotes(fields[*geometries]) + " are read, and not " +
                       in_quotes(fields[found->x]) + " and " + in_quotes(fields[found->y]) +
                       " (--columns chooses these)");
    layout.wkt = geometries;
    return true;
  }
  if (!found) {
    layout.wkt = geometries;
    if (geometries && table.says_columns)
      warnings.push_back("the geometries of column " + in_quotes(fields[*geometries]) + " are read");
    return layout.wkt.has_value();
  }
  layout.numbers = {found->x, found->y};
  layout.degrees = found->degrees;
  const std::string others = other_columns(fields, found->x, found->y, false);
  if (found->x != 0 || found->y != 1 || table.says_columns || others.starts_with(','))
    warnings.push_back("x is column " + std::to_string(found->x + 1) + ", " + in_quotes(fields[found->x]) +
                       ", and y is column " + std::to_string(found->y + 1) + ", " + in_quotes(fields[found->y]) +
                       ", as the header says" + others);
  return true;
}

/// Sets the column of heights by its name, unless the column is requested.
void find_height_column(const FieldTexts& fields, TableLayout& layout) {
  if (layout.wkt || layout.height) return;
  layout.height = find_height(fields);
  if (std::find(layout.numbers.begin(), layout.numbers.end(), layout.height) != layout.numbers.end())
    layout.height.reset();
}

/// Returns the names of the columns of a table of a kind other than any. Throws BadInput unless the kind may have as
/// many columns as the table.
FieldTexts names_of_kind(TableKind kind, const TableBeginning& table) {
  std::vector<std::string> widths, longest;
  for (const KindRow& row : kind_rows) {
    if (row.kind != kind) continue;
    const FieldTexts names(row.columns.begin(), row.columns.begin() + row.width());
    if (names.size() == table.fields.size()) return names;
    widths.push_back(std::to_string(names.size()));
    longest.assign(names.begin(), names.end());
  }
  bad_input(here(table), found_fields(table), listed(widths, " or ") + ": " + listed(longest, ", "));
}

/// Returns whether the table has the columns of its kind; if so, sets `layout`.
bool find_by_kind(const TableBeginning& table, TableKind kind, bool in_space, TableLayout& layout) {
  if (kind != TableKind::any) lay_out_by_names(names_of_kind(kind, table), in_space, layout);
  return kind != TableKind::any;
}

/// Returns whether there is a column of geometries, under any name; if so, sets `layout`. For tables without known
/// names.
bool find_by_content(const TableBeginning& table, TableLayout& layout, std::vector<std::string>& warnings) {
  layout.wkt = table.choice.geometry;
  if (!layout.wkt) return false;
  layout.header = *layout.wkt < table.fields.size() && !is_geometry(table.fields[*layout.wkt]);
  warnings.push_back("the geometries of column " + std::to_string(*layout.wkt + 1) +
                     (layout.header ? ", " + in_quotes(table.fields[*layout.wkt]) + "," : "") + " are read");
  return true;
}

/// Returns whether the comment before the first line of numbers names the columns; if so, sets `layout`.
bool find_by_comment(const TableBeginning& table, bool in_space, TableLayout& layout,
                     std::vector<std::string>& warnings) {
  if (!has_names(table, in_space)) return false;
  const FieldTexts& names = table.names;
  lay_out_by_names(names, in_space, layout);
  layout.degrees = is_longitude(names[layout.numbers[0]]) && is_latitude(names[layout.numbers[1]]);
  warnings.push_back("the comment " + in_quotes(table.comment) + " names the columns (--columns chooses others)");
  return true;
}

/// Throws BadInput that advises to choose `columns` if the first of four columns in .xyz may be numbers of elements.
void refuse_atoms(const TableBeginning& table, const std::string& columns) {
  if (input_ending(table.lines.name()) == "xyz" && table.fields.size() == 4 && table.choice.begin_with_atoms)
    bad_input(here(table), found_fields(table) + ", the first of which may be the number of an element",
              "x y z, or before atoms their number and a comment (--columns " + columns + " reads atoms)");
}

/// If lines of text are left out above the data, adds the warning that there is no header, so that the first columns
/// are read.
void warn_of_no_header(const TableBeginning& table, const std::string& columns, std::vector<std::string>& warnings) {
  if (table.says_columns) warnings.push_back("no header was found; " + columns + " (--columns chooses others)");
}

/// Returns whether a first line without known names is a header by the line after it: the columns at `places`, or, if
/// `places` is empty, at least two columns are names above numbers. Other fields may be whole numbers, such as years.
bool is_above_numbers(const FieldTexts& fields, const TableSample& sample, std::vector<std::size_t> places) {
  if (sample.lines() < 2) return false;
  const auto is_above = [&](std::size_t i) { return is_header(fields, {i}) && is_number(sample.field(1, i)); };
  if (places.empty())
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (is_above(i)) places.push_back(i);
  const auto may_be_name = [](std::string_view f) { return !is_nearly_number(f) || parse_count(f); };
  return places.size() > 1 && std::all_of(places.begin(), places.end(), is_above) &&
         std::all_of(fields.begin(), fields.end(), may_be_name) &&
         std::none_of(fields.begin(), fields.end(), is_geometry);
}

/// Returns whether the first line numbers the columns from 0 after an empty name, as pandas writes it.
bool is_numbering(const FieldTexts& fields) {
  for (std::size_t i = 1; i < fields.size(); ++i)
    if (fields[i] != std::to_string(i - 1)) return false;
  return fields.size() > 2 && fields.front().empty();
}

/// Takes the columns after the first in a table whose first line numbers them.
void lay_out_by_numbering(bool in_space, TableLayout& layout, std::vector<std::string>& warnings) {
  layout.numbers = in_space ? std::vector<std::size_t>{1, 2, 3} : std::vector<std::size_t>{1, 2};
  layout.header = true;
  warnings.push_back(std::string("the first line numbers the columns; x is column 2, y is column 3") +
                     (in_space ? ", z is column 4" : "") + " (--columns chooses others)");
}

TableLayout lay_out_plane(const TableBeginning& table, TableKind kind, const CloudRequest& request,
                          std::vector<std::string>& warnings) {
  const FieldTexts& fields = table.fields;
  TableLayout layout{.width = table.width, .numbers = {0, 1}};
  const bool by_name = is_by_name(request.columns), has_comment = has_names(table, false);
  const TableSample sample(table);
  if (has_comment) layout.names = table.names;
  if (request.columns) {
    layout.numbers = chosen(*request.columns, has_comment ? table.names : fields, table);
    layout.header = is_numbering(fields);
    if (layout.numbers.size() == 1) {
      layout.wkt = std::exchange(layout.numbers, {0, 1}).front();
      layout.header = by_name ? !has_comment : is_unknown_header(fields, {*layout.wkt});
      return layout;
    }
    if (layout.numbers.size() == 3) {
      layout.height = layout.numbers.back();
      layout.numbers.pop_back();
    }
  } else if (find_by_header(fields, table, layout, warnings)) {
    layout.header = true;
    find_height_column(fields, layout);
    return layout;
  } else if (find_by_content(table, layout, warnings)) {
    return layout;
  } else if (is_numbering(fields)) {
    lay_out_by_numbering(false, layout, warnings);
    return layout;
  } else if (!is_text_only(fields) &&
             (find_by_comment(table, false, layout, warnings) || find_by_kind(table, kind, false, layout))) {
    return layout;
  }
  const std::size_t x = layout.numbers[0], y = layout.numbers[1],
                    needed = std::max({x, y, layout.height.value_or(0)}) + 1;
  if (fields.size() < needed)
    bad_input(here(table), is_text_only(fields) ? in_quotes(table.lines.line()) : counted(fields.size(), "column"),
              needed == 2 ? (is_text_only(fields) ? "two numbers" : "two columns") +
                                way_of_fields(table.lines.line(), table.choice.separator, false)
                          : "at least " + counted(needed, "column") + ", as --columns requires");
  if (x == y) refuse_repeated_column(fields[x], "two columns");  // under two names, or by name and by number
  if (layout.height == x || layout.height == y) refuse_repeated_column(fields[*layout.height]);
  const bool is_known = find_coordinates(fields).has_value() && may_be_known_header(fields);
  const auto places = request.columns ? layout.numbers : std::vector<std::size_t>();
  if (layout.header) return layout;
  layout.header = by_name    ? !has_comment
                  : is_known ? is_header(fields, layout.numbers)
                             : is_unknown_header(fields, layout.numbers) || is_above_numbers(fields, sample, places);
  if (!layout.header) {
    if (!request.columns) {
      refuse_atoms(table, "2,3");
      warn_of_no_header(table, "x is column 1, and y is column 2", warnings);
    }
    // Take a third number as height in .xyz, or if heights are requested; otherwise a third number may be anything.
    const bool has_number = is_number(fields[x]) || is_number(fields[y]);
    const bool is_xyz = input_ending(table.lines.name()) == "xyz",
               may_be_z = request.heights && fields.size() == 3 && is_number(fields.back());
    if (has_number && !request.columns && fields.size() > 2 && (is_xyz || may_be_z)) layout.height = 2;
    if (has_number && !request.columns && !is_xyz) doubt_first_columns(table, sample, warnings);
    if (layout.height && !is_xyz) warnings.emplace_back("column 3 is read as z (--columns 1,2 leaves it out)");
    return layout;
  }
  if (!request.columns) refuse_unknown_names(table, sample);
  layout.degrees = is_longitude(fields[x]) && is_latitude(fields[y]);
  if (is_latitude(fields[x]) && is_longitude(fields[y]))
    warnings.push_back("x is the latitude " + in_quotes(fields[x]) + " and y the longitude " + in_quotes(fields[y]) +
                       ", as --columns requires");
  if (!request.columns) warn_of_unknown_names(table, 2, warnings);
  find_height_column(fields, layout);
  return layout;
}

void choose_in_space(const TableBeginning& table, const std::vector<Column>& columns, TableLayout& layout) {
  layout.numbers = chosen(columns, layout.names.empty() ? table.fields : layout.names, table);
  const std::size_t needed = *std::max_element(layout.numbers.begin(), layout.numbers.end()) + 1;
  if (table.fields.size() < needed)
    bad_input(here(table), found_fields(table), "at least " + counted(needed, "column") + ", as --columns requires");
  for (std::size_t i = 0; i < layout.numbers.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (layout.numbers[i] == layout.numbers[k])
        refuse_repeated_column(table.fields[layout.numbers[i]]);  // under two names, or by name and by number
}

/// Sets the columns of points in space by the names of the header, or, if the header has three unknown names, in their
/// order.
void find_by_space_header(const TableBeginning& table, TableLayout& layout, std::vector<std::string>& warnings) {
  const FieldTexts& fields = table.fields;
  layout.numbers = find_space_columns(fields);
  if (layout.numbers.empty() && fields.size() == 3) {
    layout.numbers = {0, 1, 2};
    warn_of_unknown_names(table, 3, warnings);
  }
  if (layout.numbers.empty())
    bad_input(here(table), in_quotes(table.lines.line()),
              "a header with columns x, y and z (--columns X,Y,Z chooses others)");
  std::string names;
  bool in_order = true;
  for (std::size_t i = 0; i < layout.numbers.size(); ++i) {
    in_order = in_order && layout.numbers[i] == i;
    names += (names.empty() ? "" : ", ") + in_quotes(fields[layout.numbers[i]]);
  }
  const std::string others = other_columns(fields, layout.numbers[0], layout.numbers[1], true);
  if (!in_order || table.says_columns || others.starts_with(','))
    warnings.push_back("the columns " + names + " are read, as the header says" + others);
}

[[noreturn]] void refuse_width(const TableBeginning& table) {
  if (is_text_only(table.fields))
    bad_input(here(table), in_quotes(table.lines.line()),
              "3 or 6 numbers" + way_of_fields(table.lines.line(), table.choice.separator, false));
  refuse_atoms(table, "2,3,4");
  bad_input(here(table), found_fields(table),
            table.fields.size() > 3 ? "3 or 6 (--columns X,Y,Z chooses some of more)" : "3 or 6");
}

TableLayout lay_out_space(const TableBeginning& table, TableKind kind, const CloudRequest& request,
                          std::vector<std::string>& warnings) {
  const FieldTexts& fields = table.fields;
  TableLayout layout{.width = table.width};
  const bool by_name = is_by_name(request.columns), has_comment = has_names(table, true);
  const bool is_known = !find_space_columns(fields).empty() && may_be_known_header(fields);
  if (has_comment) layout.names = table.names;
  if (request.columns) {
    choose_in_space(table, *request.columns, layout);
    layout.header = is_numbering(fields);
  } else if (is_numbering(fields) && fields.size() > 3) {
    lay_out_by_numbering(true, layout, warnings);
  } else if (is_known || is_unknown_header(fields, {0, 1, 2})) {
    find_by_space_header(table, layout, warnings);
  } else if (find_by_comment(table, true, layout, warnings) || find_by_kind(table, kind, true, layout)) {
    return layout;
  } else {
    if (fields.size() != 3 && fields.size() != 6) refuse_width(table);
    for (std::size_t i = 0; i < fields.size(); ++i) layout.numbers.push_back(i);
    layout.unnamed = fields.size() == 6;
    if (layout.unnamed) refuse_decimal_commas(table, TableSample(table));
    warn_of_no_header(table, "x, y and z are columns 1 to 3", warnings);
  }
  if (layout.header) return layout;
  layout.header = by_name    ? !has_comment
                  : is_known ? is_header(fields, layout.numbers)
                             : is_unknown_header(fields, layout.numbers);
  if (!layout.header) return layout;
  layout.degrees = is_longitude(fields[layout.numbers[0]]) && is_latitude(fields[layout.numbers[1]]);
  layout.colors = find_color_columns(fields);
  const auto is_taken = [&](std::size_t color) {  // the column has another role
    return std::find(layout.numbers.begin(), layout.numbers.end(), color) != layout.numbers.end();
  };
  if (std::any_of(layout.colors.begin(), layout.colors.end(), is_taken)) layout.colors.clear();
  return layout;
}

void refuse_long_names(const TableBeginning& table) {
  for (const std::string_view name : table.fields)
    if (name.size() > longest_word)
      bad_input(here(table), "a column name of " + counted(name.size(), "character"),
                "names of at most " + counted(longest_word, "character"));
}

}  // namespace

void lay_out_by_names(const std::vector<std::string_view>& names, bool in_space, TableLayout& layout) {
  layout.names = names;
  const std::optional<NamedColumns> plane = find_coordinates(names);
  layout.numbers = in_space ? find_space_columns(names) : std::vector<std::size_t>{plane->x, plane->y};
  if (in_space) layout.colors = find_color_columns(names);
  if (!in_space) find_height_column(names, layout);
}

std::string found_columns(std::size_t count, std::string_view line) {
  return counted(count, "column") + " (" + in_quotes(line) + ")";
}

bool is_by_name(const std::optional<std::vector<Column>>& columns) {
  return columns && std::any_of(columns->begin(), columns->end(), [](const Column& c) { return c.number == 0; });
}

HeaderKind header_kind(const FieldTexts& fields, const CloudRequest& request) {
  const auto is_there = [&](const Column& column) { return column.number > 0 || has_column(fields, column.name); };
  const bool is_known = is_by_name(request.columns)
                            ? std::all_of(request.columns->begin(), request.columns->end(), is_there)
                        : request.in_space ? !find_space_columns(fields).empty()
                                           : find_coordinates(fields) || find_wkt(fields);
  if (is_known && may_be_known_header(fields)) return HeaderKind::known_names;
  const auto names = std::count_if(fields.begin(), fields.end(), [](std::string_view f) { return !is_missing(f); });
  const std::size_t least = std::min<std::size_t>(fields.size(), request.in_space ? 3 : 2);
  const bool is_unknown = static_cast<std::size_t>(names) >= least && is_unknown_header(fields, {0});
  return is_unknown ? HeaderKind::unknown_names : HeaderKind::none;
}

TableLayout lay_out_table(const TableBeginning& table, TableKind kind, const CloudRequest& request,
                          std::vector<std::string>& warnings) {
  const TableLayout layout =
      request.in_space ? lay_out_space(table, kind, request, warnings) : lay_out_plane(table, kind, request, warnings);
  if (layout.header) refuse_long_names(table);
  if (layout.wkt) return layout;
  const TableSample sample(table);
  doubt_coordinates(table, layout, request, sample, warnings);
  if (request.heights && !layout.height) warn_of_no_height(table, layout, request, sample, warnings);
  return layout;
}

std::size_t least_columns(TableKind kind) {
  const auto row =
      std::find_if(std::begin(kind_rows), std::end(kind_rows), [&](const KindRow& r) { return r.kind == kind; });
  return row == std::end(kind_rows) ? 2 : static_cast<std::size_t>(row->width());
}

/// Reads a table whose columns, if no header names them, are x, y, z and then an intensity, a color or both. The first
/// line of such a table may be the number of points; exactly so many points must follow, unless invalid lines are
/// skipped.
const CloudFormat pts_reader = reader_of_kind<TableKind::pts>;

/// Reads a table whose columns, if no header names them, are x, y, z, nx, ny, nz.
const CloudFormat xyzn_reader = reader_of_kind<TableKind::xyzn>;

/// Reads a table whose columns, if no header names them, are x, y, z, red, green, blue: from 0 to 1; or to 255 if a
/// channel in the file is greater than 1; or to 65535 if one is greater than 255.
const CloudFormat xyzrgb_reader = reader_of_kind<TableKind::xyzrgb>;

}  // namespace rbpa::app
