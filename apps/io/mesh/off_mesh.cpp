#include "io/cloud/off.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {

MeshFile read_off_mesh(std::string_view text, const std::string& name) {
  const OffHeader header = read_off_header(text, text.size(), name);
  std::string_view counts = header.counts;
  const std::optional<std::size_t> faces = parse_count(take_word(counts));
  if (!faces)
    bad_input(at_line(name, header.line), in_quotes(trimmed(header.counts)) + " behind the number of vertices",
              "the number of faces");
  Lines lines = header.lines;
  MeshFile mesh;
  mesh.positions.reserve(header.vertices);
  mesh.point_lines.reserve(header.vertices);
  for (std::size_t i = 0; i < header.vertices; ++i) {
    if (!lines.next_with_content())
      bad_input(name, counted(i, "vertex line"), announced(header, header.vertices, "vertex line"));
    std::string_view rest = lines.line();
    mesh.positions.push_back(take_position(rest, lines, name));
    mesh.point_lines.push_back(lines.number());
  }
  // The shortest face line is "0" and its end, but for the last.
  if (*faces > (lines.rest().size() + 1) / 2)
    bad_input(name, counted(lines.rest().size(), "byte") + " behind the vertices",
              announced(header, *faces, "face line"));
  mesh.reserve_faces(*faces);
  mesh.face_lines.reserve(*faces);
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < *faces; ++f) {
    if (!lines.next_with_content()) bad_input(name, counted(f, "face line"), announced(header, *faces, "face line"));
    std::string_view rest = lines.line();
    take_corner_list(rest, lines, name, mesh.positions.size(), corners);
    mesh.soup.add_face(corners);
    mesh.face_lines.push_back(lines.number());
  }
  if (lines.next_with_content())
    bad_input(at_line(name, lines.number()), in_quotes(lines.line()),
              "nothing behind the " + announced(header, *faces, "face line"));
  return mesh;
}

}  // namespace rbpa::app
