#include "io/table/field_text.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

bool same_name(std::string_view a, std::string_view b) {
  const auto same_letter = [](char p, char q) {
    return std::tolower(static_cast<unsigned char>(p)) == std::tolower(static_cast<unsigned char>(q));
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_letter);
}

}  // namespace

std::string_view beyond_byte_order_mark(std::string_view text, const std::string& name) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    bad_input(name, "text in UTF-16", "UTF-8 (iconv -f UTF-16 -t UTF-8)");
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

bool is_separator_hint(std::string_view line) { return line.size() == 5 && line.starts_with("sep="); }

bool is_number(std::string_view field) {
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  return parse_whole_number(text).fault != NumberFault::not_a_number;
}

bool is_missing(std::string_view field) {
  constexpr std::string_view signs[] = {"", "NA", "N/A", "#N/A", "NaN", "-NaN", "null", "none", "nil", "-", "\\N"};
  return std::any_of(std::begin(signs), std::end(signs), [&](std::string_view sign) { return same_name(field, sign); });
}

std::size_t find_column(const std::vector<std::string_view>& header, const std::string& wanted, const Lines& lines,
                        const std::string& name) {
  auto found = std::find(header.begin(), header.end(), wanted);
  if (found == header.end())
    found =
        std::find_if(header.begin(), header.end(), [&](std::string_view field) { return same_name(field, wanted); });
  if (found == header.end())
    bad_input(at_line(name, lines.number()), in_quotes(lines.line()), "a header with a column " + in_quotes(wanted));
  return static_cast<std::size_t>(found - header.begin());
}

}  // namespace rbpa::app
