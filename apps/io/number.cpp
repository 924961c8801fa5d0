#include "io/number.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace rbpa::app {

ParsedNumber parse_extreme_number(const char* first, const char* /*last*/, const char* end) {
  // strtod() tells too large from too small; the program never leaves the "C" locale.
  const double value = std::strtod(std::string(first, end).c_str(), nullptr);
  return {value, end, std::isinf(value) ? NumberFault::out_of_range : NumberFault::none};
}

ParsedNumber parse_whole_number(std::string_view text) {
  const char* last = text.data() + text.size();
  ParsedNumber number = parse_number(text.data(), last);
  if (number.end != last) number.fault = NumberFault::not_a_number;
  return number;
}

const char* expected_instead(NumberFault fault) {
  switch (fault) {
    case NumberFault::not_finite:
      return "a finite number";
    case NumberFault::out_of_range:
      return "a number within the range of a double (up to 1.8e308)";
    default:
      return "a number";
  }
}

}  // namespace rbpa::app
