#include "io/text/signature.h"

#include <algorithm>
#include <iterator>

#include "io/failure.h"
#include "io/number.h"
#include "io/scalar.h"
#include "io/text/fields.h"
#include "io/text/lines.h"
#include "io/text/plain_text.h"

namespace rbpa::app {
namespace {

using namespace std::string_view_literals;

/// The first bytes of a binary format.
struct Magic {
  std::string_view bytes, ending;
};
constexpr Magic magics[] = {{"LASF", "las"},
                            {"\x93NUMPY", "npy"},
                            {"\x89PNG", "png"},
                            {"SQLite format 3\0"sv, "gpkg"},
                            {"fgb\x03"
                             "fgb",
                             "fgb"},
                            {"\0\0\x27\x0A"sv, "shp"},
                            {"PK\x03\x04", "zip"}};

bool begins_with_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return text.starts_with(word); });
}

bool has_line(std::string_view text, bool (*is)(std::string_view line)) {
  for (Lines lines(text); lines.next();)
    if (is(lines.line())) return true;
  return false;
}

bool is_atom(std::string_view line) { return begins_with_one_of(line, {"ATOM  ", "HETATM"}); }
bool is_atom_site(std::string_view line) { return same_letters(line.substr(0, 11), "_atom_site."); }
bool is_vertex(std::string_view line) {
  const std::string_view word = take_word(line);
  const bool three = is_number(take_word(line)) && is_number(take_word(line)) && is_number(take_word(line));
  return word == "v" && three;
}

/// Recognizes a text by its first line with content.
std::string_view ending_of_text(std::string_view text) {
  Lines lines(text);
  if (!lines.next_with_content()) return {};
  const std::string_view line = lines.line();
  std::string_view rest = line;
  const std::string_view word = take_word(rest);
  if (text.starts_with("# .PCD") || begins_with_one_of(line, {"VERSION ", "FIELDS "})) return "pcd";
  if (word == "ply") return "ply";
  if (word.ends_with("OFF") && word.find_first_not_of("STCNOF") == std::string_view::npos) return "off";
  if ((word == "P2" || word == "P5")) return "pgm";
  if (line.starts_with('{') || line.starts_with('\x1E')) return "geojson";
  constexpr std::string_view records[] = {"HEADER", "TITLE ", "COMPND", "REMARK", "CRYST1",
                                          "MODEL ", "ATOM  ", "HETATM", "AUTHOR", "SEQRES"};
  if (std::find(std::begin(records), std::end(records), line.substr(0, 6)) != std::end(records) &&
      has_line(text, is_atom))
    return "pdb";
  if (line.starts_with("ITEM: ")) return "dump";
  if (same_letters(word.substr(0, 5), "data_") && has_line(text, is_atom_site)) return "cif";
  if (same_letters(word, "solid") && text.find("facet") != std::string_view::npos) return "stl";
  constexpr std::string_view of_obj[] = {"v", "vn", "vt", "o", "g", "s", "mtllib", "usemtl"};
  if (std::find(std::begin(of_obj), std::end(of_obj), word) != std::end(of_obj) && has_line(text, is_vertex))
    return "obj";
  const std::string_view geometry = text.substr(0, std::min(text.find(')') + 1, text.size()));
  return begins_with_geometry(geometry) ? "wkt" : std::string_view();
}

}  // namespace

std::string_view ending_of_content(std::string_view bytes) {
  for (const Magic& magic : magics)
    if (bytes.starts_with(magic.bytes)) return magic.ending;
  constexpr std::size_t facet_count = 80, header = 84, facet = 50;
  if (bytes.size() > header && bytes.size() == header + facet * std::size_t{load<std::uint32_t>(
                                                                    bytes.data() + facet_count, std::endian::little)})
    return "stl";
  constexpr std::size_t most = std::size_t{1} << 20U;
  std::string room;
  return ending_of_text(with_line_feeds(without_mark(bytes.substr(0, most)), room));
}

Format format_of_content(Use use, std::string_view bytes, const std::string& name, std::optional<Format> otherwise) {
  const std::string_view found = ending_of_content(bytes);
  const std::optional<Format> format = found.empty() ? otherwise : find_format(use, found);
  if (format && *format != Format::ogr) return *format;
  bad_input(name, found.empty() ? "content of an unknown format" : "the content of a file ." + std::string(found),
            "one of " + endings(use) + (found.empty() ? " (name the format with --format)" : ""));
}

std::string way_by_content(Use use, Format format, std::string_view bytes) {
  const std::string found(ending_of_content(bytes));
  const std::optional<Format> other = found.empty() ? std::nullopt : find_format(use, found);
  return other && *other != format ? "the content is that of a file ." + found + ": --format " + found : std::string();
}

}  // namespace rbpa::app
