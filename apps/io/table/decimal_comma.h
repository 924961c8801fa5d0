// What: numbers with a decimal comma in a table.
// Law:  all numbers of a table have the one sign or the other, or are whole.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

class DecimalComma {
 public:
  bool is_used() const { return line_ > 0; }

  /// The number that `field` is. Throws BadInput naming `here`, the place of its line.
  double read(std::string_view field, const std::string& here) const;

  /// The first number that has one, in `line`. Throws BadInput unless all numbers before were whole.
  void begin(std::string_view field, std::size_t line, bool all_whole, const std::string& here,
             std::vector<std::string>& remarks);

  /// Throws BadInput when `field` has a decimal point where commas are used.
  void refuse_point(std::string_view field, const std::string& here) const;

 private:
  std::size_t line_ = 0;  // that has shown it
};

}  // namespace rbpa::app
