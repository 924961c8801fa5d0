#include "io/cloud/table_lines.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "io/bytes/available_memory.h"
#include "io/cloud/table_separator.h"
#include "io/failure.h"
#include "io/text/line_selection.h"
#include "io/text/plain_text.h"

namespace rbpa::app {
namespace {

constexpr std::size_t at_once = std::size_t{1} << 20U;

}  // namespace

bool TableLines::next() {
  std::string_view line;
  do {
    while (!lines_.next())
      if (!next_text(0)) return false;
    line = without_mark(lines_.line());  // a mark within the text is that of a file that was appended
  } while (is_passed_over(line));
  line_ = line;
  spanned_ = 0;
  is_open_ = false;
  if (separator_ == '\t') widen();
  if (separator_ != '\0' && std::memchr(line_.data(), '"', line_.size()) != nullptr) join();
  return true;
}

/// Returns whether the line is blank, has only separators, or is a comment, which is counted.
bool TableLines::is_passed_over(std::string_view line) {
  if (line.empty()) return true;
  if (is_comment(line)) {
    ++comments_;
    look_for_point(line);
    return true;
  }
  char separator = separator_ == '\0' ? separator_of_points_ : separator_;
  if (separator == '\0' && std::string_view(",;|").find(line.front()) < 3) separator = line.front();
  return line.front() == separator && separator != blanks &&
         std::all_of(line.begin(), line.end(), [&](char c) { return c == separator || is_blank(c); });
}

/// Counts a comment that would be a point without its mark; before the columns are known, any with two numbers.
void TableLines::look_for_point(std::string_view comment) {
  const std::string_view text = trimmed(comment.substr(comment.front() == '#' ? 1 : 2));
  if (separator_of_points_ == '\0' && fields_of_data(text, separator_of(text))) ++passed_points_;
  if (coordinates_.empty()) return;
  std::size_t numbers = 0;
  FieldCount count;
  for (Fields fields(text, separator_of_points_); !fields.at_end();) {
    const std::string_view field = without_quotes(fields.take());
    const bool is_one = std::find(coordinates_.begin(), coordinates_.end(), count.all) != coordinates_.end();
    if (is_one && is_number(field)) ++numbers;
    count.add(field);
  }
  if (numbers != coordinates_.size() || !count.fits(width_)) return;
  if (passed_points_++ == 0) first_passed_ = at_line(name(), lines_.number()) + ", " + in_quotes(comment);
}

void TableLines::set_coordinates(const std::vector<std::size_t>& columns, const FieldCount& width, char separator) {
  if (std::find(columns.begin(), columns.end(), 0U) == columns.end()) coordinates_ = columns;
  separator_of_points_ = separator;
  passed_points_ = 0;
  width_ = width;
}

std::string TableLines::warning_on_comments() const {
  if (passed_points_ == 0) return "";
  return counted(passed_points_, "line") + (passed_points_ == 1 ? " is a comment" : " are comments") +
         " with numbers for a point, " + (passed_points_ == 1 ? "" : "the first is ") + first_passed_ +
         " (quotes around its first field make it a point)";
}

void TableLines::set_layout(char separator, std::size_t least_fields) {
  separator_ = separator;
  least_fields_ = least_fields;
  if (line_.empty() || separator_ == '\0') return;
  if (separator_ == '\t') widen();
  if (std::memchr(line_.data(), '"', line_.size()) != nullptr) join();
}

/// Extends the line by the tabs around it if it has too few fields without them.
void TableLines::widen() {
  if (count_fields(line_, separator_).all >= least_fields_) return;
  const char* first = line_.data();
  const char* last = first + line_.size();
  while (first != text_.data() && is_blank(first[-1])) --first;
  while (last != text_.data() + text_.size() && is_blank(*last)) ++last;
  while (*first == ' ') ++first;
  while (last[-1] == ' ' || last[-1] == '\r') --last;
  line_ = {first, static_cast<std::size_t>(last - first)};
}

/// Joins the lines of a quoted text to one line, and reads further pieces of the file if the text continues there.
void TableLines::join() {
  const char* end = end_of_record(line_, text_.data() + text_.size(), separator_);
  if (end == nullptr && !content_.is_in_memory()) {
    const std::string_view text = ahead(line_.size() + at_once);
    end = end_of_record(line_, text.data() + text.size(), separator_);
  }
  swallowed_ = end == nullptr ? 0 : swallowed_row(end);
  is_open_ = end == nullptr || swallowed_ > 0;
  if (is_open_ || end <= line_.data() + line_.size()) return;
  for (const std::size_t first = lines_.number(); lines_.rest().data() <= end && lines_.next();)
    spanned_ = lines_.number() - first;
  line_ = trimmed({line_.data(), static_cast<std::size_t>(end - line_.data())});
}

/// Returns the number of the first line after the current line that would be a line of data if it stood alone, as the
/// current line would, although both are in the record that ends at `end`; 0 if there is none. Such a line has whole
/// numbers and decimals where the current line has them. A quote that is a sign of inches or of repetition, and no
/// quotation mark, makes such a record.
std::size_t TableLines::swallowed_row(const char* end) const {
  const char* const behind = line_.data() + line_.size();
  const std::optional<FieldCount> width = end > behind ? fields_of_data(line_, separator_) : std::nullopt;
  if (!width || width->all < least_fields_) return 0;
  const auto kind = [](std::string_view f) { return is_number(f) ? (f.find_first_of(".,") < f.size() ? 2 : 1) : 0; };
  const auto is_like = [&](std::string_view row) {
    Fields of_first(line_, separator_), of_row(row, separator_);
    while (!of_first.at_end() && !of_row.at_end()) {
      const int first = kind(without_quotes(of_first.take())), second = kind(without_quotes(of_row.take()));
      if (first != 0 && first != second) return false;
    }
    return of_first.at_end() && of_row.at_end() && fields_of_data(row, separator_);
  };
  Lines later({behind, static_cast<std::size_t>(end - behind)}, lines_.number() - 1);
  while (later.next())
    if (is_like(later.line())) return later.number();
  return 0;
}

void TableLines::refuse_open() const {
  if (swallowed_ == 0) bad_input(at_line(name(), number()), "a text in quotes that does not end", "a closing quote");
  bad_input(at_line(name(), number()),
            "a text in quotes with lines of data, the first of them " + std::to_string(swallowed_),
            "a closing quote before them (without a quote that is a sign of inches or of repetition)");
}

std::string_view TableLines::ahead(std::size_t size) {
  const auto left = [&] { return static_cast<std::size_t>(text_.data() + text_.size() - line_.data()); };
  if (left() >= size || content_.is_in_memory()) return {line_.data(), left()};
  const std::size_t number = lines_.number(), length = line_.size();
  taken_ = mark_ + static_cast<std::size_t>(line_.data() - text_.data());
  next_text(size);
  lines_ = Lines(text_, number - 1);
  lines_.next();
  line_ = text_.substr(0, length);
  return text_;
}

/// Goes to the next text: all that is in memory, or the next piece of a file, of more than `at_least` bytes up to the
/// end of a line. Returns false if there is none.
bool TableLines::next_text(std::size_t at_least) {
  content_.skip(taken_);
  std::string_view text = content_.ahead();
  std::size_t searched = 0;  // number of first bytes without a line end
  for (std::size_t wanted = at_least + at_once; !content_.is_in_memory(); wanted += at_once) {
    text = content_.ahead(wanted);
    if (text.size() < wanted) break;  // the end of the file
    const std::size_t lines = size_of_lines(text.substr(searched));
    if (lines > 0 && searched + lines > at_least) {
      text = text.substr(0, searched + lines);
      break;
    }
    searched = text.size() - 1;
    require_memory(text.size());
  }
  const bool is_first = taken_ == 0 && lines_.number() == 0;
  taken_ = text.size();
  text_ = is_first ? plain_text(text, name(), room_) : with_line_feeds(text, room_);
  mark_ = text.size() - text_.size();
  lines_ = Lines(text_, lines_.number());
  return !text.empty();
}

/// Throws WholeRefusal if memory does not suffice for a line of more than `size` bytes.
void TableLines::require_memory(std::size_t size) const {
  constexpr double bytes_for_each = 5;  // the text, its copy when it grows, and the points
  const std::optional<double> there = available_memory();
  if (there && bytes_for_each * static_cast<double>(size) > *there)
    throw WholeRefusal(name() + ": found a line of more than " + bytes_text(static_cast<double>(size)) +
                       ", expected at most a fifth of the available memory (a table has a line for each point)");
}

std::string_view TableLines::line_before() const {
  std::string_view before = text_.substr(0, static_cast<std::size_t>(line_.data() - text_.data()));
  before = before.substr(0, before.find_last_of('\n') + 1);  // up to the line, without blanks before it
  if (before.empty()) return {};
  before.remove_suffix(1);
  constexpr std::size_t longest = std::size_t{1} << 20U;  // no header is longer
  const std::size_t cut = before.size() - std::min(before.size(), longest);
  const std::size_t end = before.substr(cut).find_last_of('\n');
  if (end == std::string_view::npos) return cut > 0 ? std::string_view() : trimmed(before);
  return trimmed(before.substr(cut + end + 1));
}

std::string_view TableLines::comment_before() const {
  const std::string_view before = line_before();
  return is_comment(before) ? trimmed(before.substr(before.front() == '#' ? 1 : 2)) : std::string_view();
}

}  // namespace rbpa::app
