// What: divides the input of a fuzz target: a byte of options, the ending of a file format, a line feed, and the bytes
//       of the file. Formats that are added to the table of io/formats.h are fuzzed without a change here.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/target.h"
#include "io/cloud/cloud.h"
#include "io/failure.h"
#include "io/formats.h"

namespace fuzz {

struct FuzzedFile {
  unsigned options = 0;  ///< bits
  std::string ending = {}, bytes = {};
};

/// Divides an input; nothing if it has no ending.
inline std::optional<FuzzedFile> divided(std::string_view input) {
  const std::size_t end = input.find('\n', 1);
  if (end == std::string_view::npos) return std::nullopt;
  return FuzzedFile{static_cast<unsigned char>(input.front()), std::string(input.substr(1, end - 1)),
                    std::string(input.substr(end + 1))};
}

/// Returns the first of `conditions` that names only fields of the format; nothing if there is none.
inline std::optional<rbpa::app::Condition> condition_of(rbpa::app::Format format,
                                                        std::initializer_list<const char*> conditions) {
  const std::optional<rbpa::app::FieldNames> names = rbpa::app::fields_of(format);
  for (const char* condition : conditions) try {
      if (names) return rbpa::app::Condition(condition, *names);
    } catch (const rbpa::app::WrongUsage&) {
      continue;
    }
  return std::nullopt;
}

/// Returns a box in the plane, and a resolution.
inline rbpa::app::PointWindow window() {
  const double box[] = {0, 0, 700, 700};
  return {.bounds = rbpa::app::box_of("--bounds", box), .resolution = 0.5};
}

inline void has_all_values(const std::vector<rbpa::app::PointColumn>& kept, std::size_t points) {
  for (const rbpa::app::PointColumn& column : kept)
    require(column.size() == points, "a field has a value for each point");
}

}  // namespace fuzz
