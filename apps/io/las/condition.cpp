#include "io/las/condition.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

using Step = Condition::Step;
using Instructions = std::vector<Condition::Instruction>;

constexpr std::pair<std::string_view, Step> comparisons[] = {
    {"==", Step::equal},      {"=", Step::equal},          {"!=", Step::not_equal}, {"<>", Step::not_equal},
    {"<=", Step::less_equal}, {">=", Step::greater_equal}, {"<", Step::less},       {">", Step::greater}};

/// Recursive descent, a function for each rule of the grammar.
class Parser {
 public:
  Parser(const std::string& text, Instructions& result) : rest_(text), result_(result) {}

  void parse() {
    take();
    take_alternatives(0);
    if (!word_.empty()) refuse("and, or, or the end");
  }

 private:
  static constexpr int deepest = 100;  // brackets in brackets

  /// Goes to the next word: a name, a number or a sign.
  void take() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) rest_.remove_prefix(1);
    const auto is_of_word = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    std::size_t size = 0;
    while (size < rest_.size() && is_of_word(rest_[size])) {
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

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  bool is(std::string_view word, std::string_view sign = "") const {
    if (!sign.empty() && word_ == sign) return true;
    return std::equal(word_.begin(), word_.end(), word.begin(), word.end(),
                      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
  }

  bool take_if(std::string_view word, std::string_view sign = "") {
    if (!is(word, sign)) return false;
    take();
    return true;
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    throw WrongUsage("--where: found " + (word_.empty() ? "the end" : in_quotes(word_)) + ", expected " + expected);
  }

  void take_alternatives(int depth) {
    take_conjunction(depth);
    while (take_if("or", "||")) {
      take_conjunction(depth);
      result_.push_back({Step::either});
    }
  }

  void take_conjunction(int depth) {
    take_term(depth);
    while (take_if("and", "&&")) {
      take_term(depth);
      result_.push_back({Step::both});
    }
  }

  void take_term(int depth) {
    if (depth == deepest) refuse("at most " + std::to_string(deepest) + " brackets in each other");
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

  void take_comparison() {
    Condition::Instruction left = take_operand();
    if (is("in") || is("not")) return take_list(left, take_if("not"));
    std::optional<Step> step = take_sign();
    result_.push_back(left);
    if (!step) return;
    // 0 < z < 10 is 0 < z and z < 10.
    for (bool first = true; step; first = false, step = take_sign()) {
      if (!first) result_.push_back(left);
      left = take_operand();
      result_.push_back(left);
      result_.push_back({*step});
      if (!first) result_.push_back({Step::both});
    }
  }

  void take_list(const Condition::Instruction& left, bool negated) {
    if (!take_if("in")) refuse("in");
    if (!take_if("(")) refuse("'('");
    bool first = true;
    do {
      result_.push_back(left);
      result_.push_back(take_operand());
      result_.push_back({Step::equal});
      if (!first) result_.push_back({Step::either});
      first = false;
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
    if (!is_las_field(word_)) refuse("a number or a field of LAS: " + las_field_names());
    Condition::Instruction field{Step::field, 0, std::string(word_)};
    take();
    return field;
  }

  std::string_view rest_;
  std::string_view word_;  // the next one, empty at the end
  Instructions& result_;
};

/// The formats that have a field, for a message.
std::string formats_with(std::string_view field, unsigned minor) {
  std::string formats;
  for (unsigned format = 0; format <= last_las_format; ++format)
    if (find_las_field(field, format, minor)) formats += (formats.empty() ? "" : ", ") + std::to_string(format);
  return formats.empty() ? "one of a later version" : formats;
}

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
      return a != 0 && b != 0 ? 1 : 0;
    default:
      return a != 0 || b != 0 ? 1 : 0;
  }
}

}  // namespace

Condition::Condition(const std::string& text) { Parser(text, instructions_).parse(); }

Selection::Selection(const Condition& condition, const LasRecords& records, const std::string& name)
    : axes_(records.axes) {
  for (const Condition::Instruction& given : condition.instructions()) {
    Instruction& instruction = instructions_.emplace_back(Instruction{given.step, given.number});
    if (given.step != Step::field) continue;
    if (const std::optional<std::size_t> axis = las_axis(given.field)) {
      instruction.field = {.offset = 4 * *axis, .type = Scalar::int32};
      instruction.axis = axis;
      continue;
    }
    const std::optional<LasField> field = find_las_field(given.field, records.format, records.minor);
    if (!field)
      bad_input(name, "point format " + std::to_string(records.format) + " of LAS 1." + std::to_string(records.minor),
                "one with " + given.field + ", as --where asks: " + formats_with(given.field, records.minor));
    instruction.field = *field;
  }
}

bool Selection::operator()(const char* record) {
  values_.clear();
  for (const Instruction& instruction : instructions_) {
    if (instruction.step == Step::number) {
      values_.push_back(instruction.number);
    } else if (instruction.step == Step::field) {
      const char* at = record + instruction.field.offset;
      values_.push_back(instruction.axis ? axes_[*instruction.axis](load<std::int32_t>(at, std::endian::little))
                                         : instruction.field.value(record));
    } else if (instruction.step == Step::negation) {
      values_.back() = values_.back() == 0 ? 1 : 0;
    } else {
      const double right = values_.back();
      values_.pop_back();
      values_.back() = evaluated(instruction.step, values_.back(), right);
    }
  }
  return values_.back() != 0;
}

}  // namespace rbpa::app
