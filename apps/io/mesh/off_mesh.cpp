#include "io/cloud/off.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {

MeshFile read_off_mesh(std::string_view text, const std::string& name) {
  const OffHeader off = read_off_header(text, name);
  const PlyHeader header = off.elements(off.normals ? 6 : 3);
  const PlyElement &vertex = header.elements.front(), &face = header.elements.back();
  PlyText data(header, name);
  MeshFile mesh;
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
  if (data.has_more())
    bad_input(at_line(name, data.lines().number()), in_quotes(data.lines().line()),
              "the end of the file after " + announced(face));
  return mesh;
}

}  // namespace rbpa::app
