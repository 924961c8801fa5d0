#include "report/facts_text.h"

#include <cstddef>

namespace rbpa::app {

std::string facts_text(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
  return json;
}

}  // namespace rbpa::app
