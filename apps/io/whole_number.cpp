#include "io/whole_number.h"

#include <charconv>
#include <system_error>

#include "io/failure.h"

namespace rbpa::app {

std::size_t parse_whole(const std::string& option, const std::string& text, WholeNumbers allowed,
                        const std::string& things) {
  std::size_t number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error == std::errc() && end == last && number >= allowed.least && number <= allowed.greatest) return number;
  std::string expected = ", expected a whole number ";
  if (!things.empty()) expected.append("of ").append(things).append(" ");
  expected.append("from ").append(std::to_string(allowed.least));
  if (allowed.greatest < WholeNumbers().greatest) expected.append(" to ").append(std::to_string(allowed.greatest));
  throw WrongUsage(option + ": found " + in_quotes(text) + expected);
}

}  // namespace rbpa::app
