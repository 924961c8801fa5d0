// What: a line of a table as its fields.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "io/lines.h"

namespace rbpa::app {

constexpr char blanks = ' ';  ///< as a separator: any run of spaces and tabs

inline std::string_view without_quotes(std::string_view field) {
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') return field.substr(1, field.size() - 2);
  return field;
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
    if (separator_ == blanks) {
      while (last != end_ && !is_blank(*last)) ++last;
    } else {
      if (last != end_ && *last == '"') last = std::find(last + 1, end_, '"');
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

inline std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> result;
  for (Fields fields(line, separator); !fields.at_end();) result.push_back(without_quotes(fields.take()));
  return result;
}

}  // namespace rbpa::app
