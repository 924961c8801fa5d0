#include "io/cloud/table_doubts.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <set>

#include "io/failure.h"
#include "io/text/columns.h"
#include "io/text/fields.h"
#include "io/text/line_selection.h"

namespace rbpa::app {

TableSample::TableSample(const TableBeginning& table) {
  const char* const begin = table.lines.line().data();
  const std::string_view rest = table.lines.rest();
  std::string_view text(begin, static_cast<std::size_t>(rest.data() + rest.size() - begin));
  if (text.size() > separator_sample) text = text.substr(0, text.rfind('\n', separator_sample) + 1);
  TableLines lines(Content(text, table.lines.name()));
  lines.set_layout(table.choice.separator, table.choice.fields.to_last_text);
  while (lines.next()) {
    rows_.emplace_back();
    for (Fields fields(lines.line(), table.choice.separator); !fields.at_end();)
      rows_.back().push_back(without_quotes(fields.take()));
  }
}

bool TableSample::all(std::size_t column, Test test, std::size_t first) const {
  for (std::size_t i = first; i < lines(); ++i)
    if (!test(field(i, column))) return false;
  return first < lines();
}

bool TableSample::any(std::size_t column, Test test, std::size_t first) const {
  for (std::size_t i = first; i < lines(); ++i)
    if (test(field(i, column))) return true;
  return false;
}

namespace {

bool is_number_or_missing(std::string_view field) { return is_number(field) || is_missing(field); }
bool is_whole(std::string_view field) {
  if (field.starts_with('-')) field.remove_prefix(1);
  return parse_count(field).has_value();
}
bool is_decimal(std::string_view field) { return is_number(field) && !is_whole(field); }
bool is_positive(std::string_view field) {
  return is_number(field) && !field.starts_with('-') && field.find_first_of("123456789") != std::string_view::npos;
}
bool is_digits(std::string_view field) { return parse_count(field).has_value(); }
bool has_leading_zero(std::string_view field) { return field.size() > 1 && field.front() == '0'; }
bool is_latitude_letter(std::string_view field) { return is_word_of(field, "N S"); }
bool is_longitude_letter(std::string_view field) { return is_word_of(field, "E W"); }
bool is_zone(std::string_view field) {  // of UTM, such as 32 or 32U, or the number of a system
  const std::size_t digits = std::min(field.find_first_not_of("0123456789"), field.size());
  const std::size_t letters = field.size() - digits, number = parse_count(field.substr(0, digits)).value_or(0);
  return letters < 2 && number > 0 && (number <= 60 || (letters == 0 && number >= 1000));
}

/// Returns the number in a field, with a decimal point or comma; nothing for any other text.
std::optional<double> value_of(std::string_view field) {
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  const ParsedNumber number = parse_written_number(text);
  return number.fault == NumberFault::none ? std::optional(number.value) : std::nullopt;
}

/// Returns whether the field may be a whole number with one sign between thousands: "1.011".
bool may_have_thousands(std::string_view field) {
  if (field.starts_with('-')) field.remove_prefix(1);
  const std::size_t sign = field.find_first_of(".,");
  return sign != std::string_view::npos && sign <= 3 && field.size() == sign + 4 && field.front() != '0' &&
         is_whole(field.substr(0, sign)) && parse_count(field.substr(sign + 1));
}

std::string column_text(std::size_t column) { return "column " + std::to_string(column + 1); }

[[noreturn]] void refuse(const TableBeginning& table, const std::string& found, const std::string& expected) {
  throw WholeRefusal(at_line(table.lines.name(), table.lines.number()) + ": found " + found + ", expected " + expected);
}

/// Returns the sign that column 0 or 1 of a table without a header is no coordinate but numbers or labels the lines, or
/// is a time. Empty without a sign, or if the other columns before column 3 have texts.
std::string doubt_column(const TableSample& sample, std::size_t column) {
  if (sample.lines() < 3 || !sample.any(2, is_number, 0) || !sample.all(2, is_number_or_missing, 0) ||
      !sample.all(1 - column, is_number_or_missing, 0))
    return "";
  std::set<double> values;
  std::size_t decimals = 0;  // number of decimals in the other columns
  double first = 0, step = 0, last = 0, greatest = 0, least_other = std::numeric_limits<double>::infinity();
  bool are_whole = true, ascend = true, are_even = true, differ = false;
  for (std::size_t i = 0; i < sample.lines(); ++i) {
    const std::optional<double> value = value_of(sample.field(i, column));
    if (!value) return "";
    if (i == 0) first = *value;
    if (i == 1) step = *value - first;
    are_whole = are_whole && std::trunc(*value) == *value;
    ascend = ascend && (i == 0 || *value > last);
    are_even = are_even && (i == 0 || std::abs(*value - last - step) <= 1e-6 * step);
    differ = differ || sample.field(i, 1 - column) != sample.field(0, 1 - column);  // false in a row of a grid
    greatest = std::max(greatest, std::abs(*value));
    for (const std::size_t other : {1 - column, std::size_t{2}}) {
      decimals += is_decimal(sample.field(i, other)) ? 1U : 0U;
      if (const auto of_other = value_of(sample.field(i, other)))
        least_other = std::min(least_other, std::abs(*of_other));
    }
    values.insert(last = *value);
  }
  if (are_whole && ascend && are_even && step == 1 && differ) return "which numbers the lines";
  constexpr double by_far = 10;
  const bool all_differ = values.size() == sample.lines(), have_decimals = decimals > sample.lines(),
             is_far = are_whole && all_differ && by_far * greatest < least_other;
  if (column > 0 || !differ || !(have_decimals || is_far)) return "";
  if (are_whole && all_differ) return "whole numbers that all differ, as numbers of points do";
  if (are_whole) return "whole numbers beside decimals, as labels are";
  constexpr double second = 1e9;  // of the year 2001, from 1970 on
  if (ascend && (are_even || (*values.begin() > second && *values.rbegin() < 2 * second)))
    return "which ascends as times do";
  return "";
}

/// Returns whether the numbers of columns 1 and 2 may be latitudes and longitudes: column 1 is within ±90; column 2 is
/// within ±180, but not within ±90; and column 2 has a number below -90, or all its numbers are larger in absolute
/// value than all of column 1.
bool are_exchanged(const TableSample& sample) {
  double greatest_x = 0, least_y = 180, greatest_y = 0;
  bool is_west = false;
  for (std::size_t i = 0; i < sample.lines(); ++i) {
    const std::optional<double> x = value_of(sample.field(i, 0)), y = value_of(sample.field(i, 1));
    if (!x || !y) continue;
    greatest_x = std::max(greatest_x, std::abs(*x));
    greatest_y = std::max(greatest_y, std::abs(*y));
    least_y = std::min(least_y, std::abs(*y));
    is_west = is_west || *y < -90;
  }
  return greatest_x <= 90 && greatest_y > 90 && greatest_y <= 180 && (is_west || least_y > greatest_x);
}

/// Returns whether `count` pairs of columns from `first` on may be numbers with decimal commas in a table with commas
/// as separator, "13,28,52,56". One of four signs suffices: a fraction begins with 0; blanks follow only every second
/// comma, "1,5, 2,5"; all numbers are long and all fractions short; few numbers have many fractions.
bool are_split_decimals(const TableBeginning& table, const TableSample& sample, std::size_t first, std::size_t count) {
  bool has_zeros = false, are_large = true, are_few = sample.lines() > 1, are_apart = true;
  for (std::size_t k = first; k < first + 2 * count; k += 2) {
    std::set<std::string_view> numbers, fractions;
    if (!sample.all(k, is_whole, 0) || !sample.all(k + 1, is_digits, 0)) return false;
    for (std::size_t i = 0; i < sample.lines(); ++i) {
      numbers.insert(sample.field(i, k));
      fractions.insert(sample.field(i, k + 1));
      are_large = are_large && sample.field(i, k).size() > 4 && sample.field(i, k + 1).size() < 4;
    }
    has_zeros = has_zeros || sample.any(k + 1, has_leading_zero, 0);
    are_few = are_few && count == 2 && numbers.size() * 4 <= fractions.size();
  }
  const std::string_view line = table.lines.line();
  std::size_t commas = first;
  for (std::size_t at = line.find(','); at < line.size(); at = line.find(',', at + 1))
    are_apart = are_apart && line.substr(at + 1).starts_with(' ') == (++commas % 2 == 0);
  return has_zeros || are_large || are_apart || are_few;
}

/// Throws WholeRefusal if a name or another column says that the numbers of axis 0 or 1 have another sign, or are
/// degrees and minutes: 4807.038 beside N. The other column is any column if the layout has degrees, else one beside
/// the column of the axis, whose name is unknown.
void doubt_sign(const TableBeginning& table, const TableLayout& layout, std::size_t axis, const TableSample& sample) {
  const std::size_t column = layout.numbers[axis], first = layout.header ? 1 : 0;
  const std::string way =
      axis == 0 ? "longitudes that are negative in the west" : "latitudes that are negative in the south";
  const std::string change = " (change the sign of the column)";
  if (layout.degrees && layout.header && is_reversed(table.fields[column]) && sample.any(column, is_positive, first))
    refuse(table, "the name " + in_quotes(table.fields[column]) + " above positive numbers", way + change);
  for (std::size_t other = 0; other < table.fields.size(); ++other) {
    const bool is_beside = other == column + 1 || other + 1 == column;
    if (!layout.degrees && (!is_beside || (layout.header && is_coordinate(table.fields[column], axis)))) continue;
    if (!sample.all(other, axis == 0 ? is_longitude_letter : is_latitude_letter, first)) continue;
    for (std::size_t i = first; i < sample.lines(); ++i) {
      const std::string_view letter = sample.field(i, other), field = sample.field(i, column);
      const std::string found = column_text(other) + " with " + in_quotes(letter) + " for " + in_quotes(field);
      const double value = std::abs(value_of(field).value_or(0)), most = axis == 0 ? 180 : 90;
      if (value > most && value <= 100 * most && std::fmod(value, 100) < 60)
        refuse(table, found + ", degrees and minutes in one number",
               "decimal degrees (degrees + minutes / 60), negative for the hemispheres W and S");
      if (is_word_of(letter, "S W") && is_positive(field) && (layout.degrees || value <= most))
        refuse(table, found, way + ", without a column for it");
    }
  }
}

/// Adds a warning if numbers of the column with three digits after a sign, "1.011", stand among whole numbers. Throws
/// WholeRefusal if the whole numbers are so much larger that the sign is one between thousands.
void doubt_thousands(const TableBeginning& table, std::size_t column, const TableSample& sample, std::size_t first,
                     std::vector<std::string>& warnings) {
  std::size_t signs = 0, whole = 0, lines = sample.lines() - first;
  double greatest = 0, greatest_whole = 0;
  std::string_view sign;
  for (std::size_t i = first; i < sample.lines(); ++i) {
    const std::string_view field = sample.field(i, column);
    const double value = std::abs(value_of(field).value_or(0));
    if (may_have_thousands(field)) {
      if (signs++ == 0) sign = field;
      greatest = std::max(greatest, value);
    } else if (is_whole(field) && field.size() < (field.starts_with('-') ? 5 : 4)) {
      ++whole;
      greatest_whole = std::max(greatest_whole, value);
    } else if (is_missing(field)) {
      --lines;
    }
  }
  if (signs == 0 || whole == 0 || signs + whole < lines) return;
  std::string thousands(sign);
  std::erase_if(thousands, [](char c) { return c == '.' || c == ','; });
  const std::string digits = " three digits after each sign, as in " + std::string(sign) + ", and ",
                    way = "export the table with cells in a plain format";
  if (constexpr double by_far = 10; greatest_whole > by_far * greatest)
    refuse(table, column_text(column) + " with" + digits + "much larger whole numbers", thousands + " (" + way + ")");
  warnings.push_back(column_text(column) + " has" + digits + "its other numbers have none: is it " + thousands +
                     "? (then " + way + ")");
}

/// Throws WholeRefusal if all numbers of the column have a point before three digits, and all of another column have
/// decimal commas: the points are then signs between thousands.
void refuse_points_beside_commas(const TableBeginning& table, std::size_t column, const TableSample& sample,
                                 std::size_t first) {
  const auto has_point = [](std::string_view f) { return may_have_thousands(f) && f.find('.') < f.size(); };
  const auto has_comma = [](std::string_view f) { return is_number(f) && f.find(',') < f.size(); };
  if (table.choice.separator == ',' || !sample.all(column, has_point, first)) return;
  for (std::size_t i = 0; i < table.fields.size(); ++i)
    if (sample.all(i, has_comma, first))
      refuse(table,
             column_text(column) + " with three digits after each point, beside decimal commas in " + column_text(i),
             "one decimal sign (export the table with cells in a plain format)");
}

/// Returns whether x and y may be northings and eastings: x is from 1e6 to 1e7 and y from 1e5 to 1e6, and x has no name
/// of an easting.
bool may_be_northings(const TableBeginning& table, const TableLayout& layout, const TableSample& sample) {
  const std::size_t first = layout.header ? 1 : 0, x = layout.numbers[0];
  const auto is_northing = [](std::string_view f) { return value_of(f) > 1e6 && value_of(f) <= 1e7; };
  const auto is_easting = [](std::string_view f) { return value_of(f) >= 1e5 && value_of(f) < 1e6; };
  const bool is_named = layout.header && is_coordinate(table.fields[x], 0) &&
                        table.fields[x].find_first_of("xX") == std::string_view::npos;
  return !is_named && sample.all(x, is_northing, first) && sample.all(layout.numbers[1], is_easting, first);
}

/// Returns the warning that the first line of points numbers the columns, as it has whole numbers from 0 or 1 on above
/// decimals; empty if it does not.
std::string doubt_first_line(const TableBeginning& table, const TableLayout& layout, const TableSample& sample) {
  for (std::size_t i = 0; i < table.fields.size(); ++i)
    if (const std::optional<std::size_t> number = parse_count(table.fields[i]);
        !number || *number != i + (table.fields[0] == "0" ? 0U : 1U))
      return "";
  for (const std::size_t column : layout.numbers)
    if (sample.lines() < 3 || !sample.all(column, is_decimal, 1)) return "";
  return "the first line, " + in_quotes(table.lines.line()) +
         ", is read as a point, and may be a header that numbers the columns (then delete it)";
}

/// Adds a warning if a column of zones, of UTM or other systems, has several zones, and no condition selects lines.
void doubt_zones(const TableBeginning& table, const CloudRequest& request, const TableSample& sample,
                 std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < table.fields.size() && !request.where; ++i) {
    const std::string name(table.fields[i]);
    if (!is_word_of(name, "zone utmzone utm_zone zona huso fuso epsg srid crs") || !sample.all(i, is_zone, 1)) continue;
    const std::string value(sample.field(1, i));
    for (std::size_t line = 2; line < sample.lines(); ++line)
      if (sample.field(line, i) != value)
        return warnings.push_back("the column " + in_quotes(name) + " has " + value + " and " +
                                  std::string(sample.field(line, i)) + ": are there points of two systems? (--where '" +
                                  name + " == " + (parse_count(value) ? value : '"' + value + '"') + "' selects one)");
  }
}

/// Returns the columns that are most likely x and y below a header with unknown names: by words of the names. Else each
/// by a known name, or the first free column of decimals, else of numbers but a first column of distinct integers, else
/// of numbers. Returns fewer than two columns if there are no others.
std::vector<std::size_t> find_likely(const TableBeginning& table, const TableSample& sample) {
  std::vector<std::size_t> places = find_likely_columns(table.fields);
  if (!places.empty()) return places;
  const std::size_t width = table.fields.size(), none = width;
  places = {none, none};
  const auto take = [&](std::size_t axis, const auto& fits) {
    for (std::size_t i = 0; i < width && places[axis] == none; ++i)
      if (places[1 - axis] != i && fits(i)) places[axis] = i;
  };
  std::set<std::string_view> values;  // distinct fields of the first column
  for (std::size_t i = 1; i < sample.lines(); ++i) values.insert(sample.field(i, 0));
  const bool has_identifiers = values.size() > 1 && values.size() + 1 == sample.lines() && sample.all(0, is_whole, 1);
  for (const std::size_t axis : {0U, 1U})
    take(axis, [&](std::size_t i) { return is_coordinate(table.fields[i], axis) && sample.any(i, is_number, 1); });
  for (const int least : {2, 1, 0})  // how sure a column must be
    for (const std::size_t axis : {0U, 1U})
      take(axis, [&](std::size_t i) {
        return sample.any(i, is_number, 1) && (least < 2 || sample.any(i, is_decimal, 1)) &&
               (least < 1 || i > 0 || !has_identifiers);
      });
  std::erase(places, none);
  return places;
}

/// Returns the argument of --columns for the columns that are most likely x and y; "X,Y" if there are no two.
std::string likely_columns(const TableBeginning& table, const TableSample& sample) {
  const std::vector<std::size_t> places = find_likely(table, sample);
  if (places.size() < 2) return "X,Y";
  std::string names, numbers;
  bool are_words = true;
  for (const std::size_t place : places) {
    const std::string_view name = table.fields[place];
    are_words = are_words && name.find_first_of(" ,;\"'()[]|&$<>*?!#\\") == std::string_view::npos &&
                !is_number(name) && printable(name) == name;
    names.append(names.empty() ? "" : ",").append(name);
    numbers += (numbers.empty() ? "" : ",") + std::to_string(place + 1);
  }
  return are_words ? names : numbers;
}

}  // namespace

std::string other_columns(const std::vector<std::string_view>& fields, std::size_t x, std::size_t y, bool in_space) {
  std::vector<std::string_view> others = fields;
  others[x] = others[y] = {};
  const std::optional<NamedColumns> found = find_coordinates(others);
  if (!found) return " (--columns chooses others)";
  return ", and not " + in_quotes(fields[found->x]) + " and " + in_quotes(fields[found->y]) + " (--columns " +
         (in_space ? "chooses" : std::to_string(found->x + 1) + "," + std::to_string(found->y + 1) + " chooses") +
         " these)";
}

void warn_of_unknown_names(const TableBeginning& table, std::size_t numbers, std::vector<std::string>& warnings) {
  const std::vector<std::string_view>& fields = table.fields;
  std::vector<std::string> columns, unknown;
  for (std::size_t k = 0; k < numbers; ++k) {
    if (!is_coordinate(fields[k], k)) unknown.push_back(in_quotes(fields[k]));
    columns.push_back(std::string(1, "xyz"[k]) + " is column " + std::to_string(k + 1) + ", " + in_quotes(fields[k]));
  }
  if (unknown.empty() && fields.size() == numbers && !table.says_columns) return;
  const std::string way = fields.size() > numbers ? "--columns chooses others"
                          : numbers == 2          ? "--columns 2,1 exchanges them"
                                                  : "--columns chooses another order";
  std::string doubt;
  if (unknown.size() == numbers)
    doubt = "no name of a column is that of a coordinate; ";
  else if (!unknown.empty())
    doubt = listed(unknown, " and ") + (unknown.size() > 1 ? " are no names" : " is no name") + " of a coordinate; ";
  warnings.push_back(doubt + listed(columns, ", and ") + " (" + way + ")");
}

void refuse_unknown_names(const TableBeginning& table, const TableSample& sample) {
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < table.fields.size() && sample.lines() > 1; ++i)
    numbers += is_number(sample.field(1, i)) ? 1U : 0U;
  if (table.fields.size() == 2 || numbers < 2 || !table.choice.first_fits) return;
  const bool are_boxes = are_sides(table.fields);
  throw WholeRefusal(
      at_line(table.lines.name(), table.lines.number()) + ": found " + in_quotes(table.lines.line()) + ", expected " +
      (are_boxes ? "columns of points, and not of the sides of boxes" : "known names of coordinates, such as x and y") +
      " (--columns " + (are_boxes ? "X,Y" : likely_columns(table, sample)) + " chooses columns)");
}

void doubt_first_columns(const TableBeginning& table, const TableSample& sample, std::vector<std::string>& warnings) {
  if (const std::string why = doubt_column(sample, 0); !why.empty())
    warnings.push_back("x is column 1, " + why + " (--columns 2,3 takes the columns after it)");
  else if (const std::string numbers = doubt_column(sample, 1); !numbers.empty())
    warnings.push_back("y is column 2, " + numbers + " (--columns 1,3 leaves it out)");
  else if (are_exchanged(sample))
    warnings.emplace_back(
        "x is within -90 to 90, and y is not, as latitudes and longitudes are: are they exchanged? (--columns "
        "2,1 takes them in the other order)");
  for (const std::string_view field : table.fields)
    if (std::deque<std::string> room;
        table.choice.separator == ',' && !has_thousands(field) && count_fields(field, blanks).all > 1) {
      const std::vector<std::string_view> words = split(field, blanks, room);
      if (std::all_of(words.begin(), words.end(), is_number))
        refuse(table, in_quotes(table.lines.line()) + ", several points",
               "one in each line (tr ' ' '\\n' makes lines of them)");
    }
  refuse_decimal_commas(table, sample);
}

void refuse_decimal_commas(const TableBeginning& table, const TableSample& sample) {
  const std::size_t width = table.fields.size();
  if (table.choice.separator == ',' && width >= 4 && width <= 6 &&
      are_split_decimals(table, sample, width % 2, width / 2))
    refuse(table, in_quotes(table.lines.line()) + ", whose commas may be decimal signs",
           "numbers with decimal points between commas (export the table with semicolons; --columns reads commas as "
           "separators)");
}

void doubt_coordinates(const TableBeginning& table, const TableLayout& layout, const CloudRequest& request,
                       const TableSample& sample, std::vector<std::string>& warnings) {
  const std::size_t first = layout.header ? 1 : 0, x = layout.numbers[0], y = layout.numbers[1];
  for (const std::size_t column : layout.numbers) {
    doubt_thousands(table, column, sample, first, warnings);
    if (!layout.degrees) refuse_points_beside_commas(table, column, sample, first);
  }
  for (const std::size_t axis : {0U, 1U}) doubt_sign(table, layout, axis, sample);
  if (may_be_northings(table, layout, sample))
    warnings.push_back(
        "x is beyond 1000000 and y is not, as northings and eastings are: are they exchanged? (--columns " +
        std::to_string(y + 1) + "," + std::to_string(x + 1) +
        (request.in_space ? "," + std::to_string(layout.numbers[2] + 1) : "") + " takes them in the other order)");
  if (!layout.header) {
    if (const std::string warning = doubt_first_line(table, layout, sample); !warning.empty())
      warnings.push_back(warning);
    return;
  }
  doubt_zones(table, request, sample, warnings);
  if (have_different_units(table.fields[x], table.fields[y]))
    warnings.push_back(in_quotes(table.fields[x]) + " and " + in_quotes(table.fields[y]) +
                       " have different units (lengths and areas need one)");
  if (!layout.degrees) return;
  const bool are_whole = sample.all(x, is_whole, first) && sample.all(y, is_whole, first);
  for (std::size_t i = 0; i < table.fields.size(); ++i)
    if (is_part_of_degree(table.fields[i]) && (are_whole || i == x || i == y))
      refuse(
          table,
          "the column " + in_quotes(table.fields[i]) +
              (i == x || i == y ? " of minutes or seconds" : " beside whole degrees in " + in_quotes(table.fields[x])),
          "decimal degrees in one column (degrees + minutes / 60 + seconds / 3600)");
}

void warn_of_no_height(const TableBeginning& table, const TableLayout& layout, const CloudRequest& request,
                       const TableSample& sample, std::vector<std::string>& warnings) {
  const std::size_t first = layout.header ? 1 : 0;
  const auto is_in_condition = [&](std::string_view name) {
    return request.where && std::any_of(request.where->fields().begin(), request.where->fields().end(),
                                        [&](const std::string& field) { return same_letters(field, name); });
  };
  const std::vector<std::string_view>& names = layout.header ? table.fields : layout.names;
  std::vector<std::string> others;
  for (std::size_t i = 0; i < table.fields.size(); ++i)
    if (i != layout.numbers[0] && i != layout.numbers[1] && sample.any(i, is_number, first) &&
        sample.all(i, is_number_or_missing, first) && !(i < names.size() && is_in_condition(names[i])))
      others.push_back(i < names.size() && !names[i].empty() ? in_quotes(names[i]) : column_text(i));
  if (others.empty()) return;
  constexpr std::size_t most = 4;
  if (others.size() > most) others.resize(most), others.push_back("others");
  warnings.push_back("no column has a known name of heights, so there is no z (--columns X,Y,Z takes z from " +
                     listed(others, " or ") + ")");
}

}  // namespace rbpa::app
