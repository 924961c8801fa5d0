#include "io/cloud/table_separator.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "io/cloud/table_lines.h"
#include "io/formats.h"
#include "io/interrupt.h"
#include "io/text/odd_fields.h"

namespace rbpa::app {
namespace {

/// A line, split at one separator.
struct Split {
  FieldCount fields = {};
  std::size_t numbers = 0;
  std::optional<std::size_t> geometry = std::nullopt;
  bool begins_with_atom = false;
  bool has_comma = false, is_decimal = false;

  Split(std::string_view line, char separator) {
    for (Fields rest(line, separator); !rest.at_end();) {
      const std::string_view field = without_quotes(rest.take());
      if (fields.all == 0) begins_with_atom = is_atomic_number(field);
      if (is_number(field) || (separator != ',' && has_thousands(field)) || parse_angle(field)) ++numbers;
      if (!geometry && is_geometry(field)) geometry = fields.all;
      fields.add(field);
    }
    has_comma = separator != ',' && line.find(',') != std::string_view::npos;
    is_decimal = has_comma && commas_are_decimal(line, separator);
  }
  bool is_data() const { return numbers > 1 || geometry; }

  static bool is_atomic_number(std::string_view field) {
    const std::optional<std::size_t> number = parse_count(field);
    return number && *number > 0 && *number <= 118;
  }
};

/// Lines of data with equally many fields.
struct Group {
  SeparatorChoice choice;
  bool any_decimal = false, all_decimal = true;

  void add(const Split& line) {
    ++choice.lines;
    choice.begin_with_atoms = choice.begin_with_atoms && line.begins_with_atom;
    if (!choice.geometry) choice.geometry = line.geometry;
    any_decimal = any_decimal || line.is_decimal;
    all_decimal = all_decimal && (line.is_decimal || !line.has_comma);
  }
};

/// Returns the largest group of lines of data; but if the first line is not data, the first group of lines with as many
/// fields as the first line, if there is one. `by_most`: as for choose_separator().
Group largest_group(std::string_view text, char separator, bool by_most, const std::string& name) {
  constexpr std::size_t most_lines = 64;
  TableLines lines(Content(text, name));
  lines.set_layout(separator, std::numeric_limits<std::size_t>::max());
  std::optional<Split> first;
  std::vector<Group> groups;
  for (std::size_t i = 0; i < most_lines && lines.next(); ++i) {
    stop_if_interrupted();
    const Split line(lines.line(), separator);
    if (!first) {
      first = line;
      if (!by_most && !line.is_data() && line.fields.all == 1)
        first->fields = count_fields(lines.line(), separator_of(lines.line()));
    }
    if (!line.is_data()) continue;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& known) {
      return line.fields.fits(known.choice.fields) || known.choice.fields.fits(line.fields);
    });
    if (group == groups.end())
      group = groups.insert(group, Group{{.separator = separator, .fields = line.fields, .begin_with_atoms = true}});
    group->add(line);
  }
  const auto fits = [&](const Group& group) {
    return group.choice.fields.fits(first->fields) || first->fields.fits(group.choice.fields);
  };
  auto best = first && !first->is_data() ? std::find_if(groups.begin(), groups.end(), fits) : groups.end();
  if (best == groups.end())
    best = std::max_element(groups.begin(), groups.end(),
                            [](const Group& a, const Group& b) { return a.choice.lines < b.choice.lines; });
  if (best == groups.end()) return {{.separator = separator}};
  best->choice.first_fits = fits(*best);
  return *best;
}

}  // namespace

SeparatorChoice choose_separator(std::string_view text, std::optional<char> said, bool by_most,
                                 const std::string& name) {
  if (text.size() > separator_sample)
    if (const std::size_t end = text.rfind('\n', separator_sample); end != std::string_view::npos)
      text = text.substr(0, end + 1);
  if (said) return largest_group(text, *said, by_most, name).choice;
  const bool tabs = same_letters(input_ending(name), "tsv");
  const auto rank = [&](const Group& group) {
    const SeparatorChoice& choice = group.choice;
    const bool is_decimal = group.any_decimal && group.all_decimal;
    return std::tuple(!by_most && choice.first_fits && choice.lines > 0,
                      tabs && choice.separator == '\t' && choice.lines > 0, choice.lines, by_most && is_decimal,
                      choice.first_fits, is_decimal);
  };
  std::optional<Group> best;
  for (const char separator : {',', ';', '\t', '|', blanks}) {
    const Group group = largest_group(text, separator, by_most, name);
    if (!best || rank(group) > rank(*best)) best = group;
  }
  if (best->choice.lines == 0) {
    TableLines lines(Content(text, name));
    if (lines.next()) best->choice.separator = separator_of(lines.line());
  }
  return best->choice;
}

std::optional<FieldCount> fields_of_data(std::string_view line, char separator) {
  const Split split(line, separator);
  return split.is_data() ? std::optional(split.fields) : std::nullopt;
}

}  // namespace rbpa::app
