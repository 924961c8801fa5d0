#include "io/cloud/table_doubts.h"

#include <algorithm>
#include <deque>
#include <set>

#include "io/failure.h"
#include "io/text/columns.h"
#include "io/text/fields.h"
#include "io/text/line_selection.h"

namespace rbpa::app {
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
bool has_leading_zero(std::string_view field) { return field.size() > 1 && field.front() == '0'; }
bool is_latitude_letter(std::string_view field) { return field == "N" || field == "S"; }
bool is_longitude_letter(std::string_view field) { return field == "E" || field == "W"; }

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

/// Returns whether column 1 of a table without a header numbers its lines: three lines or more have consecutive
/// integers in column 1 and numbers in columns 2 and 3, and not all have the same number in column 2, as a row of a
/// grid has. `is_apart`: the integers need only differ, where most numbers of columns 2 and 3 are decimals.
bool is_numbered(const TableSample& sample, bool is_apart) {
  if (sample.lines() < 3 || !sample.any(2, is_number, 0) || !sample.all(1, is_number_or_missing, 0) ||
      !sample.all(2, is_number_or_missing, 0))
    return false;
  std::set<std::size_t> numbers;
  std::size_t decimals = 0;
  bool differ = false, follow = true;
  for (std::size_t i = 0; i < sample.lines(); ++i) {
    const std::optional<std::size_t> number = parse_count(sample.field(i, 0));
    if (!number || !numbers.insert(*number).second) return false;
    follow = follow && *number == *numbers.begin() + i;
    differ = differ || sample.field(i, 1) != sample.field(0, 1);
    for (const std::size_t column : {1U, 2U}) decimals += is_decimal(sample.field(i, column)) ? 1U : 0U;
  }
  return differ && (is_apart ? decimals > sample.lines() : follow);
}

/// Returns whether the columns from `first` on may be two numbers with decimal commas in a table with commas as
/// separator: "13,28,52,56". Either a fraction begins with 0, or few numbers have many fractions.
bool may_be_split_decimals(const TableSample& sample, std::size_t first) {
  std::set<std::string_view> texts[4];
  for (std::size_t k = 0; k < 4; ++k) {
    if (!sample.all(first + k, is_whole, 0)) return false;
    for (std::size_t i = 0; i < sample.lines(); ++i) texts[k].insert(sample.field(i, first + k));
  }
  const bool has_zeros = sample.any(first + 1, has_leading_zero, 0) || sample.any(first + 3, has_leading_zero, 0);
  return has_zeros || (texts[0].size() * 4 <= texts[1].size() && texts[2].size() * 4 <= texts[3].size());
}

/// Throws WholeRefusal if a name or another column says that numbers of `column`, on axis 0 or 1, have another sign.
void doubt_sign(const TableBeginning& table, const TableLayout& layout, std::size_t axis, const TableSample& sample) {
  const std::size_t column = layout.numbers[axis], first = layout.header ? 1 : 0;
  const std::string way =
      axis == 0 ? "longitudes that are negative in the west" : "latitudes that are negative in the south";
  const std::string change = " (change the sign of the column)";
  if (layout.header && is_reversed(table.fields[column]) && sample.any(column, is_positive, first))
    refuse(table, "the name " + in_quotes(table.fields[column]) + " above positive numbers", way + change);
  for (std::size_t other = 0; other < table.fields.size(); ++other) {
    if (!sample.all(other, axis == 0 ? is_longitude_letter : is_latitude_letter, first)) continue;
    for (std::size_t i = first; i < sample.lines(); ++i)
      if (std::string_view("SW").find(sample.field(i, other)) != std::string_view::npos &&
          is_positive(sample.field(i, column)))
        refuse(table,
               column_text(other) + " with " + in_quotes(sample.field(i, other)) + " for " +
                   in_quotes(sample.field(i, column)),
               way + ", without a column for it");
  }
}

}  // namespace

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

std::string likely_columns(const TableBeginning& table, const TableSample& sample) {
  std::vector<std::size_t> places = find_likely_columns(table.fields);
  for (const TableSample::Test test : {is_decimal, is_number})
    for (std::size_t i = 0; i < table.fields.size() && places.size() < 2; ++i)
      if (sample.lines() > 1 && test(sample.field(1, i)) && std::find(places.begin(), places.end(), i) == places.end())
        places.push_back(i);
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

void doubt_first_columns(const TableBeginning& table, const TableSample& sample, std::vector<std::string>& warnings) {
  const std::string others = " (--columns 2,3 takes the columns after it)";
  if (is_numbered(sample, false))
    warnings.push_back("x is column 1, which numbers the lines" + others);
  else if (is_numbered(sample, true))
    warnings.push_back("x is column 1, whole numbers that all differ, as numbers of points do" + others);
  if (table.choice.separator != ',') return;
  for (const std::string_view field : table.fields)
    if (std::deque<std::string> room; !has_thousands(field) && count_fields(field, blanks).all > 1) {
      const std::vector<std::string_view> words = split(field, blanks, room);
      if (std::all_of(words.begin(), words.end(), is_number))
        refuse(table, in_quotes(table.lines.line()) + ", several points",
               "one in each line (tr ' ' '\\n' makes lines of them)");
    }
  const std::size_t width = table.fields.size();
  if ((width == 4 || width == 5) && sample.lines() > 1 && may_be_split_decimals(sample, width - 4))
    warnings.push_back("x is " + std::string(sample.field(0, 0)) + " and y is " + std::string(sample.field(0, 1)) +
                       " in the first line: are these commas decimal signs? (then export the table with semicolons)");
}

void refuse_no_table(std::string_view bytes, const std::string& name) {
  struct Kind {
    std::string_view beginning;
    const char *found, *expected;
  };
  constexpr const char *sheet = "text (save the sheet as CSV)", *page = "a table (was the download refused?)";
  constexpr Kind kinds[] = {{"PK\x03\x04", "a workbook, or another zip file", sheet},
                            {"\xD0\xCF\x11\xE0", "a workbook of Excel", sheet},
                            {"<!doctype html", "a web page", page},
                            {"<html", "a web page", page},
                            {"{", "JSON", "a table (--format geojson reads GeoJSON)"}};
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), bytes.size()));
  for (const Kind& kind : kinds)
    if (same_letters(bytes.substr(0, kind.beginning.size()), kind.beginning))
      bad_input(name, kind.found, kind.expected);
}

std::string doubt_last_line(const TableLines& lines, char separator) {
  std::string_view last = lines.rest();
  last = last.substr(0, last.find_last_not_of(" \t\r\n") + 1);
  last.remove_prefix(last.find_last_of('\n') + 1);
  if (!fields_of_data(last, separator)) return "";
  for (Fields fields(last, separator); !fields.at_end();)
    if (is_word_of(
            without_quotes(fields.take()),
            "sum sum: total total: mean average summe summe: gesamt mittel mittelwert somme moyenne suma media totale"))
      return "the last line, " + in_quotes(last) + ", is read as a point, and may be no point but a total of others";
  return "";
}

void refuse_second_header(const TableLines& lines, char separator, const FieldCount& width, const std::string& header) {
  std::deque<std::string> room;
  std::vector<std::string_view> names = split(lines.line(), separator, room);
  if (header.empty() || lines.line() == header || names.size() != width.all || names.size() < 2) return;
  const auto is_name = [](std::string_view f) { return !is_missing(f) && !is_nearly_number(f) && !is_geometry(f); };
  if (!std::all_of(names.begin(), names.end(), is_name) || (!lines.line_before().empty() && !find_coordinates(names)))
    return;
  std::sort(names.begin(), names.end());
  if (std::adjacent_find(names.begin(), names.end()) != names.end()) return;
  throw WholeRefusal(at_line(lines.name(), lines.number()) + ": found " + in_quotes(lines.line()) +
                     ", the header of another table, expected lines of the table with the header " + in_quotes(header) +
                     " (a file for each table)");
}

void doubt_coordinates(const TableBeginning& table, const TableLayout& layout, const TableSample& sample,
                       std::vector<std::string>& warnings) {
  const std::size_t first = layout.header ? 1 : 0;
  for (const std::size_t column : layout.numbers) {
    std::size_t signs = 0, whole = 0, lines = sample.lines() - first;
    std::string_view sign;
    for (std::size_t i = first; i < sample.lines(); ++i) {
      const std::string_view field = sample.field(i, column);
      if (may_have_thousands(field))
        ++signs, sign = sign.empty() ? field : sign;
      else if (is_whole(field) && field.size() < (field.starts_with('-') ? 5 : 4))
        ++whole;
      else if (is_missing(field))
        --lines;
    }
    if (signs == 0 || whole == 0 || signs + whole < lines) continue;
    std::string thousands(sign);
    std::erase_if(thousands, [](char c) { return c == '.' || c == ','; });
    warnings.push_back(column_text(column) + " has three digits after each sign, as in " + std::string(sign) +
                       ", and its other numbers have none: is it " + thousands +
                       "? (then export the table with cells in a plain format)");
  }
  if (!layout.degrees) return;
  for (const std::size_t axis : {0U, 1U}) doubt_sign(table, layout, axis, sample);
  if (!layout.header || !sample.all(layout.numbers[0], is_whole, first) ||
      !sample.all(layout.numbers[1], is_whole, first))
    return;
  for (const std::string_view name : table.fields)
    if (is_part_of_degree(name))
      refuse(table,
             "the column " + in_quotes(name) + " beside whole degrees in " + in_quotes(table.fields[layout.numbers[0]]),
             "decimal degrees in one column (degrees + minutes / 60 + seconds / 3600)");
}

}  // namespace rbpa::app
