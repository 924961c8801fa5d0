#include "io/cloud/off.h"

#include <algorithm>
#include <utility>

#include "io/bytes/claim.h"
#include "io/bytes/number.h"
#include "io/cloud/element_cloud.h"
#include "io/cloud/readers.h"
#include "io/failure.h"
#include "io/text/plain_text.h"
#include "io/text/vertex_lines.h"

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

OffHeader read_off_header(std::string_view text, std::size_t size, const std::string& name) {
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
  const std::size_t left = size - (text.size() - lines.rest().size());
  // The shortest vertex line is "0 0" and its end, but for the last.
  if (*vertices > (left + 1) / 4)
    bad_input(name, counted(left, "byte") + " of data", announced(header, *vertices, "vertex line"));
  return header;
}

double claimed_off_size(std::string_view first, const std::string& name) {
  std::string room;
  first = plain_text(first, name, Format::off, room);
  const OffHeader header = read_off_header(first, unknown_size, name);
  std::string_view counts = header.counts;
  const std::size_t faces = parse_count(take_word(counts)).value_or(0);
  return end_of_lines(first, header.lines, static_cast<double>(header.vertices) + static_cast<double>(faces));
}

std::string announced(const OffHeader& header, std::size_t count, std::string_view noun) {
  return counted(count, noun) + " as line " + std::to_string(header.line) + " says";
}

std::unique_ptr<Cloud> open_off(Content content, const CloudRequest& request) {
  const std::string_view text = content.ahead();
  const OffHeader off = read_off_header(text, text.size(), content.name());
  PointLayout layout{.has_room = true};
  layout.facts.normals = request.in_space && off.normals;
  layout.colors_behind = request.in_space && off.colors;
  if (layout.colors_behind) layout.facts.colors = Channels::bytes;
  if (!request.in_space) layout.height = 2;
  PlyElement vertex{.name = "vertex", .noun = "vertex line", .count = off.vertices, .line = off.line};
  vertex.properties.resize(!request.in_space ? 2 : off.normals ? 6 : 3, {.name = "", .type = Scalar::float64});
  for (std::size_t k = 0; k < vertex.properties.size(); ++k) layout.columns.emplace_back(k, k);
  PlyHeader header{.elements = {std::move(vertex)}, .lines = off.lines.number(), .data = off.lines.rest()};
  return open_elements(std::move(content), std::move(header), std::move(layout), request);
}

}  // namespace rbpa::app
