#include "io/text/condition.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

using Step = Condition::Step;
using Instructions = std::vector<Condition::Instruction>;

constexpr std::pair<std::string_view, Step> comparisons[] = {
    {"==", Step::equal},      {"=", Step::equal},          {"!=", Step::not_equal}, {"<>", Step::not_equal},
    {"<=", Step::less_equal}, {">=", Step::greater_equal}, {"<", Step::less},       {">", Step::greater}};

/// Returns whether a character belongs to a word; every character beyond ASCII counts as a letter.
bool is_of_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || c == '_' || c == '.' || byte >= 0x80;
}

bool is_quote(char c) { return c == '"' || c == '\''; }

std::string_view unquoted(std::string_view word) {
  return word.size() > 2 && is_quote(word.front()) ? word.substr(1, word.size() - 2) : word;
}

/// Returns the name of a column in a list, where quotes are as in CSV; nothing if they are not.
std::optional<std::string> listed_name(std::string_view word) {
  if (word.find('"') == std::string_view::npos) return std::string(word);
  if (word.size() < 2 || word.front() != '"' || word.back() != '"') return std::nullopt;
  word = word.substr(1, word.size() - 2);
  std::string name;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word[i] == '"' && (++i == word.size() || word[i] != '"')) return std::nullopt;
    name += word[i];
  }
  return name;
}

/// A recursive-descent parser with a function for each rule of the grammar.
class Parser {
 public:
  Parser(const std::string& text, const FieldNames& names, Instructions& result, std::vector<std::string>& fields,
         std::vector<Condition::Text>& texts)
      : rest_(text), names_(names), result_(result), fields_(fields), texts_(texts) {}

  void parse() {
    take();
    take_alternatives(0);
    if (!word_.empty()) refuse("'and', 'or' or the end");
  }

 private:
  static constexpr int deepest = 100;  // of nested brackets and nots

  /// Sets word_ to the next word: a name, perhaps in quotes, a number or a sign.
  void take() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) rest_.remove_prefix(1);
    std::size_t size = 0;
    if (!rest_.empty() && is_quote(rest_.front())) size = std::min(rest_.find(rest_.front(), 1), rest_.size() - 1) + 1;
    while ((size == 0 || !is_quote(rest_.front())) && size < rest_.size() && is_of_word(rest_[size])) {
      ++size;
      const bool exponent =
          (rest_[size - 1] == 'e' || rest_[size - 1] == 'E') && (is_digit(rest_.front()) || rest_.front() == '.');
      if (exponent && size < rest_.size() && (rest_[size] == '-' || rest_[size] == '+')) ++size;
    }
    if (size == 0 && !rest_.empty()) {
      constexpr std::string_view pairs[] = {"==", "!=", "<>", "<=", ">=", "&&", "||"};
      const std::string_view two = rest_.substr(0, 2);
      size = std::find(std::begin(pairs), std::end(pairs), two) == std::end(pairs) ? 1 : 2;
    }
    word_ = rest_.substr(0, size);
    rest_.remove_prefix(size);
  }

  bool is(std::string_view word, std::string_view sign = "") const {
    return (!sign.empty() && word_ == sign) || same_letters(word_, word);
  }

  bool take_if(std::string_view word, std::string_view sign = "") {
    if (!is(word, sign)) return false;
    take();
    return true;
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    bad_usage("--where", word_.empty() ? "the end" : in_quotes(word_), expected);
  }

  void take_alternatives(int depth) {
    take_conjunction(depth);
    while (take_if("or", "||")) {
      const std::size_t first = begin_second(Step::unless_true);
      take_conjunction(depth);
      join(Step::either, first);
    }
  }

  /// Appends `step`, a jump for a first operand that decides alone. Returns the index of the jump, for join().
  std::size_t begin_second(Step step) {
    result_.push_back({step});
    return result_.size() - 1;
  }
  void join(Step step, std::size_t first) {
    result_.push_back({step});
    result_[first].field = result_.size();
  }

  void take_conjunction(int depth) {
    take_term(depth);
    while (take_if("and", "&&")) {
      const std::size_t first = begin_second(Step::unless_false);
      take_term(depth);
      join(Step::both, first);
    }
  }

  void take_term(int depth) {
    if (depth > deepest) refuse("at most " + std::to_string(deepest) + " nested brackets");
    if (take_if("not", "!")) {
      take_term(depth + 1);
      result_.push_back({Step::negation});
    } else if (take_if("(")) {
      take_alternatives(depth + 1);
      if (!take_if(")")) refuse("')'");
    } else {
      take_comparison();
    }
  }

  /// Returns whether the next word is a text in quotes of either kind.
  bool is_text() const {
    return names_.texts && word_.size() > 1 && is_quote(word_.front()) && word_.back() == word_.front();
  }

  /// Appends the comparison of `field` with the next word, a text.
  void take_text(const std::string& field) {
    result_.push_back({Step::text, 0, texts_.size()});
    texts_.push_back({field, std::string(word_.substr(1, word_.size() - 2))});
    take();
  }

  /// Returns the name of the field `left`, which is compared with a text, and removes it from fields_ if it was not
  /// among the first `known` fields. Throws WrongUsage if `left` is a number.
  std::string name_of(const Condition::Instruction& left, std::size_t known) {
    if (left.step != Step::field) refuse("a number or " + names_.described);
    std::string name = fields_[left.field];
    if (fields_.size() > known) fields_.pop_back();
    return name;
  }

  void take_comparison() {
    const std::size_t known = fields_.size();
    Condition::Instruction left = take_operand();
    if (is("in") || is("not")) return take_list(left, known, take_if("not"));
    std::optional<Step> step = take_sign();
    if (step && is_text()) {
      if (*step != Step::equal && *step != Step::not_equal) refuse("a number (a text is compared with == and !=)");
      take_text(name_of(left, known));
      if (*step == Step::not_equal) result_.push_back({Step::negation});
      return;
    }
    result_.push_back(left);
    if (!step) return;
    // Read 0 < z < 10 as 0 < z and z < 10.
    for (bool first = true; step; first = false, step = take_sign()) {
      if (!first) result_.push_back(left);
      left = take_operand();
      result_.push_back(left);
      result_.push_back({*step});
      if (!first) result_.push_back({Step::both});
    }
  }

  void take_list(const Condition::Instruction& left, std::size_t known, bool negated) {
    if (!take_if("in")) refuse("'in' and a list");
    if (!take_if("(")) refuse("'('");
    const bool are_texts = is_text();
    const std::string field = are_texts ? name_of(left, known) : "";
    bool first = true;
    do {
      if (are_texts) {
        if (!is_text()) refuse("a text in quotes, as the list has texts");
        take_text(field);
      } else {
        result_.insert(result_.end(), {left, take_operand(), {Step::equal}});
      }
      if (!std::exchange(first, false)) result_.push_back({Step::either});
    } while (take_if(","));
    if (!take_if(")")) refuse("',' or ')'");
    if (negated) result_.push_back({Step::negation});
  }

  std::optional<Step> take_sign() {
    for (const auto& [sign, step] : comparisons)
      if (take_if(sign)) return step;
    return std::nullopt;
  }

  Condition::Instruction take_operand() {
    const bool negative = take_if("-");
    const ParsedNumber number = parse_whole_number(word_);
    if (number.fault == NumberFault::none) {
      take();
      return {Step::number, negative ? -number.value : number.value};
    }
    if (negative) refuse("a number");
    const bool keyword = is("and") || is("or") || is("not") || is("in");
    if (keyword || !names_.are(word_)) refuse("a number or " + names_.described);
    const std::string name(unquoted(word_));
    take();
    const auto known = std::find(fields_.begin(), fields_.end(), name);
    const auto index = static_cast<std::size_t>(known - fields_.begin());
    if (known == fields_.end()) fields_.push_back(name);
    return {Step::field, 0, index};
  }

  std::string_view rest_;
  std::string_view word_;  // the next word; empty at the end
  const FieldNames& names_;
  Instructions& result_;
  std::vector<std::string>& fields_;
  std::vector<Condition::Text>& texts_;
};

bool is_true(double value) { return value != 0 && !std::isnan(value); }

double evaluated(Step step, double a, double b) {
  switch (step) {
    case Step::equal:
      return a == b ? 1 : 0;
    case Step::not_equal:
      return a != b ? 1 : 0;
    case Step::less:
      return a < b ? 1 : 0;
    case Step::less_equal:
      return a <= b ? 1 : 0;
    case Step::greater:
      return a > b ? 1 : 0;
    case Step::greater_equal:
      return a >= b ? 1 : 0;
    case Step::both:
      return is_true(a) && is_true(b) ? 1 : 0;
    default:
      return is_true(a) || is_true(b) ? 1 : 0;
  }
}

}  // namespace

FieldNames names_of_columns() {
  const auto are = [](std::string_view word) {
    if (word.empty()) return false;
    return is_of_word(word.front()) || (word.size() > 2 && word.front() == '"' && word.back() == '"');
  };
  return {are, "the name of a column (in double quotes unless it is a word other than and, or, not, in)", true};
}

Condition::Condition(const std::string& text, const FieldNames& names) {
  Parser(text, names, instructions_, fields_, texts_).parse();
}

Condition::Condition(const std::string& text, const FieldNames& names, const std::vector<WantedColumn>& columns,
                     std::string_view option)
    : columns_(columns), option_(option) {
  for (const WantedColumn& column : columns_) {
    if (!names.are(column.name))
      bad_usage(option_ == "--where" ? "fields" : option_, in_quotes(column.name), names.described);
    fields_.push_back(column.name);
  }
  parse(text, names);
}

Condition Condition::of_groups(const GroupColumns& columns, const std::string& text, const FieldNames& names) {
  Condition condition;
  condition.is_of_groups_ = true;
  const auto add = [&](const char* option, std::string_view column, WantedColumn::Kind kind) {
    const std::optional<std::string> listed = listed_name(column);
    if (!listed || !names.are(column)) bad_usage(option, in_quotes(column), names.described);
    const std::string& name = *listed;
    if (kind == WantedColumn::Kind::text && std::count(condition.fields_.begin(), condition.fields_.end(), name) > 0)
      bad_usage(option, in_quotes(column) + " twice", "once");
    condition.fields_.push_back(name);
    condition.columns_.push_back({.name = name, .kind = kind});
  };
  const std::string_view keys = columns.keys ? std::string_view(*columns.keys) : std::string_view();
  bool is_quoted = false;
  for (std::size_t begin = 0, end = 0; columns.keys && end <= keys.size(); ++end) {
    if (end < keys.size() && keys[end] == '"') is_quoted = !is_quoted;
    if (end < keys.size() && (is_quoted || keys[end] != ',')) continue;
    add("--group-by", keys.substr(begin, end - begin), WantedColumn::Kind::text);
    begin = end + 1;
  }
  if (columns.radius) add("--alpha column", *columns.radius, WantedColumn::Kind::radius);
  condition.parse(text, names);
  return condition;
}

void Condition::parse(const std::string& text, const FieldNames& names) {
  selects_ = !text.empty();
  if (!selects_) return instructions_.push_back({Step::number, 1});
  // Add a field for each compared column, also if it is requested: requested columns may be texts, compared ones are
  // numbers.
  std::vector<std::string> compared;
  Parser(text, names, instructions_, compared, texts_).parse();
  for (Instruction& instruction : instructions_)
    if (instruction.step == Step::field) instruction.field += columns_.size();
  fields_.insert(fields_.end(), compared.begin(), compared.end());
}

bool Selection::decides(const Condition::Instruction& instruction) {
  if (instruction.step == Step::number) {
    stack_.push_back(instruction.number);
  } else if (instruction.step == Step::negation) {
    stack_.back() = is_true(stack_.back()) ? 0 : 1;
  } else if (instruction.step == Step::unless_true || instruction.step == Step::unless_false) {
    const bool is_held = is_true(stack_.back());
    if (is_held != (instruction.step == Step::unless_true)) return false;
    stack_.back() = is_held ? 1 : 0;
    return true;
  } else {
    const double right = stack_.back();
    stack_.pop_back();
    stack_.back() = evaluated(instruction.step, stack_.back(), right);
  }
  return false;
}

bool Selection::count() {
  const bool is_held = is_true(stack_.back());
  ++judged_;
  if (is_held) ++selected_;
  return is_held;
}

void Selection::warning(std::string_view noun, std::vector<std::string>& warnings) const {
  if (selects_) warnings.push_back("--where selects " + std::to_string(selected_) + " of " + counted(judged_, noun));
}

}  // namespace rbpa::app
