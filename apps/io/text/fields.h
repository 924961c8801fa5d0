// What: splits a line of a table into fields: separators, quoted texts, decimal commas.
// Law:  all numbers of a table have a decimal point or a decimal comma, or are whole.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/number.h"
#include "io/text/lines.h"

namespace rbpa::app {

constexpr char blanks = ' ';  ///< the separator that stands for any run of spaces and tabs

inline std::string_view without_quotes(std::string_view field) {
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') return field.substr(1, field.size() - 2);
  return field;
}

/// Returns the position after the quote that ends the quoted text at `quote`, in which two quotes stand for one (RFC
/// 4180); null if it does not end before `end`.
inline const char* end_of_quoted(const char* quote, const char* end) {
  for (const char* at = std::find(quote + 1, end, '"'); at != end; at = std::find(at + 2, end, '"'))
    if (at + 1 == end || at[1] != '"') return at + 1;
  return nullptr;
}

/// The fields of one line from left to right.
class Fields {
 public:
  Fields(std::string_view line, char separator)
      : at_(line.data()), end_(line.data() + line.size()), separator_(separator) {
    if (separator_ == blanks) skip_comment();
  }

  bool at_end() const { return done_; }
  const char* begin_of_field() const { return at_; }
  const char* end_of_line() const { return end_; }

  std::string_view take() {
    const char* first = at_;
    const char* last = first;
    if (last != end_ && *last == '"')
      if (const char* const behind = end_of_quoted(first, end_)) last = behind;
    if (separator_ == blanks) {
      while (last != end_ && !is_blank(*last)) ++last;
    } else {
      last = std::find(last, end_, separator_);
    }
    leave_field(last);
    return trimmed({first, static_cast<std::size_t>(last - first)});
  }

  /// Skips a field whose text the caller has read up to `behind`; returns false if there is more text in it.
  bool take_up_to(const char* behind) {
    if (separator_ == blanks) {
      if (behind != end_ && !is_blank(*behind)) return false;
    } else {
      while (behind != end_ && is_blank(*behind) && *behind != separator_) ++behind;
      if (behind != end_ && *behind != separator_) return false;
    }
    leave_field(behind);
    return true;
  }

 private:
  void leave_field(const char* last) {
    at_ = last;
    if (separator_ != blanks) {
      if (at_ == end_) {
        done_ = true;
        return;
      }
      ++at_;  // an empty field may follow, even at the end of the line
    }
    while (at_ != end_ && is_blank(*at_) && (*at_ != separator_ || separator_ == blanks)) ++at_;
    if (separator_ == blanks) skip_comment();
  }
  void skip_comment() { done_ = at_ == end_ || *at_ == '#'; }

  const char* at_;
  const char* end_;
  char separator_;
  bool done_ = false;
};

/// The number of fields of a line, with and without empty fields at its end, which other lines may lack.
struct FieldCount {
  std::size_t all = 0, to_last_text = 0;

  void add(std::string_view field) {
    ++all;
    if (!field.empty()) to_last_text = all;
  }
  /// Returns whether lines with both counts may be of one table: they differ only in empty fields at the end.
  bool fits(const FieldCount& first) const {
    return all >= first.to_last_text && (all <= first.all || to_last_text <= first.all);
  }
};
FieldCount count_fields(std::string_view line, char separator);

/// Returns the text of a field, without quotes around it and with one quote for two; `room` holds it if it differs from
/// the line.
std::string_view text_of_field(std::string_view field, std::string& room);

/// Returns the texts of all fields; `room` holds those that differ from the line.
std::vector<std::string_view> split(std::string_view line, char separator, std::deque<std::string>& room);

/// Returns the end of the record that begins with `line`: the end of that line, or of a later one, before `end`, if a
/// quoted text spans lines. Null if such a text does not end, or is longer than a mebibyte.
const char* end_of_record(std::string_view line, const char* end, char separator);

/// Returns comma, semicolon, tab or blanks: the first of these that is in the line outside of quotes. Commas are
/// ignored if every one of them is between the digits of a number.
char separator_of(std::string_view line);

/// Returns whether `line`, split at `separator`, has commas, and each of them is in a number of its own, "1,5;2", or,
/// unless blanks separate, between the thousands of one.
bool commas_are_decimal(std::string_view line, char separator);

/// Returns the separator of a line "sep=;", which Excel may write as the first line.
std::optional<char> separator_hint(std::string_view line);

/// Returns whether the field is a number, with a decimal point or comma.
bool is_number(std::string_view field);

/// Returns whether the field looks like a number, such as "1.0D0", "−1", "12o" or "<0.5": it has a digit, and begins
/// with it or has no letters but those of exponents.
bool is_nearly_number(std::string_view field);

/// Returns whether the field is a number with signs between thousands: "345.941,89", "1,234,567", "5'678.6", "5 678,6".
bool has_thousands(std::string_view field);

/// Returns what a message expects in place of a field with this fault.
std::string expected_for(std::string_view field, NumberFault fault);

/// Returns whether the field begins like well-known text, and its brackets are closed.
bool is_geometry(std::string_view field);

/// Returns whether the text begins with the name of a geometry, followed by an opening bracket or EMPTY.
bool begins_with_geometry(std::string_view text);

/// Returns whether the field stands for a missing value: "NA", nothing, and others.
bool is_missing(std::string_view field);

/// Returns whether a field of the header has that name, in letters of either case.
bool has_column(const std::vector<std::string_view>& header, std::string_view wanted);

/// Returns the index of the field with the name `wanted` in the header, the current line of `lines`; if none matches
/// exactly, in letters of either case. Throws BadInput.
std::size_t find_column(const std::vector<std::string_view>& header, const std::string& wanted, const Lines& lines,
                        const std::string& name);

/// Numbers with decimal commas, and the check that no other number of the table has a decimal point.
class DecimalComma {
 public:
  bool is_used() const { return line_ > 0; }

  /// Returns the number in `field`. Throws BadInput naming `here`, its file and line.
  double read(std::string_view field, const std::string& here) const;

  /// Notes the first number with a decimal comma, in `line`. Throws BadInput unless all numbers before it are whole.
  void begin(std::string_view field, std::size_t line, bool all_whole, const std::string& here,
             std::vector<std::string>& warnings);

  /// Throws BadInput if `field` has a decimal point although commas are used.
  void refuse_point(std::string_view field, const std::string& here) const;

 private:
  std::size_t line_ = 0;  // of the first decimal comma; 0: there is none
};

}  // namespace rbpa::app
