#include "io/text_points.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/lines.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

constexpr char blanks = ' ';  // as a separator: any run of spaces and tabs

char separator_of(std::string_view line) {
  for (const char c : {',', ';', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return blanks;
}

std::string_view without_quotes(std::string_view field) {
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

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> result;
  for (Fields fields(line, separator); !fields.at_end();) result.push_back(without_quotes(fields.take()));
  return result;
}

bool is_number(std::string_view field) { return parse_whole_number(field).fault != NumberFault::not_a_number; }

class TextReader {
 public:
  TextReader(std::string_view text, const std::string& name, const Columns& columns)
      : text_(text), lines_(text), name_(name), columns_(columns) {}

  std::vector<Point> read() {
    if (!lines_.next_with_content()) {
      if (columns_.x.number == 0 || columns_.y.number == 0)
        bad_input(name_, "no header line", "one with the column names");
      return {};
    }
    const bool header = take_header();
    if (header && !lines_.next_with_content()) return {};
    separator_ = separator_of(lines_.line());
    if (!header) first_line_ = lines_.number();
    first_point_ = lines_.number();

    std::vector<Point> points;
    // A point takes four characters or more; room that is not used costs nothing.
    points.reserve(std::min(count_line_ends(lines_.rest()) + 1, text_.size() / 4 + 1));
    points.push_back(read_line());
    do {
      read_plain_lines(points);
      if (!lines_.next_with_content()) return points;
      points.push_back(read_line());
    } while (true);
  }

 private:
  std::string here() const { return at_line(name_, lines_.number()); }

  /// Finds the columns; whether the current line is the header.
  bool take_header() {
    const std::vector<std::string_view> fields = split(lines_.line(), separator_of(lines_.line()));
    const auto position = [&](const Column& column) {
      return column.number > 0 ? column.number - 1 : find_name(fields, column.name);
    };
    x_ = position(columns_.x);
    y_ = position(columns_.y);
    const bool by_name = columns_.x.number == 0 || columns_.y.number == 0;
    const std::size_t needed = std::max(x_, y_) + 1;
    if (fields.size() < needed) {
      const bool text_only = std::none_of(fields.begin(), fields.end(), is_number);
      bad_input(here(), text_only ? in_quotes(lines_.line()) : counted(fields.size(), "column"),
                needed == 2 ? (text_only ? "two numbers" : "two columns")
                            : "at least " + counted(needed, "column") + ", as --columns asks");
    }
    if (x_ == y_) refuse_one_column(fields[x_]);  // under two names, or by name and by number
    if (!by_name && (is_number(fields[x_]) || is_number(fields[y_]))) return false;
    first_line_ = lines_.number();
    header_ = lines_.line();
    width_ = fields.size();
    return true;
  }

  std::size_t find_name(const std::vector<std::string_view>& fields, const std::string& wanted) const {
    const auto same_letter = [](char a, char b) {
      return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    auto found = std::find(fields.begin(), fields.end(), wanted);
    if (found == fields.end())
      found = std::find_if(fields.begin(), fields.end(), [&](std::string_view field) {
        return std::equal(field.begin(), field.end(), wanted.begin(), wanted.end(), same_letter);
      });
    if (found == fields.end())
      bad_input(here(), in_quotes(lines_.line()), "a header with a column " + in_quotes(wanted));
    return static_cast<std::size_t>(found - fields.begin());
  }

  /// Reads the lines that hold nothing but fields without quotes, as nearly all do: without looking for their ends first.
  void read_plain_lines(std::vector<Point>& points) {
    for (Point p; const char* behind = read_plain_line(p); lines_.pass_line(behind)) {
      if (points.size() % 16384 == 0) stop_if_interrupted();
      points.push_back(p);
    }
  }

  /// Where the next line ends, when it is plain and a point; else null.
  const char* read_plain_line(Point& p) const {
    const char* at = lines_.rest().data();
    const char* const end = at + lines_.rest().size();
    const auto skip_blanks = [&](char but) {
      while (at != end && is_blank(*at) && *at != but) ++at;
    };
    const char kept = separator_ == blanks ? '\0' : separator_;  // a tab may be the separator
    skip_blanks('\0');
    for (std::size_t column = 0; column < *width_; ++column) {
      if (column > 0) {
        const char* const field_end = at;
        skip_blanks(kept);
        if (separator_ == blanks) {
          if (at == field_end) return nullptr;
        } else {
          if (at == end || *at != separator_) return nullptr;
          ++at;
          skip_blanks(kept);
        }
      }
      if (column == x_ || column == y_) {
        const ParsedNumber number = parse_number(at, end);
        if (number.fault != NumberFault::none) return nullptr;
        if (column == x_) p.x = number.value;
        if (column == y_) p.y = number.value;
        at = number.end;
      } else {
        const char* const field = at;
        while (at != end && !is_blank(*at) && *at != separator_ && *at != '\n' && *at != '"' && *at != '#') ++at;
        if (at == field) return nullptr;
      }
    }
    skip_blanks('\0');
    return at == end || *at == '\n' ? at : nullptr;
  }

  Point read_line() {
    Fields fields(lines_.line(), separator_);
    std::optional<double> x, y;
    std::size_t count = 0;
    for (; !fields.at_end(); ++count) {
      if (count == x_ || count == y_) {
        const double value = read_number(fields);
        if (count == x_) x = value;
        if (count == y_) y = value;
      } else {
        fields.take();
      }
    }
    if (!width_) width_ = count;
    if (count != *width_)
      bad_input(here(), counted(count, "column") + " (" + in_quotes(lines_.line()) + ")",
                std::to_string(*width_) + " as in line " + std::to_string(first_line_));
    return {*x, *y};
  }

  double read_number(Fields& fields) const {
    const ParsedNumber number = parse_number(fields.begin_of_field(), fields.end_of_line());
    if (number.fault == NumberFault::none && fields.take_up_to(number.end)) return number.value;
    const std::string_view field = without_quotes(fields.take());
    const ParsedNumber whole = parse_whole_number(field);
    if (whole.fault != NumberFault::none)
      bad_input(here(), in_quotes(field), expected_instead(whole.fault) + hint(whole.fault));
    return whole.value;
  }

  /// The first point has text where a number should be: others of its columns may be meant.
  std::string hint(NumberFault fault) const {
    if (fault != NumberFault::not_a_number || lines_.number() != first_point_) return "";
    if (split(lines_.line(), separator_).size() <= 2) return "";
    return " (--columns X,Y chooses other columns" + (header_.empty() ? "" : " of " + in_quotes(header_)) + ")";
  }

  std::string_view text_;
  Lines lines_;
  const std::string& name_;
  const Columns& columns_;
  char separator_ = blanks;
  std::size_t x_ = 0;
  std::size_t y_ = 0;
  std::size_t first_line_ = 0;        // the line that says how many columns there are
  std::optional<std::size_t> width_;  // how many
  std::string_view header_;           // empty without one
  std::size_t first_point_ = 0;       // its line
};

}  // namespace

std::vector<Point> read_text_points(std::string_view text, const std::string& name, const Columns& columns) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
  return TextReader(text, name, columns).read();
}

}  // namespace rbpa::app
