#include "io/claim.h"

namespace rbpa::app {

double end_of_lines(std::string_view first, Lines lines, double count) {
  std::size_t end = first.size() - lines.rest().size();
  for (; count > 0 && lines.next_with_content(); --count) {
    if (lines.rest().empty() && first.back() != '\n') break;  // it may go on
    end = first.size() - lines.rest().size();
  }
  return static_cast<double>(end) + 2 * count;
}

}  // namespace rbpa::app
