// What: splits a line of a table into fields; recognizes separators, quoted texts and decimal commas.
// Law:  all numbers of a table have a decimal point or a decimal comma, or are whole.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/interrupt.h"
#include "io/number.h"
#include "io/text/lines.h"

namespace rbpa::app {

constexpr char blanks = ' ';  ///< the separator that stands for any run of spaces and tabs

inline std::string_view without_quotes(std::string_view field) {
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') return field.substr(1, field.size() - 2);
  return field;
}

/// Returns the position after the quote that ends the quoted text at `quote`, in which two quotes stand for one (RFC
/// 4180); null if the text does not end before `end`.
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
    if (constexpr std::ptrdiff_t large = 1 << 20; last - first > large) stop_if_interrupted();
    std::string_view field = trimmed({first, static_cast<std::size_t>(last - first)});
    while (field.starts_with(no_break_space)) field = trimmed(field.substr(no_break_space.size()));
    while (field.ends_with(no_break_space)) field = trimmed(field.substr(0, field.size() - no_break_space.size()));
    return field;
  }

  /// Skips the field whose text the caller has read up to `behind`. Returns false, and skips nothing, if the field has
  /// more text.
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

  static constexpr std::string_view no_break_space = "\xC2\xA0";

  const char* at_;
  const char* end_;
  char separator_;
  bool done_ = false;
};

/// Numbers of fields of a line: with and without the empty fields at its end, which other lines of the table may lack.
struct FieldCount {
  std::size_t all = 0, to_last_text = 0;

  void add(std::string_view field) {
    ++all;
    if (!field.empty()) to_last_text = all;
  }
  /// Returns whether a line with this count may be of the table whose first line has the count `first`: the lines
  /// differ only in empty fields at the end.
  bool fits(const FieldCount& first) const {
    return all >= first.to_last_text && (all <= first.all || to_last_text <= first.all);
  }
};
FieldCount count_fields(std::string_view line, char separator);

/// Returns the text of a field, without quotes around it and with one quote in place of each two. If the field has
/// doubled quotes, the text replaces the content of `room`.
std::string_view text_of_field(std::string_view field, std::string& room);

/// Returns the texts of all fields of `line`; texts that differ from the line are added to `room`.
std::vector<std::string_view> split(std::string_view line, char separator, std::deque<std::string>& room);

/// Returns the end of the record that begins with `line`: the end of that line, or, if a quoted text spans lines, of a
/// later line before `end`. Null if a quoted text does not end, is longer than a mebibyte, or spans lines and is
/// followed by more text in its field.
const char* end_of_record(std::string_view line, const char* end, char separator);

/// Returns the separator of the line: comma, semicolon, tab or '|', the first of these that separates fields of the
/// line, else blanks. Commas do not count if each is the decimal comma of a number, or between its thousands.
char separator_of(std::string_view line);

/// Returns whether `line`, split at `separator`, has several fields and a comma, and all commas of a field are one
/// comma between digits, as in "1,5;2", or between the thousands of a number.
bool commas_are_decimal(std::string_view line, char separator);

/// Returns the separator that `line` names, if it is "sep=;" or the like, which Excel may write as the first line.
std::optional<char> separator_hint(std::string_view line);

/// The number of characters of the longest number, or name of a column. Such texts are copied, and copies of longer
/// ones would delay the end of a run after a signal.
inline constexpr std::size_t longest_word = 65536;

/// Returns whether the field is a number, with a decimal point or comma, of at most longest_word characters.
bool is_number(std::string_view field);

/// Returns whether the field looks like a number, such as "1.0D0", "−1", "12o" or "<0.5": the field has a digit, and it
/// begins with a digit after signs and points, or has no letters but e and d.
bool is_nearly_number(std::string_view field);

/// Returns whether the field is a number with separators of thousands: "345.941,89", "1,234,567", "5'678.6", "5 678,6".
bool has_thousands(std::string_view field);
/// Returns the number without its separators of thousands; nothing unless has_thousands().
std::optional<std::string> without_thousands(std::string_view field);

/// Returns whether the field is like well-known text: it begins with the name of a geometry, every bracket is closed,
/// and there is a digit if there are brackets.
bool is_geometry(std::string_view field);

/// Returns whether the text begins with the name of a geometry, after an SRID if there is one, and an opening bracket
/// or EMPTY follows.
bool begins_with_geometry(std::string_view text);

/// Returns whether the field stands for a missing value: it is empty, "NA", "null", "-" or the like.
bool is_missing(std::string_view field);

/// Returns whether a line without blanks around it is a comment: it begins with "//", or with '#' and not with an error
/// of a spreadsheet, such as "#REF!".
bool is_comment(std::string_view line);

/// Returns whether a field of the header has the name `wanted`, in letters of either case.
bool has_column(const std::vector<std::string_view>& header, std::string_view wanted);

/// Returns the index of the first field of `header` that is `wanted`, else of the first that is `wanted` in letters of
/// either case. Throws BadInput that quotes the current line of `lines`, the header of the file `name`, and ends in
/// `way`.
std::size_t find_column(const std::vector<std::string_view>& header, const std::string& wanted, const Lines& lines,
                        const std::string& name, const std::string& way = "");

/// Reads numbers with decimal commas, and checks that no other number of the table has a decimal point.
class DecimalComma {
 public:
  bool is_used() const { return line_ > 0; }

  /// Returns the number in `field`. Throws BadInput that names `here`, the file and line of `field`.
  double read(std::string_view field, const std::string& here) const;

  /// Records that `field`, in line number `line`, is the first number with a decimal comma, and adds a warning. Throws
  /// BadInput that names `here`, unless `all_whole`: all numbers before are whole.
  void begin(std::string_view field, std::size_t line, bool all_whole, const std::string& here,
             std::vector<std::string>& warnings);

  /// Throws BadInput that names `here` if `field` has a decimal point and is_used().
  void refuse_point(std::string_view field, const std::string& here) const;

 private:
  std::size_t line_ = 0;  // number of the line of the first decimal comma; 0: there is none
};

}  // namespace rbpa::app
