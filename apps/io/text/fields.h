// What: a line of a table as its fields: by which sign they are apart, what their texts are, decimal commas.
// Law:  all numbers of a table have a decimal point or a decimal comma, or are whole.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text/lines.h"

namespace rbpa::app {

constexpr char blanks = ' ';  ///< as a separator: any run of spaces and tabs

inline std::string_view without_quotes(std::string_view field) {
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') return field.substr(1, field.size() - 2);
  return field;
}

/// Behind the quote that ends the text in quotes at `quote`, in which two quotes are one (RFC 4180). Null where none
/// does before `end`.
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

  /// Passes over a field whose text has been read up to `behind`; false when there is more text in it.
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

/// Of a line; what is empty behind the others may be missing in other lines.
struct FieldCount {
  std::size_t all = 0, to_last_text = 0;

  void add(std::string_view field) {
    ++all;
    if (!field.empty()) to_last_text = all;
  }
  /// Whether lines of both are of one table: they differ in empty fields at the end alone.
  bool fits(const FieldCount& first) const {
    return all >= first.to_last_text && (all <= first.all || to_last_text <= first.all);
  }
};
FieldCount count_fields(std::string_view line, char separator);

/// The text of a field, in which two quotes are one; `room` holds it where it is not as in the line.
std::string_view text_of_field(std::string_view field, std::string& room);

/// The texts of all fields; `room` holds those that are not as in the line.
std::vector<std::string_view> split(std::string_view line, char separator, std::deque<std::string>& room);

/// Where the record ends that begins as `line` does: at the end of that line, or of a later one before `end` where a
/// text in quotes goes on. Null where such a text does not end, or goes on for more than a mebibyte.
const char* end_of_record(std::string_view line, const char* end, char separator);

/// Comma, semicolon, tab or blanks: the first of them that is in the line outside of quotes. A comma that stands
/// between the digits of a number in every field that has one separates nothing.
char separator_of(std::string_view line);

/// Whether `line`, apart at `separator`, has commas, and every one of them stands in a number of its own: "1,5;2".
bool commas_are_decimal(std::string_view line, char separator);

/// Returns the separator of a line "sep=;", which Excel may write before everything else.
std::optional<char> separator_hint(std::string_view line);

/// With a decimal point or comma.
bool is_number(std::string_view field);

/// Whether it was meant to be one, such as "1.0D0", "−1", "12o" or "<0.5": it has a digit, and begins with it or has no
/// letters but those of exponents.
bool is_nearly_number(std::string_view field);

/// Whether it begins as well-known text does, and its brackets close.
bool is_geometry(std::string_view field);

/// Whether it has the name of a geometry, after which a bracket opens or there is EMPTY.
bool begins_with_geometry(std::string_view text);

/// What programs write where there is no value: "NA", nothing, and others.
bool is_missing(std::string_view field);

/// Whether a field of the header is called that, in letters of either case.
bool has_column(const std::vector<std::string_view>& header, std::string_view wanted);

/// Which field of the header, the current line of `lines`, is called that, by case or else without. Throws BadInput.
std::size_t find_column(const std::vector<std::string_view>& header, const std::string& wanted, const Lines& lines,
                        const std::string& name);

class DecimalComma {
 public:
  bool is_used() const { return line_ > 0; }

  /// The number that `field` is. Throws BadInput naming `here`, the place of its line.
  double read(std::string_view field, const std::string& here) const;

  /// The first number that has one, in `line`. Throws BadInput unless all numbers before were whole.
  void begin(std::string_view field, std::size_t line, bool all_whole, const std::string& here,
             std::vector<std::string>& remarks);

  /// Throws BadInput when `field` has a decimal point where commas are used.
  void refuse_point(std::string_view field, const std::string& here) const;

 private:
  std::size_t line_ = 0;  // that has shown it
};

}  // namespace rbpa::app
