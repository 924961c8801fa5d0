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
  Condition(const std::string& text, const FieldNames& names, std::vector<std::string> columns,
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
    text
  };
  /// In the order of evaluation: values before what is made of them.
  struct Instruction {
    Step step;
    double number = 0;      ///< of Step::number
    std::size_t field = 0;  ///< of Step::field: which of fields(); of Step::text: which of texts()
  };
  const std::vector<Instruction>& instructions() const { return instructions_; }
  /// As they were written, each once.
  const std::vector<std::string>& fields() const { return fields_; }
  /// How many of them are wanted of each point.
  std::size_t columns() const { return columns_; }
  /// Whether the first of fields() is a key, and whether the next is a radius.
  bool has_key() const { return of_groups_.key.has_value(); }
  bool has_radius() const { return of_groups_.radius.has_value(); }
  /// The option that names a field: "--group-by" the key, "--alpha" the radius, that of columns() the others of these, "--where" all others.
  std::string_view option_of(const std::string& field) const {
    if (field == of_groups_.key) return "--group-by";
    if (field == of_groups_.radius) return "--alpha";
    const auto end = fields_.begin() + static_cast<std::ptrdiff_t>(columns_);
    return std::find(fields_.begin(), end, field) != end ? std::string_view(option_) : "--where";
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

  std::vector<Instruction> instructions_ = {};
  std::vector<std::string> fields_ = {};
  std::vector<Text> texts_ = {};
  std::size_t columns_ = 0;
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
        first_text_(condition.fields().size()),
        values_(first_text_ + condition.texts().size()) {}

  /// Where the values of the condition's fields belong, of the point that holds() judges, and behind them 1 or 0 for each of
  /// its texts.
  std::span<double> values() { return values_; }
  bool holds();

  bool all_held() const { return selected_ == judged_; }
  /// The condition's columns(), of the point that was judged last.
  std::span<const double> column_values() const { return {values_.data(), columns_}; }
  /// "2 of 3 points are as --where asks"; nothing where all count.
  void remark(std::string_view noun, std::vector<std::string>& remarks) const;

 private:
  std::vector<Condition::Instruction> instructions_;
  std::size_t columns_;
  bool selects_;
  std::size_t first_text_;
  std::vector<double> values_;
  std::vector<double> stack_ = {};
  std::size_t judged_ = 0, selected_ = 0;
};

}  // namespace rbpa::app
