// What: `--where` on the records of a LAS file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/condition.h"
#include "io/las/las_fields.h"
#include "io/las/scaled_integer.h"

namespace rbpa::app {

/// Those of all formats, and x, y and z.
FieldNames names_of_las_fields();

/// Where fields of a certain file are.
struct LasRecords {
  unsigned format, minor;
  std::vector<ScaledInteger> axes;  ///< of x, y, z
};

/// A condition on the records of one file.
class Selection {
 public:
  /// Throws BadInput when the records of the file `name` lack a field.
  Selection(const Condition& condition, const LasRecords& records, const std::string& name);

  bool operator()(const char* record);

 private:
  struct Place {
    LasField field;
    std::optional<std::size_t> axis = std::nullopt;  // x, y or z
  };
  std::vector<ScaledInteger> axes_;
  std::vector<Place> places_;  // of the condition's fields
  std::vector<double> values_;
  Decision holds_;
};

}  // namespace rbpa::app
