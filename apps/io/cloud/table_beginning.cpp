#include "io/cloud/table_beginning.h"

#include <algorithm>
#include <cctype>
#include <deque>

#include "io/cloud/table_odd_lines.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/text/fields.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

constexpr std::string_view way_of_comments = " (quotes around the first field of a line make it one)";

/// Returns the value of "Properties=" in a comment; empty if the comment has none.
std::string_view properties_in(std::string_view comment) {
  constexpr std::string_view key = "properties=";
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  const auto* const found = std::search(comment.begin(), comment.end(), key.begin(), key.end(), same);
  if (found == comment.end()) return {};
  comment.remove_prefix(static_cast<std::size_t>(found - comment.begin()) + key.size());
  const bool quoted = comment.starts_with('"');
  if (quoted) comment.remove_prefix(1);
  return comment.substr(0, std::min(comment.find_first_of(quoted ? "\"" : " \t"), comment.size()));
}

/// Returns the names of the columns of a Properties value of extended XYZ, such as "species:S:1:pos:R:3"; empty if it
/// is not understood.
std::vector<std::string> names_of(std::string_view properties) {
  std::deque<std::string> room;
  const std::vector<std::string_view> words = split(properties, ':', room);
  std::vector<std::string> names;
  for (std::size_t i = 0; i + 2 < words.size(); i += 3) {
    const std::optional<std::size_t> columns = parse_count(words[i + 2]);
    constexpr std::size_t most = 1024;
    if (!columns || *columns > most) return {};
    for (std::size_t k = 0; k < *columns; ++k) {
      const std::string name(words[i]);
      if (name == "pos" && *columns == 3)
        names.emplace_back(1, "xyz"[k]);
      else if (*columns == 1)
        names.push_back(name == "species" ? "element" : name);
      else
        names.push_back(name + "_" + std::to_string(k + 1));
    }
  }
  const bool has_place = std::find(names.begin(), names.end(), "x") != names.end();
  return has_place ? names : std::vector<std::string>();
}

/// Returns whether `line` is data and not a comment: all its fields are numbers, as many as the fields of `next`.
bool are_both_data(std::string_view line, std::string_view next) {
  std::size_t numbers = 0;
  for (Fields fields(line, blanks); !fields.at_end();)
    if (is_number(fields.take()))
      ++numbers;
    else
      return false;
  return numbers == count_fields(next, blanks).all;
}

/// Returns whether a line is an atom: the symbol of an element, a label that begins with a letter, or, `by_number`, the
/// number of an element; then three numbers.
bool is_atom_line(std::string_view line, bool by_number) {
  Fields fields(line, blanks);
  const auto take = [&] { return fields.at_end() ? std::string_view() : fields.take(); };
  const std::string_view element = take();
  if (element.empty()) return false;
  const std::optional<std::size_t> number = parse_count(element);
  const bool is_symbol = std::isalpha(static_cast<unsigned char>(element.front())) != 0 && !is_number(element);
  if (!is_symbol && !(by_number && number && *number <= 118)) return false;
  return is_number(take()) && is_number(take()) && is_number(take());
}

class Starter {
 public:
  Starter(TableLines& lines, TableKind kind, const CloudRequest& request, LineSelection& selection,
          std::vector<std::string>& warnings)
      : lines_(lines), kind_(kind), request_(request), selection_(selection), warnings_(warnings) {}

  TableStart start() {
    std::optional<char> said;
    start_.has_line = lines_.next();
    if (start_.has_line && (said = separator_hint(lines_.line()))) start_.has_line = lines_.next();
    if (start_.has_line) {
      comment_ = lines_.comment_before();
      if (const std::string_view line = lines_.line();
          line.starts_with('%') && separator_of(line) == blanks && !selection_.skips())
        bad_input(at_line(lines_.name(), lines_.number()), in_quotes(line),
                  "a header or points (comments begin with #: sed 's/^%/#/' makes them)");
      if (take_atoms()) return std::move(start_);
      take_count();
    }
    if (start_.has_line)
      lay_out(said);
    else if (is_by_name(request_.columns))
      bad_input(lines_.name(), "no header line", "one with the column names");
    if (!start_.has_line && start_.layout.header && !start_.announced)
      bad_input(
          at_line(lines_.name(), start_.first_line),
          in_quotes(start_.header) + " and no line after it" + (lines_.comments() > comments_ ? " but comments" : ""),
          "lines of points after a header" + std::string(lines_.passed_points() > 0 ? way_of_comments : ""));
    if (!start_.any_table && !start_.has_line && selection_.skipped() == 0 && lines_.passed_points() > 0)
      bad_input(lines_.name(), counted(lines_.comments(), "comment") + " and no point",
                "points" + std::string(way_of_comments));
    if (!start_.any_table && !start_.has_line && selection_.skipped() + lines_.comments() == 0 && !start_.announced)
      bad_input(lines_.name(), "blank lines only", "points");
    return std::move(start_);
  }

 private:
  void next() {
    start_.has_line = lines_.next();
    if (start_.has_line && !lines_.comment_before().empty()) comment_ = lines_.comment_before();
  }

  /// Takes the count and the comment of the .xyz format of chemistry, if there are any. Returns whether the layout
  /// follows from them: if there are any, and no columns are requested. Elements may be numbers only if the ending of
  /// the file is .xyz or absent.
  bool take_atoms() {
    if (kind_ != TableKind::any || !parse_count(lines_.line())) return false;
    const std::string_view known = input_ending(lines_.name());
    const auto atoms = find_xyz_atoms(lines_.ahead(separator_sample), known.empty() || same_letters(known, "xyz"));
    if (!atoms) return false;
    start_.announced = AnnouncedPoints{atoms->count, lines_.number(), true};
    lines_.pass_line(atoms->behind_comment);
    start_.has_line = lines_.next();
    if (request_.columns) {  // the request may name columns by these names
      comment_.clear();
      for (const std::string& name : atoms->names) comment_ += name + ' ';
      return false;
    }
    const std::vector<std::string_view> names(atoms->names.begin(), atoms->names.end());
    lay_out_by_names(names, request_.in_space, start_.layout);
    start_.layout.width = count_fields(lines_.line(), blanks);
    finish(blanks);
    return true;
  }

  /// Takes the number of points: a line with one whole number before lines with more fields.
  void take_count() {
    const std::optional<std::size_t> count = parse_count(lines_.line());
    if (!count || start_.announced) return;
    if (kind_ != TableKind::pts && (request_.skip_invalid || !is_before_points())) return;
    start_.announced = AnnouncedPoints{*count, lines_.number()};
    next();
  }
  bool is_before_points() const {
    Lines behind(lines_.ahead(separator_sample));
    behind.next();
    return behind.next_with_content() &&
           count_fields(behind.line(), separator_of(behind.line())).all >= least_columns(kind_);
  }

  void lay_out(std::optional<char> said) {
    std::deque<std::string> room;
    constexpr std::size_t most_tries = 1000;  // each attempt reads following lines
    const auto choose = [&] {
      return choose_separator(lines_.ahead(separator_sample), said, selection_.skips(), lines_.name());
    };
    std::optional<SeparatorChoice> passed;
    SeparatorChoice choice = choose();
    if (selection_.skips() && !lacks_name_of_rows(lines_, choice)) passed = pass_title(said);
    if (passed) choice = *passed;
    for (std::size_t tries = 1;; ++tries) {
      try {
        lay_out(choice, said.has_value(), room);
        return;
      } catch (const WholeRefusal&) {
        throw;
      } catch (const BadInput& refusal) {
        if (!selection_.leaves_out(refusal)) throw;
      }
      lines_.set_layout('\0', 0);
      comment_.clear();
      next();
      if (!start_.has_line) return;
      room.clear();
      if (tries < most_tries) choice = choose();
    }
  }

  /// Leaves out the lines above the header, or, if there is no header, the lines above the data. The header is the last
  /// line above the data with the names that the request requires, or else with known names, or else with any names.
  /// Returns the choice of the separator, which the current line then fits; nothing if the first lines have no data or
  /// begin with data.
  std::optional<SeparatorChoice> pass_title(std::optional<char> said) {
    SeparatorChoice choice = choose_separator(lines_.ahead(separator_sample), said, true, lines_.name());
    if (choice.lines == 0) return std::nullopt;
    TableLines lines(Content(lines_.ahead(separator_sample), lines_.name()));
    lines.set_layout(choice.separator, choice.fields.to_last_text);
    int best = 0;
    std::size_t header = 0, data = 0, texts = 0;  // numbers of lines
    for (;; ++data) {
      if (!lines.next()) return std::nullopt;
      const std::optional<FieldCount> width = fields_of_data(lines.line(), choice.separator);
      const bool is_data = width && (width->fits(choice.fields) || choice.fields.fits(*width));
      const int rank = header_rank(lines, choice, is_data);
      if (is_data && (rank == 0 || best > 0)) break;
      if (rank > 0 && rank >= best) {
        best = rank;
        header = data;
      }
      if (!width && has_text_only(lines.line(), choice.separator)) ++texts;
    }
    if (data == 0) return std::nullopt;
    if (best == 0) refuse_lost_header(data);
    says_columns_ = texts > (best > 0 ? 1U : 0U);
    const std::size_t left_out = best > 0 ? header : data;
    lines_.set_layout(choice.separator, choice.fields.to_last_text);
    for (std::size_t i = 0; i < left_out; ++i) {
      const FieldCount width = count_fields(lines_.line(), choice.separator);
      const bool fits = width.fits(choice.fields) || choice.fields.fits(width);
      selection_.leaves_out(BadInput(at_line(lines_.name(), lines_.number()) + ": found " +
                                     (fits ? in_quotes(lines_.line()) + ", expected the header or numbers"
                                           : found_columns(width.all, lines_.line()) + ", expected " +
                                                 std::to_string(choice.fields.all) + " as in the lines after it")));
      comment_.clear();
      next();
    }
    lines_.set_layout('\0', 0);
    choice.first_fits = true;
    return choice;
  }

  /// Throws WholeRefusal if one of the next `count` lines, which do not fit the lines after them, is a header with
  /// known names: the lines after them have the columns in other places, or another separator.
  void refuse_lost_header(std::size_t count) {
    TableLines lines(Content(lines_.ahead(separator_sample), lines_.name()));
    for (std::size_t i = 0; i < count && lines.next(); ++i) {
      std::deque<std::string> room;
      const std::vector<std::string_view> names = split(lines.line(), separator_of(lines.line()), room);
      if (header_kind(names, request_) != HeaderKind::known_names) continue;
      throw WholeRefusal(at_line(lines_.name(), lines_.number() - 1 + lines.number()) + ": found " +
                         in_quotes(lines.line()) +
                         ", a header above lines with other numbers of fields, expected one name "
                         "for each field (quotes around texts with separators; decimal commas need semicolons)");
    }
  }

  static bool has_text_only(std::string_view line, char separator) {
    bool any_text = false;
    for (Fields fields(line, separator); !fields.at_end();) {
      const std::string_view field = without_quotes(fields.take());
      if (is_number(field)) return false;
      any_text = any_text || !is_missing(field);
    }
    return any_text;
  }

  /// Returns a rank for the current line of `lines` as header of the table that `choice` describes: the higher, the
  /// more likely; 0 if the line is no header. A line of numbers, or a line with another separator than the data, is a
  /// header only if it has known names.
  int header_rank(const TableLines& lines, const SeparatorChoice& choice, bool is_data) const {
    if (lines.is_open()) return 0;
    char separator = choice.separator;
    const bool differs = choice.fields.all > 1 && count_fields(lines.line(), separator).all == 1;
    if (differs) separator = separator_of(lines.line());
    const FieldCount width = count_fields(lines.line(), separator);
    if (!width.fits(choice.fields) && !choice.fields.fits(width)) return 0;
    std::deque<std::string> room;
    const std::vector<std::string_view> names = split(lines.line(), separator, room);
    const HeaderKind kind = header_kind(names, request_);
    if (kind == HeaderKind::none || (kind == HeaderKind::unknown_names && (differs || is_data))) return 0;
    const int rank = kind == HeaderKind::known_names ? 2 : 1;
    try {
      LineSelection(request_.where, true).find_columns(names, lines.lines(), lines.name());
      return rank + 2;
    } catch (const BadInput&) {
      return rank;
    }
  }

  void lay_out(const SeparatorChoice& choice, bool is_said, std::deque<std::string>& room) {
    std::vector<std::string> warnings;
    char separator = choice.separator;
    lines_.set_layout(separator, choice.fields.to_last_text);
    if (!is_said && choice.lines > 0 &&
        count_fields(lines_.line(), separator).all == 1) {  // a line with one field does not show the separator
      separator = separator_of(lines_.line());
      lines_.set_layout(separator, choice.fields.to_last_text);
    }
    if (lines_.is_open()) lines_.refuse_open();
    TableBeginning table{.lines = lines_, .comment = comment_, .choice = choice, .says_columns = says_columns_};
    table.fields = split(lines_.line(), separator, room);
    for (const std::string_view field : table.fields) table.width.add(field);
    const bool lacks_name = choice.lines > 0 && lacks_name_of_rows(lines_, choice);
    const bool fits = table.width.fits(choice.fields) || choice.fields.fits(table.width);
    if (selection_.skips() && choice.lines > 0 && !fits && !lacks_name)
      bad_input(at_line(lines_.name(), lines_.number()), found_columns(table.width.all, lines_.line()),
                std::to_string(choice.fields.all) + " as in the lines after it");
    if (lacks_name) {
      table.fields.insert(table.fields.begin(), std::string_view());
      table.width = choice.fields;
    }
    const std::size_t least = std::min<std::size_t>(table.fields.size(), request_.in_space ? 3 : 2);
    table.fields.resize(std::max(table.width.to_last_text, least));
    if (!comment_.empty()) table.names = split(comment_, separator_of(comment_), room);
    start_.layout = lay_out_table(table, kind_, request_, warnings);
    if (start_.layout.header) {
      if (choice.lines > 1 && !choice.first_fits && !choice.geometry && choice.fields.all == table.width.all + 1)
        throw WholeRefusal(at_line(lines_.name(), lines_.number()) + ": found " + in_quotes(lines_.line()) + ", " +
                           counted(table.width.all, "name") + " above lines of " +
                           counted(choice.fields.all, "column") +
                           ", expected a name for each column (add that of the column without a name, or quotes around "
                           "texts with separators)");
      start_.header = lines_.line();
      start_.layout.names = table.fields;
    }
    warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
    const bool was_said = is_said || choice.lines > 0;
    finish(was_said ? choice.separator : separator);
    start_.may_lack_fields =
        start_.layout.header && choice.lines > 0 && choice.first_fits && choice.separator != blanks;
    if (!start_.layout.header) return;
    lines_.set_layout('\0', 0);
    comments_ = lines_.comments();
    next();
    if (!start_.has_line) return;
    take_count();
    if (!was_said && start_.has_line) start_.separator = separator_of_data(separator);
    lines_.set_layout(start_.separator, start_.layout.width.to_last_text);
  }

  /// Returns the separator of the data below a header with separator `of_header`. Commas within a geometry separate
  /// nothing.
  char separator_of_data(char of_header) {
    if (start_.layout.wkt) return count_fields(start_.header, of_header).all > 1 ? of_header : ';';
    lines_.set_layout(of_header, 0);
    const bool fits = !lines_.is_open() && count_fields(lines_.line(), of_header).all > 1;
    return fits ? of_header : separator_of(lines_.line());
  }

  void finish(char separator) {
    start_.any_table = true;
    start_.separator = separator;
    start_.first_line = lines_.number();
    selection_.find_columns(start_.layout.names, lines_.lines(), lines_.name());
    std::string room;
    for (const std::string_view name : start_.layout.names) start_.names.emplace_back(text_of_field(name, room));
    start_.layout.names.clear();  // the names view a line that is replaced next
    lines_.set_layout(separator, start_.layout.width.to_last_text);
    if (!start_.layout.wkt) lines_.set_coordinates(start_.layout.numbers, start_.layout.width, separator);
  }

  TableLines& lines_;
  TableKind kind_;
  const CloudRequest& request_;
  LineSelection& selection_;
  std::vector<std::string>& warnings_;
  std::string comment_ = {};   // the line before the first line of the table, or before the count
  bool says_columns_ = false;  // TableBeginning::says_columns
  std::size_t comments_ = 0;   // number of comments up to the header
  TableStart start_ = {};
};

}  // namespace

std::vector<std::string> xyz_columns(std::string_view comment) { return names_of(properties_in(comment)); }

std::optional<XyzBeginning> find_xyz_atoms(std::string_view text, bool by_number) {
  Lines lines(text);
  if (!lines.next()) return std::nullopt;
  const std::optional<std::size_t> count = parse_count(lines.line());
  if (!count || *count == 0 || !lines.next()) return std::nullopt;
  XyzBeginning atoms{.count = *count, .names = xyz_columns(lines.line())};
  const bool says_columns = !atoms.names.empty();
  const std::string_view comment = lines.line();
  atoms.behind_comment = lines.rest().data() - 1;
  if (!lines.next()) return std::nullopt;
  if (says_columns)
    return count_fields(lines.line(), blanks).all >= atoms.names.size() ? std::optional(atoms) : std::nullopt;
  if (!is_atom_line(lines.line(), by_number && !are_both_data(comment, lines.line()))) return std::nullopt;
  atoms.names = {"element", "x", "y", "z"};
  return atoms;
}

std::string check_announced(const AnnouncedPoints& announced, std::size_t lines, const std::string& name,
                            bool skips_invalid) {
  if (announced.count == lines) return "";
  const std::string said = std::to_string(announced.count) + " as line " + std::to_string(announced.line) + " says";
  if (!skips_invalid)
    bad_input(name, counted(lines, "line") + " of points", said + " (--skip-invalid reads what is there)");
  return "there are " + counted(lines, "line") + " of points, and not " + said;
}

std::string check_after_atoms(const AnnouncedPoints& announced, const TableLines& lines, bool skips_invalid) {
  const bool is_frame = parse_count(lines.line()).has_value();
  if (!is_frame && !skips_invalid)
    bad_input(at_line(lines.name(), lines.number()), in_quotes(lines.line()) + " after the last atom",
              "the end of the file or the next frame, as line " + std::to_string(announced.line) + " counts " +
                  counted(announced.count, "atom") + " (--skip-invalid leaves out the rest)");
  return "the atoms are the " + std::to_string(announced.count) + " that line " + std::to_string(announced.line) +
         " counts" + (is_frame ? ", of the first frame" : "") + "; what follows them is left out";
}

TableStart start_table(TableLines& lines, TableKind kind, const CloudRequest& request, LineSelection& selection,
                       std::vector<std::string>& warnings) {
  return Starter(lines, kind, request, selection, warnings).start();
}

}  // namespace rbpa::app
