// What: reads a table in text, a point per line: the reader of .csv, .xy, .pts and the like.
// How:  1. start_table() (table_beginning.h) passes the lines before the points: choose_separator() (table_separator.h)
//          and lay_out_table() (table_layout.h) find the columns, and table_doubts.h warns if they may be others.
//       2. next() reads plain lines by read_plain_line(), all others by take_line() with TableFields (table_fields.h);
//          LineSelection applies --where and --skip-invalid, and table_odd_lines.h recognizes lines that are no points.
//       3. finish() adds the warnings about the whole table.
#include <algorithm>
#include <limits>
#include <utility>

#include "io/cloud/colors.h"
#include "io/cloud/table_beginning.h"
#include "io/cloud/table_fields.h"
#include "io/cloud/table_lines.h"
#include "io/cloud/table_odd_lines.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/wkt.h"
#include "io/text/fields.h"
#include "io/text/line_selection.h"
#include "io/text/odd_fields.h"
#include "io/utf8.h"

namespace rbpa::app {
namespace {

class TableCloud final : public Cloud {
 public:
  TableCloud(Content content, const CloudRequest& request, TableKind kind)
      : lines_(std::move(content)),
        name_(lines_.name()),
        request_(request),
        kind_(kind),
        selection_(request.where, request.skip_invalid, request.keeps.has_value()) {
    TableStart start = [&] {
      try {
        return start_table(lines_, kind_, request_, selection_, facts_.file.warnings);
      } catch (const WholeRefusal&) {
        throw;
      } catch (const BadInput& refusal) {
        throw is_mended_by_skipping() ? LineSelection::with_hint(refusal) : refusal;
      }
    }();
    has_line_ = start.has_line;
    announced_ = start.announced;
    if (start.any_table) begin(start);
  }

  bool next(CloudBlock& block) override {
    stop_if_interrupted();
    make_room(block);
    reading_.begin_block(block, numbers_);
    while (has_line_ && block.count < points_at_once) {
      take_line(block);
      if (is_plain_ && plain_width_ > 0 && !reading_.has_commas()) read_plain_lines(block);
      has_line_ = lines_.next();
      if (!has_line_ || point_lines_ != last_line_) continue;
      warn(check_after_atoms(*announced_, lines_, request_.skip_invalid));
      has_line_ = false;
    }
    for (std::size_t k = 0; k < numbers_; ++k) block.column[k].resize(block.count);
    block.heights.resize(has_heights_ ? block.count : 0);
    any_points_ = any_points_ || block.count > 0;
    reading_.end_block();
    if (block.count == 0 && announced_)
      warn(check_announced(*std::exchange(announced_, std::nullopt), point_lines_, name_, request_.skip_invalid));
    if (block.count == 0 && any_points_ && !ended_) end();
    return block.count > 0;
  }

  void finish() override {
    selection_.add_warnings(any_points_, name_, facts_.file.warnings);
    warn(lines_.warning_on_comments());
    if (is_last_point_) warn(doubt_);
    facts_.file.texts = selection_.take_texts();
    facts_.file.all_points = index_;
  }

  std::uint64_t bytes_read() const override { return lines_.content().bytes_read(); }

 private:
  /// The role of a column: the index of a column of CloudBlock, `height` or `nothing`.
  static constexpr std::uint8_t first_color = CloudBlock::color, height = 9, nothing = 10;
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  using Numbers = std::array<double, CloudBlock::color>;

  void warn(std::string warning) {
    if (!warning.empty()) facts_.file.warnings.push_back(std::move(warning));
  }
  std::string here() const { return at_line(name_, lines_.number()); }

  // The beginning.

  void begin(TableStart& start) {
    if (announced_ && announced_->atoms) last_line_ = announced_->count;
    wkt_ = start.layout.wkt;
    numbers_ = start.layout.numbers.size();
    first_line_ = start.first_line;
    separator_ = start.separator;
    width_ = start.layout.width;
    header_ = std::move(start.header);
    lay_out(start.layout, start.names);
    to_last_name_ = width_.to_last_text;
    if (start.may_lack_fields) {
      const auto last = std::find_if(role_.rbegin(), role_.rend(), [](std::uint8_t r) { return r < height; });
      width_.to_last_text = wkt_ ? *wkt_ + 1 : static_cast<std::size_t>(role_.rend() - last);
    }
    if (header_.empty()) index_ = selection_.skipped();
    if (has_line_) selection_.settle_kinds(lines_.line(), lines_.lines(), separator_);
    reading_.begin(separator_, request_.in_space, header_);
    is_plain_ = !wkt_ && !facts_.colors && !selection_.has_condition() && !reading_.keeps_any();
    if (!has_line_ || !lines_.content().is_in_memory()) return;
    // Estimate the room: a point takes at least two characters for each number. Unused room costs nothing.
    const std::string_view rest = lines_.rest();
    const std::size_t shortest = request_.in_space ? 6 : 4;
    facts_.expected = std::min(count_line_ends(rest) + 2, rest.size() / shortest + 2);
    doubt_ = doubt_last_line(lines_, separator_);
  }

  void lay_out(const TableLayout& layout, const std::vector<std::string>& names) {
    const auto is = [&](std::size_t column, std::size_t role) {
      if (column >= role_.size()) role_.resize(column + 1, nothing);
      role_[column] = static_cast<std::uint8_t>(role);
    };
    role_.resize(layout.width.all, nothing);
    if (!wkt_)
      for (std::size_t k = 0; k < numbers_; ++k) is(layout.numbers[k], k);
    for (std::size_t k = 0; k < layout.colors.size(); ++k) is(layout.colors[k], first_color + k);
    if (layout.height) is(*layout.height, height);
    if (layout.height && *layout.height < names.size()) facts_.file.height_name = as_utf8(names[*layout.height]);
    for (std::size_t k = 0; request_.keeps && k < names.size(); ++k) {
      const std::string name = as_utf8(names[k]);
      if (name.empty() || !request_.keeps->has(name) || k == wkt_ || (k < role_.size() && role_[k] != nothing))
        continue;
      reading_.keep(k, name);
    }
    has_heights_ = request_.heights && (layout.height || wkt_);
    facts_.normals = numbers_ == 6;
    if (!layout.colors.empty()) facts_.colors = Channels::bytes;
    facts_.file.degrees = layout.degrees;
    is_unnamed_ = layout.unnamed;
    is_by_content_ = layout.unnamed && !request_.last_are_normals;
  }

  // Points.

  void make_room(CloudBlock& block) const {
    block.count = 0;
    for (std::size_t k = 0; k < numbers_; ++k) block.column[k].resize(points_at_once);
    if (has_heights_) block.heights.resize(points_at_once);
    clear_colors(block);
    clear_fields(block, selection_.column_values().size());
    block.index.clear();
  }

  void append(const Numbers& value, CloudBlock& block) {
    if (is_by_content_) last_.take({value[3], value[4], value[5]});
    for (std::size_t k = 0; k < numbers_; ++k) block.column[k][block.count] = value[k];
    append_fields(selection_.column_values(), block);
    reading_.append_words();
    if (has_heights_) block.heights[block.count] = z_;
    if (request_.skip_invalid || selection_.has_condition()) block.index.push_back(index_);
    ++index_;
    ++block.count;
  }

  bool has_no_direction(const Numbers& value) const {
    return numbers_ == 6 && !is_by_content_ && request_.needs_normals && value[3] == 0 && value[4] == 0 &&
           value[5] == 0;
  }

  /// Reads lines whose fields are plain numbers without quotes, as nearly all are, without first searching for line
  /// ends.
  void read_plain_lines(CloudBlock& block) {
    Numbers value{};
    while (block.count < points_at_once && point_lines_ < last_line_) {
      const char* const behind = read_plain_line(value);
      if (behind == nullptr) return;
      append(value, block);
      is_last_point_ = true;
      ++point_lines_;
      lines_.pass_line(behind);
    }
  }

  /// Returns the end of the next line, and sets `value`, if the line is plain and a point; returns null otherwise.
  const char* read_plain_line(Numbers& value) {
    z_ = none;
    const char* at = lines_.rest().data();
    const char* const end = at + lines_.rest().size();
    const auto skip_blanks = [&](char but) {
      while (at != end && is_blank(*at) && *at != but) ++at;
    };
    const char separator = separator_;
    const std::size_t width = plain_width_, numbers = numbers_;
    const std::uint8_t* const role = role_.data();
    const char kept = separator == blanks ? '\0' : separator;  // a tab may be the separator
    skip_blanks(kept);
    for (std::size_t column = 0; column < width; ++column) {
      if (column > 0) {
        const char* const field_end = at;
        skip_blanks(kept);
        if (separator == blanks) {
          if (at == field_end) return nullptr;
        } else {
          if (at == end || *at != separator) return nullptr;
          ++at;
          skip_blanks(kept);
        }
      }
      if (role[column] < numbers) {
        const ParsedNumber number = parse_number(at, end);
        if (number.fault != NumberFault::none) return nullptr;
        value[role[column]] = number.value;
        at = number.end;
      } else {
        const char* const field = at;
        if (column == 0 && at != end && *at == '/') return nullptr;  // perhaps "//", which begins a comment
        while (at != end && !is_blank(*at) && *at != separator && *at != '\n' && *at != '"' && *at != '#') ++at;
        if (at == field) return nullptr;
        if (role[column] == height) take_height({field, static_cast<std::size_t>(at - field)});
      }
    }
    skip_blanks('\0');
    if (at != end && *at != '\n') return nullptr;
    return has_no_direction(value) ? nullptr : at;
  }

  /// Reads the points of the current line, if the condition selects the line.
  void take_line(CloudBlock& block) {
    ++point_lines_;
    const std::size_t index = index_;
    const auto take_one = [&] {
      if (lines_.is_open()) lines_.refuse_open();
      const auto read = [this](Fields& fields) { return reading_.read(fields, of_where); };
      const auto take = [this](const FieldCount& count) { take_width(count); };
      try {
        if (selection_.is_selected(Fields(lines_.line(), separator_), read, take))
          wkt_ ? read_geometries(block) : read_point(block);
      } catch (const BadInput&) {
        if (any_points_ || block.count > 0) refuse_second_header(lines_, separator_, width_, header_);
        throw;
      }
    };
    selection_.attempt(take_one, [&] { return any_points_ || block.count > 0 || is_mended_by_skipping(); });
    is_last_point_ = index_ != index;
    if (!is_last_point_) ++index_;
    if (!is_last_point_ || plain_width_ >= to_last_name_) return;
    warn("line " + std::to_string(lines_.number()) + " has " + counted(plain_width_, "field") + " and line " +
         std::to_string(first_line_) + " " + std::to_string(width_.all) +
         ": fields that are not read may be missing at the end");
    to_last_name_ = 0;
  }

  /// Returns whether the first lines of the file have a point if lines that are no points are left out.
  bool is_mended_by_skipping() const {
    CloudRequest skipping = request_;
    skipping.skip_invalid = true;
    try {
      Content content = lines_.content().again();
      std::string_view beginning = content.ahead(separator_sample);
      if (beginning.size() > separator_sample)
        beginning = beginning.substr(0, beginning.rfind('\n', separator_sample) + 1);
      CloudBlock block;
      return !request_.skip_invalid && TableCloud(Content(beginning, name_), skipping, kind_).next(block);
    } catch (const std::runtime_error&) {
      return false;
    }
  }

  void read_point(CloudBlock& block) {
    z_ = none;
    Fields fields(lines_.line(), separator_);
    Numbers value{};
    std::array<std::string_view, 3> color;
    FieldCount count;
    while (!fields.at_end()) {
      const std::uint8_t role = count.all < role_.size() ? role_[count.all] : nothing;
      if (role < numbers_) {
        value[role] = reading_.read(fields, {}, role);
        count.add("a number");
        continue;
      }
      const std::string_view field = without_quotes(fields.take());
      count.add(field);
      if (role >= first_color && role < height) color[role - first_color] = field;
      if (role == height) take_height(field);
    }
    take_width(count);
    reading_.take_words();
    if (has_no_direction(value)) bad_input(here(), "a normal of length 0", "one of another length");
    if (facts_.colors) colors_.take(color, lines_.number(), block);
    append(value, block);
  }

  /// Records the height in a field; ignores a field that is not a number. After two heights differ, ignores the column
  /// of heights unless heights are requested.
  void take_height(std::string_view field) {
    std::string text(field);
    if (separator_ != ',') std::replace(text.begin(), text.end(), ',', '.');  // a decimal comma
    const ParsedNumber number = parse_whole_number(text);
    if (number.fault == NumberFault::none) facts_.file.heights.take(z_ = number.value);
    if (facts_.file.heights.differ() && !has_heights_) std::replace(role_.begin(), role_.end(), height, nothing);
  }

  /// Throws BadInput unless the current line has the fields of the table; fields at its end are optional from
  /// width_.to_last_text on.
  void take_width(const FieldCount& count) {
    if (!count.fits(width_))
      bad_input(here(), found_columns(count.all, lines_.line()),
                std::to_string(width_.all) + " as in line " + std::to_string(first_line_) +
                    way_of_fields(lines_.line(), separator_, count.all > width_.all));
    plain_width_ = count.all;
    if (count.all > role_.size()) role_.resize(count.all, nothing);
  }

  /// Reads the geometries of the current line, in its field of well-known text.
  void read_geometries(CloudBlock& block) {
    Fields fields(lines_.line(), separator_);
    std::string_view text;
    FieldCount count;
    reading_.take_words();
    while (!fields.at_end()) {
      const std::string_view field = without_quotes(fields.take());
      if (count.all == *wkt_) text = field;
      count.add(field);
    }
    take_width(count);
    std::vector<Point> points;
    WktGeometries geometries(text, request_.vertices);
    try {
      while (geometries.next(points)) continue;
    } catch (const WktFault& fault) {
      const std::string way = fault.found.starts_with("',") ? " after a blank"  // POINT (1, 2)
                              : is_number(text)             ? " (--columns X,Y takes two columns)"
                                                            : way_to_text(text);
      bad_input(here(), fault.found, fault.expected + way);
    }
    if (points.empty()) bad_input(here(), in_quotes(text), "a geometry, such as 'POINT (1 2)'" + way_to_text(text));
    std::optional<Crs>& crs = facts_.file.crs;
    if (crs && geometries.crs() && crs->code != geometries.crs()->code)
      bad_input(here(), geometries.crs()->text(), crs->text() + " as in lines before");
    if (geometries.crs()) crs = geometries.crs();
    if (!geometries.crs_warning().empty() && std::exchange(has_crs_warning_, true) == false)
      facts_.file.warnings.push_back(geometries.crs_warning());
    facts_.file.heights.take(geometries.heights());
    const std::size_t size = std::max(block.column[CloudBlock::x].size(), block.count + points.size());
    for (const std::size_t axis : {CloudBlock::x, CloudBlock::y}) block.column[axis].resize(size);
    if (has_heights_) block.heights.resize(size);
    for (std::size_t i = 0; i < points.size(); ++i) {
      z_ = geometries.z()[i];
      append({points[i].x, points[i].y}, block);
    }
  }

  void end() {
    ended_ = true;
    if (is_unnamed_) last_.settle(is_by_content_, facts_);
    if (facts_.colors && !facts_.last_are_colors) colors_.settle(kind_ != TableKind::any, facts_);
  }

  TableLines lines_;
  const std::string& name_;
  CloudRequest request_;
  TableKind kind_;
  std::optional<AnnouncedPoints> announced_ = std::nullopt;
  std::size_t point_lines_ = 0,
              last_line_ = std::numeric_limits<std::size_t>::max();  // lines of points: read, and to read
  std::size_t index_ = 0;  // number of the next point among all points of the file
  bool has_line_ = false, ended_ = false, any_points_ = false;
  char separator_ = blanks;
  std::size_t numbers_ = 0;                        // number of numbers of a point
  std::vector<std::uint8_t> role_ = {};            // role of each column
  std::optional<std::size_t> wkt_ = std::nullopt;  // the column of geometries, in place of x and y
  std::size_t first_line_ = 0;                     // number of the line that sets the number of columns
  FieldCount width_ = {};                          // the number of columns
  std::size_t to_last_name_ = 0;                   // lines with fewer fields give a warning, once
  std::size_t plain_width_ = 0;                    // number of fields of the previous plain line; 0: there was none
  std::string header_ = {};                        // line of the header; empty if there is none
  bool is_plain_ = false;                          // read_plain_lines() may succeed
  TableFields reading_ = TableFields(lines_, facts_.file);
  LineSelection selection_;
  TextColors colors_ = TextColors(widest_channel);
  bool is_unnamed_ = false,
       is_by_content_ = false;  // the last three columns have no names; their values show whether they are colors
  LastColumns last_ = {};
  bool has_crs_warning_ = false;
  std::string doubt_ = {};      // warning about the last line if it is a point
  bool is_last_point_ = false;  // the line that was read last is a point
  bool has_heights_ = false;    // heights are requested, and there may be some
  double z_ = none;             // height of the point that is being read
};

}  // namespace

std::unique_ptr<Cloud> open_table(Content content, const CloudRequest& request, TableKind kind) {
  refuse_no_table(content.ahead(separator_sample), content.name());
  return std::make_unique<TableCloud>(std::move(content), request, kind);
}

/// Reads a table in text, one point per line. Every line is a point, a comment ('#'), blank, or the one header; other
/// lines are refused, with their number, or left out and counted. The separator is that of choose_separator()
/// (table_separator.h). Fields may be in double quotes (not with blanks as separator). All lines have the same number
/// of columns. In a line that the condition excludes, only the condition's columns are read.
const CloudFormat table_reader = reader_of_kind<TableKind::any>;

}  // namespace rbpa::app
