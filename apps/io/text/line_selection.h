// What: selects the lines of a table: by `--where`, and, with `--skip-invalid`, by whether they can be read.
// Law:  every line with content is read, or deselected by the condition, or left out as it cannot be read, and counted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/number.h"
#include "io/text/condition.h"
#include "io/text/fields.h"
#include "io/text/typed_words.h"
#include "io/utf8.h"

namespace rbpa::app {

/// Numbers distinct texts, in UTF-8, in the order of their first occurrence, so that a column of texts is kept as
/// numbers and a list of texts.
class TextNumbers {
 public:
  double number_of(std::string_view text) {
    const auto [place, is_new] = numbers_.try_emplace(as_utf8(text), texts_.size());
    if (is_new) texts_.push_back(place->first);
    return static_cast<double>(place->second);
  }
  /// Returns the distinct texts in the order of their numbers. Call once.
  std::vector<std::string> take_texts() { return std::move(texts_); }

 private:
  std::vector<std::string> texts_ = {};
  std::unordered_map<std::string, std::size_t> numbers_ = {};
};

/// Returns whether a text of a file, in any encoding that as_utf8() knows, is a text in UTF-8.
inline bool is_text(std::string_view of_file, std::string_view text) {
  return of_file == text || (!is_utf8(of_file) && as_utf8(of_file) == text);
}

/// A refusal of a table that --skip-invalid does not mend: points would be wrong without the refused lines, or a line
/// has no end.
struct WholeRefusal : BadInput {
  using BadInput::BadInput;
};

/// The end of a message about a word that is not a number in a column of --where.
constexpr std::string_view of_where =
    ", as --where compares the column with numbers (== \"...\" compares it with a text)";

class LineSelection {
 public:
  /// `keeps`: the caller keeps columns of kind by_value with their types, so that their numbers here may be rounded;
  /// and numbers of columns may be missing, which are NaN.
  LineSelection(std::optional<Condition> where, bool skip_invalid, bool keeps = false)
      : where_(std::move(where)), skip_invalid_(skip_invalid), keeps_(keeps) {}

  bool has_condition() const { return where_.has_value(); }
  /// Returns the values of the condition's columns() in the last selected line; empty without a condition.
  std::span<const double> column_values() const {
    return selection_ ? selection_->column_values() : std::span<const double>();
  }

  /// Finds the columns of the condition in the header of the file `name`: the current line of `lines`, whose fields are
  /// `names`. Requires: `names` is empty if there is no header. Throws BadInput if a column is missing that is not
  /// optional. If no column is left and all lines are selected, has_condition() is false afterwards.
  void find_columns(const std::vector<std::string_view>& names, const Lines& lines, const std::string& name);

  /// Decides which columns of kind by_value hold numbers and which hold texts: by the first value that is not missing,
  /// in `line`, the first line of data, or in `behind`, the lines after it. Requires: find_columns() was called.
  void settle_kinds(std::string_view line, Lines behind, char separator);

  /// Returns whether the condition is true for a line, whose fields are `fields`. Calls take_width(count), which may
  /// refuse the number of fields, a FieldCount; then read(fields), which returns the next of `fields` as a number, only
  /// for fields that decide and, if the line is selected, for columns of numbers. Throws what read() and take_width()
  /// throw.
  template <typename Read, typename TakeWidth>
  bool is_selected(Fields fields, const Read& read, const TakeWidth& take_width) {
    if (!where_) return true;
    found_.assign(places_.size(), Fields({}, blanks));
    FieldCount count;
    for (; !fields.at_end(); count.add(fields.take()))
      for (std::size_t i = 0; i < places_.size(); ++i)
        if (places_[i] == count.all) found_[i] = fields;
    take_width(count);
    const std::size_t texts = where_->fields().size();
    const auto text = [&](std::size_t i) { return text_of_field(Fields(found_[i]).take(), room_); };
    const auto number = [&](std::size_t i) {
      Fields field = found_[i];
      return read(field);
    };
    if (!selection_->holds(number, [&](std::size_t i) { return is_text(text(texts + i), where_->texts()[i].text); }))
      return false;
    for (std::size_t k = 0; k < where_->columns(); ++k)
      if (places_[k] != not_there)
        selection_->values()[k] = kinds_[k] == Kind::text     ? numbers_[k].number_of(text(k))
                                  : kinds_[k] == Kind::radius ? radius_of(k, text(k), number)
                                  : keeps_                    ? kept_number(k, text(k), number)
                                                              : number(k);
    return true;
  }

  /// Returns for each of the condition's columns its distinct texts, in the order of their numbers in column_values();
  /// nothing for a column of numbers and for a column that the file does not have. Call once.
  std::vector<std::optional<std::vector<std::string>>> take_texts() {
    std::vector<std::optional<std::vector<std::string>>> all;
    for (std::size_t k = 0; k < kinds_.size(); ++k)
      all.push_back(kinds_[k] == Kind::text && places_[k] != not_there ? std::optional(numbers_[k].take_texts())
                                                                       : std::nullopt);
    return all;
  }

  /// Calls take(), which reads the current line. If take() throws BadInput, leaves the line out and counts it, or,
  /// without --skip-invalid, throws the BadInput: with_hint() if has_points(), that is, if other lines are points.
  /// Throws WholeRefusal.
  template <typename Take, typename HasPoints>
  void attempt(const Take& take, const HasPoints& has_points) {
    try {
      take();
    } catch (const WholeRefusal&) {
      throw;
    } catch (const BadInput& refusal) {
      if (leaves_out(refusal)) return;
      if (has_points()) throw with_hint(refusal);
      throw;
    }
  }

  /// Returns the refusal of a line with the hint that --skip-invalid leaves out lines that are not points.
  static BadInput with_hint(const BadInput& refusal);

  /// Returns whether --skip-invalid leaves out lines; if so, counts the current line as left out because of `refusal`.
  bool leaves_out(const BadInput& refusal) {
    if (skip_invalid_ && skipped_++ == 0) first_skipped_ = refusal.what();
    return skip_invalid_;
  }
  bool skips() const { return skip_invalid_; }
  std::size_t skipped() const { return skipped_; }  ///< number of lines left out until now

  /// Adds warnings about the numbers of selected and of left-out lines. Throws BadInput that names `name` if lines were
  /// left out, none was deselected, and not `any_points`.
  void add_warnings(bool any_points, const std::string& name, std::vector<std::string>& warnings) const;

 private:
  /// Returns the number of column k, whose text is `word`; NaN for any other text, as only the group of that point has
  /// no radius then.
  template <typename Number>
  static double radius_of(std::size_t k, std::string_view word, const Number& number) {
    const ParsedNumber plain = parse_whole_number(word);
    if (plain.fault == NumberFault::none || plain.fault == NumberFault::not_finite) return plain.value;
    try {
      return is_missing(word) ? std::numeric_limits<double>::quiet_NaN() : number(k);
    } catch (const BadInput&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

  /// Returns the number of column k, whose text is `word`.
  template <typename Number>
  double kept_number(std::size_t k, std::string_view word, const Number& number) const {
    if (is_missing(word)) return std::numeric_limits<double>::quiet_NaN();
    const std::optional<std::int64_t> whole =
        where_->column(k).kind == Kind::by_value ? integer_of(word) : std::nullopt;
    return whole ? static_cast<double>(*whole) : number(k);
  }

  using Kind = WantedColumn::Kind;
  static constexpr std::size_t not_there = ~std::size_t{0};

  std::optional<Condition> where_;
  bool skip_invalid_, keeps_;
  std::vector<std::size_t> places_ = {};   // column of the table for each field, then for each text, of the condition
  std::vector<Fields> found_ = {};         // the rest of the current line from each of `places_` on
  std::vector<Kind> kinds_ = {};           // kind of each of the condition's columns
  std::vector<TextNumbers> numbers_ = {};  // numbers of the texts in each of the condition's columns
  std::optional<Selection> selection_ = std::nullopt;
  std::string room_ = {};
  std::size_t skipped_ = 0;
  std::string first_skipped_ = {};
};

}  // namespace rbpa::app
