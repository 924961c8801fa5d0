// What: `--where`: which points of a LAS file count: "classification == 2 and (return_number == 1 or not overlap)".
// Cost: a few operations a point for each word.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/las/las_fields.h"
#include "io/las/scaled_integer.h"

namespace rbpa::app {

/// Comparisons of fields and numbers with == != < <= > >= (also = and <>, and 0 < z < 10), or `field in (2, 6)`, or a
/// field that is not 0; joined by not, and, or (also ! && ||) and brackets. Small and capital letters are the same.
class Condition {
 public:
  /// Throws WrongUsage naming what is not understood.
  explicit Condition(const std::string& text);

  enum class Step { field, number, equal, not_equal, less, less_equal, greater, greater_equal, both, either, negation };
  /// In the order of evaluation: values before what is made of them.
  struct Instruction {
    Step step;
    double number = 0;       ///< of Step::number
    std::string field = {};  ///< of Step::field
  };
  const std::vector<Instruction>& instructions() const { return instructions_; }

 private:
  std::vector<Instruction> instructions_;
};

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
  struct Instruction {
    Condition::Step step;
    double number = 0;
    LasField field = {};
    std::optional<std::size_t> axis = std::nullopt;  // x, y or z
  };
  std::vector<ScaledInteger> axes_;
  std::vector<Instruction> instructions_;
  std::vector<double> values_;
};

}  // namespace rbpa::app
