// What: which lines of a table count: those that are as `--where` asks and, where others are left out, are what is read.
// Law:  every line with content is taken, deselected, or left out and counted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/text/condition.h"
#include "io/text/fields.h"

namespace rbpa::app {

constexpr std::string_view of_where =
    " in a column that --where asks for (== \"...\" compares a text)";  ///< behind what a number is expected to be

class LineSelection {
 public:
  LineSelection(std::optional<Condition> where, bool skip_invalid)
      : where_(std::move(where)), skip_invalid_(skip_invalid) {}

  bool has_condition() const { return where_.has_value(); }
  /// Of the condition's columns(), in the line that was judged last.
  std::span<const double> column_values() const {
    return selection_ ? selection_->column_values() : std::span<const double>();
  }

  /// The columns of the condition, by the header of the file `name`, in the current line. `names` are its fields; none
  /// where there is no header, which is refused. Throws BadInput.
  void find_columns(const std::vector<std::string_view>& names, const Lines& lines, const std::string& name);

  /// Whether a line is as the condition asks. Of its fields read(fields) makes the requested numbers, and
  /// take_width(widths) judges how many there are.
  template <typename Read, typename TakeWidth>
  bool is_selected(Fields fields, const Read& read, const TakeWidth& take_width) {
    if (!where_) return true;
    FieldCount count;
    const std::size_t keys = where_->has_key() ? 1 : 0, of_groups = keys + (where_->has_radius() ? 1 : 0);
    const auto first_number = columns_.begin() + static_cast<std::ptrdiff_t>(of_groups);
    while (!fields.at_end()) {
      const std::size_t column = count.all;
      if (keys > 0 && columns_[0] == column)
        selection_->values()[0] = keys_.number_of(text_of_field(Fields(fields).take(), room_));
      if (of_groups > keys && columns_[keys] == column)
        selection_->values()[keys] = radius_of(without_quotes(Fields(fields).take()));
      if (std::find(text_columns_.begin(), text_columns_.end(), column) != text_columns_.end())
        compare_texts(column, text_of_field(Fields(fields).take(), room_));
      if (std::find(first_number, columns_.end(), column) == columns_.end()) {
        count.add(fields.take());
        continue;
      }
      count.add("a number");
      const double value = read(fields);
      for (auto i = static_cast<std::size_t>(first_number - columns_.begin()); i < columns_.size(); ++i)
        if (columns_[i] == column)  // which may have been named in two ways
          selection_->values()[i] = value;
    }
    take_width(count);
    return selection_->holds();
  }

  /// Of the condition's key, the texts that were found: column_values() has a number for each, from 0 on.
  std::vector<std::string> take_keys() { return std::move(keys_.texts); }

  /// Takes a line; one that take() refuses is left out, or the refusal stands.
  template <typename Take>
  void attempt(const Take& take) {
    try {
      take();
    } catch (const BadInput& refusal) {
      if (!leaves_out(refusal)) throw;
    }
  }

  /// For messages about a line that would be left out.
  std::string hint() const { return skip_invalid_ ? "" : " (--skip-invalid leaves out lines that are no point)"; }

  /// Leaves out the current line, if lines may be.
  bool leaves_out(const BadInput& refusal) {
    if (skip_invalid_ && skipped_++ == 0) first_skipped_ = refusal.what();
    return skip_invalid_;
  }
  bool skips() const { return skip_invalid_; }

  /// What was selected, and what was left out. Throws BadInput when that is all there was.
  void add_remarks(bool any_points, const std::string& name, std::vector<std::string>& remarks) const;

 private:
  struct Keys {
    std::vector<std::string> texts = {};
    std::unordered_map<std::string, std::size_t> numbers = {};

    double number_of(std::string_view text) {
      const auto [place, is_new] = numbers.try_emplace(std::string(text), texts.size());
      if (is_new) texts.emplace_back(text);
      return static_cast<double>(place->second);
    }
  };

  /// NaN for what is none: that is for its group to say, and no reason to refuse the file.
  static double radius_of(std::string_view text) {
    const ParsedNumber number = parse_whole_number(text);
    const bool is_one = number.fault == NumberFault::none || number.fault == NumberFault::not_finite;
    return is_one ? number.value : std::numeric_limits<double>::quiet_NaN();
  }

  void compare_texts(std::size_t column, std::string_view found) {
    for (std::size_t i = 0; i < text_columns_.size(); ++i)
      if (text_columns_[i] == column)
        selection_->values()[columns_.size() + i] = found == where_->texts()[i].text ? 1 : 0;
  }

  std::optional<Condition> where_;
  bool skip_invalid_;
  std::vector<std::size_t> columns_ = {};       // of the condition's fields
  std::vector<std::size_t> text_columns_ = {};  // of its texts
  std::optional<Selection> selection_ = std::nullopt;
  Keys keys_ = {};
  std::string room_ = {};
  std::size_t skipped_ = 0;
  std::string first_skipped_ = {};
};

}  // namespace rbpa::app
