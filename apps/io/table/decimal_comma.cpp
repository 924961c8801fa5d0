#include "io/table/decimal_comma.h"

#include <algorithm>

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

std::string with_point(std::string_view field) {
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  return text;
}

}  // namespace

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
