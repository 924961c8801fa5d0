#include "io/text/fields.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "io/bytes/number.h"
#include "io/failure.h"

namespace rbpa::app {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// No comma, or one between digits.
bool may_be_decimal(std::string_view field) {
  const std::size_t comma = field.find(',');
  if (comma == std::string_view::npos) return true;
  return comma > 0 && is_digit(field[comma - 1]) && comma + 1 < field.size() && is_digit(field[comma + 1]) &&
         field.find(',', comma + 1) == std::string_view::npos;
}

std::string with_point(std::string_view field) {
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  return text;
}

}  // namespace

bool commas_are_decimal(std::string_view line, char separator) {
  if (line.find(',') == std::string_view::npos) return false;
  std::size_t count = 0;
  for (Fields fields(line, separator); !fields.at_end(); ++count)
    if (!may_be_decimal(without_quotes(fields.take()))) return false;
  return count > 1;
}

char separator_of(std::string_view line) {
  for (const char c : {';', '\t', blanks})
    if ((c == blanks || line.find(c) != std::string_view::npos) && commas_are_decimal(line, c)) return c;
  for (const char c : {',', ';', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return blanks;
}

std::string_view beyond_byte_order_mark(std::string_view text, const std::string& name) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    bad_input(name, "text in UTF-16", "UTF-8 (iconv -f UTF-16 -t UTF-8)");
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

bool is_separator_hint(std::string_view line) { return line.size() == 5 && line.starts_with("sep="); }

bool is_number(std::string_view field) {
  return parse_whole_number(with_point(field)).fault != NumberFault::not_a_number;
}

bool is_missing(std::string_view field) {
  constexpr std::string_view signs[] = {"", "NA", "N/A", "#N/A", "NaN", "-NaN", "null", "none", "nil", "-", "\\N"};
  return std::any_of(std::begin(signs), std::end(signs),
                     [&](std::string_view sign) { return same_letters(field, sign); });
}

std::size_t find_column(const std::vector<std::string_view>& header, const std::string& wanted, const Lines& lines,
                        const std::string& name) {
  auto found = std::find(header.begin(), header.end(), wanted);
  if (found == header.end())
    found =
        std::find_if(header.begin(), header.end(), [&](std::string_view field) { return same_letters(field, wanted); });
  if (found == header.end())
    bad_input(at_line(name, lines.number()), in_quotes(lines.line()), "a header with a column " + in_quotes(wanted));
  return static_cast<std::size_t>(found - header.begin());
}

double DecimalComma::read(std::string_view field, const std::string& here) const {
  const bool one = std::count(field.begin(), field.end(), ',') == 1 && field.find('.') == std::string_view::npos;
  const ParsedNumber number = parse_whole_number(with_point(field));
  if (!one || number.fault != NumberFault::none)
    bad_input(here, in_quotes(field), expected_instead(one ? number.fault : NumberFault::not_a_number));
  return number.value;
}

void DecimalComma::begin(std::string_view field, std::size_t line, bool all_whole, const std::string& here,
                         std::vector<std::string>& remarks) {
  if (!all_whole) bad_input(here, in_quotes(field), "a number with a decimal point, as in lines before");
  line_ = line;
  remarks.push_back("the decimal sign is a comma: " + shown(field) + " is read as " + shown(with_point(field)));
}

void DecimalComma::refuse_point(std::string_view field, const std::string& here) const {
  if (is_used() && field.find('.') != std::string_view::npos)
    bad_input(here, in_quotes(field), "a number with a decimal comma, as in line " + std::to_string(line_));
}

}  // namespace rbpa::app
