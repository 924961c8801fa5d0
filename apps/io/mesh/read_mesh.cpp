#include "io/mesh/read_mesh.h"

#include <limits>
#include <stdexcept>

#include "io/bytes/input_bytes.h"
#include "io/cloud/cloud.h"
#include "io/failure.h"
#include "io/text/plain_text.h"
#include "io/text/signature.h"

namespace rbpa::app {
namespace {

MeshFile parse(Format format, std::string_view bytes, const std::string& name) {
  if (format == Format::off) return read_off_mesh(bytes, name);
  if (format == Format::ply) return read_ply_mesh(bytes, name);
  if (format == Format::obj) return read_obj_mesh(bytes, name);
  if (format == Format::stl) return read_stl_mesh(bytes, name);
  throw std::logic_error("read_mesh: found a format without a reader, expected off, ply, obj or stl");
}

}  // namespace

MeshFile read_mesh(const MeshSource& source) {
  const InputBytes input(source.path, "a mesh file", decompression_of(source.format, source.path));
  const bool is_known = source.format != Format::by_content || input.bytes().empty();
  return mesh_in(input.bytes(), input.name(),
                 is_known ? source.format : format_of_content(Use::mesh, input.bytes(), input.name(), std::nullopt));
}

MeshFile mesh_in(std::string_view bytes, const std::string& name, Format format) {
  // Refuse an empty file, the result of an earlier command that failed; a mesh without faces may be intended.
  if (bytes.empty()) bad_input(name, "an empty file", "a mesh");
  std::string room;
  MeshFile mesh =
      reading_as(Use::mesh, format, bytes, [&] { return parse(format, plain_text(bytes, name, format, room), name); });
  // Limit the numbers: a halfedge mesh numbers its elements with int, and a soup its corners with 32 bits.
  constexpr std::size_t most = std::numeric_limits<int>::max() / 2;
  if (mesh.positions.size() > most || mesh.soup.corners.size() > most)
    bad_input(name, counted(mesh.positions.size(), "point") + " and " + counted(mesh.soup.corners.size(), "corner"),
              "at most " + std::to_string(most) + " of each");
  mesh.soup.points = mesh.positions.size();
  return mesh;
}

}  // namespace rbpa::app
