// What: `--where`: which points of a file count, by numbers that stand beside them: "class == 2 and (z > 3 or not overlap)".
// Cost: a few operations a point for each word.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

/// What a condition may call a field.
struct FieldNames {
  bool (*are)(std::string_view word);
  std::string described;  ///< for messages, behind "expected a number or "
  bool texts = false;     ///< they may be compared with a text
};

/// Of tables: any name. One that is no word, such as "point class", stands in double quotes.
FieldNames names_of_columns();

/// A column that is wanted of each point beside its place.
struct WantedColumn {
  enum class Kind {
    by_value,  ///< numbers where the first value is one, else texts; of atoms as the column has it
    number,
    text,
    radius  ///< a number, NaN for what is none: that is for its group to say, and no reason to refuse the file
  };
  std::string name;
  Kind kind = Kind::number;
  bool if_there = false;  ///< where the file has no such column it is left out
};

/// Of points in groups, which fields have what belongs to their group.
struct GroupColumns {
  std::optional<std::string> key = std::nullopt;     ///< `--group-by`: its name
  std::optional<std::string> radius = std::nullopt;  ///< `--alpha column:NAME`
};

/// Comparisons of fields and numbers with == != < <= > >= (also = and <>, and 0 < z < 10), or `field in (2, 6)`, or a
/// field that is not 0; joined by not, and, or (also ! && ||) and brackets. Small and capital letters are the same. Where
/// fields may be texts: `field == "A"`, != and `in ("A", "B")`, quotes of either kind, letters as they are.
class Condition {
 public:
  /// Throws WrongUsage naming what is not understood.
  Condition(const std::string& text, const FieldNames& names);
  /// The same, and fields that are wanted of each point as well, by `option`: the first of fields(), no two of them equal. Of an empty
  /// text all points count.
  Condition(const std::string& text, const FieldNames& names, const std::vector<WantedColumn>& columns,
            std::string_view option = "--where");
  /// The same, and key and radius of each point, those there are, which are the first of fields() and the only ones of columns():
  /// where fields may be texts a key is one, whatever it looks like. Throws WrongUsage.
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
    unless_true,  ///< goes on at Instruction::field where the value so far is not 0, and makes it 1
    unless_false  ///< the same where it is 0
  };
  /// In the order of evaluation: values before what is made of them.
  struct Instruction {
    Step step;
    double number = 0;  ///< of Step::number
    std::size_t field =
        0;  ///< of Step::field: which of fields(); of Step::text: which of texts(); of others the next instruction
  };
  const std::vector<Instruction>& instructions() const { return instructions_; }
  /// As they were written: the columns, and what is compared with numbers, each once.
  const std::vector<std::string>& fields() const { return fields_; }
  /// How many of them are wanted of each point.
  std::size_t columns() const { return columns_.size(); }
  const WantedColumn& column(std::size_t i) const { return columns_[i]; }
  /// The option that names a field: "--group-by" the key, "--alpha" the radius, that of columns() the others of these, "--where" all others.
  std::string_view option_of(const std::string& field) const {
    if (field == of_groups_.key) return "--group-by";
    if (field == of_groups_.radius) return "--alpha";
    const auto is_it = [&](const WantedColumn& column) { return column.name == field; };
    return std::any_of(columns_.begin(), columns_.end(), is_it) ? std::string_view(option_) : "--where";
  }
  /// Whether some points may not count.
  bool selects() const { return selects_; }
  /// Whether a field is a text.
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
  GroupColumns of_groups_ = {};
  std::string option_ = "--where";  // of the columns
  bool selects_ = true;
};

/// Judges one point after the other, and counts.
class Selection {
 public:
  explicit Selection(const Condition& condition)
      : instructions_(condition.instructions()),
        columns_(condition.columns()),
        selects_(condition.selects()),
        values_(condition.fields().size()) {}

  /// number(i) is the value of the condition's field i, and is_text(i) whether its text i is as asked: they are called for what decides.
  /// The second of `and` and `or` does not where the first does.
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
  /// Likewise for a point whose numbers are in values().
  bool holds() {
    return holds([&](std::size_t i) { return values_[i]; }, [](std::size_t) { return false; });
  }
  /// Where the values of the condition's fields belong, of the point that holds() judges.
  std::span<double> values() { return values_; }

  bool all_held() const { return selected_ == judged_; }
  /// The condition's columns(), of the point that was judged last.
  std::span<const double> column_values() const { return {values_.data(), columns_}; }
  /// "2 of 3 points are as --where asks"; nothing where all count.
  void remark(std::string_view noun, std::vector<std::string>& remarks) const;

 private:
  /// Makes one of the values so far; whether it passes over what follows.
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
