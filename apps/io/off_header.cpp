#include "io/off_header.h"

#include "io/failure.h"
#include "io/number.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Whether a word is OFF with the prefixes of a three-dimensional ASCII file, and which of them.
struct Keyword {
  explicit Keyword(std::string_view word) {
    for (const std::string_view prefix : {"ST", "C", "N"}) {
      if (word.substr(0, prefix.size()) != prefix) continue;
      word.remove_prefix(prefix.size());
      normals = normals || prefix == "N";
      colors = colors || prefix == "C";
    }
    known = word == "OFF";
  }
  bool known = false, normals = false, colors = false;
};

}  // namespace

OffHeader read_off_header(std::string_view text, const std::string& name) {
  Lines lines(text);
  if (!lines.next_with_content()) bad_input(name, "no OFF header", "an ASCII .off file");
  std::string_view rest = lines.line();
  std::string_view after_word = rest;
  const std::string_view word = take_word(after_word);
  const Keyword keyword(word);
  if (keyword.known) {
    rest = trimmed(after_word);
    if (rest.substr(0, 6) == "BINARY") bad_input(at_line(name, lines.number()), "binary OFF", "ASCII OFF");
    if (rest.empty() || rest.front() == '#') rest = lines.next_with_content() ? lines.line() : std::string_view();
  } else if (parse_whole_number(word).fault != NumberFault::none) {
    bad_input(at_line(name, lines.number()), in_quotes(word), "OFF, COFF, NOFF or CNOFF");
  }
  const std::string_view counts = rest;
  const std::optional<std::size_t> vertices = parse_count(take_word(rest));
  if (!vertices)
    bad_input(at_line(name, lines.number()), in_quotes(counts), "the numbers of vertices, faces and edges");
  const OffHeader header{.normals = keyword.known && keyword.normals,
                         .colors = keyword.known && keyword.colors,
                         .vertices = *vertices,
                         .line = lines.number(),
                         .counts = rest,
                         .lines = lines};
  // The shortest vertex line is "0 0" and its end, but for the last.
  if (*vertices > (lines.rest().size() + 1) / 4)
    bad_input(name, counted(lines.rest().size(), "byte") + " of data", announced(header, *vertices, "vertex line"));
  return header;
}

std::string announced(const OffHeader& header, std::size_t count, std::string_view noun) {
  return counted(count, noun) + " as line " + std::to_string(header.line) + " says";
}

}  // namespace rbpa::app
