#include "io/cloud/xyz_atoms.h"

#include <algorithm>
#include <cctype>

#include "io/text/fields.h"
#include "io/text/lines.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Returns the value of "Properties=" in a comment; empty if there is none.
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

/// Returns "species:S:1:pos:R:3" as names of columns; none if it is not understood.
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

/// Whether a line of numbers is data and not a comment, as the next line has equally many fields.
bool are_both_data(std::string_view line, std::string_view next) {
  std::size_t numbers = 0;
  for (Fields fields(line, blanks); !fields.at_end();)
    if (is_number(fields.take()))
      ++numbers;
    else
      return false;
  return numbers == count_fields(next, blanks).all;
}

/// Whether a line is an atom: the symbol of an element, or a label that begins with a letter, and three numbers.
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

}  // namespace

std::optional<XyzAtoms> find_xyz_atoms(std::string_view text, bool by_number) {
  Lines lines(text);
  if (!lines.next()) return std::nullopt;
  const std::optional<std::size_t> count = parse_count(lines.line());
  if (!count || *count == 0 || !lines.next()) return std::nullopt;
  XyzAtoms atoms{.count = *count, .names = names_of(properties_in(lines.line()))};
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

}  // namespace rbpa::app
