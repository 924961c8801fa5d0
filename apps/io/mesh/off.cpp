// What: reads points and meshes of ASCII OFF files.
#include <utility>

#include "io/cloud/element_cloud.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"
#include "io/number.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

/// The keyword of a three-dimensional ASCII file: OFF with prefixes. The number of vertices may follow the keyword
/// without a blank.
struct Keyword {
  explicit Keyword(std::string_view word) {
    for (const std::string_view prefix : {"ST", "C", "N"}) {
      if (word.substr(0, prefix.size()) != prefix) continue;
      word.remove_prefix(prefix.size());
      normals = normals || prefix == "N";
      colors = colors || prefix == "C";
    }
    if (!word.starts_with("OFF")) return;
    glued = word.substr(3);
    known = glued.empty() || parse_count(glued);
  }
  bool known = false, normals = false, colors = false;
  std::string_view glued;  // the text after the keyword in its word
};

struct OffHeader {
  bool normals;  ///< N is among the prefixes: three numbers after the coordinates of a vertex
  bool colors;   ///< C is among the prefixes: red, green, blue and mostly opacity after the normal
  std::size_t vertices, faces;
  std::size_t line;  ///< number of the line with the counts
  Lines lines;       ///< the lines from the vertices on

  /// Returns a PLY header with the elements of the file: vertices of `numbers` numbers each, and faces.
  PlyHeader elements(std::size_t numbers) const {
    PlyElement vertex{.name = "vertex", .noun = "vertex line", .count = vertices, .line = line};
    vertex.properties.resize(numbers, {.name = "", .type = Scalar::float64});
    PlyElement face{.name = "face", .noun = "face line", .count = faces, .line = line};
    face.properties.push_back({.name = "", .type = Scalar::uint32, .count_type = Scalar::uint32});
    return {.elements = {std::move(vertex), std::move(face)}, .lines = lines.number(), .data = lines.rest()};
  }
};

/// Reads a header: OFF with any of the prefixes ST, C, N, or none; then the counts, in the same line or in the next.
/// The vertices may follow the counts in their line. Throws BadInput that names the line, also if the file is too short
/// for so many vertices of at least two coordinates.
OffHeader read_off_header(std::string_view text, const std::string& name) {
  Lines lines(text);
  if (!lines.next_with_content()) bad_input(name, "no OFF header", "an ASCII .off file");
  std::string_view rest = lines.line();
  std::string_view after_word = rest;
  const std::string_view word = take_word(after_word);
  const Keyword keyword(word);
  if (keyword.known) {
    rest.remove_prefix(static_cast<std::size_t>(keyword.glued.data() - rest.data()));
    rest = trimmed(rest);
    if (rest.substr(0, 6) == "BINARY") bad_input(at_line(name, lines.number()), "binary OFF", "ASCII OFF");
    if (rest.empty() || rest.front() == '#') rest = lines.next_with_content() ? lines.line() : std::string_view();
  } else if (parse_whole_number(word).fault != NumberFault::none) {
    bad_input(at_line(name, lines.number()), in_quotes(word), "OFF, COFF, NOFF or CNOFF");
  }
  const std::string_view counts = rest;
  const std::optional<std::size_t> vertices = parse_count(take_word(rest)), faces = parse_count(take_word(rest));
  if (!vertices || !faces)
    bad_input(at_line(name, lines.number()), in_quotes(counts), "the numbers of vertices, faces and edges");
  take_word(rest);
  rest = trimmed(rest);
  const std::size_t line = lines.number();
  if (!rest.empty() && rest.front() != '#')
    lines = Lines(text.substr(static_cast<std::size_t>(rest.data() - text.data())), line - 1);
  const std::size_t left = lines.rest().size();
  const OffHeader header{.normals = keyword.known && keyword.normals,
                         .colors = keyword.known && keyword.colors,
                         .vertices = *vertices,
                         .faces = *faces,
                         .line = line,
                         .lines = lines};
  // Count four bytes for a vertex: "0 0" and a line end, which the last line may lack.
  if (*vertices > (left + 1) / 4)
    bad_input(name, counted(left, "byte") + " of data", announced(header.elements(0).elements.front()));
  return header;
}

/// Returns the number of coordinates of a vertex, as the first vertex shows: 3, or unless `in_space` also 2.
std::size_t numbers_of_vertex(const OffHeader& off, bool in_space) {
  if (off.normals) return in_space ? 6 : 3;
  Lines lines = off.lines;
  std::string_view first = lines.next_with_content() ? lines.line() : std::string_view();
  take_word(first);
  take_word(first);
  return in_space || !take_word(first).empty() ? 3 : 2;
}

std::unique_ptr<Cloud> open_off(Content content, const CloudRequest& request) {
  const std::string_view text = content.ahead();
  const OffHeader off = read_off_header(text, content.name());
  PointLayout layout{.has_room = true};
  layout.facts.normals = request.in_space && off.normals;
  layout.colors_behind = request.in_space && off.colors;
  if (layout.colors_behind) layout.facts.colors = Channels::bytes;
  PlyHeader header = off.elements(numbers_of_vertex(off, request.in_space));
  const std::size_t numbers = header.elements.front().properties.size();
  for (std::size_t k = 0; k < (request.in_space ? numbers : 2); ++k) layout.columns.emplace_back(k, k);
  if (!request.in_space && numbers == 3) layout.height = 2;
  return open_elements(std::move(content), std::move(header), std::move(layout), request);
}

}  // namespace

/// Reads the vertices of OFF, with the normals of NOFF and the colors of COFF; skips the faces.
const CloudFormat off_reader = {.open = open_off, .skips_invalid = true};

MeshFile read_off_mesh(std::string_view text, const std::string& name) {
  const OffHeader off = read_off_header(text, name);
  const PlyHeader header = off.elements(off.normals ? 6 : 3);
  const PlyElement &vertex = header.elements.front(), &face = header.elements.back();
  PlyText data(header, name);
  MeshFile mesh;
  if (off.normals) mesh.unused.emplace_back("vertex normals");
  if (off.colors) mesh.unused.emplace_back("vertex colors");
  mesh.positions.reserve(vertex.count);
  mesh.point_lines.reserve(vertex.count);
  data.pass(vertex, 0, vertex.count, [&](std::size_t, std::string_view& rest) {
    mesh.positions.push_back(take_position(rest, data.lines(), name));
    for (std::size_t k = 3; k < vertex.properties.size(); ++k) take_word(rest);
    mesh.point_lines.push_back(data.lines().number());
  });
  data.require_room(face);
  mesh.reserve_faces(face.count);
  mesh.face_lines.reserve(face.count);
  std::vector<std::uint32_t> corners;
  data.pass(face, 0, face.count, [&](std::size_t, std::string_view& rest) {
    take_corner_list(rest, data.lines(), name, mesh.positions.size(), corners);
    mesh.soup.add_face(corners);
    mesh.face_lines.push_back(data.lines().number());
  });
  data.require_end();
  return mesh;
}

}  // namespace rbpa::app
