// What: conditions of `--where`, which select points of a file by their fields: "class == 2 and (z > 3 or not
//       overlap)".
// Cost: at most a few operations for each point and each word of the condition.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

/// The rule that decides which words of a condition name fields.
struct FieldNames {
  bool (*are)(std::string_view word);  ///< returns whether a word may name a field
  std::string described;               ///< description for messages, after "expected a number or "
  bool texts = false;                  ///< fields may be compared with texts
};

/// Returns the rule for tables: any word is the name of a field, and any text in double quotes, such as "point class".
FieldNames names_of_columns();

/// A column that is read for each point in addition to its position.
struct WantedColumn {
  enum class Kind {
    /// Numbers if the first value that is not missing is a number, else texts; for atoms, the column decides. The
    /// values are unspecified in LAS if CloudRequest::keeps is present, and in binary PLY and PCD if
    /// CloudRequest::keeps chooses the field, because the field is then kept with its own type.
    by_value,
    number,
    text,
    radius  ///< a number; any other text is NaN, so that only the group of that point is without a radius
  };
  std::string name;
  Kind kind = Kind::number;
  bool if_there = false;  ///< a file without the column is accepted
};

/// The fields that assign points to groups.
struct GroupColumns {
  std::optional<std::string> keys = std::nullopt;    ///< `--group-by`: fields of the group's name, between commas
  std::optional<std::string> radius = std::nullopt;  ///< `--alpha column:NAME`: field of the group's radius
};

/// A compiled condition: comparisons of fields and numbers with == != < <= > >= (also = and <>, and 0 < z < 10), or
/// `field in (2, 6)`, `field not in (2, 6)`, or a field alone, which is true if it is neither 0 nor missing; joined by
/// not, and, or (also ! && ||) and at most 100 nested brackets and nots. The case of these words does not matter. If
/// fields may be texts, also `field == "A"`, != and `in ("A", "B")`, in quotes of either kind; the case of the texts
/// matters.
class Condition {
 public:
  /// Parses a condition. Throws WrongUsage that names the part that is not understood, also for an empty text.
  Condition(const std::string& text, const FieldNames& names);
  /// Parses a condition. The first of fields() are `columns`, which `option` requests for each point. An empty text
  /// selects all points. Requires: the names of `columns` are different. Throws WrongUsage, also if the name of a
  /// column is not a name of a field.
  Condition(const std::string& text, const FieldNames& names, const std::vector<WantedColumn>& columns,
            std::string_view option = "--where");
  /// Parses a condition. The first of fields() are the keys and the radius of groups, if `columns` names them. Keys are
  /// texts, even if they look like numbers. An empty text selects all points. Throws WrongUsage, also if a key or the
  /// radius is not a name of a field, or a key comes twice.
  static Condition of_groups(const GroupColumns& columns, const std::string& text, const FieldNames& names);

  enum class Step {
    field,
    number,
    equal,
    not_equal,
    less,
    less_equal,
    greater,
    greater_equal,
    both,
    either,
    negation,
    text,
    unless_true,  ///< if the last value is not 0, makes it 1 and jumps to instruction Instruction::field
    unless_false  ///< if the last value is 0, jumps to instruction Instruction::field
  };
  /// A step of a stack machine: operands come before their operator.
  struct Instruction {
    Step step;
    double number = 0;  ///< the number of Step::number
    /// The index in fields() for Step::field, and in texts() for Step::text; for unless_true and unless_false, that of
    /// the instruction to which to jump.
    std::size_t field = 0;
  };
  const std::vector<Instruction>& instructions() const { return instructions_; }
  /// Returns the names of fields, without quotes: first the columns(), then the fields that are compared with numbers
  /// or are alone. Neither part repeats a name, but a name may be in both parts.
  const std::vector<std::string>& fields() const { return fields_; }
  /// Returns the number of columns that are requested for each point. They are the first of fields().
  std::size_t columns() const { return columns_.size(); }
  const WantedColumn& column(std::size_t i) const { return columns_[i]; }
  /// Returns the option that names a field: "--group-by" for the keys of groups, "--alpha" for their radius, `option`
  /// of the constructor for other columns, and "--where" for all other fields.
  std::string_view option_of(const std::string& field) const {
    for (const WantedColumn& column : columns_) {
      if (column.name != field) continue;
      if (!is_of_groups_) return option_;
      return column.kind == WantedColumn::Kind::text ? "--group-by" : "--alpha";
    }
    return "--where";
  }
  /// Returns whether the condition may exclude points.
  bool selects() const { return selects_; }
  /// A comparison of a field with a text.
  struct Text {
    std::string field, text;
  };
  const std::vector<Text>& texts() const { return texts_; }

 private:
  Condition() = default;
  void parse(const std::string& text, const FieldNames& names);

  std::vector<Instruction> instructions_ = {};
  std::vector<std::string> fields_ = {};
  std::vector<Text> texts_ = {};
  std::vector<WantedColumn> columns_ = {};
  bool is_of_groups_ = false;       // columns_ are those of groups
  std::string option_ = "--where";  // requests columns_
  bool selects_ = true;
};

/// Evaluates a condition for one point after another. Counts the points, and those that it selects.
class Selection {
 public:
  explicit Selection(const Condition& condition)
      : instructions_(condition.instructions()),
        columns_(condition.columns()),
        selects_(condition.selects()),
        values_(condition.fields().size()) {}

  /// Returns whether the condition is true for a point. number(i) returns the value of field i of the condition, and
  /// is_text(i) whether its comparison i of texts is true. Both are called only as needed: not for the second operand
  /// of `and` or `or` if the first decides.
  template <typename Number, typename IsText>
  bool holds(const Number& number, const IsText& is_text) {
    stack_.clear();
    for (std::size_t i = 0; i < instructions_.size(); ++i) {
      using Step = Condition::Step;
      const Condition::Instruction& instruction = instructions_[i];
      if (instruction.step == Step::field)
        stack_.push_back(number(instruction.field));
      else if (instruction.step == Step::text)
        stack_.push_back(is_text(instruction.field) ? 1 : 0);
      else if (decides(instruction))
        i = instruction.field - 1;
    }
    return count();
  }
  /// Returns whether the condition is true for a point whose fields have the numbers in values(). Every comparison with
  /// a text is false.
  bool holds() {
    return holds([&](std::size_t i) { return values_[i]; }, [](std::size_t) { return false; });
  }
  /// Returns the room for the values of the condition's fields, which the caller fills in before holds().
  std::span<double> values() { return values_; }

  bool all_held() const { return selected_ == judged_; }
  /// Returns the first values(): those of the condition's columns(), for the point that was filled in last.
  std::span<const double> column_values() const { return {values_.data(), columns_}; }
  /// Adds "--where selects 3 of 8 POINTS" to `warnings`, with `noun` for POINTS, unless the condition is empty.
  void warning(std::string_view noun, std::vector<std::string>& warnings) const;

 private:
  /// Executes an instruction that reads no field. Returns whether to jump to instruction.field.
  bool decides(const Condition::Instruction& instruction);
  bool count();

  std::vector<Condition::Instruction> instructions_;
  std::size_t columns_;
  bool selects_;
  std::vector<double> values_;
  std::vector<double> stack_ = {};
  std::size_t judged_ = 0, selected_ = 0;
};

}  // namespace rbpa::app
