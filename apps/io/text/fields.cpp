#include "io/text/fields.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/text/odd_fields.h"
#include "io/utf8.h"

namespace rbpa::app {
namespace {

/// Returns whether the field has no comma, or a single one, between digits.
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
    if (const std::string_view field = without_quotes(fields.take()); !may_be_decimal(field) && !has_thousands(field))
      return false;
  return count > 1;
}

FieldCount count_fields(std::string_view line, char separator) {
  FieldCount count;
  for (Fields fields(line, separator); !fields.at_end();) count.add(fields.take());
  return count;
}

std::string_view text_of_field(std::string_view field, std::string& room) {
  const std::string_view text = without_quotes(field);
  if (text.size() == field.size() || text.find("\"\"") == std::string_view::npos) return text;
  room.clear();
  for (std::size_t at = 0; at < text.size(); ++at) {
    room += text[at];
    if (text.substr(at, 2) == "\"\"") ++at;
  }
  return room;
}

std::vector<std::string_view> split(std::string_view line, char separator, std::deque<std::string>& room) {
  std::vector<std::string_view> result;
  std::string text;
  for (Fields fields(line, separator); !fields.at_end();) {
    const std::string_view field = fields.take();
    result.push_back(text_of_field(field, text));
    if (result.back().data() == text.data() && !text.empty()) result.back() = room.emplace_back(text);
  }
  return result;
}

const char* end_of_record(std::string_view line, const char* end, char separator) {
  constexpr std::ptrdiff_t longest = std::ptrdiff_t{1} << 20U;  // the most bytes of a text that spans lines
  const char* at = line.data();
  const char* line_end = at + line.size();
  const auto skip_blanks = [&] {
    while (at != line_end && is_blank(*at) && (*at != separator || separator == blanks)) ++at;
  };
  while (true) {
    skip_blanks();
    if (separator == blanks && at != line_end && *at == '#') return line_end;
    if (at != line_end && *at == '"') {
      const char* const limit = end - at > longest ? at + longest : end;
      const char* const behind = end_of_quoted(at, limit);
      if (behind == nullptr) return nullptr;
      if (at = behind; at > line_end) {
        line_end = std::find(at, end, '\n');
        skip_blanks();
        const bool is_apart = at > behind && separator == blanks;
        if (at != line_end && *at != separator && !is_apart) return nullptr;
      }
    }
    const auto ends_field = [&](char c) { return separator == blanks ? is_blank(c) : c == separator; };
    if (at == line_end || !ends_field(*at)) at = std::find_if(at, line_end, ends_field);
    if (at == line_end) return line_end;
    ++at;
  }
}

namespace {

bool separates(std::string_view line, char separator) {
  Fields fields(line, separator);
  if (!fields.at_end()) fields.take();
  return !fields.at_end();
}

}  // namespace

char separator_of(std::string_view line) {
  for (const char c : {';', '\t', '|', blanks}) {
    stop_if_interrupted();  // a line may be long
    if ((c == blanks || separates(line, c)) && commas_are_decimal(line, c)) return c;
  }
  for (const char c : {',', ';', '\t', '|'})
    if (separates(line, c)) return c;
  return blanks;
}

std::optional<char> separator_hint(std::string_view line) {
  line = without_quotes(line);
  if (!line.starts_with("sep=") || line.size() > 5) return std::nullopt;
  return line.size() == 5 ? line.back() : '\t';  // a tab was trimmed
}

bool is_number(std::string_view field) {
  if (field.size() > longest_word) return false;
  const bool has_comma = field.find(',') != std::string_view::npos;
  const ParsedNumber number = has_comma ? parse_written_number(with_point(field)) : parse_written_number(field);
  return number.fault != NumberFault::not_a_number;
}

namespace {

/// Returns the number without `sign`, its separator of thousands; nothing if the field is not a number with this
/// separator.
std::optional<std::string> without_thousands(std::string_view field, std::string_view sign) {
  const auto digits = [&] { return std::min(field.find_first_not_of("0123456789"), field.size()); };
  const auto move = [&](std::size_t count, std::string& to) {
    to += field.substr(0, count);
    field.remove_prefix(count);
  };
  std::string result;
  if (field.starts_with('-') || field.starts_with('+')) move(1, result);
  const std::size_t first = digits();
  if (first == 0 || first > 3) return std::nullopt;
  move(first, result);
  bool any = false;
  while (field.starts_with(sign)) {
    field.remove_prefix(sign.size());
    if (digits() != 3) return std::nullopt;
    move(3, result);
    any = true;
  }
  if (!any) return std::nullopt;
  if (field.starts_with('.') || field.starts_with(',')) move(1, result);
  move(digits(), result);
  return field.empty() ? std::optional(result) : std::nullopt;
}

}  // namespace

std::optional<std::string> without_thousands(std::string_view field) {
  if (is_number(field)) return std::nullopt;
  for (const std::string_view sign : {".", ",", "'", " ", "\xE2\x80\x99", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89"})
    if (std::optional<std::string> number = without_thousands(field, sign)) return number;
  return std::nullopt;
}

bool has_thousands(std::string_view field) { return without_thousands(field).has_value(); }

bool is_nearly_number(std::string_view field) {
  const auto has = [&](const auto& is) { return std::any_of(field.begin(), field.end(), is); };
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  if (is_number(field) || parse_angle(field)) return true;
  if (field.empty() || is_letter(field.front()) || field.front() == '_' || !has(is_digit)) return false;
  const std::size_t sign = field.find_first_not_of("+-.");
  if (sign != std::string_view::npos && is_digit(field[sign])) return true;
  return !has([&](char c) { return is_letter(c) && std::string_view("eEdD").find(c) == std::string_view::npos; });
}

bool begins_with_geometry(std::string_view field) {
  constexpr std::string_view kinds[] = {"POINT",      "LINESTRING",       "POLYGON",      "GEOMETRYCOLLECTION",
                                        "MULTIPOINT", "MULTILINESTRING",  "MULTIPOLYGON", "TRIANGLE",
                                        "TIN",        "POLYHEDRALSURFACE"};
  if (same_letters(field.substr(0, 5), "SRID=")) field.remove_prefix(std::min(field.find(';') + 1, field.size()));
  field = trimmed(field);
  std::string_view word = field.substr(0, 32);  // longer than any kind
  word = word.substr(0, word.find_first_of(" \t\n("));
  const auto is = [&](std::string_view kind) {
    return word.size() <= kind.size() + 2 && same_letters(word.substr(0, kind.size()), kind);
  };
  if (std::none_of(std::begin(kinds), std::end(kinds), is)) return false;
  if (same_letters(trimmed(field.substr(word.size())).substr(0, 5), "EMPTY")) return true;
  const std::size_t behind = std::min(field.find_first_not_of(" \t\nzmZM", word.size()), field.size());
  return behind < field.size() && field[behind] == '(';
}

bool is_geometry(std::string_view field) {
  if (!begins_with_geometry(field)) return false;
  const auto open = std::count(field.begin(), field.end(), '(');
  return open == std::count(field.begin(), field.end(), ')') &&
         (open == 0 || std::any_of(field.begin(), field.end(), is_digit));
}

bool is_missing(std::string_view field) {
  constexpr std::string_view signs[] = {"", "NA", "N/A", "#N/A", "NaN", "-NaN", "null", "none", "nil", "-", "\\N"};
  return std::any_of(std::begin(signs), std::end(signs),
                     [&](std::string_view sign) { return same_letters(field, sign); });
}

bool is_comment(std::string_view line) {
  constexpr std::string_view errors[] = {"#NV",     "#N/A",   "#REF!", "#BEZUG!", "#WERT!", "#VALUE!",
                                         "#DIV/0!", "#NAME?", "#NUM!", "#ZAHL!",  "#NULL!"};
  const auto is = [&](std::string_view error) {
    return line.starts_with(error) &&
           (line.size() == error.size() || std::isalnum(static_cast<unsigned char>(line[error.size()])) == 0);
  };
  return line.starts_with("//") || (line.starts_with('#') && std::none_of(std::begin(errors), std::end(errors), is));
}

bool has_column(const std::vector<std::string_view>& header, std::string_view wanted) {
  return std::any_of(header.begin(), header.end(),
                     [&](std::string_view field) { return same_letters(as_utf8(field), wanted); });
}

std::size_t find_column(const std::vector<std::string_view>& header, const std::string& wanted, const Lines& lines,
                        const std::string& name, const std::string& way) {
  auto found = std::find(header.begin(), header.end(), wanted);
  if (found == header.end())
    found = std::find_if(header.begin(), header.end(),
                         [&](std::string_view field) { return same_letters(as_utf8(field), wanted); });
  if (found == header.end())
    bad_input(at_line(name, lines.number()), in_quotes(lines.line()),
              "a header with a column " + in_quotes(wanted) + way);
  return static_cast<std::size_t>(found - header.begin());
}

double DecimalComma::read(std::string_view field, const std::string& here) const {
  const bool one = std::count(field.begin(), field.end(), ',') == 1 && field.find('.') == std::string_view::npos;
  const ParsedNumber number = parse_written_number(with_point(field));
  if (!one || number.fault != NumberFault::none)
    bad_input(here, in_quotes(field), expected_for(field, one ? number.fault : NumberFault::not_a_number));
  return number.value;
}

void DecimalComma::begin(std::string_view field, std::size_t line, bool all_whole, const std::string& here,
                         std::vector<std::string>& warnings) {
  if (!all_whole)
    bad_input(here, in_quotes(field),
              "a number with a decimal point, as in lines before (one decimal sign in all lines)");
  line_ = line;
  warnings.push_back("the decimal sign is a comma: " + shown(field) + " is read as " + shown(with_point(field)));
}

void DecimalComma::refuse_point(std::string_view field, const std::string& here) const {
  if (is_used() && field.find('.') != std::string_view::npos)
    bad_input(
        here, in_quotes(field),
        "a number with a decimal comma, as in line " + std::to_string(line_) + " (one decimal sign in all lines)");
}

}  // namespace rbpa::app
